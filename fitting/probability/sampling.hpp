// Points in the unit box by Monte Carlo, Latin hypercube or Sobol sequence; each point follows from its index alone.
#pragma once

#include "fitting/probability/counted_random.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace delabole {

enum class SamplingMethod { monte_carlo, latin_hypercube, sobol_sequence };

// Sobol sequence with a random digital shift: point i of replicate r is the i-th point of the sequence, counted from
// the origin, with its binary digits exchanged by those of a random number. Each point is then uniform in the box, and
// any first 2^m points still fill it as evenly as before; replicates are independent, so that their spread measures the
// error. Source: A. B. Owen, Monte Carlo theory, methods and examples, chapter 17; directions: GSL (Antonov & Saleev
// 1979, Bratley & Fox 1988).
class SobolSequence {
  public:
    // Points 0 ... count - 1. Throws std::invalid_argument for count > 2^30 and for dimension > 40, the greatest that
    // GSL tabulates.
    SobolSequence(std::size_t dimension, std::size_t count, std::uint64_t seed);

    std::size_t dimension() const { return dimension_; }
    // Coordinates in (0, 1). index < count.
    void point(std::size_t index, std::size_t replicate, std::span<double> coordinates) const;

  private:
    std::size_t dimension_;
    std::size_t digits_ = 0;
    std::vector<std::uint32_t> directions_;  // direction numbers of 30 bits: for each digit, those of all dimensions
    CountedRandom shift_;
};

// A plan of `replicates` independent samples of `points` points each; point i of the plan is point i % points of
// replicate i / points. Each replicate holds
//   monte_carlo      independent points
//   latin_hypercube  one point in each of `points` strata of every coordinate, at random within the stratum
//                    (M. D. McKay, R. J. Beckman & W. J. Conover, Technometrics 21 (1979) 239-245)
//   sobol_sequence   the first `points` points of SobolSequence
class SamplePlan {
  public:
    // dimension, points and replicates are >= 1; the limits of SobolSequence apply to a Sobol sequence.
    SamplePlan(SamplingMethod method, std::size_t dimension, std::size_t points, std::size_t replicates,
               std::uint64_t seed);

    std::size_t points() const { return points_; }
    std::size_t replicates() const { return replicates_; }
    std::size_t size() const { return points_ * replicates_; }
    // Coordinates in (0, 1). Safe to call from several threads.
    void point(std::size_t index, std::span<double> coordinates) const;

  private:
    SamplingMethod method_;
    std::size_t dimension_;
    std::size_t points_;
    std::size_t replicates_;
    CountedRandom random_;
    std::vector<SobolSequence> sobol_;        // at most one
    std::vector<std::uint32_t> permutation_;  // of strata: replicate by replicate, dimension by dimension
};

}  // namespace delabole
