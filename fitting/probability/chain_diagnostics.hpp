// Whether several random walks no longer depend on their starting points and agree with each other.
//
// Source: A. Vehtari, A. Gelman, D. Simpson, B. Carpenter & P.-C. Buerkner, Bayesian Analysis 16 (2021) 667-718; the
// sum of autocorrelations is cut off after C. J. Geyer, Statistical Science 7 (1992) 473-483.
#pragma once

#include <span>
#include <vector>

namespace delabole {

struct ChainDiagnostics {
    // Square root of the ratio of the variance of all chains together to that within half-chains, both of normal scores
    // of the ranks; the greater of two such numbers, one for the values and one for their distances from the median.
    // Near 1 where chains agree; infinite where no half-chain moves.
    double r_hat;
    double bulk_size;  // number of independent draws that would give the mean rank as accurately
    double tail_size;  // the same for the 5 and 95 % quantiles, the lesser of the two
};

// diagnose() and r_hat() need chains of equal length with at least four values each, otherwise they throw
// std::invalid_argument.
ChainDiagnostics diagnose(std::span<const std::vector<double>> chains);
// ChainDiagnostics::r_hat alone, which costs least.
double r_hat(std::span<const std::vector<double>> chains);

}  // namespace delabole
