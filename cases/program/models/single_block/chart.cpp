#include "cases/program/models/single_block/chart.hpp"

#include "limit_equilibrium/block_row/single_block.hpp"

#include <cmath>

namespace delabole {

namespace {

constexpr double right_angle = degrees(90);
constexpr int steps = 90;

// Inclination above which the toe of a toppling dry block slips; 90 deg if it never does. The bisection is over the
// inclination, because the friction needed increases with it; with the slenderness it decreases and increases.
double slip_inclination(double slenderness_angle, double friction_angle) {
    double low = slenderness_angle;
    double high = right_angle;
    // The error is then far less than the width of a line.
    for (int halving = 0; halving < 50; ++halving) {
        const double middle = (low + high) / 2;
        (toe_slip_friction_angle(middle, slenderness_angle) < friction_angle ? low : high) = middle;
    }
    return low;
}

}  // namespace

ModeChart single_block_chart(double friction_angle, BlockCriteria criteria, const std::string& title) {
    const double phi = friction_angle;
    ModeChart chart{.title = title, .x = "base.inclination", .y = "block.slenderness_angle"};
    const Point corner(phi, phi);
    chart.regions.push_back({DrawnMode::stays, {Point(0, 0), corner, Point(phi, right_angle), Point(0, right_angle)}});
    if (criteria == BlockCriteria::superposed_static) {
        chart.regions.push_back(
            {DrawnMode::slides, {corner, Point(right_angle, right_angle), Point(phi, right_angle)}});
        chart.regions.push_back({DrawnMode::topples, {Point(0, 0), Point(phi, 0), corner}});
        chart.regions.push_back({DrawnMode::slides_and_topples,
                                 {Point(phi, 0), Point(right_angle, 0), Point(right_angle, right_angle), corner}});
        chart.boundaries.push_back({"slides: inclination = friction", {Point(phi, 0), Point(phi, right_angle)}});
        chart.boundaries.push_back(
            {"topples: inclination = atan(b / a)", {Point(0, 0), Point(right_angle, right_angle)}});
        return chart;
    }
    Polyline slip{corner};
    for (int step = 1; step < steps; ++step) {
        const double slenderness_angle = phi * (1 - static_cast<double>(step) / steps);
        slip.emplace_back(slip_inclination(slenderness_angle, phi), slenderness_angle);
    }
    // For an infinitely slender column tan(friction) = tan(inclination) / 4.
    slip.emplace_back(std::atan(4 * std::tan(phi)), 0);
    Polyline topples{Point(0, 0)};
    topples.insert(topples.end(), slip.begin(), slip.end());
    Polyline both = slip;
    both.emplace_back(right_angle, 0);
    both.emplace_back(right_angle, phi);
    chart.regions.push_back(
        {DrawnMode::slides,
         {corner, Point(right_angle, phi), Point(right_angle, right_angle), Point(phi, right_angle)}});
    chart.regions.push_back({DrawnMode::topples, topples});
    chart.regions.push_back({DrawnMode::slides_and_topples, both});
    chart.boundaries.push_back({"slides: inclination = friction", {corner, Point(phi, right_angle)}});
    chart.boundaries.push_back({"topples: inclination = atan(b / a)", {Point(0, 0), corner}});
    chart.boundaries.push_back({"toe of the toppling block slips", slip});
    chart.boundaries.push_back({"no toppling: atan(b / a) = friction", {corner, Point(right_angle, phi)}});
    return chart;
}

}  // namespace delabole
