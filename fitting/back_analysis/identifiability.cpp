#include "fitting/back_analysis/steps.hpp"

#include "fitting/back_analysis/verdict.hpp"

#include <Eigen/SVD>

#include <algorithm>
#include <cmath>

namespace delabole {

namespace {

constexpr double step = 1e-4;  // of the range
constexpr double second_step = 4 * step;
constexpr double agreement = 0.01;
constexpr double rank_threshold = 0.5;  // standard deviations of data per range of parameter

class Differences {
  public:
    Differences(const Search& search, std::span<const double> best, EvaluationCount& account)
        : search_(search), best_(best.begin(), best.end()), account_(account), at_best_(residuals(best_)) {}

    const Residuals& at_best() const { return at_best_; }

    // Derivative of the residuals with respect to one parameter, per range; empty if the model fails on both sides.
    Eigen::VectorXd column(std::size_t parameter, double share) {
        const Interval& range = search_.misfit.bounds()[parameter];
        const double width = range.upper - range.lower;
        const double centre = std::clamp(best_[parameter], range.lower + share * width, range.upper - share * width);
        const double low = centre - share * width;
        const double high = centre + share * width;
        const Residuals left = at(parameter, low);
        const Residuals right = at(parameter, high);
        if (left.failure.empty() && right.failure.empty()) {
            return difference(right, left, (high - low) / width);
        }
        if (right.failure.empty() && high > best_[parameter]) {
            return difference(right, at_best_, (high - best_[parameter]) / width);
        }
        if (left.failure.empty() && low < best_[parameter]) {
            return difference(at_best_, left, (best_[parameter] - low) / width);
        }
        return {};
    }

  private:
    Residuals residuals(std::span<const double> point) {
        Residuals result = search_.residuals(point);
        account_.record({0, result.failure});
        return result;
    }

    Residuals at(std::size_t parameter, double value) {
        std::vector<double> point = best_;
        point[parameter] = value;
        return residuals(point);
    }

    Eigen::VectorXd difference(const Residuals& right, const Residuals& left, double distance) const {
        Eigen::VectorXd result = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(at_best_.values.size()));
        for (std::size_t row = 0; row < at_best_.values.size(); ++row) {
            if (!at_best_.idle[row]) {
                result[static_cast<Eigen::Index>(row)] = (right.values[row] - left.values[row]) / distance;
            }
        }
        return result;
    }

    const Search& search_;
    std::vector<double> best_;
    EvaluationCount& account_;
    Residuals at_best_;
};

Eigen::MatrixXd scaled_jacobian(Differences& differences, const std::vector<std::size_t>& free,
                                IdentifiabilityStatus& status) {
    const auto rows = static_cast<Eigen::Index>(differences.at_best().values.size());
    Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(rows, static_cast<Eigen::Index>(free.size()));
    status = IdentifiabilityStatus::reliable;
    for (std::size_t index = 0; index < free.size() && rows > 0; ++index) {
        const Eigen::VectorXd fine = differences.column(free[index], step);
        const Eigen::VectorXd coarse = differences.column(free[index], second_step);
        if (fine.size() == 0) {
            status = IdentifiabilityStatus::model_fails_nearby;
            continue;
        }
        jacobian.col(static_cast<Eigen::Index>(index)) = fine;
        const bool agree = coarse.size() > 0 && (fine - coarse).norm() <= agreement * std::max(1.0, fine.norm());
        if (!agree && status == IdentifiabilityStatus::reliable) {
            status = IdentifiabilityStatus::steps_disagree;
        }
    }
    return jacobian;
}

// Singular values and right vectors, as many of each as the matrix has columns, even if it has fewer rows.
void decompose(const Eigen::MatrixXd& matrix, Eigen::VectorXd& values, Eigen::MatrixXd& directions) {
    const Eigen::Index columns = matrix.cols();
    Eigen::MatrixXd square = Eigen::MatrixXd::Zero(std::max(matrix.rows(), columns), columns);
    square.topRows(matrix.rows()) = matrix;
    const Eigen::JacobiSVD<Eigen::MatrixXd> decomposition(square, Eigen::ComputeThinV);
    values = decomposition.singularValues();
    directions = decomposition.matrixV();
}

int rank_of(const Eigen::VectorXd& singular_values) {
    return static_cast<int>((singular_values.array() > rank_threshold).count());
}

Eigen::MatrixXd with_prior_rows(const Eigen::MatrixXd& jacobian, const Misfit& misfit,
                                const std::vector<std::size_t>& free) {
    const auto count = static_cast<Eigen::Index>(free.size());
    Eigen::MatrixXd stacked = Eigen::MatrixXd::Zero(jacobian.rows() + count, count);
    stacked.topRows(jacobian.rows()) = jacobian;
    for (std::size_t index = 0; index < free.size(); ++index) {
        const FreeParameter& parameter = misfit.mechanism().parameters[free[index]];
        if (parameter.prior) {
            const auto place = static_cast<Eigen::Index>(index);
            stacked(jacobian.rows() + place, place) =
                (parameter.upper - parameter.lower) / parameter.prior->standard_deviation;
        }
    }
    return stacked;
}

void add_covariance(Identifiability& result, const Eigen::VectorXd& values, const Eigen::MatrixXd& directions,
                    const Eigen::VectorXd& ranges) {
    const Eigen::MatrixXd root = ranges.asDiagonal() * directions * values.cwiseInverse().asDiagonal();
    result.covariance = root * root.transpose();
    const Eigen::VectorXd inverse_deviation = result.covariance->diagonal().cwiseSqrt().cwiseInverse();
    result.correlation = inverse_deviation.asDiagonal() * *result.covariance * inverse_deviation.asDiagonal();
}

std::vector<double> misses_of(const Eigen::MatrixXd& jacobian, const Residuals& at_best) {
    std::vector<double> misses(static_cast<std::size_t>(jacobian.cols()), 0.0);
    for (Eigen::Index column = 0; column < jacobian.cols(); ++column) {
        double& miss = misses[static_cast<std::size_t>(column)];
        for (Eigen::Index row = 0; row < jacobian.rows(); ++row) {
            const double residual = std::abs(at_best.values[static_cast<std::size_t>(row)]);
            miss = std::abs(jacobian(row, column)) > rank_threshold ? std::max(miss, residual) : miss;
        }
    }
    return misses;
}

// Whether the result of the model at the best point is far from what the surrogate predicts.
bool run_contradicts(const Search& search, std::span<const double> best, double scatter) {
    constexpr double allowed = 2;  // standard deviations of data, or of runs at the same point
    const Residuals run = search.misfit.residuals(best);
    const double expected = std::sqrt(std::max(search.surrogate->value(best, Priors::ignored).value, 0.0));
    return !run.failure.empty() || std::abs(std::sqrt(data_misfit(run)) - expected) > allowed * std::max(1.0, scatter);
}

// Whether the data are one FS = 1 and nothing else depends on the parameters.
bool only_failure_bears(const Misfit& misfit) {
    int failures = 0;
    int others = misfit.data_count();
    for (const QuantityObservation& observation : misfit.observations()) {
        const bool is_failure = observation.quantity == "factor_of_safety" && observation.value == 1 &&
                                observation.relation == Relation::equal;
        failures += is_failure ? 1 : 0;
        others -= is_failure ? 1 : 0;
    }
    return failures == 1 && others == 0 && misfit.output("factor_of_safety").has_value();
}

}  // namespace

Identifiability identify(const Search& search, std::span<const double> best, EvaluationCount& account, double scatter) {
    const Misfit& misfit = search.misfit;
    const std::vector<std::size_t> free = misfit.free_parameters();
    const std::vector<Dimension> dimensions = misfit.dimensions();
    Identifiability result;
    VerdictQuestion question;
    Eigen::VectorXd ranges(static_cast<Eigen::Index>(free.size()));
    for (std::size_t index = 0; index < free.size(); ++index) {
        const FreeParameter& parameter = misfit.mechanism().parameters[free[index]];
        result.parameters.push_back(parameter.name);
        question.dimensions.push_back(dimensions[free[index]]);
        ranges[static_cast<Eigen::Index>(index)] = parameter.upper - parameter.lower;
    }
    question.ranges = ranges;
    question.has_priors = misfit.has_priors();
    question.only_failure_observed = only_failure_bears(misfit);
    if (free.empty()) {
        result.status = IdentifiabilityStatus::reliable;
        result.verdict = verdict(result, question);
        return result;
    }

    if (search.surrogate != nullptr && run_contradicts(search, best, scatter)) {
        result.status = IdentifiabilityStatus::run_contradicts;
        result.verdict = verdict(result, question);
        return result;
    }
    Differences differences(search, best, account);
    const Eigen::MatrixXd jacobian = scaled_jacobian(differences, free, result.status);
    Eigen::VectorXd values;
    decompose(jacobian, values, result.directions);
    result.singular_values.assign(values.begin(), values.end());
    result.rank = rank_of(values);
    result.misses = misses_of(jacobian, differences.at_best());
    Eigen::VectorXd posterior_values;
    Eigen::MatrixXd posterior_directions;
    decompose(with_prior_rows(jacobian, misfit, free), posterior_values, posterior_directions);
    result.rank_with_priors = rank_of(posterior_values);
    if (result.rank_with_priors == static_cast<int>(free.size())) {
        add_covariance(result, posterior_values, posterior_directions, ranges);
    }
    result.verdict = verdict(result, question);
    return result;
}

}  // namespace delabole
