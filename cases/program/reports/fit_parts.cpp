#include "cases/program/reports/fit_parts.hpp"

#include "cases/program/reader/units.hpp"
#include "cases/program/reports/sensitivity_parts.hpp"
#include "fitting/work/words.hpp"
#include "plots/drawing/text.hpp"
#include "plots/figures/study_figures.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace delabole {

const ProfileLikelihood* profile_of(const MechanismFit& fit, const std::string& parameter, bool with_priors) {
    const auto found = std::ranges::find_if(fit.profiles, [&](const ProfileLikelihood& profile) {
        return profile.parameter == parameter && profile.with_priors == with_priors;
    });
    return found == fit.profiles.end() ? nullptr : &*found;
}

std::string interval_in_words(const ProfileLikelihood* profile, const FreeParameter& parameter, Dimension dimension) {
    if (profile == nullptr) {
        return "";
    }
    const auto end = [&](double value, double bound) {
        return value_in_words(value, dimension) + (value == bound ? " (bound)" : "");
    };
    return end(profile->interval_95.lower, parameter.lower) + " to " + end(profile->interval_95.upper, parameter.upper);
}

std::string misfit_in_words(double misfit) {
    constexpr double unseen = 1e-6;  // a thousandth of a standard deviation
    return misfit < unseen ? "0" : number_in_words(misfit);
}

std::string title_of(const MechanismFit& fit) {
    return fit.title.empty() ? fit.name : fit.title;
}

std::string short_name(const MechanismFit& fit, const std::string& name) {
    const std::string ending = name.substr(name.rfind('.') + 1);
    const auto alike = std::ranges::count_if(fit.parameters, [&](const FreeParameter& parameter) {
        return parameter.name == ending || parameter.name.ends_with("." + ending);
    });
    return human_name(alike == 1 ? ending : name);
}

std::string screen_of(const Table& table, std::vector<std::string> titles) {
    std::vector<std::vector<std::string>> rows = {std::move(titles)};
    rows.insert(rows.end(), table.rows.begin(), table.rows.end());
    for (std::vector<std::string>& row : rows) {
        row.front().insert(0, "  ");
    }
    return table.rows.empty() ? "" : text_table(rows);
}

namespace {

// Returns the verdict, in sentences that begin with a capital, with the names that the sentence on the values uses.
std::string verdict_in_short_names(const MechanismFit& fit) {
    std::vector<std::string> names;
    for (const FreeParameter& parameter : fit.parameters) {
        names.push_back(parameter.name);
    }
    // Longer names come first, since a name may begin like another one.
    std::ranges::sort(names, std::greater{}, [](const std::string& name) { return name.size(); });
    const std::string& verdict = fit.identifiability.verdict;
    std::string text;
    for (std::size_t place = 0; place < verdict.size();) {
        const auto name = std::ranges::find_if(
            names, [&](const std::string& one) { return verdict.compare(place, one.size(), one) == 0; });
        if (name == names.end()) {
            text += verdict[place++];
            continue;
        }
        const std::string own = short_name(fit, *name);
        text += text.empty() || text.ends_with(". ") ? capitalised(own) : own;
        place += name->size();
    }
    return text;
}

std::string determined_in_words(const MechanismFit& fit) {
    const std::size_t count = fit.parameters.size();
    const auto rank = static_cast<std::size_t>(fit.identifiability.rank);
    if (count == 1) {
        return rank == 1 ? "The data determine its parameter near the best point"
                         : "The data do not determine its parameter";
    }
    const std::string what = rank >= count ? "all"
                             : rank == 0   ? "none"
                             : rank == 1   ? "one combination"
                                           : std::to_string(rank) + " combinations";
    return "The data determine " + what + " of its " + std::to_string(count) + " parameters" +
           (rank >= count ? " near the best point" : "");
}

// "30.9 deg to 39.6 deg" or "at most 12.1 kPa": an end at a bound of the search is not stated.
std::string range_in_words(const ProfileLikelihood* profile, const FreeParameter& parameter, Dimension dimension) {
    if (profile == nullptr) {
        return "";
    }
    const double lower = profile->interval_95.lower;
    const double upper = profile->interval_95.upper;
    const bool from_bound = lower == parameter.lower;
    const bool to_bound = upper == parameter.upper;
    if (from_bound && to_bound) {
        return "anywhere within its bounds";
    }
    return (from_bound ? "at most " + value_in_words(upper, dimension)
            : to_bound ? "at least " + value_in_words(lower, dimension)
                       : value_in_words(lower, dimension) + " to " + value_in_words(upper, dimension)) +
           " with 95 %";
}

// Lists only the first parameters, because a case names the most important ones first.
std::string values_in_words(const MechanismFit& fit, std::size_t most) {
    std::vector<std::string> values;
    for (std::size_t index = 0; index < std::min(most, fit.best.size()); ++index) {
        const FreeParameter& parameter = fit.parameters[index];
        const std::string range =
            range_in_words(profile_of(fit, parameter.name, true), parameter, fit.dimensions[index]);
        values.push_back(short_name(fit, parameter.name) + " " +
                         value_in_words(fit.best[index], fit.dimensions[index]) +
                         (range.empty() ? "" : " (" + range + ")"));
    }
    return list_in_words(values);
}

}  // namespace

HeadCard head_card(const FitResult& result) {
    HeadCard head{AnswerTone::open, {}, {}};
    if (result.mechanisms.empty()) {
        return head;
    }
    const MechanismFit& best = result.mechanisms.front();
    const bool with_priors = std::ranges::any_of(
        best.parameters, [](const FreeParameter& parameter) { return parameter.prior.has_value(); });
    if (best.best.empty() && !best.parameters.empty()) {
        head.sentences.emplace_back("No mechanism has an answer within the bounds of its parameters.");
        return head;
    }
    if (result.mechanisms.size() == 1) {
        constexpr std::size_t most = 3;
        if (const std::string values = values_in_words(best, most); !values.empty()) {
            head.sentences.push_back("Best fit" + std::string(with_priors ? " with the priors" : "") + ": " + values +
                                     ".");
        }
        head.sentences.push_back(verdict_in_short_names(best));
        return head;
    }
    const std::string probability = probability_of_best(result);
    const std::string count = std::to_string(result.mechanisms.size());
    const std::string with_probability = probability.empty() ? "" : ", with a probability of " + probability;
    // If other priors would put another mechanism first, the first sentence says so and names no best explanation.
    if (const std::string others = first_under_other_priors(result); !others.empty()) {
        head.sentences.push_back("Which of the " + count + " compared explains best depends on what was put in: " +
                                 best.name + " as given" + with_probability + ", " + others + ".");
    } else {
        head.sentences.push_back("Best explanation of the " + count + " compared" + with_probability + ": " +
                                 title_of(best) + ".");
        if (const std::string dependence = dependence_of_ranking(result); !dependence.empty()) {
            head.sentences.push_back(dependence);
        }
    }
    const std::string values = values_in_words(best, 2);
    head.sentences.push_back(determined_in_words(best) +
                             (values.empty() ? ""
                              : with_priors  ? "; with the priors they give " + values
                                             : "; they give " + values) +
                             ".");
    return head;
}

namespace {

Table minima_table(const MechanismFit& fit) {
    Table table{"Minima found by the starts", {"misfit"_number, "starts"_number}};
    for (const FreeParameter& parameter : fit.parameters) {
        table.columns.emplace_back(parameter.name, true);
    }
    for (const MinimumCluster& minimum : fit.minima) {
        std::vector<std::string> row = {misfit_in_words(minimum.misfit), std::to_string(minimum.hits)};
        for (std::size_t index = 0; index < minimum.parameters.size(); ++index) {
            row.push_back(value_in_words(minimum.parameters[index], fit.dimensions[index]));
        }
        table.rows.push_back(std::move(row));
    }
    return table;
}

Table direction_table(const Identifiability& identifiability) {
    Table table{
        "Directions in the space of the parameters, scaled by their bounds, best determined first. Determined "
        "are those with a singular value above 0.5: moving along them through the whole range changes the data "
        "by more than half a standard deviation",
        {"singular value"_number}};
    for (const std::string& name : identifiability.parameters) {
        table.columns.emplace_back(name, true);
    }
    for (std::size_t column = 0; column < identifiability.singular_values.size(); ++column) {
        const auto rounded = [](double value) { return number_in_words(std::abs(value) < 1e-6 ? 0 : value); };
        std::vector<std::string> cells = {rounded(identifiability.singular_values[column])};
        for (std::size_t row = 0; row < identifiability.parameters.size(); ++row) {
            cells.push_back(
                rounded(identifiability.directions(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column))));
        }
        table.rows.push_back(std::move(cells));
    }
    return table;
}

Table correlation_table(const MechanismFit& fit) {
    const Identifiability& identifiability = fit.identifiability;
    Table table{"Standard deviations and correlations, data and priors together, linear at the best point",
                {"parameter", "standard deviation"_number}};
    for (const std::string& name : identifiability.parameters) {
        table.columns.emplace_back(name, true);
    }
    const Eigen::MatrixXd& correlation = *identifiability.correlation;
    for (Eigen::Index row = 0; row < correlation.rows(); ++row) {
        const std::string& name = identifiability.parameters[static_cast<std::size_t>(row)];
        const Dimension dimension = fit.dimension_of(name);
        std::vector<std::string> cells = {
            name, value_in_words(std::sqrt((*identifiability.covariance)(row, row)), dimension)};
        for (Eigen::Index column = 0; column < correlation.cols(); ++column) {
            cells.push_back(number_in_words(correlation(row, column)));
        }
        table.rows.push_back(std::move(cells));
    }
    return table;
}

}  // namespace

Folded knowledge_of(const MechanismFit& fit, const ResultFolder& folder) {
    Folded folded{"How well its parameters are known", {}};
    FigureRow profiles;
    for (std::size_t index = 0; index < fit.parameters.size(); ++index) {
        const std::string& name = fit.parameters[index].name;
        if (const auto profile = profile_likelihood_figure(fit, name)) {
            profiles.figures.push_back(folder.draw(*profile, fit.name + "_profile_" + std::to_string(index + 1),
                                                   "Profile likelihood of " + name + "."));
        }
    }
    if (!profiles.figures.empty()) {
        folded.blocks.emplace_back(std::move(profiles));
    }
    if (!fit.identifiability.singular_values.empty()) {
        folded.blocks.emplace_back(direction_table(fit.identifiability));
    }
    if (fit.identifiability.correlation && fit.identifiability.covariance) {
        folded.blocks.emplace_back(correlation_table(fit));
    }
    folded.blocks.emplace_back(minima_table(fit));
    folded.blocks.emplace_back(Paragraph{evaluations_in_words(fit.evaluations)});
    return folded;
}

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
        text += " By the surrogate the evidence may be wrong by " + in_percent(surrogate.evidence_error) +
                ", if predictions change smoothly between runs.";
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
