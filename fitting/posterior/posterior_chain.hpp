// One chain in the sampling of a posterior.
#pragma once

#include "fitting/posterior/prior_space.hpp"
#include "fitting/probability/counted_random.hpp"
#include "fitting/probability/student_mixture.hpp"
#include "fitting/search/evaluate_points.hpp"

#include <cstdint>
#include <limits>
#include <vector>

namespace delabole {

// The points from which all chains derive their steps; they do not change during a walk.
struct PosteriorArchive {
    std::vector<std::vector<double>> points;  // earlier states of all chains, at least two
    StudentMixture mixture;                   // fitted to the points
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

    // Draws a population from the prior and moves it by differential evolution; the last generations become the states.
    // False if no draw has an answer or the work was stopped.
    bool begin();
    // Makes that many steps; the states are then those after each step.
    void walk(int steps, const PosteriorArchive& archive);

    const std::vector<State>& states() const { return states_; }
    int moved() const { return moved_; }  // number of steps of the last walk that moved
    const EvaluationCount& evaluations() const { return evaluations_; }

  private:
    using Points = std::vector<const std::vector<double>*>;
    struct Proposal {
        std::vector<double> normal;
        double log_weight;  // log of the density of the step back over that of the step
    };

    double normal_number();
    // False also for a state whose log_density is `least` or less: such a state is not evaluated to the end.
    bool evaluate(State& state, double least = -std::numeric_limits<double>::infinity());
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
