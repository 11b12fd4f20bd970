// [support_design]: the choices of support, their cost, and the factor of safety to be reached.
#include "cases/program/case/case_parts.hpp"
#include "cases/program/reader/described_reader.hpp"
#include "cases/program/reader/units.hpp"

namespace delabole {
namespace {

void check_support_design(Reading& reading, const SupportDesign& design, const CaseModel& model) {
    if (std::holds_alternative<RelaxationStudy>(model)) {
        reading.complain_at("support_design",
                            "belongs to plane_failure and stepped_base: blocks in motion take too long");
        return;
    }
    if (find_quantity(named_inputs(model), "support[1].rows") == nullptr) {
        reading.complain_at("support_design", "has nothing to choose: the model has no [[support]]");
    }
    for (std::size_t index = 0; index < design.choices.size(); ++index) {
        const SupportChoice& choice = design.choices[index];
        const std::string key = indexed("support_design.choose", index);
        if (!is_whole(choice.points)) {
            reading.complain_at(key + ".points", "must be a whole number");
        } else if (choice.input.ends_with(".rows") &&
                   !(is_whole(choice.from) &&
                     is_whole(choice.points > 1 ? (choice.to - choice.from) / (choice.points - 1) : 0))) {
            reading.complain_at(key + ".points", "makes numbers of rows that are not whole");
        }
    }
    if (number_of_patterns(design) > most_support_patterns) {
        reading.complain_at("support_design",
                            "allows " + readable_quantity(number_of_patterns(design), Dimension::ratio) +
                                " patterns; at most " + readable_quantity(most_support_patterns, Dimension::ratio) +
                                " are tried");
    }
}

}  // namespace

SupportDesign read_support_design(Section& section, const CaseModel& model, const ModelNames& names) {
    SupportDesign design{};
    section.refer_to({std::span(&names, 1), "a number that this model answers"});
    read_fields(section, design);
    if (!section.contains("choose")) {
        section.reading().complain(section.place(), "support_design", {},
                                   "has nothing to choose: [[support_design.choose]] is required");
    }
    if (section.reading().clean()) {
        check_support_design(section.reading(), design, model);
    }
    return design;
}

}  // namespace delabole
