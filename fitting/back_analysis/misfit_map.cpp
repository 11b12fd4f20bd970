#include "fitting/back_analysis/steps.hpp"

#include "fitting/probability/estimate.hpp"

#include <limits>

namespace delabole {

std::vector<double> grid(const Interval& range, int count) {
    std::vector<double> values;
    values.reserve(static_cast<std::size_t>(count));
    for (int index = 0; index < count; ++index) {
        values.push_back(std::lerp(range.lower, range.upper, static_cast<double>(index) / (count - 1)));
    }
    return values;
}

std::optional<MisfitMap> map_misfit(const Search& search, std::span<const double> best, double misfit,
                                    EvaluationCount& account) {
    const std::vector<std::size_t> free = search.misfit.free_parameters();
    if (free.size() < 2) {
        return std::nullopt;
    }
    const Mechanism& mechanism = search.misfit.mechanism();
    const FitSettings& settings = search.misfit.problem().settings;
    MisfitMap map;
    map.x = mechanism.parameters[free[0]].name;
    map.y = mechanism.parameters[free[1]].name;
    map.x_values = grid(search.misfit.bounds()[free[0]], settings.map_points);
    map.y_values = grid(search.misfit.bounds()[free[1]], settings.map_points);
    map.level_68 = misfit + chi_square_quantile(probability_68, 2);
    map.level_95 = misfit + chi_square_quantile(probability_95, 2);
    map.misfit.resize(settings.map_points, settings.map_points);

    using Row = std::pair<std::vector<double>, EvaluationCount>;
    const auto rows = share_tasks<Row>(map.y_values.size(), search.workers(), [&](std::size_t row) {
        Row result{std::vector<double>(map.x_values.size(), std::numeric_limits<double>::infinity()), {}};
        std::vector<double> point(best.begin(), best.end());
        point[free[1]] = map.y_values[row];
        for (std::size_t column = 0; column < map.x_values.size() && !search.stopped(); ++column) {
            point[free[0]] = map.x_values[column];
            const Evaluation evaluation = search.evaluate(point, Priors::counted, result.second);
            if (evaluation.valid()) {
                result.first[column] = evaluation.value;
            }
        }
        return result;
    });
    for (std::size_t row = 0; row < rows.size(); ++row) {
        for (std::size_t column = 0; column < map.x_values.size(); ++column) {
            map.misfit(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column)) = rows[row].first[column];
        }
        account.add(rows[row].second);
    }
    return map;
}

}  // namespace delabole
