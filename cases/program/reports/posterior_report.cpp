#include "cases/program/reports/fit_parts.hpp"

#include "cases/program/reader/units.hpp"
#include "fitting/studies/comparison.hpp"
#include "fitting/work/words.hpp"
#include "plots/drawing/text.hpp"
#include "plots/figures/study_figures.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace delabole {

namespace {

// The mechanisms that were sampled, with their weights relative to each other.
struct Weighed {
    std::vector<const MechanismFit*> fits;
    std::vector<MechanismWeight> with_field_evidence;
    std::vector<MechanismWeight> data_alone;

    // A single mechanism always has the probability 1, which says nothing.
    bool compared() const { return fits.size() > 1; }
};

std::vector<MechanismWeight> weights_of(const std::vector<const MechanismFit*>& fits, bool with_field_evidence,
                                        std::size_t variant = 0) {
    std::vector<LogEvidence> evidences;
    for (const MechanismFit* fit : fits) {
        const Evidence& evidence = fit->posterior->evidences[variant].evidence;
        evidences.push_back({fit->posterior->log_evidence(evidence, with_field_evidence), evidence.standard_error});
    }
    return weigh(evidences);
}

Weighed weighed(const FitResult& result) {
    Weighed all;
    for (const MechanismFit& fit : result.mechanisms) {
        if (fit.posterior) {
            all.fits.push_back(&fit);
        }
    }
    all.with_field_evidence = weights_of(all.fits, true);
    all.data_alone = weights_of(all.fits, false);
    return all;
}

std::string percent_with_error(const MechanismWeight& weight) {
    const std::string text = number_in_words(100 * weight.probability);
    // An error that would be rounded to 0 is not shown.
    return weight.standard_error < 0.0005 ? text : text + " +- " + number_in_words(100 * weight.standard_error);
}

// Bayes factor relative to the best mechanism: "1 : 37".
std::string bayes_factor_in_words(double log_bayes_factor) {
    if (log_bayes_factor == 0) {
        return "best";
    }
    return std::isfinite(log_bayes_factor) ? "1 : " + human_number(std::exp(-log_bayes_factor), 3) : "none";
}

std::string logarithm_in_words(double value, double error) {
    return std::isfinite(value) ? number_in_words(value) + " +- " + number_in_words(error) : "none";
}

// Appends Bayes factor and probabilities if there are several mechanisms.
void append_comparison(const Weighed& all, std::size_t index, std::vector<std::string>& row) {
    if (all.compared()) {
        row.push_back(bayes_factor_in_words(all.with_field_evidence[index].log_bayes_factor));
        row.push_back(percent_with_error(all.with_field_evidence[index]));
        row.push_back(percent_with_error(all.data_alone[index]));
    }
}

Table evidence_table_of(const Weighed& all) {
    Table table{"Mechanisms by evidence", {"mechanism", "ln evidence"_number}};
    if (all.compared()) {
        table.columns.insert(table.columns.end(),
                             {"Bayes factor"_number, "probability, %"_number, "without field evidence, %"_number});
    }
    table.columns.insert(table.columns.end(), {"ln Occam factor"_number, "prior without answer, %"_number});
    for (std::size_t index = 0; index < all.fits.size(); ++index) {
        const MechanismPosterior& posterior = *all.fits[index]->posterior;
        const bool estimated = posterior.evidence().status == EvidenceStatus::estimated;
        std::vector<std::string> row{title_of(*all.fits[index]),
                                     logarithm_in_words(posterior.log_evidence(), posterior.evidence().standard_error)};
        append_comparison(all, index, row);
        row.push_back(estimated ? number_in_words(posterior.log_occam_factor()) : "none");
        row.push_back(number_in_words(100 * posterior.evidence().failed_share));
        table.rows.push_back(std::move(row));
    }
    return table;
}

// Whether other priors and another model error were tried, under which several mechanisms can be ordered.
bool has_variants(const Weighed& all) {
    return all.compared() && all.fits.front()->posterior->evidences.size() > 1;
}

const MechanismFit& first_as_given(const Weighed& all) {
    const auto first = std::ranges::max_element(all.with_field_evidence, {}, &MechanismWeight::probability);
    return *all.fits[static_cast<std::size_t>(first - all.with_field_evidence.begin())];
}

// The mechanisms that are first under some variant, though not as given: "critical_sliding with flat priors".
std::string others_first_in_words(const Weighed& all) {
    const auto& variants = all.fits.front()->posterior->evidences;
    const auto first_of = [&](std::size_t variant) {
        const auto weights = weights_of(all.fits, true, variant);
        return all.fits[static_cast<std::size_t>(std::ranges::max_element(weights, {}, &MechanismWeight::probability) -
                                                 weights.begin())];
    };
    std::vector<std::string> others;
    for (const MechanismFit* other : all.fits) {
        std::vector<std::string> where;
        for (std::size_t variant = 1; variant < variants.size() && other != first_of(0); ++variant) {
            if (first_of(variant) == other) {
                where.push_back(variant_in_words(variants[variant].variant));
            }
        }
        if (!where.empty()) {
            others.push_back(other->name + " with " + list_in_words(where));
        }
    }
    return list_in_words(others);
}

// Whether the order of the mechanisms is the same under all variants.
std::string dependence_in_words(const Weighed& all) {
    if (!has_variants(all)) {
        return {};
    }
    const std::string best = first_as_given(all).name;
    const std::string others = others_first_in_words(all);
    return others.empty()
               ? best +
                     " stays first when priors are halved, doubled or flat, when their means are one standard "
                     "deviation lower or higher, and when the model error of the factor of safety is halved or "
                     "doubled, as far as the case has them."
               : "Which is first depends on what was put in: " + best + " as given, " + others + ".";
}

Table dependence_table(const Weighed& all) {
    Table table{"ln evidence, field evidence included, when priors and model error are changed", {{"mechanism"}}};
    for (const VariantEvidence& variant : all.fits.front()->posterior->evidences) {
        table.columns.emplace_back(variant_in_words(variant.variant), true);
    }
    for (const MechanismFit* fit : all.fits) {
        std::vector<std::string> row = {fit->name};
        for (const VariantEvidence& variant : fit->posterior->evidences) {
            row.push_back(logarithm_in_words(fit->posterior->log_evidence(variant.evidence, true),
                                             variant.evidence.standard_error));
        }
        table.rows.push_back(std::move(row));
    }
    return table;
}

void write_evidence(const Weighed& all, const ResultFolder& folder) {
    CsvTable csv({"mechanism", "variant", "status", "ln_evidence", "ln_evidence_with_field_evidence", "standard_error",
                  "probability", "effective_size", "failed_share", "evaluations"});
    for (std::size_t variant = 0; variant < all.fits.front()->posterior->evidences.size(); ++variant) {
        const std::vector<MechanismWeight> weights = weights_of(all.fits, true, variant);
        for (std::size_t index = 0; index < all.fits.size(); ++index) {
            const MechanismPosterior& posterior = *all.fits[index]->posterior;
            const VariantEvidence& entry = posterior.evidences[variant];
            csv.add_row({all.fits[index]->name, std::string(word_of(entry.variant)),
                         std::string(word_of(entry.evidence.status)), posterior.log_evidence(entry.evidence, false),
                         posterior.log_evidence(entry.evidence, true), entry.evidence.standard_error,
                         weights[index].probability, entry.evidence.effective_size, entry.evidence.failed_share,
                         static_cast<double>(entry.evidence.evaluations.total)});
        }
    }
    folder.write("evidence.csv", csv.text());
}

std::string interval_in_words(const Interval& interval, Dimension dimension) {
    return value_in_words(interval.lower, dimension) + " to " + value_in_words(interval.upper, dimension);
}

Table posterior_table(const MechanismFit& fit) {
    Table table{"Posterior of the parameters",
                {"parameter", "median"_number, "68 %"_number, "95 %"_number, "R-hat"_number,
                 "effective size, bulk"_number, "effective size, tails"_number}};
    for (const ParameterPosterior& parameter : fit.posterior->posterior.parameters) {
        const Dimension dimension = fit.dimension_of(parameter.name);
        // Four digits, since otherwise every R-hat would be shown as 1.
        const std::string r_hat = std::isfinite(parameter.diagnostics.r_hat)
                                      ? std::to_string(parameter.diagnostics.r_hat).substr(0, 5)
                                      : "infinite";
        table.rows.push_back({parameter.name, value_in_words(parameter.median, dimension),
                              interval_in_words(parameter.interval_68, dimension),
                              interval_in_words(parameter.interval_95, dimension), r_hat,
                              std::to_string(std::lround(parameter.diagnostics.bulk_size)),
                              std::to_string(std::lround(parameter.diagnostics.tail_size))});
    }
    return table;
}

Table posterior_correlations(const MechanismFit& fit) {
    const Posterior& posterior = fit.posterior->posterior;
    Table table{"Means, standard deviations and correlations of the posterior",
                {"parameter", "mean"_number, "standard deviation"_number}};
    for (const ParameterPosterior& parameter : posterior.parameters) {
        table.columns.emplace_back(parameter.name, true);
    }
    for (std::size_t row = 0; row < posterior.parameters.size(); ++row) {
        const ParameterPosterior& parameter = posterior.parameters[row];
        const Dimension dimension = fit.dimension_of(parameter.name);
        std::vector<std::string> cells = {parameter.name, value_in_words(parameter.mean, dimension),
                                          value_in_words(parameter.standard_deviation, dimension)};
        for (Eigen::Index column = 0; column < posterior.correlation.cols(); ++column) {
            cells.push_back(number_in_words(posterior.correlation(static_cast<Eigen::Index>(row), column)));
        }
        table.rows.push_back(std::move(cells));
    }
    return table;
}

std::string sampling_in_words(const Posterior& posterior) {
    return "Sampled: " + std::string(word_of(posterior.status)) + ", " + std::to_string(posterior.steps) +
           " steps of each chain, of which " + number_in_words(100 * posterior.acceptance) + " % moved, " +
           std::to_string(posterior.evaluations.total) + " evaluations.";
}

void write_draws(const MechanismFit& fit, const ResultFolder& folder) {
    std::vector<std::string> columns = {"chain"};
    for (std::size_t index = 0; index < fit.parameters.size(); ++index) {
        columns.push_back(column_name(fit.parameters[index].name, fit.dimensions[index]));
    }
    columns.emplace_back("data_misfit");
    CsvTable csv(std::move(columns));
    for (const Draw& draw : fit.posterior->posterior.draws) {
        std::vector<Cell> row = {static_cast<double>(draw.chain + 1)};
        for (std::size_t index = 0; index < draw.parameters.size(); ++index) {
            row.emplace_back(in_display_unit(draw.parameters[index], fit.dimensions[index]));
        }
        row.emplace_back(draw.misfit);
        csv.add_row(row);
    }
    folder.write(fit.name + "_draws.csv", csv.text());
}

}  // namespace

std::string probability_of_best(const FitResult& result) {
    const Weighed all = weighed(result);
    for (std::size_t index = 0; index < all.fits.size() && all.compared(); ++index) {
        if (all.fits[index] == &result.mechanisms.front()) {
            return number_in_words(std::round(100 * all.with_field_evidence[index].probability)) + " %";
        }
    }
    return {};
}

std::string dependence_of_ranking(const FitResult& result) {
    const Weighed all = weighed(result);
    return all.fits.empty() ? std::string() : dependence_in_words(all);
}

std::string first_under_other_priors(const FitResult& result) {
    const Weighed all = weighed(result);
    return has_variants(all) ? others_first_in_words(all) : std::string();
}

void append_evidence(const FitResult& result, const Sheet& sheet) {
    const Weighed all = weighed(result);
    if (all.fits.empty()) {
        return;
    }
    if (const std::string sentence = dependence_in_words(all); !sentence.empty()) {
        sheet.add(Notice{NoticeKind::verdict, "Whether the ranking can be trusted", {sentence}});
    }
    sheet.add(evidence_table_of(all));
    Folded folded{"Evidence: how it was weighed, and what it depends on", {}};
    folded.blocks.emplace_back(Paragraph{
        "Evidence: the likelihood exp(-misfit / 2) averaged over the priors, so that a mechanism pays for parameters "
        "that have to be tuned; the Occam factor is what is left of its greatest likelihood. A datum or a piece of "
        "field evidence about which it says nothing counts as missed by two standard deviations. Probabilities hold if "
        "one of these mechanisms is true and all are equally likely beforehand. Errors are those of the computation."});
    if (const auto figure = evidence_figure(result)) {
        folded.blocks.emplace_back(sheet.folder.draw(
            *figure, "evidence", "Natural logarithm of the evidence and its parts: shorter is better."));
    }
    if (all.fits.front()->posterior->evidences.size() > 1) {
        folded.blocks.emplace_back(dependence_table(all));
    }
    if (const auto figure = evidence_dependence_figure(result)) {
        folded.blocks.emplace_back(sheet.folder.draw(
            *figure, "evidence_dependence",
            "Evidence when the standard deviations or the means of all priors, or the standard deviation of the "
            "observed factors of safety (the model error), are changed. Bars: 95 % interval of the computation."));
    }
    if (const auto figure = chain_agreement_figure(result)) {
        folded.blocks.emplace_back(sheet.folder.draw(
            *figure, "chain_agreement", "How far the chains disagree, by the length that was used of them."));
    }
    sheet.add(std::move(folded));
    write_evidence(all, sheet.folder);
}

Json json_of_evidence(const FitResult& result) {
    const Weighed all = weighed(result);
    Json json = Json::array();
    for (std::size_t index = 0; index < all.fits.size(); ++index) {
        const MechanismPosterior& posterior = *all.fits[index]->posterior;
        const Evidence& evidence = posterior.evidence();
        Json entry;
        entry["mechanism"] = all.fits[index]->name;
        entry["status"] = word_of(evidence.status);
        entry["ln_evidence"] = json_number(posterior.log_evidence());
        entry["ln_evidence_without_field_evidence"] = json_number(posterior.log_evidence(evidence, false));
        entry["standard_error"] = json_number(evidence.standard_error);
        entry["ln_bayes_factor"] = json_number(all.with_field_evidence[index].log_bayes_factor);
        entry["probability"] = json_number(all.with_field_evidence[index].probability);
        entry["probability_error"] = json_number(all.with_field_evidence[index].standard_error);
        entry["probability_without_field_evidence"] = json_number(all.data_alone[index].probability);
        const bool estimated = evidence.status == EvidenceStatus::estimated;
        entry["ln_occam_factor"] = estimated ? json_number(posterior.log_occam_factor()) : Json(nullptr);
        entry["prior_without_answer"] = json_number(evidence.failed_share);
        for (const VariantEvidence& variant : posterior.evidences) {
            Json& part = entry["variants"][std::string(word_of(variant.variant))];
            part["ln_evidence"] = json_number(posterior.log_evidence(variant.evidence, true));
            part["standard_error"] = json_number(variant.evidence.standard_error);
        }
        json.push_back(std::move(entry));
    }
    return json;
}

std::string screen_of_evidence(const FitResult& result) {
    const Weighed all = weighed(result);
    if (all.fits.empty()) {
        return {};
    }
    std::vector<std::vector<std::string>> rows = {{"Evidence", "ln evidence"}};
    if (all.compared()) {
        rows.front().insert(rows.front().end(), {"Bayes factor", "probability, %", "without field evidence, %"});
    }
    for (std::size_t index = 0; index < all.fits.size(); ++index) {
        const MechanismPosterior& posterior = *all.fits[index]->posterior;
        rows.push_back({"  " + all.fits[index]->name,
                        logarithm_in_words(posterior.log_evidence(), posterior.evidence().standard_error)});
        append_comparison(all, index, rows.back());
    }
    const std::string sentence = dependence_in_words(all);
    return text_table(rows) + (sentence.empty() ? "" : "  " + sentence + "\n") + "\n";
}

void append_posterior(const MechanismFit& fit, const Sheet& sheet) {
    if (!fit.posterior) {
        return;
    }
    const Posterior& posterior = fit.posterior->posterior;
    if (posterior.draws.empty()) {
        return;
    }
    sheet.add(posterior_table(fit));
    sheet.add(Paragraph{sampling_in_words(posterior)});
    if (const auto figure = posterior_corner_figure(fit)) {
        FigureInReport corner =
            sheet.folder.draw(*figure, fit.name + "_posterior",
                              "Posterior of each parameter over its prior, and of each pair. Vertical "
                              "lines and the diamond: the best point.");
        corner.wide = posterior.parameters.size() > 2;
        sheet.add(std::move(corner));
    }
    if (const auto figure = running_quantiles_figure(fit)) {
        sheet.draw(*figure, fit.name + "_sampling",
                   "Convergence of the sampling: median and ends of the 95 % interval from the first steps of all "
                   "chains, less the final median and in final standard deviations.");
    }
    if (posterior.parameters.size() > 1) {
        sheet.add(posterior_correlations(fit));
    }
    write_draws(fit, sheet.folder);
}

Json json_of_posterior(const MechanismFit& fit) {
    const Posterior& posterior = fit.posterior->posterior;
    Json json;
    json["status"] = word_of(posterior.status);
    json["warnings"] = fit.posterior->warnings;
    json["parameters"] = Json::object();
    for (const ParameterPosterior& parameter : posterior.parameters) {
        const Dimension dimension = fit.dimension_of(parameter.name);
        Json& entry = json["parameters"][column_name(parameter.name, dimension)];
        put<&ParameterPosterior::mean, &ParameterPosterior::standard_deviation, &ParameterPosterior::median,
            &ParameterPosterior::interval_68, &ParameterPosterior::interval_95>(entry, parameter, dimension);
        entry["r_hat"] = json_number(parameter.diagnostics.r_hat);
        entry["effective_size_bulk"] = json_number(parameter.diagnostics.bulk_size);
        entry["effective_size_tails"] = json_number(parameter.diagnostics.tail_size);
    }
    json["correlation"] = json_of_matrix(posterior.correlation);
    json["steps_of_each_chain"] = posterior.steps;
    json["acceptance"] = json_number(posterior.acceptance);
    return json;
}

std::string screen_of_posterior(const MechanismFit& fit) {
    if (!fit.posterior) {
        return {};
    }
    std::string text;
    for (const std::string& warning : fit.posterior->warnings) {
        text += "  warning: " + warning + "\n";
    }
    return text + screen_of(posterior_table(fit),
                            {"posterior", "median", "68 %", "95 %", "R-hat", "size, bulk", "size, tails"});
}

}  // namespace delabole
