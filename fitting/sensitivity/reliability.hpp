// First-order reliability: how many standard deviations, and in which direction, the parameters have to change until
// the slope fails, and the probability of failure for a limit surface that is flat there.
//
// In the space of independent standard normal numbers u the design point u* is the point of the limit surface nearest
// to the medians; beta = |u*|, negative if the slope fails at the medians; p_f ~ Phi(-beta). alpha = u* / beta holds
// the direction cosines of u*. Where parameters are correlated an axis does not belong to a single parameter; the
// importance
//     gamma = L^-T alpha / |L^-T alpha|
// then refers to the parameters (equal to alpha without correlation): negative for a parameter whose decrease leads to
// failure. For curved limit surfaces p_f is an approximation whose error is not estimated here; sampling gives it.
// Sources: A. M. Hasofer & N. C. Lind, J. Engineering Mechanics Division ASCE 100 (1974) 111-121; P.-L. Liu & A. Der
// Kiureghian, Structural Safety 9 (1991) 161-177; importance: A. Der Kiureghian, First- and second-order reliability
// methods, in Engineering design reliability handbook (2005), section 14.5.
#pragma once

#include "fitting/probability/dependence.hpp"
#include "fitting/search/evaluate_points.hpp"
#include "fitting/search/nearest_point.hpp"
#include "fitting/sensitivity/propagation.hpp"

#include <cstdint>
#include <vector>

namespace delabole {

struct ReliabilitySettings {
    int starts = 8;
    double step = 1e-3;
    double tolerance = 1e-3;
    static constexpr auto fields() {
        return FieldTable{
            with_default(number<&ReliabilitySettings::starts>(
                within(1, 10'000), "the medians, then random points two standard deviations away")),
            with_default(number<&ReliabilitySettings::step>(
                within(1e-6, 1), "step of differences in standard deviations; larger for models with a coarse answer")),
            with_default(number<&ReliabilitySettings::tolerance>(within(1e-8, 0.5), "error of the reliability index")),
        };
    }
};

enum class ReliabilityStatus {
    converged,             // the nearest point found passes the check of nearest_point.hpp
    not_converged,         // a point of the surface was found that does not pass the check; it is given
    limit_not_reached,     // no start reached the surface within 8 standard deviations
    no_answer_at_medians,  // the model gives no value of the quantity there
    interrupted,
};

struct DesignPoint {
    double reliability_index = 0;
    std::vector<double> standard_normal;  // u*
    std::vector<double> parameters;
    std::vector<double> alpha;
    std::vector<double> importance;
    double off_surface = 0;   // standard deviations
    double misalignment = 0;  // sine of an angle
    int hits = 0;             // number of starts that led to this point
    bool converged = false;
};

struct ReliabilityResult {
    ReliabilityStatus status = ReliabilityStatus::limit_not_reached;
    bool medians_fail = false;
    double reliability_index = 0;  // of the nearest design point; meaningful if there is one
    double probability_of_failure = 0;
    std::vector<DesignPoint> points;  // distinct ones, nearest first; further ones increase the probability of failure
    int starts = 0;
    int converged_starts = 0;
    EvaluationCount evaluations;
};

ReliabilityResult reliability(const Evaluator& evaluator, const InputSpace& space, const ReliabilitySettings& settings,
                              const FailureCriterion& criterion, std::uint64_t seed);

}  // namespace delabole
