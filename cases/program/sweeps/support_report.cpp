#include "cases/program/sweeps/support_report.hpp"

#include "fitting/work/words.hpp"
#include "plots/drawing/text.hpp"

#include <cmath>

namespace delabole {

namespace {

// "2 rows, spacing 2 m, length 4 m"
std::string choice_in_words(const SupportDesign& design, const TriedSupport& tried) {
    const std::string only_pattern = "support[1].";
    std::string words;
    for (std::size_t index = 0; index < design.choices.size(); ++index) {
        const SupportChoice& choice = design.choices[index];
        const bool short_name = choice.input.starts_with(only_pattern);
        const std::string name = short_name ? choice.input.substr(only_pattern.size()) : choice.input;
        const double value = tried.values[index];
        words += index == 0 ? "" : ", ";
        words += name == "rows" ? number_in_words(value) + (value == 1 ? " row" : " rows")
                                : human_name(name) + " " + value_in_words(value, choice.dimension);
    }
    return words;
}

// The cost per shown unit of length, in the currency of the case.
double shown_cost(double per_metre) {
    return per_metre * shown_unit(Dimension::length).si_per_unit;
}

std::string per_length_of_slope() {
    return shown_unit(Dimension::length).symbol == "m" ? " per metre of slope" : " per foot of slope";
}

// Null if no pattern has an answer.
const TriedSupport* answer_of(const SupportDesignResult& found) {
    const std::optional<std::size_t> answer = found.cheapest ? found.cheapest : found.strongest;
    return answer ? &found.tried[*answer] : nullptr;
}

// Counts of the causes: "bolt head above crest 12, plane never surfaces 3".
std::string causes_in_words(const SupportDesignResult& found) {
    std::vector<std::string> causes;
    for (const auto& [cause, count] : found.failed_by_cause) {
        causes.push_back(human_name(cause) + " " + std::to_string(count));
    }
    return list_in_words(causes);
}

// ", instead of FS 0.93 without bolts"
std::string without_support_in_words(CaseModel model) {
    std::visit(
        [](auto& study) {
            if constexpr (requires { study.model.support.clear(); }) {
                study.model.support.clear();
            } else if constexpr (requires { study.model.scene.support.clear(); }) {
                study.model.scene.support.clear();
            }
        },
        model);
    const Analysis analysis = analyse_model(model);
    const NamedOutput* factor = analysis.find("factor_of_safety");
    const auto* value = factor != nullptr ? std::get_if<double>(&factor->value) : nullptr;
    return value != nullptr ? ", instead of " + factor_in_words(*value) + " without these bolts" : "";
}

// Returns the inputs of a pattern that lie at an end of their ranges, which may have been too narrow. A single row does
// not count, since there cannot be fewer.
std::vector<std::string> at_ends(const SupportDesign& design, const TriedSupport& tried) {
    std::vector<std::string> inputs;
    for (std::size_t index = 0; index < design.choices.size(); ++index) {
        const SupportChoice& choice = design.choices[index];
        const double nearness = 1e-9 * std::abs(choice.to - choice.from);
        const double value = tried.values[index];
        const bool single_row = choice.input.ends_with(".rows") && value == 1;
        if (!single_row && (std::abs(value - choice.from) <= nearness || std::abs(value - choice.to) <= nearness)) {
            inputs.push_back(choice.input);
        }
    }
    return inputs;
}

// Tells what to try if no pattern suffices.
std::string remedy_for(const SupportDesign& design, const TriedSupport& strongest) {
    const std::vector<std::string> at_end = at_ends(design, strongest);
    return (at_end.empty() ? "" : "choose beyond the range of " + list_in_words(at_end) + ", or ") +
           "give the bolts more capacity";
}

// "; cheaper ones may lie beyond the range of support[1].rows"
std::string doubt_about(const SupportDesign& design, const TriedSupport& cheapest) {
    const std::vector<std::string> at_end = at_ends(design, cheapest);
    return at_end.empty() ? "" : "; cheaper ones may lie beyond the range of " + list_in_words(at_end);
}

std::string sentence_of(const SupportDesign& design, const SupportDesignResult& found, const std::string& without) {
    const std::string patterns = std::to_string(found.patterns) + " patterns";
    const TriedSupport* shown = answer_of(found);
    if (shown == nullptr) {
        return "None of " + patterns + " of support has an answer (" + causes_in_words(found) +
               "): what is shown has the support of the case.";
    }
    const std::string factor = factor_in_words(design.factor_of_safety);
    const std::string what = choice_in_words(design, *shown) + ", for " + number_in_words(shown_cost(shown->cost)) +
                             per_length_of_slope() + without + (found.cheapest ? doubt_about(design, *shown) : "") +
                             ".";
    return found.cheapest ? "Of " + patterns + " the cheapest for " + factor + ": " + what
                          : "None of " + patterns + " gives " + factor + " (" + remedy_for(design, *shown) +
                                "); the strongest, shown here: " + what;
}

Figure cost_figure(const DesignedSupport& support, const TriedSupport& answer) {
    Points tried{.legend = "patterns that were tried", .colour = Colour::grey, .size = 0.6};
    for (const TriedSupport& pattern : support.found.tried) {
        if (pattern.factor_of_safety) {
            tried.points.emplace_back(shown_cost(pattern.cost), *pattern.factor_of_safety);
        }
    }
    const double factor = support.design.factor_of_safety;
    const Line required{.points = {{shown_cost(support.found.tried.front().cost), factor},
                                   {shown_cost(support.found.tried.back().cost), factor}},
                        .legend = "required",
                        .dash = Dash::dashed};
    const Points chosen{.points = {{shown_cost(answer.cost), *answer.factor_of_safety}},
                        .legend = support.found.cheapest ? "cheapest that suffices" : "strongest",
                        .colour = Colour::vermilion};
    return {.title = "Support by its cost",
            .x = {.title = "cost" + per_length_of_slope()},
            .y = {.title = "factor of safety"},
            .series = {tried, required, chosen}};
}

std::string support_csv(const DesignedSupport& support) {
    std::vector<std::string> titles;
    for (const SupportChoice& choice : support.design.choices) {
        titles.push_back(column_name(choice.input, choice.dimension));
    }
    titles.insert(titles.end(), {"cost_per_metre_of_slope", "factor_of_safety", "no_answer_because"});
    CsvTable csv(titles);
    for (const TriedSupport& pattern : support.found.tried) {
        std::vector<Cell> row;
        for (std::size_t index = 0; index < pattern.values.size(); ++index) {
            row.emplace_back(in_display_unit(pattern.values[index], support.design.choices[index].dimension));
        }
        row.emplace_back(pattern.cost);
        row.push_back(pattern.factor_of_safety ? Cell(*pattern.factor_of_safety) : Cell(""));
        row.emplace_back(pattern.failure);
        csv.add_row(row);
    }
    return csv.text();
}

}  // namespace

std::optional<DesignedSupport> design_support_of(CaseFile& file, const std::function<bool(double)>& watch) {
    if (!file.support_design) {
        return std::nullopt;
    }
    SupportDesign design = *file.support_design;
    std::erase_if(design.choices, [&](const SupportChoice& choice) {
        const auto written = file.places.find(choice.input);
        return written != file.places.end() && written->second.place.from_option;
    });
    if (design.choices.empty()) {
        return std::nullopt;
    }
    DesignedSupport support{design, design_support(interface_of(file.model), design, watch), {}};
    support.sentence = sentence_of(design, support.found, without_support_in_words(file.model));
    if (const TriedSupport* answer = answer_of(support.found)) {
        std::vector<Condition> conditions;
        for (std::size_t index = 0; index < design.choices.size(); ++index) {
            conditions.push_back({design.choices[index].input, answer->values[index], design.choices[index].dimension});
        }
        file.model = with_conditions(file.model, conditions);
    }
    return support;
}

void add_to_head(const DesignedSupport& support, HeadCard& head) {
    constexpr std::size_t most_sentences = 3;
    if (answer_of(support.found) != nullptr && head.sentences.front().starts_with("FS ")) {
        head.sentences.front() = "With these bolts " + head.sentences.front();
    }
    head.sentences.insert(head.sentences.begin() + 1, support.sentence);
    head.sentences.resize(std::min(head.sentences.size(), most_sentences));
}

Json document_support(const DesignedSupport& support, const Sheet& sheet) {
    const SupportDesignResult& found = support.found;
    const TriedSupport* answer = answer_of(found);
    sheet.add(Heading{"Support"});
    sheet.add(Paragraph{support.sentence});
    if (answer != nullptr) {
        sheet.draw(cost_figure(support, *answer), "support",
                   "Patterns in the order of their cost, up to the first that gives the factor of safety; "
                   "support.csv has each.");
    }
    sheet.write("support.csv", support_csv(support));
    Json json;
    json["status"] = found.cheapest ? "found" : answer != nullptr ? "never_reached" : "no_answer";
    json["patterns"] = found.patterns;
    json["tried"] = found.tried.size();
    if (!found.failed_by_cause.empty()) {
        Table table{"Patterns without an answer", {{"why"}, {"patterns", true}}, {}};
        for (const auto& [cause, count] : found.failed_by_cause) {
            table.rows.push_back({human_name(cause), std::to_string(count)});
            json["failed_patterns"][cause] = count;
        }
        sheet.add(std::move(table));
    }
    if (answer == nullptr) {
        return json;
    }
    for (std::size_t index = 0; index < answer->values.size(); ++index) {
        const SupportChoice& choice = support.design.choices[index];
        json[column_name(choice.input, choice.dimension)] = json_of(answer->values[index], choice.dimension);
    }
    json["cost_per_metre_of_slope"] = json_number(answer->cost);
    json["factor_of_safety"] = json_number(*answer->factor_of_safety);
    return json;
}

}  // namespace delabole
