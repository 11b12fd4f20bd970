#include "cases/program/reports/study_reports.hpp"

#include "fitting/work/words.hpp"
#include "plots/figures/study_figures.hpp"

#include <algorithm>

namespace delabole {

namespace {

// "34 +- 2 %", with two standard errors.
std::string share_in_words(const ExpectedReduction& share) {
    return number_in_words(100 * share.value) + " \u00b1 " + number_in_words(200 * share.error) + " %";
}

std::string reductions_in_words(const std::vector<ParameterInformation>& parameters) {
    std::vector<std::string> items;
    for (const ParameterInformation& parameter : parameters) {
        items.push_back(parameter.parameter + " " + share_in_words(parameter.standard_deviation));
    }
    return items.empty() ? "nothing" : list_in_words(items);
}

const ParameterInformation* most_of(const CandidateInformation& candidate) {
    const auto most = std::ranges::max_element(
        candidate.over_mechanisms, {}, [](const ParameterInformation& one) { return one.standard_deviation.value; });
    return most == candidate.over_mechanisms.end() ? nullptr : &*most;
}

Json json_of(const ExpectedReduction& share) {
    Json json;
    json["value"] = json_number(share.value);
    json["standard_error"] = json_number(share.error);
    return json;
}

Json json_of(const std::vector<ParameterInformation>& parameters) {
    Json json = Json::object();
    for (const ParameterInformation& parameter : parameters) {
        json[parameter.parameter]["standard_deviation"] = json_of(parameter.standard_deviation);
        json[parameter.parameter]["interval_95"] = json_of(parameter.interval_95);
    }
    return json;
}

std::string written(const MechanismInformation& mechanism) {
    switch (mechanism.status) {
    case InformationStatus::found:
        return reductions_in_words(mechanism.parameters);
    case InformationStatus::not_predicted:
        return "says nothing about it";
    case InformationStatus::few_answers:
        return "has an answer at " + number_in_words(100 * (1 - mechanism.without_answer)) + " % of the draws only";
    case InformationStatus::few_draws_alike:
        break;
    }
    return reductions_in_words(mechanism.parameters) + "; sharper than the draws can tell (" +
           number_in_words(mechanism.effective_draws) + " of them keep a weight)";
}

void add_rows(const CandidateInformation& candidate, CsvTable& csv) {
    const auto add = [&](const std::string& mechanism, const std::string& status,
                         const std::vector<ParameterInformation>& parameters) {
        for (const ParameterInformation& parameter : parameters) {
            csv.add_row({candidate.label, mechanism, status, parameter.parameter, parameter.standard_deviation.value,
                         parameter.standard_deviation.error, parameter.interval_95.value, parameter.interval_95.error});
        }
    };
    add("all", "", candidate.over_mechanisms);
    for (const MechanismInformation& mechanism : candidate.mechanisms) {
        add(mechanism.mechanism, std::string(word_of(mechanism.status)), mechanism.parameters);
    }
}

}  // namespace

StudyDocuments document_information(const std::vector<FitCandidate>& candidates,
                                    const std::vector<CandidateInformation>& information, const Sheet& sheet) {
    StudyDocuments documents;
    sheet.add(Heading{"What to measure next"});
    sheet.draw(information_figure(information), "value_of_information",
               "Expected reduction of each parameter's posterior standard deviation, mechanisms weighted by their "
               "probabilities. Outcomes of the measurement are simulated from the posterior, and the posterior is "
               "weighted anew with each; a mechanism that says nothing about the quantity gains nothing.");
    Table table{"Expected reduction of standard deviations, two standard errors either way",
                {"measurement", "error", "most", "about the mechanism, nats"_number, "cost"_number}};
    Table by_mechanism{"By mechanism", {{"measurement"}, {"mechanism"}, {"expected reduction"}}};
    CsvTable csv({"candidate", "mechanism", "status", "parameter", "standard_deviation_reduction",
                  "standard_deviation_reduction_error", "interval_95_reduction", "interval_95_reduction_error"});
    std::vector<std::vector<std::string>> screen{{"what to measure next", "reduces most", "by"}};
    for (std::size_t index = 0; index < information.size(); ++index) {
        const CandidateInformation& candidate = information[index];
        const ParameterInformation* most = most_of(candidate);
        const std::string about = candidate.about_mechanism
                                      ? number_in_words(candidate.about_mechanism->value) + " \u00b1 " +
                                            number_in_words(2 * candidate.about_mechanism->error)
                                      : "one mechanism predicts it at most";
        const auto& cost = candidates[index].cost;
        table.rows.push_back({candidate.label, candidates[index].source,
                              most == nullptr ? "" : most->parameter + " " + share_in_words(most->standard_deviation),
                              about, cost ? number_in_words(*cost) : ""});
        if (most != nullptr) {
            screen.push_back({candidate.label, most->parameter, share_in_words(most->standard_deviation)});
        }
        Json& json = documents.json[candidate.label];
        json["over_mechanisms"] = json_of(candidate.over_mechanisms);
        if (candidate.about_mechanism) {
            json["about_mechanism_nats"] = json_of(*candidate.about_mechanism);
        }
        if (cost) {
            json["cost"] = *cost;
        }
        for (const MechanismInformation& mechanism : candidate.mechanisms) {
            Json& own = json["mechanisms"][mechanism.mechanism];
            put<&MechanismInformation::status, &MechanismInformation::effective_draws,
                &MechanismInformation::without_answer>(own, mechanism);
            own["parameters"] = json_of(mechanism.parameters);
            by_mechanism.rows.push_back({candidate.label, mechanism.mechanism, written(mechanism)});
        }
        add_rows(candidate, csv);
    }
    sheet.write("value_of_information.csv", csv.text());
    sheet.add(std::move(table));
    sheet.add(std::move(by_mechanism));
    documents.screen = '\n' + text_table(screen);
    return documents;
}

}  // namespace delabole
