#include "plane_failure/plane_failure.hpp"

#include "plane_failure/critical.hpp"
#include "plane_failure/stability.hpp"

#include <algorithm>
#include <cmath>

namespace delabole {

namespace {

using Forces = Equilibrium<double>;

// Moments about the lower end of the base, counter-clockwise (overturning, as the mass moves towards -x) positive.
class MomentSum {
  public:
    void add(double moment) { (moment > 0 ? overturning_ : restoring_) += std::abs(moment); }
    void add_force(double x, double y, double force_x, double force_y) { add(x * force_y - y * force_x); }

    double restoring() const { return restoring_; }
    double overturning() const { return overturning_; }

  private:
    double restoring_ = 0;
    double overturning_ = 0;
};

// Centroid of the sliding mass relative to the daylighting point.
Point centroid(const Wedge<double>& wedge) {
    const double plane_slope = wedge.plane.sine / wedge.plane.cosine;
    double area = 0;
    Point moment = Point::Zero();
    for (std::size_t index = 1; index < wedge.station_count; ++index) {
        const Station<double>& left = wedge.stations[index - 1];
        const Station<double>& right = wedge.stations[index];
        const double width = right.x - left.x;
        // Each trapezoid is the sum of the two triangles on its left and right side.
        const auto add = [&](double x, double middle_above, double triangle_area) {
            area += triangle_area;
            moment += triangle_area * Point(x, middle_above + x * plane_slope);
        };
        add(left.x + width / 3, (left.ground + left.floor + right.floor) / 3, width * (left.ground - left.floor) / 2);
        add(left.x + 2 * width / 3, (left.ground + right.ground + right.floor) / 3,
            width * (right.ground - right.floor) / 2);
    }
    return moment / area;
}

double height_of_ground(const Polyline& ground, double x) {
    for (std::size_t index = 1; index < ground.size(); ++index) {
        if (x <= ground[index].x() && ground[index].x() > ground[index - 1].x()) {
            const double position = (x - ground[index - 1].x()) / (ground[index].x() - ground[index - 1].x());
            return ground[index - 1].y() + position * (ground[index].y() - ground[index - 1].y());
        }
    }
    return ground.back().y();
}

MomentSum moments(const PlaneFailure<>& problem, const Forces& forces) {
    const Wedge<double>& wedge = forces.wedge;
    const SineCosine<double>& plane = wedge.plane;
    const double weight = forces.stability.weight;
    MomentSum sum;
    const Point middle = centroid(wedge);
    sum.add_force(middle.x(), middle.y(), 0, -weight);
    sum.add(forces.water.base.moment);
    // Water in the crack pushes along the crack's normal (-sin, cos); its arm includes the base's projection on the
    // crack.
    const double base_along_crack =
        wedge.base_length * (wedge.crack.cosine * plane.cosine + wedge.crack.sine * plane.sine);
    sum.add(forces.water.crack.moment + forces.water.crack.force * base_along_crack);
    sum.add(-forces.water.face.moment);
    if (problem.seismic) {
        sum.add_force(middle.x(), middle.y(), -problem.seismic->horizontal_coefficient * weight, 0);
        sum.add_force(middle.x(), middle.y(), 0, -problem.seismic->vertical_coefficient * weight);
    }
    const double daylight_x = wedge.daylight_height * wedge.face.cosine / wedge.face.sine;
    for (const Surcharge<>& surcharge : problem.surcharge) {
        const double loaded = detail::loaded_length(surcharge, wedge);
        sum.add_force(wedge.crest_x + surcharge.from_distance + loaded / 2, 0, 0, -surcharge.pressure * loaded);
    }
    const Polyline ground = problem.line_load.empty() ? Polyline{} : ground_profile(problem);
    for (const LineLoad<>& load : problem.line_load) {
        if (detail::stands_on_mass(load, wedge)) {
            const detail::Force<double> force = detail::plunging_force(load.force, load.plunge);
            const double x = wedge.crest_x + load.distance_behind_crest;
            sum.add_force(x, height_of_ground(ground, x + daylight_x) - wedge.daylight_height, force.x, force.y);
        }
    }
    for_each_bolt(problem, wedge, [&](const Bolt<>& bolt) {
        const detail::Force<double> force = detail::plunging_force(bolt.force, bolt.plunge);
        const double height = bolt.head_height - wedge.daylight_height;
        sum.add_force(height * wedge.face.cosine / wedge.face.sine, height, force.x, force.y);
    });
    return sum;
}

PlaneFailureOutcome outcome_of(const PlaneFailureResult& result, bool lifted) {
    const bool slides = result.factor_of_safety < 1;
    const bool overturns = result.overturning_factor < 1;
    if (lifted) {
        return PlaneFailureOutcome::lifts_off;
    }
    if (slides && overturns) {
        return PlaneFailureOutcome::slides_and_overturns;
    }
    if (slides) {
        return PlaneFailureOutcome::slides;
    }
    return overturns ? PlaneFailureOutcome::overturns : PlaneFailureOutcome::stable;
}

PlaneFailureResult result_of(const PlaneFailure<>& problem, const Forces& forces) {
    const Wedge<double>& wedge = forces.wedge;
    PlaneFailureResult result;
    result.check = forces.check;
    result.crack_location = wedge.crack_location;
    result.factor_of_safety = forces.stability.factor_of_safety;
    result.plane_dip = problem.failure_plane.dip;
    result.crack_dip = problem.tension_crack ? problem.tension_crack->dip : degrees(90);
    result.crack_depth = wedge.crack_depth();
    result.crack_distance_behind_crest = wedge.crack_top_x - wedge.crest_x;
    result.crack_base_height = wedge.daylight_height + wedge.base_top_height();
    result.crack_top_height = result.crack_base_height + result.crack_depth;
    result.crack_base_below_crest = wedge.crest_height - wedge.base_top_height();
    result.sliding_area = wedge.base_length;
    result.section_area = wedge.area;
    result.weight = forces.stability.weight;
    result.base_water_force = forces.water.base.force;
    result.crack_water_force = forces.water.crack.force;
    result.normal_force = forces.stability.normal_force;
    result.driving_force = forces.stability.driving_force;
    result.resisting_force = forces.stability.resisting_force;
    result.friction_margin = std::atan2(result.resisting_force, std::abs(result.normal_force)) -
                             std::atan2(result.driving_force, std::abs(result.normal_force));
    const MomentSum sum = moments(problem, forces);
    result.restoring_moment = sum.restoring();
    result.overturning_moment = sum.overturning();
    result.overturning_factor =
        sum.overturning() > 0 ? sum.restoring() / sum.overturning() : std::numeric_limits<double>::infinity();
    result.normal_force_position =
        result.normal_force == 0
            ? std::copysign(std::numeric_limits<double>::infinity(), sum.restoring() - sum.overturning())
            : (sum.restoring() - sum.overturning()) / (result.normal_force * wedge.base_length);
    result.outcome = outcome_of(result, forces.stability.lifted);
    return result;
}

}  // namespace

FactorOfSafety factor_of_safety(const PlaneFailure<>& problem) {
    const Forces forces = evaluate(problem);
    const bool valid = forces.check == PlaneFailureCheck::valid;
    return {forces.check, valid ? forces.stability.factor_of_safety : std::numeric_limits<double>::quiet_NaN()};
}

PlaneFailureCheck check_ranges(const PlaneFailure<>& problem) {
    return in_range(problem) ? PlaneFailureCheck::valid : PlaneFailureCheck::input_out_of_range;
}

PlaneFailureResult analyse(const PlaneFailure<>& problem) {
    PlaneFailureResult result;
    result.check = check_ranges(problem);
    if (result.check != PlaneFailureCheck::valid) {
        return result;
    }
    const Forces forces = evaluate(problem);
    if (forces.check != PlaneFailureCheck::valid) {
        result.check = forces.check;
        return result;
    }
    return result_of(problem, forces);
}

Polyline ground_profile(const PlaneFailure<>& problem) {
    const SlopeSection<>& slope = problem.slope;
    Polyline ground = {Point(0, 0), Point(slope.height / std::tan(slope.face_dip), slope.height)};
    if (slope.bench) {
        ground.push_back(ground.back() + slope.bench->width * Point(1, std::tan(slope.bench->dip)));
    }
    Wedge<double> wedge;
    const double mass_end = make_wedge(problem, wedge) == PlaneFailureCheck::valid
                                ? wedge.crack_top_x + wedge.daylight_height / std::tan(slope.face_dip)
                                : 0.0;
    const double end = std::max(mass_end, ground.back().x()) + slope.height / 3;
    ground.push_back(ground.back() + (end - ground.back().x()) * Point(1, std::tan(slope.upper_surface_dip)));
    return ground;
}

std::vector<std::size_t> bolts_that_hold_nothing(const PlaneFailure<>& problem) {
    Wedge<double> wedge;
    std::vector<std::size_t> idle;
    if (make_wedge(problem, wedge) == PlaneFailureCheck::valid) {
        std::size_t index = 0;
        for_each_bolt(problem, wedge, [&](const Bolt<>& bolt) {
            if (index < problem.bolt.size() && bolt.force < problem.bolt[index].force) {
                idle.push_back(index);
            }
            ++index;
        });
    }
    return idle;
}

std::vector<std::vector<BoltRow>> support_rows(const PlaneFailure<>& problem) {
    Wedge<double> wedge;
    if (make_wedge(problem, wedge) != PlaneFailureCheck::valid) {
        return {};
    }
    std::vector<std::vector<BoltRow>> rows;
    for (const PlaneSupport<>& support : problem.support) {
        PlaneFailure<> alone = problem;
        alone.bolt.clear();
        alone.support = {support};
        std::vector<BoltRow>& pattern = rows.emplace_back();
        for_each_bolt(alone, wedge, [&](const Bolt<>& bolt) {
            pattern.push_back({{bolt.head_height / std::tan(problem.slope.face_dip), bolt.head_height}, bolt.force});
        });
    }
    return rows;
}

Polyline profile_after_failure(const PlaneFailure<>& problem) {
    Wedge<double> wedge;
    if (make_wedge(problem, wedge) != PlaneFailureCheck::valid) {
        return {};
    }
    const Point daylight(wedge.daylight_height * wedge.face.cosine / wedge.face.sine, wedge.daylight_height);
    const Point base_top = daylight + Point(wedge.base_top_x, wedge.base_top_height());
    const Point crack_top = base_top + wedge.crack_length * Point(wedge.crack.cosine, wedge.crack.sine);
    Polyline profile = {Point(0, 0)};
    if (wedge.daylight_height > 0) {
        profile.push_back(daylight);
    }
    profile.push_back(base_top);
    if (wedge.crack_length > 0) {
        profile.push_back(crack_top);
    }
    for (const Point& point : ground_profile(problem)) {
        if (point.x() > crack_top.x()) {
            profile.push_back(point);
        }
    }
    return profile;
}

ResolvedStudy resolve(const PlaneFailureStudy<>& study) {
    if (!study.critical) {
        return {check_ranges(study.model), study.model, false, 0};
    }
    const CriticalGeometry critical = find_critical_geometry(study.model, *study.critical);
    return {critical.check, critical.problem, critical.at_boundary, critical.factor_of_safety};
}

namespace {

constexpr std::string_view base_elevation_name = "crack_base_elevation";
constexpr std::string_view top_elevation_name = "crack_top_elevation";

Prediction predict(PlaneFailureStudy<> study, std::span<const Assignment> assignments) {
    assign(study.model, assignments);
    const ResolvedStudy resolved = resolve(study);
    if (resolved.check != PlaneFailureCheck::valid) {
        return {word_of(resolved.check), {}, {}};
    }
    const PlaneFailureResult result = analyse(resolved.problem);
    if (result.check != PlaneFailureCheck::valid) {
        return {word_of(result.check), {}, {}};
    }
    Prediction prediction{{}, output_values(result), {}};
    if (study.model.slope.toe_elevation) {
        prediction.outputs.push_back(result.crack_base_height + *study.model.slope.toe_elevation);
        prediction.outputs.push_back(result.crack_top_height + *study.model.slope.toe_elevation);
    }
    prediction.profile = profile_after_failure(resolved.problem);
    return prediction;
}

}  // namespace

ModelInterface model_interface(const PlaneFailureStudy<>& study) {
    ModelInterface model;
    model.inputs = inputs_of(study.model);
    model.outputs = outputs_of(PlaneFailureResult{});
    if (study.model.slope.toe_elevation) {
        model.outputs.push_back(
            {std::string(base_elevation_name), Dimension::length, "elevation of the crack's bottom"});
        model.outputs.push_back({std::string(top_elevation_name), Dimension::length, "elevation of the crack's top"});
    }
    model.predict = [study](std::span<const Assignment> assignments) { return predict(study, assignments); };
    return model;
}

}  // namespace delabole
