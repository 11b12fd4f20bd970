// Reports what is impossible about a plane failure, and which value is the cause.
#include "cases/program/reader/units.hpp"
#include "cases/program/results/model_reports.hpp"
#include "plane_failure/plane_failure.hpp"
#include "plane_failure/wedge.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

namespace delabole {

namespace {

enum class Side { below, above };

// A limit as text, rounded to six digits towards the allowed side, so that the number is valid when copied into the
// case.
std::string limit_in_words(double limit, Side allowed, Dimension dimension) {
    const double unit = display_unit(dimension).si_per_unit;
    const double shown = limit / unit;
    if (shown == 0 || !std::isfinite(shown)) {
        return readable_quantity(limit, dimension);
    }
    constexpr int digits = 6;
    const double step = std::pow(10.0, std::floor(std::log10(std::abs(shown))) - (digits - 1));
    // A number that is round except for the last bits is not moved.
    const double nearest = std::round(shown / step);
    const bool round_number = std::abs(shown / step - nearest) < 1e-6;
    const double steps = round_number             ? nearest
                         : allowed == Side::below ? std::floor(shown / step)
                                                  : std::ceil(shown / step);
    return readable_quantity(steps * step * unit, dimension);
}

std::string height_in_words(double height, Side allowed) {
    return limit_in_words(height, allowed, Dimension::length);
}

// The elevation of a height above the toe, if the case has elevations.
std::string elevation_in_words(const PlaneFailure<>& problem, double height, Side allowed) {
    return height_in_words(problem.slope.toe_elevation.value_or(0) + height, allowed);
}

// Vertical depth of the tension crack if its top were at this distance behind the crest; nothing if that is impossible.
std::optional<double> depth_of_crack_at(PlaneFailure<> problem, double distance) {
    problem.tension_crack->position = CrackAtDistance<>{distance};
    Wedge<double> wedge;
    return make_wedge(problem, wedge) == PlaneFailureCheck::valid ? std::optional(wedge.crack_depth()) : std::nullopt;
}

// Behind the crest the sliding mass is deepest at the crest or at the end of the bench, unless the ground rises without
// end.
std::optional<double> deepest_crack(const PlaneFailure<>& problem) {
    std::optional<double> deepest = depth_of_crack_at(problem, 0);
    if (problem.slope.bench) {
        const std::optional<double> behind_bench = depth_of_crack_at(problem, problem.slope.bench->width);
        deepest = deepest && behind_bench ? std::optional(std::max(*deepest, *behind_bench)) : std::nullopt;
    }
    return deepest;
}

// Distance behind the crest at which the failure plane would meet the ground without a crack.
std::optional<double> surfacing_distance(PlaneFailure<> problem) {
    problem.tension_crack.reset();
    Wedge<double> wedge;
    return make_wedge(problem, wedge) == PlaneFailureCheck::valid ? std::optional(wedge.base_top_x - wedge.crest_x)
                                                                  : std::nullopt;
}

std::string crack_behind_plane(const PlaneFailure<>& problem, const std::string& key) {
    const std::optional<double> distance = surfacing_distance(problem);
    if (key != "tension_crack.distance_behind_crest" || !distance) {
        return {};
    }
    return "lies behind the point where the failure plane meets the ground, " +
           height_in_words(*distance, Side::below) + " behind the crest";
}

std::string crack_below_toe(const PlaneFailure<>& problem, const std::string& key) {
    const double daylight = problem.failure_plane.daylight_height.value_or(0);
    const std::string where = daylight > 0 ? "the point where the plane daylights" : "the toe";
    if (key == "tension_crack.base_below_crest") {
        return "the crack is deeper than the slope: its bottom must lie above " + where + ", less than " +
               height_in_words(problem.slope.height - daylight, Side::below) + " below the crest";
    }
    if (key == "tension_crack.base_elevation") {
        return "the crack is deeper than the slope: its bottom must lie above " + where + ", elevation " +
               elevation_in_words(problem, daylight, Side::above);
    }
    return {};
}

std::string crack_too_deep(const PlaneFailure<>& problem, const std::string& key) {
    if (key != "tension_crack.depth") {
        return {};
    }
    const std::optional<double> deepest = deepest_crack(problem);
    std::string text = "nowhere behind the crest is there so much rock above the failure plane";
    if (deepest) {
        text += ": a crack of this dip can be at most " + height_in_words(*deepest, Side::below) + " deep";
    }
    return text;
}

std::string water_too_high(PlaneFailure<> problem, const std::string& key) {
    const bool on_base = std::holds_alternative<BasePeakMidHeightWater<>>(problem.water);
    const bool from_toe = std::holds_alternative<PeakAtToeWater<>>(problem.water);
    // Dry water suffices here, because the geometry does not depend on the water.
    problem.water = Dry{};
    const PlaneFailureResult dry = analyse(problem);
    if (dry.check != PlaneFailureCheck::valid) {
        return {};
    }
    const double daylight = problem.failure_plane.daylight_height.value_or(0);
    const double top = on_base ? dry.crack_base_height : dry.crack_top_height;
    const std::string top_name = !problem.tension_crack ? "the point where the plane meets the ground"
                                 : on_base              ? "the upper end of the base"
                                                        : "the top of the crack";
    if (key == "water.water_elevation") {
        return "is above " + top_name + ", elevation " + elevation_in_words(problem, top, Side::below);
    }
    if (key != "water.water_depth") {
        return {};
    }
    return on_base || from_toe ? "exceeds the height of " + top_name + " above the lower end of the base, " +
                                     height_in_words(top - daylight, Side::below)
                               : "exceeds the depth of the crack, " + height_in_words(dry.crack_depth, Side::below);
}

// The least value of a level at which the water exerts the pressure of the pond.
std::string water_too_low(PlaneFailure<> problem, const std::string& key) {
    const bool above_daylight = std::holds_alternative<BasePeakMidHeightWater<>>(problem.water) ||
                                std::holds_alternative<PeakAtToeWater<>>(problem.water);
    const double pond = problem.pond->depth;
    // Water of lower unit weight must stand higher.
    const double heavier = std::visit(
        [&](const auto& water) {
            if constexpr (requires { water.unit_weight; }) {
                return problem.pond->unit_weight / water.unit_weight;
            } else {
                return 1.0;
            }
        },
        problem.water);
    // Dry water suffices here, because the geometry does not depend on the water.
    problem.water = Dry{};
    problem.pond.reset();
    const PlaneFailureResult dry = analyse(problem);
    if (dry.check != PlaneFailureCheck::valid) {
        return {};
    }
    const double daylight = problem.failure_plane.daylight_height.value_or(0);
    const double bottom = above_daylight ? daylight : dry.crack_base_height;
    const double depth = (pond - bottom) * heavier;
    const std::string least = key == "water.water_elevation" ? elevation_in_words(problem, bottom + depth, Side::above)
                              : key == "water.water_depth"   ? height_in_words(depth, Side::above)
                                                             : std::string();
    const std::string pond_in_words = "pond.depth = " + readable_quantity(pond, Dimension::length);
    return "the water states less pressure than the pond, " + pond_in_words +
           ", gives where the plane daylights or at the bottom of the crack" +
           (least.empty() ? ": raise it to the pond's level, or use kind = \"dry\", which fills up to that level"
                          : ": must be at least " + least);
}

// Says what is wrong with the value of the key and which limit it violates. Empty if no number can be added to
// stated_impossibility.
std::string broken_limit(const PlaneFailure<>& problem, std::string_view failure, const std::string& key) {
    if (failure == "plane_does_not_daylight") {
        return "the failure plane is as steep as the face or steeper: must be less than slope.face_dip = " +
               readable_quantity(problem.slope.face_dip, Dimension::angle);
    }
    if (failure == "plane_never_surfaces") {
        return "the ground behind the crest is as steep as the failure plane, so the plane never meets it: must be "
               "less than failure_plane.dip = " +
               readable_quantity(problem.failure_plane.dip, Dimension::angle) + ", or a [tension_crack] is needed";
    }
    if (failure == "crack_flatter_than_plane") {
        return "must be more than failure_plane.dip = " +
               readable_quantity(problem.failure_plane.dip, Dimension::angle);
    }
    if (failure == "crack_below_plane") {
        return crack_behind_plane(problem, key);
    }
    if (failure == "crack_base_below_daylight") {
        return crack_below_toe(problem, key);
    }
    if (failure == "crack_deeper_than_mass") {
        return crack_too_deep(problem, key);
    }
    if (failure == "water_above_crack") {
        return water_too_high(problem, key);
    }
    if (failure == "water_below_pond" && problem.pond) {
        return water_too_low(problem, key);
    }
    return {};
}

}  // namespace

Impossibility impossibility(const PlaneFailureStudy<>& study, std::string_view failure) {
    const ResolvedStudy resolved = resolve(study);
    Impossibility found = stated_impossibility(PlaneFailureStudy<>::kind, failure);
    found.limit = [failure, problem = resolved.check == PlaneFailureCheck::valid ? resolved.problem : study.model](
                      const std::string& key) { return broken_limit(problem, failure, key); };
    return found;
}

}  // namespace delabole
