// How posteriors and evidences are sampled.
#pragma once

#include <cstdint>

namespace delabole {

struct PosteriorSettings {
    int chains = 8;                      // >= 2
    int draws = 4000;                    // steps of all chains together in the first round; >= 8 for each chain
    int evaluations_per_chain = 16'000;  // no further round is begun that would exceed it; >= 1
    std::uint64_t seed = 1;
};

struct EvidenceSettings {
    int points = 512;     // of each replicate, >= 16
    int replicates = 16;  // >= 2
    std::uint64_t seed = 1;
};

// Of a back-analysis; the seed is the fit's own.
struct PosteriorStudy {
    int chains = PosteriorSettings{}.chains;
    int draws = PosteriorSettings{}.draws;
    int evaluations_per_chain = PosteriorSettings{}.evaluations_per_chain;
    int evidence_points = EvidenceSettings{}.points;
};

}  // namespace delabole
