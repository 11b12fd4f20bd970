// Two blocks of equal height on a plane: Fig 4.7 of the thesis with the weights behind its boundaries, and the force
// between the blocks, equations (12) and (13).
#include "cases/program/thesis/chapter_4/chapter_4.hpp"
#include "fitting/work/words.hpp"
#include "limit_equilibrium/block_row/block_row_solver.hpp"
#include "limit_equilibrium/block_row/closed_forms.hpp"
#include "plots/drawing/extent.hpp"
#include "plots/drawing/text.hpp"
#include "plots/figures/figures.hpp"

#include <array>
#include <cmath>

namespace delabole {

namespace {

constexpr std::array<double, 2> frictions = {20, 35};
constexpr std::array<Colour, 2> colours = {Colour::blue, Colour::vermilion};
constexpr std::array<double, 2> printed_boundaries = {32.6, 25.3};  // deg, a/b = 9, for `frictions`

double forward(double slenderness, double w, double phi, double psi) {
    return tilt_or_gap(closed_form::two_blocks_forward(slenderness, 1.0, w, 1 - w, tangent(phi), tangent(psi)));
}

double backward(double slenderness, double w, double phi, double psi) {
    return tilt_or_gap(closed_form::two_blocks_backward(slenderness, 1.0, w, 1 - w, tangent(phi), tangent(psi)));
}

double boundary(double slenderness, double w, double phi) {
    return in_degrees(closed_form::boundary_base_friction(slenderness, 1.0, w, tangent(phi)));
}

Line single_block_line(double slenderness, double from, double to) {
    Line line{.points = {Point(from, in_degrees(1 / slenderness)), Point(to, in_degrees(1 / slenderness))},
              .legend = "single block, tan θ = b / a",
              .colour = Colour::grey,
              .dash = Dash::dotted};
    return line;
}

constexpr double highest_psi = 50;  // deg, of the graphs

// Draws both modes of two blocks over base friction, for both interface frictions. Below atan(b / a) they slide.
Figure modes_figure(double slenderness, double w) {
    const std::string ratio = number_in_words(slenderness);
    Figure figure = tilt_figure("Two blocks, a/b = " + ratio, "base friction ψ", "deg");
    const double least = in_degrees(1 / slenderness);
    for (std::size_t index = 0; index < frictions.size(); ++index) {
        const double phi = frictions[index];
        const std::string words = number_in_words(phi) + "°";
        figure.series.emplace_back(curve(least, highest_psi, "forward (FP), φ = " + words, colours[index], Dash::solid,
                                         [&](double psi) { return forward(slenderness, w, phi, psi); }));
        figure.series.emplace_back(curve(least, highest_psi, "backward (PB), φ = " + words, colours[index],
                                         Dash::dashed, [&](double psi) { return backward(slenderness, w, phi, psi); }));
    }
    figure.series.emplace_back(single_block_line(slenderness, least, highest_psi));
    return figure;
}

// Marks both printed values for a/b = 9 on the forward mode with this share of the weight in the lower block.
void mark_printed_boundaries(Figure& figure, double w) {
    std::vector<PrintedStatement> printed;
    for (std::size_t index = 0; index < frictions.size(); ++index) {
        const double psi = printed_boundaries[index];
        printed.push_back(
            {"printed boundary, φ = " + number_in_words(frictions[index]) + " deg: " + number_in_words(psi) + " deg",
             Point(psi, forward(9, w, frictions[index], psi))});
    }
    Frame frame;
    for (const Series& series : figure.series) {
        if (const auto* line = std::get_if<Line>(&series)) {
            frame.include(line->points);
        }
    }
    figure.x.range = std::pair{frame.x.lowest - 1, frame.x.highest + 1};
    figure.y.range = std::pair{frame.y.lowest - 1, frame.y.highest + 1};
    mark_statements(printed, 1, 1, figure);
}

// Finds the share of the lower block's weight that fits both printed boundaries best, by one Gauss-Newton step from the
// middle of the two shares that fit one each, which differ by 0.0001.
double least_squares_share(const std::array<double, 2>& shares, double slenderness) {
    constexpr double change = 1e-4;
    const double middle = (shares[0] + shares[1]) / 2;
    double numerator = 0;
    double denominator = 0;
    for (std::size_t index = 0; index < frictions.size(); ++index) {
        const double slope = (boundary(slenderness, middle + change, frictions[index]) -
                              boundary(slenderness, middle - change, frictions[index])) /
                             (2 * change);
        numerator += slope * slope * shares[index];
        denominator += slope * slope;
    }
    return numerator / denominator;
}

// The force between two equal blocks, per weight of a block, at the tilt at which the mode begins.
struct Interaction {
    RowModeCheck check{};
    double tilt_tangent = 0;
    double thrust = 0;
};

Interaction interaction(std::string_view roles, double slenderness, double phi, double psi) {
    const std::vector<RowMember<double>> members = row_members(equal_row(2, slenderness, phi, psi));
    const RowMode<double> mode = RowModeSolver<double>(members).solve(roles, 0);
    return {mode.check, mode.tangent, mode.forces.empty() ? 0 : mode.forces.front().thrust / members.front().weight};
}

// Counts where S is compressive as the thesis states. Closed forms leave rounding where S is 0.
struct SignsOfInteraction {
    int forward = 0;
    int forward_as_printed = 0;  // compressive just where psi > theta and phi + psi < 90 deg
    int backward = 0;
    int backward_compressive = 0;
};

// The grid avoids pairs of angles that add up to 90 deg, and the angle at which a block topples alone.
SignsOfInteraction signs_of_interaction() {
    constexpr double rounding = 1e-12;
    SignsOfInteraction signs;
    for (const double slenderness : {1.5, 3.0, 9.0}) {
        for (double phi = 5; phi < 90; phi += 5) {
            for (double psi = 2.5; psi < 90; psi += 5) {
                const Interaction forward = interaction("FP", slenderness, phi, psi);
                const bool holds = phi + psi < 90 && tangent(psi) > forward.tilt_tangent;
                ++signs.forward;
                signs.forward_as_printed += holds == (forward.thrust > rounding) ? 1 : 0;
                const Interaction backward = interaction("PB", slenderness, phi, psi);
                if (backward.check != RowModeCheck::no_tilt) {
                    ++signs.backward;
                    signs.backward_compressive += backward.thrust > rounding ? 1 : 0;
                }
            }
        }
    }
    return signs;
}

// The greatest friction of both base and interface with which a block can be pushed forward, by bisection.
double greatest_equal_friction(double slenderness) {
    double moves = 20;
    double locked = 80;
    while (locked - moves > 1e-9) {
        const double middle = (moves + locked) / 2;
        (interaction("FP", slenderness, middle, middle).check == RowModeCheck::locked ? locked : moves) = middle;
    }
    return moves;
}

PrintedRow count_row(const std::string& what, const std::string& printed, int met, int of) {
    return {what, printed, "in " + std::to_string(met) + " of " + std::to_string(of), "", statement(met == of)};
}

}  // namespace

Reproduction reproduce_force_between_two_blocks(const Sheet& sheet) {
    constexpr double slenderness = 3;
    constexpr double phi = 20;
    constexpr double psi = 35;
    const double c = tangent(psi);
    const double m = tangent(phi) * c;
    Reproduction result;
    const auto row = [&](const std::string& name, double printed, double computed) {
        result.add({name + ": S per weight, a/b = 3, φ = 20 deg, ψ = 35 deg", human_number(printed, 5),
                    human_number(computed, 5), difference_in_words(computed - printed),
                    "at the tilt at which the mode begins"});
        result.json[name] = {{"printed", printed}, {"computed", computed}};
    };
    const Interaction forward = interaction("FP", slenderness, phi, psi);
    double theta = std::atan(forward.tilt_tangent);
    row("(12) forward", (c * std::cos(theta) - std::sin(theta)) / (1 - m), forward.thrust);
    const Interaction backward = interaction("PB", slenderness, phi, psi);
    theta = std::atan(backward.tilt_tangent);
    row("(13) backward", (std::sin(theta) + c * std::cos(theta)) / (1 + m), backward.thrust);
    const SignsOfInteraction signs = signs_of_interaction();
    result.add(count_row("forward: S is compressive", "where ψ > θ and φ + ψ < 90 deg", signs.forward_as_printed,
                         signs.forward));
    result.add(count_row("backward: S is compressive", "always", signs.backward_compressive, signs.backward));
    const double threshold = interaction("FP", slenderness, phi, in_degrees(1 / slenderness)).thrust;
    result.add("forward: S where ψ = θ = atan(b/a)", "0", difference_in_words(threshold),
               statement(std::abs(threshold) < 1e-9));
    const double greatest = greatest_equal_friction(slenderness);
    result.add({"forward: greatest φ = ψ with S compressive", "45 deg", human_number(greatest, 4) + " deg",
                difference_in_words(greatest - 45) + " deg", statement(std::abs(greatest - 45) < 1e-6)});
    result.json["greatest_equal_friction_deg"] = greatest;
    sheet.add(Heading{"Equations (12) and (13): the force between two blocks"});
    sheet.add(Paragraph{
        "S is the thrust between two equal blocks. Its signs were computed on a grid of φ from 5 to 85 deg, ψ from 2.5 "
        "to 87.5 deg and a/b = 1.5, 3 and 9, each at the tilt at which the mode begins; backward where it has one. "
        "From φ + ψ = 90 deg on, a thrust lies within the friction cone of the base and pushes no block forward."});
    sheet.add(printed_table("Force between two blocks", result.rows));
    return result;
}

Reproduction reproduce_fig_4_7(const Sheet& sheet) {
    constexpr double slenderness = 9;
    constexpr double equal = 0.5;
    Reproduction result;
    std::array<double, 2> shares{};
    for (std::size_t index = 0; index < frictions.size(); ++index) {
        const double phi = frictions[index];
        const std::string words = number_in_words(phi);
        shares[index] =
            closed_form::weight_share_at_boundary(slenderness, 1.0, tangent(phi), tangent(printed_boundaries[index]));
        const double ratio = shares[index] / (1 - shares[index]);
        const double computed = boundary(slenderness, equal, phi);
        result.add(angle_row("boundary ψ, φ = " + words + " deg, equal weights", printed_boundaries[index], computed,
                             "printed with the weights of the blocks, which are not printed"));
        result.add("W1/W2 that gives the printed one, φ = " + words + " deg", "not printed", human_number(ratio, 4),
                   "back-analysed");
        result.json["phi_" + words] = {{"boundary_psi_equal_weights_deg", computed}, {"weight_ratio", ratio}};
    }
    const double best = least_squares_share(shares, slenderness);
    const double best_ratio = best / (1 - best);
    result.add("W1/W2 that gives both best", "not printed", human_number(best_ratio, 4), "least squares");
    result.json["weight_ratio_least_squares"] = best_ratio;
    Figure figure = modes_figure(slenderness, best);
    figure.title = "Fig 4.7: two blocks, a/b = 9, W1/W2 = " + human_number(best_ratio, 4);
    Points equal_weights{.legend = "boundaries with equal weights", .marker = Marker::circle, .size = 1.8};
    for (std::size_t index = 0; index < frictions.size(); ++index) {
        const double phi = frictions[index];
        const double psi = boundary(slenderness, best, phi);
        result.add(angle_row("boundary ψ, φ = " + number_in_words(phi) + " deg, that ratio", printed_boundaries[index],
                             psi, "one unknown for two printed values"));
        const double crossing = boundary(slenderness, equal, phi);
        equal_weights.points.emplace_back(crossing, forward(slenderness, equal, phi, crossing));
    }
    figure.series.emplace_back(equal_weights);
    figure.height = 580;  // the curves lie close together at the marks
    mark_printed_boundaries(figure, best);
    sheet.add(Heading{"Fig 4.7: two blocks, a/b = 9"});
    sheet.add(Paragraph{
        "The boundary between the modes depends on the weights. Each printed boundary alone gives a ratio of the "
        "weights; the two agree to 0.001, so that an upper block 4 % heavier than the lower one explains both."});
    sheet.add(printed_table("Boundary between forward and backward mode", result.rows));
    sheet.draw(figure, "fig_4_7", "The lower curve of each pair governs.");
    return result;
}

}  // namespace delabole
