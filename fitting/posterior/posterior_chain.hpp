// One chain of the posterior's sampler.
#pragma once

#include "fitting/posterior/prior_space.hpp"
#include "fitting/probability/counted_random.hpp"
#include "fitting/probability/student_mixture.hpp"
#include "fitting/search/evaluate_points.hpp"

#include <cstdint>
#include <vector>

namespace delabole {

// The points from which all chains take their steps; they stay as they are while the chains walk.
struct PosteriorArchive {
    std::vector<std::vector<double>> points;  // earlier states of all chains, at least two
    StudentMixture mixture;                   // in their shape
};

class PosteriorChain {
  public:
    struct State {
        std::vector<double> normal;      // standard normal numbers
        std::vector<double> parameters;  // SI
        double misfit = 0;
        double log_density = 0;  // in the space of the normal numbers, up to a constant
    };

    PosteriorChain(const Evaluator& misfit, const PriorSpace& prior, std::uint64_t seed, int number);

    // A population from the prior, moved by differential evolution; its last generations are the states. False where no
    // draw has an answer or the work was stopped.
    bool begin();
    // The states are those after each step.
    void walk(int steps, const PosteriorArchive& archive);

    const std::vector<State>& states() const { return states_; }
    int moved() const { return moved_; }  // steps of the last walk that moved
    const EvaluationCount& evaluations() const { return evaluations_; }

  private:
    using Points = std::vector<const std::vector<double>*>;
    struct Proposal {
        std::vector<double> normal;
        double log_weight;  // of the step back over the step there
    };

    double normal_number();
    bool evaluate(State& state);
    Proposal difference_step(const State& from, const Points& archive);
    Proposal snooker_step(const State& from, const Points& archive);
    Proposal mixture_step(const State& from, const StudentMixture& mixture);
    bool accept(State& state, Proposal proposal);
    bool local_step(State& state, const Points& archive);

    const Evaluator& misfit_;
    const PriorSpace& prior_;
    RandomStream random_;
    State current_;
    std::vector<State> states_;
    int moved_ = 0;
    EvaluationCount evaluations_;
};

}  // namespace delabole
