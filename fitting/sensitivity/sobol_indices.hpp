// Shares of the variance of a quantity that are due to its parameters (Sobol indices).
//
// First-order index: the share of the variance that would vanish if the parameter became known. Total index: the share
// that would remain if everything else became known; its excess over the first-order index is interaction. They are
// shares of a sum only if the parameters are independent.
//
// Matrices A and B have N rows from one Sobol sequence of twice the dimension; AB_i is A with column i of B. With
// values f less their mean and V their variance:
//     S_i = mean(f(B) (f(AB_i) - f(A))) / V    A. Saltelli et al., Computer Physics Communications 181 (2010) 259-270,
//                                              table 2 (b)
//     T_i = mean((f(A) - f(AB_i))^2) / (2 V)   M. J. W. Jansen, Computer Physics Communications 117 (1999) 35-43
#pragma once

#include "fitting/probability/dependence.hpp"
#include "fitting/probability/estimate.hpp"
#include "fitting/search/evaluate_points.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace delabole {

// Each parameter needs 2 of the 40 dimensions that GSL tabulates for the Sobol sequence.
inline constexpr std::size_t most_index_parameters = 20;

struct SobolIndicesSettings {
    int samples = 4096;  // a power of 2
    int bootstrap = 1000;
    static constexpr auto fields() {
        using S = SobolIndicesSettings;
        return FieldTable{
            with_default(number<&S::samples>(within(16, 1 << 22),
                                             "N, a power of 2; the quantity is evaluated N (parameters + 2) times")),
            with_default(number<&S::bootstrap>(within(100, 1e5), "repetitions that give the intervals")),
        };
    }
};

enum class SobolIndicesStatus {
    found,
    no_variance,         // the quantity is the same at every sample: there is no variance to be shared
    not_enough_samples,  // fewer than 16 rows whose evaluations all have an answer
};

struct SobolIndex {
    Estimate first;
    Estimate total;
};

struct SobolIndicesResult {
    SobolIndicesStatus status = SobolIndicesStatus::not_enough_samples;
    std::vector<SobolIndex> parameters;  // empty unless found
    double mean = 0;
    double variance = 0;
    long rows = 0;  // N
    // left out, because an evaluation of the row had no answer: the indices are then those of the other rows, whose
    // parameters are no longer quite independent
    long rows_without = 0;
    EvaluationCount evaluations;
};

// The intervals come from a bootstrap over rows, or over 1024 groups of neighbouring rows if there are more. The
// bootstrap takes the points for independent, which makes the intervals of a sequence too wide rather than too narrow.
// Returns nothing if the work was stopped. Throws std::invalid_argument for parameters that depend on each other, for
// more than 20 of them, and for N that is not a power of 2.
std::optional<SobolIndicesResult> sobol_indices(const Evaluator& evaluator, const InputSpace& space,
                                                const SobolIndicesSettings& settings, std::uint64_t seed);

}  // namespace delabole
