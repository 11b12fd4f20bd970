#include "fitting/sensitivity/sobol_indices.hpp"

#include "fitting/probability/sampling.hpp"

#include <algorithm>
#include <bit>
#include <stdexcept>

namespace delabole {

namespace {

constexpr std::size_t least_rows = 16;
constexpr std::size_t most_groups = 1024;

// Sums over rows; the values are taken less their mean.
struct RowSums {
    double rows = 0;
    double values = 0;               // f(A) + f(B)
    double squares = 0;              // f(A)^2 + f(B)^2
    std::vector<double> covariance;  // f(B) (f(AB_i) - f(A))
    std::vector<double> difference;  // (f(A) - f(AB_i))^2

    explicit RowSums(std::size_t dimension) : covariance(dimension, 0.0), difference(dimension, 0.0) {}

    void add(const RowSums& other, double times) {
        rows += times * other.rows;
        values += times * other.values;
        squares += times * other.squares;
        for (std::size_t index = 0; index < covariance.size(); ++index) {
            covariance[index] += times * other.covariance[index];
            difference[index] += times * other.difference[index];
        }
    }

    double mean() const { return values / (2 * rows); }
    double variance() const { return squares / (2 * rows) - mean() * mean(); }

    // First-order indices, followed by total indices.
    std::vector<double> indices() const {
        std::vector<double> all;
        const double scale = rows * variance();
        for (const double sum : covariance) {
            all.push_back(scale > 0 ? sum / scale : 0);
        }
        for (const double sum : difference) {
            all.push_back(scale > 0 ? sum / (2 * scale) : 0);
        }
        return all;
    }
};

// Evaluations of one row: A, B, AB_1, AB_2, ...
class Rows {
  public:
    Rows(const std::vector<Evaluation>& answers, std::size_t dimension) : answers_(answers), width_(dimension + 2) {}

    std::size_t size() const { return answers_.size() / width_; }
    bool complete(std::size_t row) const {
        const auto first = answers_.begin() + static_cast<std::ptrdiff_t>(row * width_);
        return std::all_of(first, first + static_cast<std::ptrdiff_t>(width_),
                           [](const Evaluation& answer) { return answer.valid(); });
    }
    double value(std::size_t row, std::size_t column) const { return answers_[row * width_ + column].value; }

  private:
    const std::vector<Evaluation>& answers_;
    std::size_t width_;
};

RowSums sums_of(const Rows& rows, std::size_t row, std::size_t dimension, double mean) {
    RowSums sums(dimension);
    const double a = rows.value(row, 0) - mean;
    const double b = rows.value(row, 1) - mean;
    sums.rows = 1;
    sums.values = a + b;
    sums.squares = a * a + b * b;
    for (std::size_t index = 0; index < dimension; ++index) {
        const double mixed = rows.value(row, index + 2) - mean;
        sums.covariance[index] = b * (mixed - a);
        sums.difference[index] = (a - mixed) * (a - mixed);
    }
    return sums;
}

void check(const InputSpace& space, const SobolIndicesSettings& settings) {
    if (!space.independent()) {
        throw std::invalid_argument("sobol_indices: the parameters depend on each other");
    }
    if (space.size() < 1 || space.size() > most_index_parameters) {
        throw std::invalid_argument("sobol_indices: " + std::to_string(space.size()) + " parameters, from 1 to 20");
    }
    if (settings.samples < static_cast<int>(least_rows) ||
        !std::has_single_bit(static_cast<unsigned>(settings.samples))) {
        throw std::invalid_argument("sobol_indices: samples must be a power of 2 and >= 16");
    }
}

}  // namespace

std::optional<SobolIndicesResult> sobol_indices(const Evaluator& evaluator, const InputSpace& space,
                                                const SobolIndicesSettings& settings, std::uint64_t seed) {
    check(space, settings);
    const std::size_t dimension = space.size();
    const auto count = static_cast<std::size_t>(settings.samples);
    const SobolSequence sequence(2 * dimension, count, seed);
    const std::size_t width = dimension + 2;
    const auto point = [&](std::size_t index, std::span<double> parameters) {
        std::array<double, 2 * most_index_parameters> coordinates{};
        sequence.point(index / width, 0, std::span(coordinates).first(2 * dimension));
        const std::size_t column = index % width;
        for (std::size_t parameter = 0; parameter < dimension; ++parameter) {
            const bool from_b = column == 1 || column == parameter + 2;
            parameters[parameter] =
                space.marginal(parameter).quantile(coordinates[parameter + (from_b ? dimension : 0)]);
        }
    };
    const std::vector<Evaluation> answers = evaluator.evaluate(dimension, count * width, point);
    if (answers.size() < count * width) {
        return std::nullopt;
    }

    SobolIndicesResult result;
    for (const Evaluation& answer : answers) {
        result.evaluations.record(answer);
    }
    const Rows rows(answers, dimension);
    std::vector<std::size_t> complete;
    for (std::size_t row = 0; row < rows.size(); ++row) {
        if (rows.complete(row)) {
            complete.push_back(row);
        }
    }
    result.rows = settings.samples;
    result.rows_without = result.rows - static_cast<long>(complete.size());
    if (complete.size() < least_rows) {
        return result;
    }
    double mean = 0;
    double least = rows.value(complete.front(), 0);
    double greatest = least;
    for (const std::size_t row : complete) {
        for (const double value : {rows.value(row, 0), rows.value(row, 1)}) {
            mean += value / (2 * static_cast<double>(complete.size()));
            least = std::min(least, value);
            greatest = std::max(greatest, value);
        }
    }
    result.mean = mean;
    if (least == greatest) {
        result.status = SobolIndicesStatus::no_variance;
        return result;
    }
    std::vector<RowSums> groups(std::min(complete.size(), most_groups), RowSums(dimension));
    RowSums all(dimension);
    for (std::size_t index = 0; index < complete.size(); ++index) {
        const RowSums row = sums_of(rows, complete[index], dimension, mean);
        groups[index * groups.size() / complete.size()].add(row, 1);
        all.add(row, 1);
    }
    result.status = SobolIndicesStatus::found;
    result.variance = all.variance();
    const std::vector<double> values = all.indices();
    const std::vector<Interval> intervals = bootstrap_intervals(
        groups.size(), 2 * dimension, settings.bootstrap, CountedRandom(seed, RandomPurpose::bootstrap),
        evaluator.threads, [&](std::span<const unsigned> times) {
            RowSums sums(dimension);
            for (std::size_t group = 0; group < groups.size(); ++group) {
                if (times[group] > 0) {
                    sums.add(groups[group], times[group]);
                }
            }
            return sums.indices();
        });
    for (std::size_t parameter = 0; parameter < dimension; ++parameter) {
        result.parameters.push_back({{values[parameter], intervals[parameter]},
                                     {values[dimension + parameter], intervals[dimension + parameter]}});
    }
    return result;
}

}  // namespace delabole
