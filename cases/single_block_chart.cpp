#include "cases/single_block_chart.hpp"

#include "limit_equilibrium/single_block.hpp"

#include <algorithm>
#include <cmath>

namespace delabole {

namespace {

constexpr double right_angle = degrees(90);
constexpr int steps = 90;

// Slenderness angle below which a dry block turns about a toe that does not slip; the toe slips for stockier ones.
double slip_boundary(double inclination, double friction_angle) {
    double slender = 0;
    double stocky = std::min(inclination, friction_angle);
    // To far less than the width of a line: slender columns need less friction than stocky blocks.
    for (int halving = 0; halving < 50; ++halving) {
        const double middle = (slender + stocky) / 2;
        (toe_slip_friction_angle(inclination, middle) < friction_angle ? slender : stocky) = middle;
    }
    return slender;
}

}  // namespace

ModeChart single_block_chart(double friction_angle, BlockCriteria criteria, const std::string& title) {
    const double phi = friction_angle;
    ModeChart chart{.title = title, .x = "base.inclination", .y = "block.slenderness_angle"};
    const Point corner(phi, phi);
    chart.regions.push_back({DrawnMode::stays, {Point(0, 0), corner, Point(phi, right_angle), Point(0, right_angle)}});
    chart.boundaries.push_back({"slides: inclination = friction", {Point(phi, phi), Point(phi, right_angle)}});
    if (criteria == BlockCriteria::superposed_static) {
        chart.regions.push_back(
            {DrawnMode::slides, {corner, Point(right_angle, right_angle), Point(phi, right_angle)}});
        chart.regions.push_back({DrawnMode::topples, {Point(0, 0), Point(phi, 0), corner}});
        chart.regions.push_back({DrawnMode::slides_and_topples,
                                 {Point(phi, 0), Point(right_angle, 0), Point(right_angle, right_angle), corner}});
        chart.boundaries.push_back({"slides, continued", {Point(phi, 0), corner}});
        chart.boundaries.push_back(
            {"topples: inclination = atan(b / a)", {Point(0, 0), Point(right_angle, right_angle)}});
        return chart;
    }
    Polyline slip{corner};
    for (int step = 1; step < steps; ++step) {
        const double inclination = phi + (right_angle - phi) * step / steps;
        slip.emplace_back(inclination, slip_boundary(inclination, phi));
    }
    Polyline topples{Point(0, 0), corner};
    topples.insert(topples.end(), slip.begin() + 1, slip.end());
    topples.emplace_back(slip.back().x(), 0);
    Polyline both = slip;
    both.emplace_back(slip.back().x(), phi);
    chart.regions.push_back(
        {DrawnMode::slides,
         {corner, Point(right_angle, phi), Point(right_angle, right_angle), Point(phi, right_angle)}});
    chart.regions.push_back({DrawnMode::topples, topples});
    chart.regions.push_back({DrawnMode::slides_and_topples, both});
    chart.boundaries.push_back({"topples: inclination = atan(b / a)", {Point(0, 0), corner}});
    chart.boundaries.push_back({"toe of the toppling block slips", slip});
    chart.boundaries.push_back({"no toppling: atan(b / a) = friction", {corner, Point(right_angle, phi)}});
    return chart;
}

}  // namespace delabole
