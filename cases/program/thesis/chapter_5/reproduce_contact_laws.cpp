// Fig 5.4 of the thesis: the laws of contact, shown by a corner that is pressed into an edge and pulled along it.
#include "cases/program/thesis/chapter_5/chapter_5.hpp"
#include "dynamic_relaxation/contact/contact_law.hpp"
#include "plots/drawing/text.hpp"

#include <algorithm>
#include <cmath>

namespace delabole {

namespace {

constexpr double stiffness = 6e6;     // N/m, of blocks of a/b = 3
constexpr double pressed = 1e-6;      // m, for shear
constexpr double peak = degrees(40);  // of friction
constexpr double residual = degrees(20);

ContactLaw law_of(double friction_after_slip) {
    ContactLaw law{};
    law.start_weight = law.end_weight = 1;
    law.normal_stiffness = law.shear_stiffness = stiffness;
    law.friction = std::tan(peak);
    law.residual_friction = std::tan(friction_after_slip);
    return law;
}

struct ContactPair {
    double normal = 0;  // N/m, that the edge exerts on the corner
    double shear = 0;   // N/m, that resists the corner's displacement
};

// Returns the forces on a corner at these places in order: x along the edge, y above it.
std::vector<ContactPair> forces_at(const ContactLaw& law, const Polyline& places) {
    RelaxationContact contact{};
    contact.along_x = -1;  // so that the edge's outward normal points up
    contact.from_start = contact.to_end = 1;
    ContactMemory memory{};
    double open_by = 0;
    std::vector<ContactPair> forces;
    for (const Point& place : places) {
        Motion corner{};
        corner.x = place.x();
        corner.y = place.y();
        const ForceOnCorner force = advance_contact(law, contact, std::nullopt, corner, Motion{}, 1, memory, open_by);
        forces.push_back({force.y, -force.x});
    }
    return forces;
}

// Moves straight to the end in so many steps.
void move_to(Polyline& places, const Point& end, int steps) {
    const Point start = places.back();
    for (int step = 1; step <= steps; ++step) {
        places.push_back(start + (end - start) * step / steps);
    }
}

Figure law_figure(const std::string& title, const std::string& x, const std::string& y, const Polyline& curve) {
    Figure figure{.title = title, .x = {.title = x, .unit = "1e-6 m"}, .y = {.title = y, .unit = "N/m"}, .height = 380};
    figure.series.emplace_back(Line{.points = curve, .colour = Colour::blue});
    return figure;
}

// The corner is pulled to and fro along the edge under a constant pressure.
Polyline shear_curve(const ContactLaw& law) {
    Polyline places{Point(0, -pressed)};
    move_to(places, Point(2e-6, -pressed), 200);
    move_to(places, Point(0.5e-6, -pressed), 200);
    move_to(places, Point(3e-6, -pressed), 200);
    const std::vector<ContactPair> forces = forces_at(law, places);
    Polyline curve;
    for (std::size_t index = 0; index < places.size(); ++index) {
        curve.emplace_back(places[index].x() * 1e6, forces[index].shear);
    }
    return curve;
}

double greatest(const Polyline& curve) {
    return std::ranges::max_element(curve, {}, [](const Point& point) { return point.y(); })->y();
}

}  // namespace

void laws_of_contact(Chapter5Item& item) {
    Polyline places{Point(0, 1e-6)};
    move_to(places, Point(0, -2e-6), 120);
    move_to(places, Point(0, 1e-6), 120);
    const std::vector<ContactPair> pressing = forces_at(law_of(peak), places);
    Polyline normal;
    double open = 0;  // the greatest force where the corner is off the edge
    double slope = 0;
    for (std::size_t index = 0; index < places.size(); ++index) {
        const double overlap = -places[index].y();
        normal.emplace_back(overlap * 1e6, pressing[index].normal);
        open = overlap < 0 ? std::max(open, std::abs(pressing[index].normal)) : open;
        slope = overlap > 1.9e-6 ? pressing[index].normal / overlap : slope;
    }
    const double strength = stiffness * pressed * std::tan(peak);
    const Polyline plastic = shear_curve(law_of(peak));
    const Polyline brittle = shear_curve(law_of(residual));
    const double after = brittle.back().y();
    constexpr double rounding = 1e-9;  // of forces, relative
    const auto close = [&](double value, double to) { return statement(std::abs(value - to) <= rounding * to); };
    const double residual_share = std::tan(residual) / std::tan(peak);
    item.result.rows = {
        {"(a) normal: force while the joint is open", "none", human_number(open, 3) + " N/m", "", statement(open == 0)},
        {"(a) normal: force over overlap", "elastic, k", human_number(slope / 1e6, 4) + "e6 N/m per m", "",
         close(slope, stiffness)},
        {"(b) shear: greatest force over k overlap tan(friction)", "1", human_number(greatest(plastic) / strength, 4),
         "", close(greatest(plastic), strength)},
        {"(b) shear: force at the end, slipping again", "as at first", human_number(plastic.back().y(), 4) + " N/m", "",
         close(plastic.back().y(), strength)},
        {"(c) brittle: force at the end over the peak", "drops to the residual", human_number(after / strength, 4), "",
         close(after, strength * residual_share) + ": tan 20 deg / tan 40 deg = " + human_number(residual_share, 4)}};
    item.draw(law_figure("Fig 5.4 (a): normal", "overlap", "normal force", normal), "fig_5_4_a",
              "Pressed and released along one line; no tension.");
    item.draw(law_figure("Fig 5.4 (b): elastic-plastic shear", "displacement along the edge", "shear force", plastic),
              "fig_5_4_b", "Pulled forward, back and forward again.");
    item.draw(law_figure("Fig 5.4 (c): brittle shear", "displacement along the edge", "shear force", brittle),
              "fig_5_4_c", "The first slip drops the force to the residual, at which it stays.");
}

}  // namespace delabole
