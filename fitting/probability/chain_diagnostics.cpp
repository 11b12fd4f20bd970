#include "fitting/probability/chain_diagnostics.hpp"

#include "fitting/probability/distribution.hpp"
#include "fitting/probability/estimate.hpp"
#include "fitting/probability/moments.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <utility>

namespace delabole {

namespace {

using Chain = std::vector<double>;

std::vector<Chain> halves(std::span<const Chain> chains) {
    std::vector<Chain> result;
    for (const Chain& chain : chains) {
        const auto half = static_cast<std::ptrdiff_t>(chain.size() / 2);
        result.emplace_back(chain.begin(), chain.begin() + half);
        result.emplace_back(chain.end() - half, chain.end());
    }
    return result;
}

// Normal scores of the ranks over all chains; equal values share their mean rank.
std::vector<Chain> normal_scores(const std::vector<Chain>& chains) {
    const std::size_t length = chains.front().size();
    std::vector<std::pair<double, std::size_t>> order;  // value and its place, counted chain by chain
    order.reserve(length * chains.size());
    for (const Chain& chain : chains) {
        for (const double value : chain) {
            order.emplace_back(value, order.size());
        }
    }
    std::sort(order.begin(), order.end());
    std::vector<Chain> scores(chains.size(), Chain(length));
    const auto count = static_cast<double>(order.size());
    for (std::size_t first = 0; first < order.size();) {
        std::size_t last = first;
        while (last + 1 < order.size() && order[last + 1].first == order[first].first) {
            ++last;
        }
        const double rank = static_cast<double>(first + last) / 2 + 1;
        const double score = normal_quantile((rank - 0.375) / (count + 0.25));
        for (std::size_t index = first; index <= last; ++index) {
            const std::size_t place = order[index].second;
            scores[place / length][place % length] = score;
        }
        first = last + 1;
    }
    return scores;
}

struct Variances {
    double within;    // mean of the chains' variances
    double together;  // estimate of the variance of the distribution
};

Variances variances(const std::vector<Chain>& chains) {
    const auto length = static_cast<double>(chains.front().size());
    const auto count = static_cast<double>(chains.size());
    Chain means;
    double within = 0;
    for (const Chain& chain : chains) {
        const double mean = mean_of(chain);
        means.push_back(mean);
        for (const double value : chain) {
            within += (value - mean) * (value - mean) / (length - 1) / count;
        }
    }
    const double grand = mean_of(means);
    double between = 0;  // variance of the means
    for (const double mean : means) {
        between += (mean - grand) * (mean - grand) / (count - 1);
    }
    return {within, within * (length - 1) / length + between};
}

double variance_ratio(const std::vector<Chain>& chains) {
    const Variances v = variances(chains);
    return v.within > 0 ? std::sqrt(v.together / v.within) : std::numeric_limits<double>::infinity();
}

double effective_size(const std::vector<Chain>& chains) {
    const std::size_t length = chains.front().size();
    const auto draws = static_cast<double>(length * chains.size());
    const Variances v = variances(chains);
    if (!(v.within > 0)) {
        return 0;
    }
    Chain means;
    for (const Chain& chain : chains) {
        means.push_back(mean_of(chain));
    }
    const auto correlation = [&](std::size_t lag) {
        double covariance = 0;
        for (std::size_t index = 0; index < chains.size(); ++index) {
            const Chain& chain = chains[index];
            const double mean = means[index];
            for (std::size_t place = 0; place + lag < length; ++place) {
                covariance += (chain[place] - mean) * (chain[place + lag] - mean);
            }
        }
        return 1 - (v.within - covariance / draws * static_cast<double>(length) / (static_cast<double>(length) - 1)) /
                       v.together;
    };
    // For a reversible chain the sums of neighbouring pairs of correlations are positive and decrease; where they cease
    // to, only noise follows.
    double pairs = 1 + correlation(1);
    double sum = pairs;
    for (std::size_t lag = 2; lag + 1 < length; lag += 2) {
        const double next = correlation(lag) + correlation(lag + 1);
        if (!(next > 0)) {
            break;
        }
        pairs = std::min(pairs, next);
        sum += pairs;
    }
    // Anticorrelated chains can do better than independent draws, but only within this limit.
    const double time = std::max(2 * sum - 1, 1 / std::log10(draws));
    return draws / time;
}

// Indicators of the values that do not exceed a quantile.
std::vector<Chain> up_to(const std::vector<Chain>& chains, double limit) {
    std::vector<Chain> result = chains;
    for (Chain& chain : result) {
        for (double& value : chain) {
            value = value <= limit ? 1 : 0;
        }
    }
    return result;
}

void check(std::span<const Chain> chains) {
    if (chains.empty() || chains.front().size() < 4 ||
        std::any_of(chains.begin(), chains.end(),
                    [&](const Chain& chain) { return chain.size() != chains.front().size(); })) {
        throw std::invalid_argument("diagnose: needs chains of equal length, at least 4");
    }
}

double r_hat_of(const std::vector<Chain>& split, const std::vector<Chain>& scores, const Chain& sorted) {
    const double median = sorted_quantile(sorted, 0.5);
    std::vector<Chain> folded = split;
    for (Chain& chain : folded) {
        for (double& value : chain) {
            value = std::abs(value - median);
        }
    }
    return std::max(variance_ratio(scores), variance_ratio(normal_scores(folded)));
}

}  // namespace

ChainDiagnostics diagnose(std::span<const std::vector<double>> chains) {
    check(chains);
    const std::vector<Chain> split = halves(chains);
    const std::vector<Chain> scores = normal_scores(split);
    const Chain sorted = sorted_together(split);
    return {r_hat_of(split, scores, sorted), effective_size(scores),
            std::min(effective_size(up_to(split, sorted_quantile(sorted, 0.05))),
                     effective_size(up_to(split, sorted_quantile(sorted, 0.95))))};
}

double r_hat(std::span<const std::vector<double>> chains) {
    check(chains);
    const std::vector<Chain> split = halves(chains);
    return r_hat_of(split, normal_scores(split), sorted_together(split));
}

}  // namespace delabole
