#include "cases/program/reports/fit_parts.hpp"

#include "cases/program/reader/units.hpp"
#include "fitting/work/words.hpp"

#include <algorithm>
#include <cmath>

namespace delabole {

namespace {

std::string in_percent(double share) {
    return number_in_words(std::round(1000 * share) / 10) + " %";
}

std::size_t runs_without_answer(const SurrogateFit& surrogate) {
    return static_cast<std::size_t>(
        std::ranges::count_if(surrogate.runs, [](const SurrogateFit::Run& run) { return !run.failure.empty(); }));
}

}  // namespace

std::string surrogate_in_words(const MechanismFit& fit) {
    const SurrogateFit& surrogate = *fit.surrogate;
    const auto hopeless = std::ranges::count_if(surrogate.runs, &SurrogateFit::Run::coarse);
    std::string text =
        "Fitted through a surrogate of " + std::to_string(surrogate.runs.size()) + " runs, " +
        std::to_string(runs_without_answer(surrogate)) +
        " of them without an answer: " + std::to_string(surrogate.components) +
        " smooth functions of the parameters. Each run predicted " + "from the others is missed by " +
        number_in_words(surrogate.error) + " standard deviations of the data, within its own 95 % band in " +
        in_percent(surrogate.within_95) + " of the cases; " +
        (surrogate.jump ? "what runs differ by beyond that comes to " : "runs that ought to be alike differ by ") +
        number_in_words(surrogate.scatter) + (surrogate.jump ? "." : ", which no parameter decides.");
    if (surrogate.coarse_runs > 0) {
        text += " Of " + std::to_string(surrogate.coarse_runs) + " coarse runs made beforehand " +
                std::to_string(hopeless) + " were so far from the data that no full run was made in their place.";
    }
    if (surrogate.given_up) {
        text +=
            " No more runs were made: even with twice its error its evidence is beyond reach of another "
            "mechanism's. fit.surrogate.give_up_below = 0 would go on; until then the intervals are rough.";
    } else if (fit.identifiability.status == IdentifiabilityStatus::run_contradicts) {
        text += " The evidence is not known: the surrogate is not the model where it fits best.";
    } else if (surrogate.evidence_error <= 0.5) {
        text += " By the surrogate the evidence may be wrong by " + in_percent(surrogate.evidence_error) + " at most.";
    } else {
        constexpr double worth_a_number = 1000;
        text += " The evidence is not known from so few runs: by the surrogate it may be wrong by " +
                (surrogate.evidence_error < worth_a_number
                     ? "a factor of " + number_in_words(std::ceil(1 + surrogate.evidence_error))
                     : "any factor") +
                ". fit.surrogate.runs allows for more.";
    }
    if (std::isfinite(surrogate.misfit_of_run)) {
        text += " Data misfit at the best point: " + number_in_words(fit.data_misfit) + " by the surrogate, " +
                number_in_words(surrogate.misfit_of_run) + " of the run made there.";
    } else {
        text += " The run at the best point has no answer.";
    }
    if (surrogate.jump) {
        std::vector<std::string> place;
        for (std::size_t index = 0; index < fit.parameters.size(); ++index) {
            place.push_back(fit.parameters[index].name + " " +
                            value_in_words(surrogate.jump->at[index], fit.dimensions[index]));
        }
        text +=
            " The model jumps at " + list_in_words(place) + ", which no smooth function follows: two runs there are " +
            number_in_words(surrogate.jump->difference) + " standard deviations of the data apart, their parameters " +
            number_in_words(100 * surrogate.jump->distance) + " % of the ranges.";
    }
    return text;
}

Json json_of_surrogate(const MechanismFit& fit) {
    const SurrogateFit& surrogate = *fit.surrogate;
    Json json;
    json["runs"] = surrogate.runs.size();
    json["coarse_runs"] = surrogate.coarse_runs;
    json["hopeless_points"] = std::ranges::count_if(surrogate.runs, &SurrogateFit::Run::coarse);
    json["runs_without_answer"] = runs_without_answer(surrogate);
    put<&SurrogateFit::components, &SurrogateFit::error, &SurrogateFit::within_95, &SurrogateFit::scatter,
        &SurrogateFit::evidence_error, &SurrogateFit::given_up, &SurrogateFit::misfit_of_run>(json, surrogate);
    if (surrogate.jump) {
        Json& jump = json["jump"];
        for (std::size_t index = 0; index < fit.parameters.size(); ++index) {
            jump["at"][column_name(fit.parameters[index].name, fit.dimensions[index])] =
                json_of(surrogate.jump->at[index], fit.dimensions[index]);
        }
        jump["share_of_ranges"] = surrogate.jump->distance;
        jump["standard_deviations"] = surrogate.jump->difference;
    }
    return json;
}

void write_runs(const MechanismFit& fit, const ResultFolder& folder) {
    std::vector<std::string> columns = {"run"};
    for (std::size_t index = 0; index < fit.parameters.size(); ++index) {
        columns.push_back(column_name(fit.parameters[index].name, fit.dimensions[index]));
    }
    columns.insert(columns.end(), {"data_misfit", "failure", "model"});
    CsvTable table(columns);
    for (std::size_t number = 0; number < fit.surrogate->runs.size(); ++number) {
        const SurrogateFit::Run& run = fit.surrogate->runs[number];
        std::vector<Cell> row = {static_cast<double>(number + 1)};
        for (std::size_t index = 0; index < run.parameters.size(); ++index) {
            row.emplace_back(in_display_unit(run.parameters[index], fit.dimensions[index]));
        }
        if (run.failure.empty()) {
            row.emplace_back(run.data_misfit);
        } else {
            row.emplace_back(std::string());
        }
        row.emplace_back(run.failure);
        row.emplace_back(std::string(run.coarse ? "coarse" : "full"));
        table.add_row(row);
    }
    folder.write(fit.name + "_runs.csv", table.text());
}

}  // namespace delabole
