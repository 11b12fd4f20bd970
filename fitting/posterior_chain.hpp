// One chain of the posterior's sampler.
#pragma once

#include "fitting/counted_random.hpp"
#include "fitting/evaluate_points.hpp"
#include "fitting/prior_space.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace delabole {

class PosteriorChain {
  public:
    struct State {
        std::vector<double> normal;      // standard normal numbers
        std::vector<double> parameters;  // SI
        double misfit = 0;
        double log_density = 0;  // in the space of the normal numbers, up to a constant
    };

    PosteriorChain(const Evaluator& misfit, const PriorSpace& prior, std::uint64_t seed, int number);

    // A population from the prior, moved by differential evolution; false where no draw has an answer or the work was
    // stopped.
    bool begin();
    // Steps with the archive as it is; the states are those after each step.
    void walk(int steps);
    // The states of the last walk become the archive.
    void renew_archive();

    const std::vector<State>& states() const { return states_; }
    int moved() const { return moved_; }  // steps of the last walk that moved
    const EvaluationCount& evaluations() const { return evaluations_; }

  private:
    struct Proposal {
        std::vector<double> normal;
        double log_weight;  // of the step back over the step there
    };

    double normal_number();
    bool evaluate(State& state);
    Proposal difference_step(const State& from, std::span<const State* const> archive);
    Proposal snooker_step(const State& from, std::span<const State* const> archive);
    bool step(State& state, std::span<const State* const> archive);

    const Evaluator& misfit_;
    const PriorSpace& prior_;
    RandomStream random_;
    std::vector<State> archive_;
    State current_;
    std::vector<State> states_;
    int moved_ = 0;
    EvaluationCount evaluations_;
};

}  // namespace delabole
