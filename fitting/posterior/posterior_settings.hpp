// How posteriors and evidences are sampled.
#pragma once

#include "parameters/fields.hpp"

#include <cstdint>

namespace delabole {

// With fewer draws of each chain their agreement cannot be judged.
inline constexpr int draws_per_chain = 8;

struct PosteriorSettings {
    int chains = 8;                      // >= 2
    int draws = 4000;                    // steps of all chains together in the first round; at least 8 for each chain
    int evaluations_per_chain = 16'000;  // limit, >= 1; a further round is begun only if it stays within
    std::uint64_t seed = 1;
};

struct EvidenceSettings {
    int points = 512;     // of each replicate, >= 16
    int replicates = 16;  // >= 2
    std::uint64_t seed = 1;
};

// The settings of a posterior in a back-analysis; the seed is that of the fit.
struct PosteriorStudy {
    int chains = PosteriorSettings{}.chains;
    int draws = PosteriorSettings{}.draws;
    int evaluations_per_chain = PosteriorSettings{}.evaluations_per_chain;
    int evidence_points = EvidenceSettings{}.points;
    static constexpr auto fields() {
        using S = PosteriorStudy;
        constexpr double most = 100'000'000;
        return FieldTable{
            with_default(number<&S::chains>(within(2, 1000), "chains of the sampler")),
            with_default(number<&S::draws>(within(draws_per_chain * 2, most),
                                           "steps of all chains together in the first round")),
            with_default(
                number<&S::evaluations_per_chain>(within(1, most), "no further round is begun that would exceed it")),
            with_default(number<&S::evidence_points>(within(16, 1 << 24), "points of each replicate of the evidence")),
        };
    }
};

}  // namespace delabole
