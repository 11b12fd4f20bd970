#include "plane_failure/water_diagram.hpp"

#include "plane_failure/stability.hpp"

#include <algorithm>
#include <functional>

namespace delabole {

namespace {

using Pressure = std::function<double(double)>;  // pressure as a function of distance along the surface

struct Pressures {
    Pressure base = [](double) { return 0.0; };
    Pressure crack = [](double) { return 0.0; };
};

double interpolate(const std::vector<PressurePoint<>>& points, double position) {
    for (std::size_t index = 1; index < points.size(); ++index) {
        const PressurePoint<>& left = points[index - 1];
        const PressurePoint<>& right = points[index];
        if (position >= left.position && position <= right.position) {
            return left.pressure +
                   (right.pressure - left.pressure) * (position - left.position) / (right.position - left.position);
        }
    }
    return 0;
}

// The forms of WaterVisitor as functions of place; the resultants there are their integrals, as a test verifies.
struct PressureVisitor {
    const PlaneFailure<>& problem;
    const Wedge<double>& wedge;
    detail::PondAtMass<double> pond;

    // Greatest depth of water in the crack.
    double full_crack() const {
        return problem.tension_crack ? std::max(wedge.crack_depth(), pond.depth_in_crack(wedge)) : 0;
    }

    double depth_in_crack(const WaterLevel<>& level) const {
        double depth = 0;
        detail::water_depth(level, problem, wedge, wedge.base_top_height(), full_crack(), depth);
        return depth;
    }

    Pressure hydrostatic(double unit_weight, double height, const SineCosine<double>& dip) const {
        return [=](double s) { return unit_weight * std::max(0.0, height - s * dip.sine); };
    }

    Pressures operator()(const Dry&) const {
        return {hydrostatic(pond.unit_weight, pond.height, wedge.plane),
                hydrostatic(pond.unit_weight, pond.depth_in_crack(wedge), wedge.crack)};
    }

    Pressures operator()(const CrackAndBaseWater<>& water) const {
        const double depth = depth_in_crack(water.level);
        const double at_top = water.unit_weight * depth;
        const double at_daylight = pond.pressure_at(0);
        const double length = wedge.base_length;
        return {[=](double s) { return at_daylight + (at_top - at_daylight) * s / length; },
                hydrostatic(water.unit_weight, depth, wedge.crack)};
    }

    Pressures operator()(const CrackOnlyWater<>& water) const {
        return {(*this)(Dry{}).base, hydrostatic(water.unit_weight, depth_in_crack(water.level), wedge.crack)};
    }

    Pressures operator()(const BasePeakMidHeightWater<>& water) const {
        double height = 0;
        detail::water_depth(water.level, problem, wedge, 0.0, wedge.base_top_height(), height);
        const double middle = height / (2 * wedge.plane.sine);
        const double peak = water.unit_weight * height / 2;
        const double at_daylight = pond.pressure_at(0);
        Pressures pressures;
        pressures.base = [=](double s) {
            if (s <= middle) {
                return middle > 0 ? at_daylight + (peak - at_daylight) * s / middle : 0.0;
            }
            return std::max(0.0, peak * (2 - s / middle));
        };
        return pressures;
    }

    Pressures operator()(const PeakAtToeWater<>& water) const {
        double height = 0;
        const double full = wedge.base_top_height() + full_crack();
        detail::water_depth(water.level, problem, wedge, 0.0, full, height);
        return {hydrostatic(water.unit_weight, height, wedge.plane),
                hydrostatic(water.unit_weight, height - wedge.base_top_height(), wedge.crack)};
    }

    Pressures operator()(const PiezometricLineWater<>& water) const {
        const auto below_line = [&water](double x, double y, const SineCosine<double>& dip) {
            return [=, line = water.point, unit_weight = water.unit_weight](double s) {
                const double level = detail::piezometric_height(line, x + s * dip.cosine);
                return unit_weight * std::max(0.0, level - y - s * dip.sine);
            };
        };
        const double x = wedge.daylight_height * wedge.face.cosine / wedge.face.sine;
        return {below_line(x, wedge.daylight_height, wedge.plane),
                below_line(x + wedge.base_top_x, wedge.daylight_height + wedge.base_top_height(), wedge.crack)};
    }

    Pressures operator()(const CustomWater<>& water) const {
        const double base_length = wedge.base_length;
        const double crack_length = wedge.crack_length;
        return {[=, points = water.base](double s) { return interpolate(points, s / base_length); },
                [=, points = water.crack](double s) { return interpolate(points, s / crack_length); }};
    }
};

constexpr int surface_points = 201;

SurfacePressure sample(const Pressure& pressure, const Point& start, const SineCosine<double>& dip, double length) {
    SurfacePressure sampled;
    for (int index = 0; index < surface_points; ++index) {
        const double s = length * index / (surface_points - 1);
        sampled.surface.push_back(start + s * Point(dip.cosine, dip.sine));
        sampled.pressure.push_back(pressure(s));
    }
    return sampled;
}

}  // namespace

WaterDiagram water_diagram(const PlaneFailure<>& problem) {
    WaterDiagram diagram;
    const Equilibrium<double> forces = evaluate(problem);
    if (forces.check != PlaneFailureCheck::valid) {
        return diagram;
    }
    const Wedge<double>& wedge = forces.wedge;
    const Pressures pressures =
        std::visit(PressureVisitor{problem, wedge, pond_at_mass(problem, wedge)}, problem.water);
    const Point daylight(wedge.daylight_height * wedge.face.cosine / wedge.face.sine, wedge.daylight_height);
    diagram.base = sample(pressures.base, daylight, wedge.plane, wedge.base_length);
    if (!problem.tension_crack) {
        return diagram;
    }
    diagram.crack = sample(pressures.crack, diagram.base.surface.back(), wedge.crack, wedge.crack_length);
    for (std::size_t index = 0; index < diagram.crack.pressure.size(); ++index) {
        if (diagram.crack.pressure[index] > 0) {
            diagram.water_in_crack.push_back(diagram.crack.surface[index]);
        }
    }
    return diagram;
}

}  // namespace delabole
