#include "cases/program/reports/study_reports.hpp"

#include "cases/program/case/case_writer.hpp"
#include "cases/program/reader/units.hpp"
#include "cases/program/reports/fit_parts.hpp"
#include "cases/program/reports/sensitivity_parts.hpp"
#include "cases/program/results/analysis.hpp"
#include "cases/program/results/model_reports.hpp"
#include "fitting/work/words.hpp"
#include "plots/drawing/text.hpp"
#include "plots/figures/study_figures.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace delabole {

namespace {

// The parameters whose ranges end the interval at either side; a table has no room for several names.
std::string ranges_in_words(const MechanismFit& fit, const ProfileLikelihood& profile) {
    std::vector<std::string> names;
    for (const FreeParameter& parameter : fit.parameters) {
        const auto among = [&](const std::vector<std::string>& all) {
            return std::ranges::find(all, parameter.name) != all.end();
        };
        if (among(profile.lower_bounded_by) || among(profile.upper_bounded_by)) {
            names.push_back(short_name(fit, parameter.name));
        }
    }
    return names.size() > 1 ? "other ranges" : "the range of " + list_in_words(names);
}

std::string determination_in_words(const MechanismFit& fit, const ProfileLikelihood* profile) {
    if (profile == nullptr) {
        return "";
    }
    const std::string words = words_for(
        profile->determination,
        {"determined", "only a lower limit", "only an upper limit", "not identifiable", "doubtful: see the verdict"});
    if (profile->determination == Determination::doubtful ||
        (profile->lower_bounded_by.empty() && profile->upper_bounded_by.empty())) {
        return words;
    }
    return profile->determination == Determination::undetermined
               ? "bounded only by " + ranges_in_words(fit, *profile)
               : words + ": the other end is due to " + ranges_in_words(fit, *profile);
}

std::string data_misfit_in_words(const MechanismFit& fit) {
    std::string misfit = misfit_in_words(fit.data_misfit);
    if (!fit.surrogate || fit.best.empty()) {
        return misfit;
    }
    const double run = fit.surrogate->misfit_of_run;
    return misfit + " (run there: " + (std::isfinite(run) ? misfit_in_words(run) : "no answer") + ")";
}

Table ranking_table(const FitResult& result) {
    Table table{"Mechanisms, best first",
                {"mechanism", "score"_number, "data misfit"_number, "prior misfit"_number, "data"_number,
                 "unexplained"_number, "status"}};
    for (const MechanismFit& fit : result.mechanisms) {
        table.rows.push_back({title_of(fit), misfit_in_words(fit.ranking_score), data_misfit_in_words(fit),
                              misfit_in_words(fit.prior_misfit), std::to_string(fit.data_count),
                              std::to_string(fit.unexplained.size()), std::string(word_of(fit.status))});
    }
    return table;
}

Table parameter_table(const MechanismFit& fit) {
    Table table{"Fitted parameters (read the verdict first)",
                {"parameter", "best"_number, "95 % range with priors"_number, "95 % range from the data alone"_number,
                 "the data alone"}};
    for (std::size_t index = 0; index < fit.best.size(); ++index) {
        const std::string& name = fit.parameters[index].name;
        const Dimension dimension = fit.dimensions[index];
        const ProfileLikelihood* data_only = profile_of(fit, name, false);
        table.rows.push_back({name, value_in_words(fit.best[index], dimension),
                              interval_in_words(profile_of(fit, name, true), fit.parameters[index], dimension),
                              interval_in_words(data_only, fit.parameters[index], dimension),
                              determination_in_words(fit, data_only)});
    }
    return table;
}

// Residuals below 5e-4 are shown as 0.
std::string residual_in_words(double residual) {
    return std::abs(residual) < 5e-4 ? "0" : number_in_words(residual);
}

std::string relation_in_words(Relation relation) {
    return relation == Relation::equal ? "" : relation == Relation::at_least ? "at least " : "at most ";
}

Table observation_table(const MechanismFit& fit) {
    Table table{"Observed and predicted",
                {"observation", "observed"_number, "standard deviation"_number, "predicted"_number,
                 "residual, standard deviations"_number, "source"}};
    for (const ObservationFit& row : fit.observations) {
        table.rows.push_back({row.label, relation_in_words(row.relation) + value_in_words(row.observed, row.dimension),
                              value_in_words(row.standard_deviation, row.dimension),
                              row.predicted ? value_in_words(*row.predicted, row.dimension) : "not predicted",
                              row.predicted ? residual_in_words(row.residual) : "", row.source});
    }
    if (fit.profile_fit) {
        table.rows.push_back({"post-failure profile (distance)", value_in_words(0, Dimension::length),
                              value_in_words(fit.profile_fit->standard_deviation, Dimension::length),
                              value_in_words(std::round(fit.profile_fit->rms * 1e3) / 1e3, Dimension::length),
                              residual_in_words(fit.profile_fit->residual()), ""});
    }
    return table;
}

Json json_of(const MechanismFit& fit) {
    Json json;
    put<&MechanismFit::name, &MechanismFit::status>(json, fit);
    json["verdict"] = fit.identifiability.verdict;
    json["identifiability"] = word_of(fit.identifiability.status);
    put<&Identifiability::rank, &Identifiability::singular_values>(json, fit.identifiability);
    json["directions"] = json_of_matrix(fit.identifiability.directions.transpose());
    put<&MechanismFit::ranking_score, &MechanismFit::data_misfit, &MechanismFit::prior_misfit>(json, fit);
    json["parameters"] = Json::object();
    for (std::size_t index = 0; index < fit.best.size(); ++index) {
        const std::string& name = fit.parameters[index].name;
        const Dimension dimension = fit.dimensions[index];
        Json& entry = json["parameters"][column_name(name, dimension)];
        entry["best"] = json_of(fit.best[index], dimension);
        for (const bool with_priors : {true, false}) {
            if (const ProfileLikelihood* profile = profile_of(fit, name, with_priors)) {
                put<&ProfileLikelihood::interval_68, &ProfileLikelihood::interval_95, &ProfileLikelihood::determination,
                    &ProfileLikelihood::lower_bounded_by, &ProfileLikelihood::upper_bounded_by>(
                    entry[with_priors ? "with_priors" : "data_only"], *profile, dimension);
            }
        }
    }
    json["rank_with_priors"] = fit.identifiability.rank_with_priors;
    json["observations"] = Json::array();
    for (const ObservationFit& row : fit.observations) {
        Json& entry = json["observations"].emplace_back();
        entry = {{"label", row.label}, {"quantity", column_name(row.quantity, row.dimension)}};
        put<&ObservationFit::relation, &ObservationFit::observed, &ObservationFit::predicted, &ObservationFit::scatter>(
            entry, row, row.dimension);
        put<&ObservationFit::residual>(entry, row);
    }
    if (fit.profile_fit) {
        json["profile_rms_m"] = fit.profile_fit->rms;
        json["profile_scatter_m"] = fit.profile_fit->scatter;
    }
    json["scatter_cost"] = fit.scatter_cost;
    json["minima"] = Json::array();
    for (const MinimumCluster& minimum : fit.minima) {
        Json entry;
        entry["misfit"] = json_number(minimum.misfit);
        entry["starts"] = minimum.hits;
        for (std::size_t index = 0; index < minimum.parameters.size(); ++index) {
            entry[column_name(fit.parameters[index].name, fit.dimensions[index])] =
                json_of(minimum.parameters[index], fit.dimensions[index]);
        }
        json["minima"].push_back(std::move(entry));
    }
    if (fit.identifiability.correlation) {
        json["correlation_with_priors"] = json_of_matrix(*fit.identifiability.correlation);
    }
    if (fit.surrogate) {
        json["surrogate"] = json_of_surrogate(fit);
    }
    put<&MechanismFit::explained, &MechanismFit::unexplained>(json, fit);
    if (fit.posterior) {
        json["posterior"] = json_of_posterior(fit);
    }
    json["evaluations"] = fit.evaluations.total;
    json["failed_evaluations"] = json_of(fit.evaluations)["without_answer"];
    return json;
}

void write_tables(const MechanismFit& fit, const ResultFolder& folder) {
    CsvTable profiles({"parameter", "with_priors", "value", "unit", "misfit"});
    const auto rounded = [](double value, double scale) { return std::abs(value) < scale ? 0 : value; };
    for (const ProfileLikelihood& profile : fit.profiles) {
        const Dimension dimension = fit.dimension_of(profile.parameter);
        const double range =
            profile.values.empty() ? 0 : 1e-12 * std::abs(profile.values.back() - profile.values.front());
        for (std::size_t point = 0; point < profile.values.size(); ++point) {
            profiles.add_row({profile.parameter, profile.with_priors ? "yes" : "no",
                              in_display_unit(rounded(profile.values[point], range), dimension),
                              std::string(display_unit(dimension).symbol),
                              rounded(profile.misfits[point], 1e-10)});  // 1e-5 standard deviations
        }
    }
    folder.write(fit.name + "_profiles.csv", profiles.text());
    CsvTable observations(
        {"label", "quantity", "relation", "observed", "predicted", "standard_deviation", "unit", "residual"});
    for (const ObservationFit& row : fit.observations) {
        const Cell predicted = row.predicted ? Cell(in_display_unit(*row.predicted, row.dimension)) : Cell("");
        observations.add_row({row.label, row.quantity, std::string(word_of(row.relation)),
                              in_display_unit(row.observed, row.dimension), predicted,
                              in_display_unit(row.standard_deviation, row.dimension),
                              std::string(display_unit(row.dimension).symbol), row.residual});
    }
    folder.write(fit.name + "_observations.csv", observations.text());
}

CaseModel at_best_point(const MechanismFit& fit, const CaseModel& model) {
    std::vector<Condition> best;
    for (std::size_t index = 0; index < fit.best.size(); ++index) {
        best.push_back({fit.parameters[index].name, fit.best[index]});
        for (const std::string& name : fit.parameters[index].also) {
            best.push_back({name, fit.best[index]});
        }
    }
    return with_conditions(model, best);
}

// Figures of the mechanism's own model at the best point, and a case with which `run` shows everything else about it.
void append_best_point(const Sheet& sheet, const MechanismFit& fit, const CaseModel& model, const FitProblem& problem) {
    if (fit.best.empty()) {
        return;
    }
    CaseFile best;
    best.title = title_of(fit) + ", at the best point of the fit";
    best.model = at_best_point(fit, model);
    sheet.write(fit.name + "_best.toml", resolved_toml(best));
    std::visit([&](const auto& at_best) { append_mechanism_figures(at_best, fit, problem, sheet); }, best.model);
}

// Misfit over the first two parameters; nothing if the fit holds no map.
std::optional<FigureInReport> map_of(const MechanismFit& fit, const ResultFolder& folder) {
    const auto map = misfit_map_figure(fit);
    return map ? std::optional(folder.draw(*map, fit.name + "_misfit_map",
                                           "Misfit (data and priors) over the first two parameters with the joint 68 "
                                           "and 95 % regions. Any further parameter is held at the best point, which "
                                           "makes the regions smaller than they are; the profile likelihoods free it."))
               : std::nullopt;
}

Folded sampling_of(const MechanismFit& fit, const ResultFolder& folder) {
    Report posterior;
    append_posterior(fit, {folder, posterior});
    return {"Its posterior: draws and chains", std::move(posterior.blocks)};
}

// Everything about a mechanism except its first figure, which is added to `sections`.
void append_mechanism(const Sheet& sheet, const MechanismFit& fit, const CaseModel& model, const FitProblem& problem,
                      FigureRow& sections) {
    sheet.add(Heading{title_of(fit) == sheet.report.title ? "What was fitted" : title_of(fit)});
    sheet.add(Notice{NoticeKind::verdict, "What the data determine", {fit.identifiability.verdict}});
    if (fit.posterior && !fit.posterior->warnings.empty()) {
        sheet.add(Notice{NoticeKind::warning, "Before the intervals are believed", fit.posterior->warnings});
    }
    if (fit.best.empty() && !fit.parameters.empty()) {
        sheet.add(
            Notice{NoticeKind::warning,
                   "No answer",
                   {"the model has no answer anywhere within the bounds. " + evaluations_in_words(fit.evaluations)}});
        append_posterior(fit, sheet);
        return;
    }
    if (fit.status != FitStatus::converged) {
        sheet.add(Notice{NoticeKind::warning,
                         "Not converged",
                         {"status: " + std::string(word_of(fit.status)) + "; the best point seen is shown"}});
    }
    if (fit.surrogate) {
        sheet.add(Paragraph{surrogate_in_words(fit)});
        write_runs(fit, sheet.folder);
    }
    sheet.add(parameter_table(fit));
    sheet.add(observation_table(fit));
    if (!fit.explained.empty()) {
        sheet.add(Paragraph{"Field evidence explained: " + list_in_words(fit.explained) + "."});
    }
    if (!fit.unexplained.empty()) {
        sheet.add(Notice{NoticeKind::warning, "What it does not explain", fit.unexplained});
    }
    Report figures;
    append_best_point({sheet.folder, figures}, fit, model, problem);
    const auto first = std::ranges::find_if(
        figures.blocks, [](const ReportBlock& block) { return std::holds_alternative<FigureInReport>(block); });
    if (first != figures.blocks.end()) {
        sections.figures.push_back(std::move(std::get<FigureInReport>(*first)));
        sections.figures.back().caption.insert(0, title_of(fit) + ". ");
        figures.blocks.erase(first);
    }
    std::ranges::move(figures.blocks, std::back_inserter(sheet.report.blocks));
    sheet.add(knowledge_of(fit, sheet.folder));
    if (fit.posterior) {
        sheet.add(sampling_of(fit, sheet.folder));
    }
    write_tables(fit, sheet.folder);
}

std::string screen_of(const MechanismFit& fit, const std::string& title) {
    std::string text = title_of(fit) == title ? fit.name + "\n" : title_of(fit) + " [" + fit.name + "]\n";
    text += "  What the data determine: " + fit.identifiability.verdict + "\n";
    text += screen_of(parameter_table(fit), {"parameter", "best", "95 % with priors", "95 % data alone", ""});
    text += screen_of_posterior(fit);
    if (fit.surrogate && !fit.best.empty()) {
        text += "  " + surrogate_in_words(fit) + "\n";
    }
    text += "  misfit " + data_misfit_in_words(fit) + " of " + std::to_string(fit.data_count) + " data, priors " +
            misfit_in_words(fit.prior_misfit) + "; " + std::string(word_of(fit.status)) + "\n";
    for (const std::string& sentence : fit.unexplained) {
        text += "  does not explain: " + sentence + "\n";
    }
    return text;
}

// The toe's elevation in the case's own section; 0 if it has none.
double toe_elevation_of(const CaseModel& model) {
    for (const Quantity& input : named_inputs(model)) {
        if (input.name == "slope.toe_elevation") {
            return input.value;
        }
    }
    return 0;
}

const CaseModel& model_of(const CaseFile& file, const std::string& mechanism) {
    return std::ranges::find(file.fit->mechanisms, mechanism, &FitMechanism::name)->model;
}

}  // namespace

std::string status_of_fit(const FitResult& result) {
    const auto any = [&](FitStatus status) {
        return std::ranges::any_of(result.mechanisms, [&](const MechanismFit& fit) { return fit.status == status; });
    };
    if (any(FitStatus::interrupted)) {
        return "interrupted";
    }
    if (any(FitStatus::no_valid_point)) {
        return "no_valid_point";
    }
    if (any(FitStatus::evaluation_limit)) {
        return "evaluation_limit";
    }
    const bool posterior_open = std::ranges::any_of(result.mechanisms, [](const MechanismFit& fit) {
        return fit.posterior && fit.posterior->posterior.status != PosteriorStatus::converged;
    });
    return posterior_open ? "posterior_not_converged" : "converged";
}

Json json_of_fit(const CaseFile& file, const FitResult& result) {
    Json json;
    json["status"] = status_of_fit(result);
    json["title"] = file.title;
    json["mechanisms"] = Json::array();
    for (const MechanismFit& fit : result.mechanisms) {
        json["mechanisms"].push_back(json_of(fit));
    }
    json["evidence"] = json_of_evidence(result);
    return json;
}

StudyDocuments document_fit(const CaseFile& file, const FitProblem& problem, const FitResult& result,
                            const Sheet& sheet) {
    StudyDocuments documents{json_of_fit(file, result), {}, {}};
    HeadCard head = head_card(result);
    FigureRow sections;
    Report details{sheet.report.title, {}, {}};
    for (const MechanismFit& fit : result.mechanisms) {
        append_mechanism({sheet.folder, details}, fit, model_of(file, fit.name), problem, sections);
        if (&fit != &result.mechanisms.front()) {
            if (const auto map = map_of(fit, sheet.folder)) {
                details.add(*map);
            }
        }
        documents.screen += screen_of(fit, sheet.report.title) + "\n";
    }
    documents.details = std::move(details.blocks);
    if (!sections.figures.empty()) {
        head.picture = sections.figures.front();
        sections.figures.erase(sections.figures.begin());
    }
    sheet.report.blocks.insert(sheet.report.blocks.begin(), std::move(head));
    if (const auto trade_off =
            result.mechanisms.empty() ? std::nullopt : map_of(result.mechanisms.front(), sheet.folder)) {
        const std::vector<FreeParameter>& parameters = result.mechanisms.front().parameters;
        sheet.add(Heading{capitalised(short_name(result.mechanisms.front(), parameters[0].name)) + " against " +
                          short_name(result.mechanisms.front(), parameters[1].name)});
        sheet.add(*trade_off);
    }
    sheet.add(Heading{result.mechanisms.size() == 1 ? "How well it fits" : "Mechanisms"});
    if (!sections.figures.empty()) {
        sheet.add(std::move(sections));
    }
    append_evidence(result, sheet);
    sheet.add(ranking_table(result));
    sheet.add(Paragraph{
        "Score: the squared residuals of data and priors, and 4 for each datum or piece of field evidence that "
        "the mechanism says nothing about. A mechanism whose geometry is put in matches the observed "
        "surfaces by construction; one that predicts them can miss them."});
    if (const auto profiles = profiles_figure(problem, result, toe_elevation_of(file.model))) {
        sheet.draw(*profiles, "profiles",
                   "Where the geometry is put in, the profile is no prediction: only a "
                   "mechanism that searches for its geometry can miss the observed one.");
    }
    documents.screen += screen_of_evidence(result);
    return documents;
}

}  // namespace delabole
