// [sensitivity]: what is uncertain and how, which quantity is studied, and which analyses are made.
#include "cases/program/case/case_parts.hpp"
#include "cases/program/reader/described_reader.hpp"
#include "cases/program/reader/names.hpp"

#include <algorithm>

namespace delabole {
namespace {

// Checks that concern several keys together and need no model.
void check_sensitivity(Reading& reading, const SensitivityStudy& study) {
    std::vector<std::string> names;
    for (std::size_t index = 0; index < study.parameters.size(); ++index) {
        const std::string& name = study.parameters[index].name;
        if (!name.empty() && std::ranges::find(names, name) != names.end()) {
            reading.complain_at(indexed("sensitivity.parameter", index) + ".name",
                                "is uncertain already: each input once");
        }
        names.push_back(name);
    }
    for (std::size_t index = 0; index < study.correlations.size(); ++index) {
        for (const std::string& name : study.correlations[index].pair) {
            if (reading.clean() && std::ranges::find(names, name) == names.end()) {
                reading.complain_at(indexed("sensitivity.correlation", index) + ".between",
                                    name + " is not among the uncertain parameters" + suggestion(name, names));
            }
        }
    }
}

}  // namespace

SensitivityStudy read_sensitivity(Section& section, const ModelNames& names) {
    SensitivityStudy study;
    section.refer_to({std::span(&names, 1), "a number that this model answers"});
    read_fields(section, study);
    if (!section.contains("parameter")) {
        section.reading().complain(section.place(), "sensitivity", {},
                                   "has nothing uncertain: [[sensitivity.parameter]] is required");
    }
    for (UncertainParameter& parameter : study.parameters) {
        if (has_limits(parameter.distribution.law)) {
            // These limits were read into the law's own members of the same names.
            parameter.distribution.lower.reset();
            parameter.distribution.upper.reset();
        }
    }
    check_sensitivity(section.reading(), study);
    return study;
}

}  // namespace delabole
