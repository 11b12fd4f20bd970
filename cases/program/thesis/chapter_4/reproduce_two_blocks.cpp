// Fig 4.7 of the thesis, two blocks of equal height on a plane: the weights behind its boundaries.
#include "cases/program/thesis/chapter_4/chapter_4.hpp"
#include "fitting/work/words.hpp"
#include "limit_equilibrium/block_row/closed_forms.hpp"
#include "plots/drawing/text.hpp"
#include "plots/figures/figures.hpp"

#include <array>

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
    figure.title = "Fig 4.7: two blocks, a/b = 9, W1/W2 = " + human_number(best_ratio, 4);
    Points equal_weights{.legend = "boundaries with equal weights", .marker = Marker::circle, .size = 1.8};
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
    report.blocks.emplace_back(Paragraph{
        "The boundary between the modes depends on the weights. Each printed boundary alone gives a ratio of the "
        "weights; the two agree to 0.001, so that an upper block 4 % heavier than the lower one explains both."});
    report.blocks.emplace_back(printed_table("Boundary between forward and backward mode", result.rows));
    report.blocks.emplace_back(folder.draw(figure, "fig_4_7", "The lower curve of each pair governs."));
    return result;
}

}  // namespace delabole
