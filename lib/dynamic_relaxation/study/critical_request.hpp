// The parameters for which a relaxation case may ask for the critical value between standing and failing, and the
// loading path on which its blocks come to each value tried.
//
// Joints with friction depend on their history: the forces between blocks before failure depend on the loading path,
// and so does the value at which the blocks fail. No path is wrong; the spread of the values on several of them is an
// error of the model.
#pragma once

#include "dynamic_relaxation/scene/settings.hpp"
#include "parameters/fields.hpp"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace delabole {

enum class LoadingPath {
    // The blocks come to rest in the case as given, stages of excavation included: at its own strengths or weight, or,
    // where it does not stand or, without stages, comes to no rest in 100 000 steps, at the greatest of 1/2, 1/4, ...
    // of the factor and the lower bound at which it does; in searches for an angle, at the bound at which they should
    // stand. Each value tried is a sudden change from that one state, in which springs, slip and broken contacts are
    // kept. Static equilibrium is sought first, without inertia; the run follows. Not with a record of shaking, which
    // would be over before the first value is tried.
    consolidated,
    preloaded,  // each value from the initial geometry: springs free, all loads at once, without inertia; then the run
    gravity,    // as preloaded, but weight, water and forces grow in ten equal steps, or in time if settings.start =
                // "ramped"
    sudden,     // each value from the initial geometry: springs free, all loads at once, with inertia
    stages,     // each value from before the first stage of excavation, with settings.start; then stage after stage
};

enum class PathChoice { one, all };

inline constexpr std::string_view paths_meaning = "all: the value on each path and their spread, too; absent: one";

// A search takes these where the case leaves them out: the width of its last bracket, rad or a ratio, and the range of
// factors that it tries.
inline constexpr double standard_angle_tolerance = degrees(0.005);
inline constexpr double standard_ratio_tolerance = 0.005;
inline constexpr double least_ratio = 0.1;
inline constexpr double greatest_reduction = 10;
inline constexpr double greatest_weight = 100;
inline constexpr std::string_view tolerance_meaning = "width of the bracket in the end";

enum class CriticalParameter { tilt, friction, strength_reduction, weight };

// Search for the constant tilt at which the blocks begin to fail, or for the friction angle of all joints, peak and
// residual, below which they do.
template <CriticalParameter parameter>
struct AngleSearch {
    double lower;
    double upper;
    std::optional<double> tolerance;
    std::optional<LoadingPath> path;
    std::optional<PathChoice> paths;

    static constexpr bool of_tilt = parameter == CriticalParameter::tilt;
    static constexpr std::string_view kind_key = "parameter";
    static constexpr std::string_view kind = of_tilt ? "tilt" : "friction";
    static constexpr auto fields() {
        using A = AngleSearch;
        constexpr Interval range = of_tilt ? between(degrees(-90), degrees(90)) : right_open(0, degrees(90));
        return FieldTable{
            number<&A::lower>(Dimension::angle, range,
                              of_tilt ? "least tilt tried, which is constant whatever [tilting] does"
                                      : "least friction angle tried, of every joint, peak and residual"),
            number<&A::upper>(Dimension::angle, range,
                              of_tilt ? "greatest tilt tried; the blocks may stand here and fail at the least"
                                      : "greatest friction angle tried"),
            absent_is(standard_angle_tolerance,
                      number<&A::tolerance>(Dimension::angle, within(degrees(1e-9), degrees(10)), tolerance_meaning)),
            section<&A::path>(
                "how the blocks come to each angle; absent: stages where the scene has some, else by settings.start"),
            section<&A::paths>(paths_meaning)};
    }
};

struct TiltSearch : AngleSearch<CriticalParameter::tilt> {};
struct FrictionSearch : AngleSearch<CriticalParameter::friction> {};

// Search for the factor of safety F: the divisor of strength at which the blocks fail (strength_reduction.hpp).
struct ReductionSearch {
    std::optional<double> lower;
    std::optional<double> upper;
    std::optional<double> tolerance;
    std::vector<std::string> joints;
    std::optional<LoadingPath> path;
    std::optional<PathChoice> paths;

    static constexpr std::string_view kind_key = "parameter";
    static constexpr std::string_view kind = "strength_reduction";
    static constexpr auto fields() {
        using R = ReductionSearch;
        return FieldTable{
            absent_is(least_ratio, number<&R::lower>(more_than(0), "least factor tried")),
            absent_is(greatest_reduction, number<&R::upper>(more_than(0), "greatest factor tried")),
            absent_is(standard_ratio_tolerance, number<&R::tolerance>(within(1e-9, 1), tolerance_meaning)),
            section<&R::joints>(
                "names of the joints whose strength and bonds are divided: of a jointed slope; interface "
                "or base of a row or columns; numbers of blocks' joints, as texts; absent: all"),
            section<&R::path>(
                "how the blocks come to each factor; absent: consolidated, or preloaded with a record of shaking"),
            section<&R::paths>(paths_meaning)};
    }
};

// Search for the factor on gravity at which the blocks begin to fail with their given strengths; water and forces do
// not grow with it. Without cohesion, tensile strength, water and forces the factor has no effect.
struct WeightSearch {
    std::optional<double> lower;
    std::optional<double> upper;
    std::optional<double> tolerance;
    std::optional<LoadingPath> path;
    std::optional<PathChoice> paths;

    static constexpr std::string_view kind_key = "parameter";
    static constexpr std::string_view kind = "weight";
    static constexpr auto fields() {
        using W = WeightSearch;
        return FieldTable{
            absent_is(least_ratio, number<&W::lower>(more_than(0), "least factor tried")),
            absent_is(greatest_weight, number<&W::upper>(more_than(0), "greatest factor tried")),
            absent_is(standard_ratio_tolerance, number<&W::tolerance>(within(1e-9, 1), tolerance_meaning)),
            section<&W::path>(
                "how the blocks come to each factor; absent: consolidated, or preloaded with a record of shaking"),
            section<&W::paths>(paths_meaning)};
    }
};

using CriticalRequest = std::variant<TiltSearch, FrictionSearch, ReductionSearch, WeightSearch>;

constexpr std::array<std::string_view, 4> enum_names(CriticalParameter) {
    return {TiltSearch::kind, FrictionSearch::kind, ReductionSearch::kind, WeightSearch::kind};
}

constexpr CriticalParameter parameter_of(const CriticalRequest& request) {
    return static_cast<CriticalParameter>(request.index());
}

// Name of the value as an output.
constexpr std::string_view name_of_critical(CriticalParameter parameter) {
    constexpr std::array<std::string_view, 4> names{"critical_tilt", "limiting_friction_angle", "factor_of_safety",
                                                    "critical_weight_factor"};
    return names[static_cast<std::size_t>(parameter)];
}

constexpr Dimension dimension_of(CriticalParameter parameter) {
    return parameter == CriticalParameter::tilt || parameter == CriticalParameter::friction ? Dimension::angle
                                                                                            : Dimension::ratio;
}

// A request with its omitted values filled in.
struct CriticalPlan {
    CriticalParameter parameter;
    double lower;
    double upper;
    double tolerance;
    std::vector<LoadingPath> path;   // the first one gives the answer
    std::vector<std::string> joint;  // names of joints whose strength is divided; empty: all

    // Whether blocks that fail may stand at a greater value: loads that neither tilt nor weight changes can hold them,
    // and what leans the other way fails on the other side. Both bounds are tried then.
    bool has_two_limits() const {
        return parameter == CriticalParameter::tilt || parameter == CriticalParameter::weight;
    }
    // Whether the blocks stand at low values and fail at high ones, unless they have two limits.
    bool stands_low() const { return parameter != CriticalParameter::friction; }
    double should_stand() const { return stands_low() ? lower : upper; }
    double should_fail() const { return stands_low() ? upper : lower; }
    // Brackets of ratios are divided at their geometric mean.
    bool is_ratio() const { return dimension_of(parameter) == Dimension::ratio; }
};

}  // namespace delabole
