#include "cases/program/reports/fit_parts.hpp"

#include "cases/program/reports/sensitivity_parts.hpp"
#include "fitting/work/words.hpp"
#include "plots/figures/study_figures.hpp"

#include <cmath>

namespace delabole {

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

}  // namespace delabole
