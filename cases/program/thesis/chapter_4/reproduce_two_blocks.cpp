// Figs 4.3 to 4.8 of the thesis: two blocks of equal height on a plane.
#include "cases/program/thesis/chapter_4/chapter_4.hpp"
#include "fitting/work/words.hpp"
#include "limit_equilibrium/block_row/closed_forms.hpp"
#include "plots/drawing/text.hpp"
#include "plots/figures/figures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace delabole {

namespace {

constexpr double gap = std::numeric_limits<double>::quiet_NaN();
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
    Line line;
    line.points = {Point(from, in_degrees(1 / slenderness)), Point(to, in_degrees(1 / slenderness))};
    line.legend = "single block, tan θ = b / a";
    line.colour = Colour::grey;
    line.dash = Dash::dotted;
    return line;
}

constexpr double highest_psi = 50;  // deg, of the graphs

// Both modes of two blocks over base friction, for both frictions of the interface. Below atan(b / a) they slide.
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

// Letters without a ground of their own, which would hide the curves that the marks stand on.
void mark_on_curves(const std::vector<PrintedStatement>& printed, Figure& figure) {
    mark_statements(printed, 1, 1, figure);
    for (Label& label : figure.labels) {
        label.boxed = false;
    }
}

// Both printed values for a/b = 9, on the forward mode with this share of the weight in the lower block.
void mark_printed_boundaries(Figure& figure, double w) {
    std::vector<PrintedStatement> printed;
    for (std::size_t index = 0; index < frictions.size(); ++index) {
        const double psi = printed_boundaries[index];
        printed.push_back(
            {"printed boundary, φ = " + number_in_words(frictions[index]) + " deg: " + number_in_words(psi) + " deg",
             Point(psi, forward(9, w, frictions[index], psi))});
    }
    mark_on_curves(printed, figure);
}

// Share of the lower block's weight that gives both printed boundaries best: one step of Gauss and Newton from between
// the two shares that give one each, which differ by 0.0001.
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

}  // namespace

Reproduction reproduce_fig_4_3(const ResultFolder& folder, Report& report) {
    constexpr double slenderness = 3;
    const double single = in_degrees(1 / slenderness);
    Figure figure = tilt_figure("Two blocks, a/b = 3, forward mode", "base friction ψ", "deg");
    constexpr std::array interfaces{10.0, 20.0, 30.0, 35.0, 40.0};
    constexpr std::array five{Colour::sky, Colour::blue, Colour::green, Colour::vermilion, Colour::purple};
    double spread = 0;
    for (std::size_t index = 0; index < interfaces.size(); ++index) {
        const double phi = interfaces[index];
        figure.series.emplace_back(curve(10, std::min(60.0, 89 - phi), "φ = " + number_in_words(phi) + "°", five[index],
                                         Dash::solid, [&](double psi) { return forward(slenderness, 0.5, phi, psi); }));
        spread = std::max(spread, std::abs(forward(slenderness, 0.5, phi, single) - single));
    }
    figure.series.emplace_back(single_block_line(slenderness, 10, 60));
    Reproduction result;
    result.rows.push_back({"θ at ψ = atan(b/a), any φ", "atan(b/a)",
                           human_number(forward(slenderness, 0.5, 35, single), 5) + " deg",
                           difference_in_words(spread) + " deg", statement(spread < 1e-9)});
    result.json["spread_at_slenderness_angle_deg"] = spread;
    report.blocks.emplace_back(Heading{"Fig 4.3: two blocks, tilt against base friction"});
    report.blocks.emplace_back(
        Paragraph{"Equation (8). The ratio a/b of the printed figure is not given; here it is 3. To the left of the "
                  "common point the blocks slide before they topple."});
    report.blocks.emplace_back(printed_table("Common point of the curves", result.rows));
    report.blocks.emplace_back(folder.draw(figure, "fig_4_3", "Tilt at which two equal blocks topple in contact."));
    return result;
}

Reproduction reproduce_fig_4_4(const ResultFolder& folder, Report& report) {
    constexpr double base = 35;
    Figure figure = tilt_figure("Two columns 1 in thick, base friction 35 deg", "height", "in");
    for (std::size_t index = 0; index < frictions.size(); ++index) {
        figure.series.emplace_back(curve(2, 9, "φ = " + number_in_words(frictions[index]) + "°", colours[index],
                                         index == 0 ? Dash::dashed : Dash::solid,
                                         [&](double a) { return forward(a, 0.5, frictions[index], base); }));
    }
    figure.series.emplace_back(curve(2, 9, "both frictions 20°", Colour::green, Dash::dotted,
                                     [](double a) { return 1 / a < tangent(20) ? forward(a, 0.5, 20, 20) : gap; }));
    figure.series.emplace_back(
        curve(2, 9, "single block", Colour::grey, Dash::dotted, [](double a) { return in_degrees(1 / a); }));
    Reproduction result;
    Table table{"Critical tilt, deg, by equation (8)",
                {{"height, in", true},
                 {"single block", true},
                 {"φ = 20°, ψ = 35°", true},
                 {"φ = ψ = 35°", true},
                 {"φ = ψ = 20°", true}},
                {}};
    double largest = 0;
    for (int height = 2; height <= 9; ++height) {
        const double a = height;
        const double low = forward(a, 0.5, 20, base);
        const double high = forward(a, 0.5, 35, base);
        largest = std::max(largest, high - low);
        table.rows.push_back({number_in_words(a), human_number(in_degrees(1 / a), 4), human_number(low, 4),
                              human_number(high, 4),
                              1 / a < tangent(20) ? human_number(forward(a, 0.5, 20, 20), 4) : "slides at 20"});
        result.json["tilt_deg_by_height_in"][std::to_string(height)] = {{"phi_20", low}, {"phi_35", high}};
    }
    result.rows.push_back({"φ = 20 against 35 deg", "20 nearer to the tests",
                           "20 lower by up to " + human_number(largest, 3) + " deg", "",
                           "the tests lay below the calculation; their values are not printed"});
    report.blocks.emplace_back(Heading{"Fig 4.4: two blocks of 2 to 9 inches"});
    report.blocks.emplace_back(Paragraph{
        "Only the friction of the interface is said to have been changed; the base is taken with 35 deg. With "
        "20 deg on the base too, short columns would slide before they topple."});
    report.blocks.emplace_back(table);
    report.blocks.emplace_back(
        folder.draw(figure, "fig_4_4", "Interface friction 20 deg (slips) against 35 deg (full sliding)."));
    return result;
}

Reproduction reproduce_fig_4_6(const ResultFolder& folder, Report& report) {
    constexpr std::array ratios{3, 2, 4, 5, 6, 7, 8, 9, 10, 15, 20, 30, 40, 50};
    Reproduction result;
    Table table{"Base friction above which the backward mode governs, equal weights",
                {{"a/b", true}, {"φ = 20°", true}, {"φ = 35°", true}},
                {}};
    report.blocks.emplace_back(Heading{"Fig 4.6: forward and backward sliding modes"});
    const double first = boundary(3, 0.5, 20);
    const double second = boundary(3, 0.5, 35);
    result.rows.push_back({"a/b = 3: governing mode", "forward for both φ",
                           "forward up to ψ = " + human_number(first, 4) + " and " + human_number(second, 4) + " deg",
                           "",
                           std::min(first, second) < highest_psi
                               ? "statement met up to " + human_number(std::min(first, second), 3) + " deg"
                               : statement(true)});
    report.blocks.emplace_back(printed_table("Which mode governs", result.rows));
    for (const int ratio : ratios) {
        const double low = boundary(ratio, 0.5, 20);
        const double high = boundary(ratio, 0.5, 35);
        table.rows.push_back({std::to_string(ratio), human_number(low, 4), human_number(high, 4)});
        result.json["boundary_psi_deg"][std::to_string(ratio)] = {{"phi_20", low}, {"phi_35", high}};
    }
    report.blocks.emplace_back(table);
    for (const int ratio : ratios) {
        Figure figure = modes_figure(ratio, 0.5);
        if (ratio == 9) {
            mark_printed_boundaries(figure, 0.5);
        }
        report.blocks.emplace_back(folder.draw(
            figure, "fig_4_6_ratio_" + std::to_string(ratio),
            std::string(ratio == 3 ? "The printed one of the fourteen graphs"
                                   : "One of the thirteen that are not printed") +
                "; equal weights" +
                (ratio <= 9 ? ", where the thesis took those of its blocks, which it does not print." : ".")));
    }
    return result;
}

Reproduction reproduce_fig_4_7(const ResultFolder& folder, Report& report) {
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
        result.rows.push_back(angle_row("boundary ψ, φ = " + words + " deg, equal weights", printed_boundaries[index],
                                        computed, "printed with the weights of the blocks, which are not printed"));
        result.rows.push_back({"W1/W2 that gives the printed one, φ = " + words + " deg", "not printed",
                               human_number(ratio, 4), "", "back-analysed"});
        result.json["phi_" + words] = {{"boundary_psi_equal_weights_deg", computed}, {"weight_ratio", ratio}};
    }
    const double best = least_squares_share(shares, slenderness);
    const double best_ratio = best / (1 - best);
    result.rows.push_back(
        {"W1/W2 that gives both best", "not printed", human_number(best_ratio, 4), "", "least squares"});
    result.json["weight_ratio_least_squares"] = best_ratio;
    Figure figure = modes_figure(slenderness, best);
    figure.title = "Two blocks, a/b = 9, W1/W2 = " + human_number(best_ratio, 4);
    Points equal_weights;
    equal_weights.legend = "boundaries with equal weights";
    equal_weights.marker = Marker::circle;
    equal_weights.size = 1.8;
    for (std::size_t index = 0; index < frictions.size(); ++index) {
        const double phi = frictions[index];
        const double psi = boundary(slenderness, best, phi);
        result.rows.push_back(angle_row("boundary ψ, φ = " + number_in_words(phi) + " deg, that ratio",
                                        printed_boundaries[index], psi, "one unknown for two printed values"));
        const double crossing = boundary(slenderness, equal, phi);
        equal_weights.points.emplace_back(crossing, forward(slenderness, equal, phi, crossing));
    }
    figure.series.emplace_back(equal_weights);
    mark_printed_boundaries(figure, best);
    report.blocks.emplace_back(Heading{"Fig 4.7: two blocks, a/b = 9"});
    report.blocks.emplace_back(
        Paragraph{"The boundary between the modes depends on the weights. Each printed boundary alone gives a ratio of "
                  "the weights; the two agree to 0.001, so that an upper block 4 % heavier than the lower one "
                  "explains both."});
    report.blocks.emplace_back(printed_table("Boundary between forward and backward mode", result.rows));
    report.blocks.emplace_back(folder.draw(figure, "fig_4_7", "The lower curve of each pair governs."));
    return result;
}

Reproduction reproduce_fig_4_8(const ResultFolder& folder, Report& report) {
    Figure figure = tilt_figure("Boundary between forward and backward mode", "a / b", "");
    figure.y.title = "boundary base friction ψ";
    std::vector<PrintedStatement> printed;
    bool falls = true;
    for (std::size_t index = 0; index < frictions.size(); ++index) {
        const double phi = frictions[index];
        figure.series.emplace_back(curve(2, 50, "φ = " + number_in_words(phi) + "°, equal weights", colours[index],
                                         Dash::solid, [&](double ratio) { return boundary(ratio, 0.5, phi); }));
        const auto& line = std::get<Line>(figure.series.back());
        for (std::size_t point = 1; point < line.points.size(); ++point) {
            falls = falls && line.points[point].y() < line.points[point - 1].y();
        }
        printed.push_back({"printed, φ = " + number_in_words(phi) + " deg", Point(9, printed_boundaries[index])});
    }
    mark_on_curves(printed, figure);
    Reproduction result;
    result.rows.push_back(
        {"boundary as columns get taller", "decreases", falls ? "decreases" : "does not", "", statement(falls)});
    const double low = boundary(9, 0.5, 20);
    const double high = boundary(9, 0.5, 35);
    result.rows.push_back({"boundary as φ grows, a/b = 9", "decreases",
                           human_number(low, 4) + " to " + human_number(high, 4) + " deg", "", statement(high < low)});
    result.json["falls_with_slenderness"] = falls;
    report.blocks.emplace_back(Heading{"Fig 4.8: boundary base friction"});
    report.blocks.emplace_back(printed_table("Statements", result.rows));
    report.blocks.emplace_back(folder.draw(figure, "fig_4_8", "Above the curve blocks fail in the backward mode."));
    return result;
}

}  // namespace delabole
