#include "kinematics/poles.hpp"

#include "kinematics/joint_set.hpp"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace delabole {

namespace {

constexpr double most_concentration = 1e4;
constexpr double least_concentration = 1;

double sum_of(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0);
}

// log of K cosh(K c) / sinh K, without overflow: K exp(K (|c| - 1)) (1 + exp(-2 K |c|)) / (1 - exp(-2 K)).
double log_density(double concentration, double cosine) {
    const double size = std::abs(cosine);
    return std::log(concentration) + concentration * (size - 1) + std::log1p(std::exp(-2 * concentration * size)) -
           std::log1p(-std::exp(-2 * concentration));
}

// K with coth K - 1 / K = mean cosine, by Newton's method on a function that increases throughout.
double concentration_of(double mean_cosine) {
    double concentration =
        std::clamp(1 / (1 - std::min(mean_cosine, 1 - 1e-9)), least_concentration, most_concentration);
    for (int iteration = 0; iteration < 50; ++iteration) {
        const double cotangent = 1 / std::tanh(concentration);
        const double excess = cotangent - 1 / concentration - mean_cosine;
        const double slope = 1 - cotangent * cotangent + 1 / (concentration * concentration);
        const double next = std::clamp(concentration - excess / slope, least_concentration, most_concentration);
        if (std::abs(next - concentration) <= 1e-12 * concentration) {
            return next;
        }
        concentration = next;
    }
    return concentration;
}

struct Mixture {
    std::vector<PoleCluster> sets;
    double background;
    double log_likelihood;
    std::vector<std::vector<double>> probability;  // [set][pole]
};

class MixtureFit {
  public:
    MixtureFit(const std::vector<Direction>& poles, const std::vector<double>& weights)
        : poles_(poles), weights_(weights), total_(sum_of(weights)) {}

    Mixture empty() const { return {{}, 1, 0, {}}; }

    // Adds one set to `fewer`: the best fit of those that begin at some of its unexplained poles.
    Mixture with_another(const Mixture& fewer) const {
        Mixture best = fewer;
        best.log_likelihood = -std::numeric_limits<double>::infinity();
        for (const Direction& axis : unexplained_poles(fewer)) {
            Mixture start = fewer;
            for (PoleCluster& set : start.sets) {
                set.share *= 0.8;
            }
            start.background *= 0.8;
            start.sets.push_back({axis, 30, 0.2});
            const Mixture found = maximised(std::move(start));
            if (found.log_likelihood > best.log_likelihood) {
                best = found;
            }
        }
        return best;
    }

  private:
    // The densest of the poles that no set explains, far from each other.
    std::vector<Direction> unexplained_poles(const Mixture& mixture) const {
        constexpr std::size_t candidates = 4;
        constexpr double kernel = 50;
        std::vector<double> unexplained = weights_;
        for (const std::vector<double>& probability : mixture.probability) {
            for (std::size_t pole = 0; pole < poles_.size(); ++pole) {
                unexplained[pole] -= weights_[pole] * probability[pole];
            }
        }
        std::vector<double> density(poles_.size(), 0.0);
        for (std::size_t at = 0; at < poles_.size(); ++at) {
            for (std::size_t pole = 0; pole < poles_.size(); ++pole) {
                const double cosine = std::abs(poles_[at].dot(poles_[pole]));
                density[at] += unexplained[pole] * std::exp(kernel * (cosine - 1));
            }
        }
        std::vector<Direction> found;
        while (found.size() < candidates) {
            const auto densest = std::ranges::max_element(density);
            if (densest == density.end() || !(*densest > 0)) {
                break;
            }
            const Direction axis = poles_[static_cast<std::size_t>(densest - density.begin())];
            found.push_back(axis);
            for (std::size_t pole = 0; pole < poles_.size(); ++pole) {
                density[pole] = std::abs(axis.dot(poles_[pole])) > std::cos(degrees(25)) ? 0 : density[pole];
            }
        }
        return found;
    }

    // Expectation step: probabilities and likelihood of the present sets.
    void expect(Mixture& mixture) const {
        mixture.probability.assign(mixture.sets.size(), std::vector<double>(poles_.size()));
        mixture.log_likelihood = 0;
        for (std::size_t pole = 0; pole < poles_.size(); ++pole) {
            double sum = mixture.background;
            for (std::size_t set = 0; set < mixture.sets.size(); ++set) {
                const PoleCluster& own = mixture.sets[set];
                mixture.probability[set][pole] =
                    own.share * std::exp(log_density(own.concentration, own.axis.dot(poles_[pole])));
                sum += mixture.probability[set][pole];
            }
            for (std::vector<double>& probability : mixture.probability) {
                probability[pole] /= sum;
            }
            mixture.log_likelihood += weights_[pole] * std::log(sum);
        }
    }

    // Maximisation step. The sign of each pole is unknown, too: its mean is tanh(K x.m).
    void maximise(Mixture& mixture) const {
        double explained = 0;
        for (std::size_t set = 0; set < mixture.sets.size(); ++set) {
            PoleCluster& own = mixture.sets[set];
            Direction sum = Direction::Zero();
            double weight = 0;
            for (std::size_t pole = 0; pole < poles_.size(); ++pole) {
                const double part = weights_[pole] * mixture.probability[set][pole];
                sum += part * std::tanh(own.concentration * own.axis.dot(poles_[pole])) * poles_[pole];
                weight += part;
            }
            own.share = weight / total_;
            explained += own.share;
            if (sum.norm() > 0 && weight > 0) {
                own.axis = sum.normalized();
                own.concentration = concentration_of(sum.norm() / weight);
            }
        }
        mixture.background = std::max(0.0, 1 - explained);
    }

    Mixture maximised(Mixture mixture) const {
        constexpr int most_iterations = 500;
        double before = -std::numeric_limits<double>::infinity();
        for (int iteration = 0; iteration < most_iterations; ++iteration) {
            expect(mixture);
            if (mixture.log_likelihood - before < 1e-7 * total_) {
                break;
            }
            before = mixture.log_likelihood;
            maximise(mixture);
        }
        return mixture;
    }

    const std::vector<Direction>& poles_;
    const std::vector<double>& weights_;
    double total_;
};

std::optional<std::size_t> likeliest(const Mixture& mixture, std::size_t pole) {
    std::optional<std::size_t> best;
    double greatest = 1;  // the rest is the probability of the background
    for (const std::vector<double>& probability : mixture.probability) {
        greatest -= probability[pole];
    }
    for (std::size_t set = 0; set < mixture.sets.size(); ++set) {
        if (mixture.probability[set][pole] > greatest) {
            greatest = mixture.probability[set][pole];
            best = set;
        }
    }
    return best;
}

// Poles of a set, with their resultant when all are turned to the side of its axis.
struct Members {
    std::vector<std::size_t> poles;
    Direction sum;  // weighted
    double weight;
};

class StraySearch {
  public:
    StraySearch(const std::vector<Direction>& poles, const std::vector<double>& weights)
        : poles_(poles), weights_(weights) {}

    // Candidates and members are in ascending order.
    Members members(const std::vector<std::size_t>& candidates, const Direction& axis) const {
        constexpr int most_rounds = 100;
        Members found = together(candidates, axis);
        for (int round = 0; round < most_rounds; ++round) {
            std::vector<std::size_t> next;
            for (const std::size_t pole : candidates) {
                if (belongs(found, pole)) {
                    next.push_back(pole);
                }
            }
            if (next == found.poles) {
                break;
            }
            found = together(std::move(next), found.sum);
        }
        return found;
    }

  private:
    Direction turned(std::size_t pole, const Direction& axis) const {
        return poles_[pole].dot(axis) < 0 ? Direction(-poles_[pole]) : poles_[pole];
    }

    Members together(std::vector<std::size_t> poles, const Direction& axis) const {
        Members members{std::move(poles), Direction::Zero(), 0};
        for (const std::size_t pole : members.poles) {
            members.sum += weights_[pole] * turned(pole, axis);
            members.weight += weights_[pole];
        }
        return members;
    }

    bool belongs(const Members& members, std::size_t pole) const {
        const bool member = std::ranges::binary_search(members.poles, pole);
        const double others = static_cast<double>(members.poles.size()) - (member ? 1 : 0);
        if (others < 2) {
            return true;
        }
        const Direction own = turned(pole, members.sum);
        const double own_weight = member ? weights_[pole] : 0;
        const Direction resultant = others / (members.weight - own_weight) * (members.sum - own_weight * own);
        const double scatter = std::max(others - resultant.norm(), (others - 1) / most_concentration);
        const double ratio = (others - 1) * (1 + resultant.norm() - (resultant + own).norm()) / scatter;
        return ratio <= (others - 1) * std::expm1(std::log(100.0) / (others - 1));
    }

    const std::vector<Direction>& poles_;
    const std::vector<double>& weights_;
};

std::vector<Members> members_of(const Mixture& mixture, const std::vector<Direction>& poles,
                                const std::vector<double>& weights) {
    std::vector<std::vector<std::size_t>> candidates(mixture.sets.size());
    for (std::size_t pole = 0; pole < poles.size(); ++pole) {
        if (const std::optional<std::size_t> set = likeliest(mixture, pole)) {
            candidates[*set].push_back(pole);
        }
    }
    const StraySearch search(poles, weights);
    std::vector<Members> sets;
    for (std::size_t set = 0; set < candidates.size(); ++set) {
        sets.push_back(search.members(candidates[set], mixture.sets[set].axis));
    }
    return sets;
}

PoleCluster cluster_of(const Members& members, double total) {
    const auto count = static_cast<double>(members.poles.size());
    const double missing = count * (1 - members.sum.norm() / members.weight);
    const Direction axis = members.sum.normalized();
    return {axis.z() < 0 ? Direction(-axis) : axis, (count - 1) / std::max(missing, (count - 1) / most_concentration),
            members.weight / total};
}

}  // namespace

double terzaghi_weight(const Orientation& plane, const LineOrientation& line, double least_angle) {
    const double sine = std::abs(upward_normal(plane).dot(direction_of(line)));
    return 1 / std::max(sine, std::sin(least_angle));
}

FisherStatistics fisher_statistics(const std::vector<Orientation>& planes, const std::vector<double>& weights) {
    const OrientationStatistics own = orientation_statistics(planes, weights);
    const auto count = static_cast<double>(planes.size());
    const double resultant = own.resultant;
    const double missing = count - resultant;
    FisherStatistics statistics{own.mean.dip, own.mean.dip_direction, count, resultant, own.concentration, 0, 0, 0, 0};
    if (planes.size() < 2) {
        statistics.upper_concentration = statistics.concentration;
        statistics.confidence_cone = std::numbers::pi;
        return statistics;
    }
    if (std::isinf(own.concentration)) {
        statistics.lower_concentration = statistics.upper_concentration = statistics.concentration;
        return statistics;
    }
    constexpr double tail = 0.025;
    statistics.lower_concentration = gsl_cdf_chisq_Pinv(tail, 2 * count - 2) / (2 * missing);
    statistics.upper_concentration = gsl_cdf_chisq_Qinv(tail, 2 * count - 2) / (2 * missing);
    statistics.confidence_cone =
        std::acos(std::max(-1.0, 1 - missing / resultant * std::expm1(std::log(20.0) / (count - 1))));
    constexpr double share = 0.6826894921370859;  // within one standard deviation of a normal variable
    statistics.variability_cone = std::acos(std::max(-1.0, 1 + std::log1p(-share) / statistics.concentration));
    return statistics;
}

PoleClusters find_clusters(const std::vector<Orientation>& planes, const std::vector<double>& weights,
                           std::size_t most_sets) {
    std::vector<Direction> poles;
    std::ranges::transform(planes, std::back_inserter(poles), upward_normal);
    std::vector<double> scaled = weights;
    const auto count = static_cast<double>(planes.size());
    for (double& weight : scaled) {
        weight *= count / sum_of(weights);
    }
    const MixtureFit fit(poles, scaled);
    Mixture mixture = fit.empty();
    std::vector<Members> best;
    PoleClusters clusters;
    clusters.information_criterion = {0};
    clusters.too_small = {false};
    double least = 0;
    for (std::size_t sets = 1; sets <= most_sets && 4 * sets < planes.size(); ++sets) {
        mixture = fit.with_another(mixture);
        const double criterion = -2 * mixture.log_likelihood + 4 * static_cast<double>(sets) * std::log(count);
        // Concentrated on one or two poles, a set would be likelier than the background at which they stand.
        constexpr std::size_t fewest_poles = 3;
        std::vector<Members> found = members_of(mixture, poles, scaled);
        const bool too_small =
            std::ranges::any_of(found, [](const Members& set) { return set.poles.size() < fewest_poles; });
        if (!too_small && criterion < least) {
            least = criterion;
            best = std::move(found);
        }
        clusters.information_criterion.push_back(criterion);
        clusters.too_small.push_back(too_small);
    }
    // The largest set comes first; sets of equal weight are in the order in which they were found.
    std::ranges::stable_sort(best, std::greater{}, &Members::weight);
    clusters.of.resize(poles.size());
    for (std::size_t set = 0; set < best.size(); ++set) {
        clusters.sets.push_back(cluster_of(best[set], count));
        for (const std::size_t pole : best[set].poles) {
            clusters.of[pole] = set;
        }
    }
    return clusters;
}

double kamb_density(const std::vector<Direction>& poles, const std::vector<double>& weights, const Direction& at) {
    const auto count = static_cast<double>(poles.size());
    const double area = 9 / (count + 9);
    const double scale = count / sum_of(weights);
    double inside = 0;
    for (std::size_t pole = 0; pole < poles.size(); ++pole) {
        inside += std::abs(poles[pole].dot(at)) >= 1 - area ? scale * weights[pole] : 0;
    }
    return (inside - count * area) / std::sqrt(count * area * (1 - area));
}

}  // namespace delabole
