#include "cases/program/sweeps/support_report.hpp"

#include "fitting/work/words.hpp"
#include "plots/drawing/text.hpp"

namespace delabole {

namespace {

const TriedSupport& answer_of(const SupportDesignResult& found) {
    return found.tried[found.cheapest.value_or(found.strongest.value())];
}

Figure cost_figure(const DesignedSupport& support) {
    Figure figure;
    figure.title = "Support by its cost";
    figure.x = {.title = "cost per metre of slope"};
    figure.y = {.title = "factor of safety"};
    Points tried;
    tried.legend = "patterns that were tried";
    tried.colour = Colour::grey;
    tried.size = 0.6;
    for (const TriedSupport& pattern : support.found.tried) {
        if (pattern.factor_of_safety) {
            tried.points.emplace_back(pattern.cost, *pattern.factor_of_safety);
        }
    }
    const TriedSupport& answer = answer_of(support.found);
    Line required;
    required.legend = "required";
    required.dash = Dash::dashed;
    required.points = {{support.found.tried.front().cost, support.design.factor_of_safety},
                       {support.found.tried.back().cost, support.design.factor_of_safety}};
    Points chosen{.points = {{answer.cost, *answer.factor_of_safety}},
                  .legend = support.found.cheapest ? "cheapest that suffices" : "strongest",
                  .colour = Colour::vermilion};
    figure.series = {tried, required, chosen};
    return figure;
}

std::string support_csv(const DesignedSupport& support) {
    std::vector<std::string> titles;
    for (const SupportChoice& choice : support.design.choices) {
        titles.push_back(column_name(choice.input, choice.dimension));
    }
    titles.insert(titles.end(), {"cost_per_metre_of_slope", "factor_of_safety", "no_answer_because"});
    CsvTable csv(titles);
    for (const TriedSupport& pattern : support.found.tried) {
        std::vector<std::variant<double, std::string>> row;
        for (std::size_t index = 0; index < pattern.values.size(); ++index) {
            row.emplace_back(in_display_unit(pattern.values[index], support.design.choices[index].dimension));
        }
        row.emplace_back(pattern.cost);
        row.emplace_back(pattern.factor_of_safety ? std::variant<double, std::string>(*pattern.factor_of_safety)
                                                  : std::variant<double, std::string>(std::string()));
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
    const SupportDesign& design = *file.support_design;
    DesignedSupport support{design, design_support(interface_of(file.model), design, watch), {}};
    if (!support.found.strongest) {
        return std::nullopt;
    }
    const TriedSupport& answer = answer_of(support.found);
    support.sentence = support_in_words(design, support.found, answer);
    std::vector<Condition> conditions;
    for (std::size_t index = 0; index < design.choices.size(); ++index) {
        conditions.push_back({design.choices[index].input, answer.values[index], design.choices[index].dimension});
    }
    file.model = with_conditions(file.model, conditions);
    return support;
}

void add_to_head(const DesignedSupport& support, HeadCard& head) {
    constexpr std::size_t most_sentences = 3;
    head.sentences.insert(head.sentences.begin() + 1, support.sentence);
    head.sentences.resize(std::min(head.sentences.size(), most_sentences));
}

Json document_support(const DesignedSupport& support, const ResultFolder& folder, Report& report) {
    const TriedSupport& answer = answer_of(support.found);
    report.blocks.emplace_back(Heading{"Support"});
    report.blocks.emplace_back(Paragraph{support.sentence});
    report.blocks.emplace_back(
        folder.draw(cost_figure(support), "support",
                    "Patterns in the order of their cost, up to the first that gives the factor of safety; support.csv "
                    "has each."));
    if (!support.found.failed_by_cause.empty()) {
        Table table{"Patterns without an answer", {{"why"}, {"patterns", true}}, {}};
        for (const auto& [cause, count] : support.found.failed_by_cause) {
            table.rows.push_back({human_name(cause), std::to_string(count)});
        }
        report.blocks.emplace_back(std::move(table));
    }
    folder.write("support.csv", support_csv(support));
    Json json;
    json["status"] = support.found.cheapest ? "found" : "never_reached";
    json["patterns"] = support.found.patterns;
    json["tried"] = support.found.tried.size();
    for (std::size_t index = 0; index < answer.values.size(); ++index) {
        const SupportChoice& choice = support.design.choices[index];
        json[column_name(choice.input, choice.dimension)] =
            json_number(in_display_unit(answer.values[index], choice.dimension));
    }
    json["cost_per_metre_of_slope"] = json_number(answer.cost);
    json["factor_of_safety"] = json_number(*answer.factor_of_safety);
    return json;
}

}  // namespace delabole
