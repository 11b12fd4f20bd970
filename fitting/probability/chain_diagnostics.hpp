// Whether several random walks have forgotten where they began and agree with each other.
//
// Source: A. Vehtari, A. Gelman, D. Simpson, B. Carpenter & P.-C. Buerkner, Bayesian Analysis 16 (2021) 667-718; the
// sum of autocorrelations is cut off after C. J. Geyer, Statistical Science 7 (1992) 473-483.
#pragma once

#include <span>
#include <vector>

namespace delabole {

struct ChainDiagnostics {
    // Square root of the variance of all chains together over that within half-chains, of normal scores of the ranks;
    // the greater of that of the values and that of their distances from the median. Near 1 where chains agree;
    // infinite where no half-chain moves.
    double r_hat;
    double bulk_size;  // independent draws that would give the mean rank as well
    double tail_size;  // the same for the 5 and 95 % quantiles, the lesser of both
};

// Both: chains of equal length, at least four values each, otherwise std::invalid_argument.
ChainDiagnostics diagnose(std::span<const std::vector<double>> chains);
// The first of the three alone, which costs least.
double r_hat(std::span<const std::vector<double>> chains);

}  // namespace delabole
