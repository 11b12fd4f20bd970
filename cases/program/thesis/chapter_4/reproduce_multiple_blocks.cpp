// Figs 4.9 and 4.10 and equations (14) to (19) of the thesis: three and four blocks of equal size on a plane.
#include "cases/program/models/block_row/drawing.hpp"
#include "cases/program/thesis/chapter_4/chapter_4.hpp"
#include "fitting/work/words.hpp"
#include "limit_equilibrium/block_row/block_row.hpp"
#include "limit_equilibrium/block_row/closed_forms.hpp"
#include "plots/drawing/text.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace delabole {

BlockRow equal_row(int count, double slenderness, double interface_friction, double base_friction) {
    BlockRow row{};
    row.base = {degrees(10), degrees(base_friction)};
    row.interface = {degrees(interface_friction)};
    row.block.assign(static_cast<std::size_t>(count), {slenderness, 1, WeightOfBlock{1e3}, {}, {}});
    return row;
}

namespace {

// Returns the modes in which all blocks turn, each by itself, which are those that the thesis counts.
std::vector<RowModeSummary> whole_row_modes(int count, double slenderness, double phi, double psi) {
    std::vector<RowModeSummary> modes;
    for (const RowModeSummary& mode : analyse(equal_row(count, slenderness, phi, psi)).mode) {
        if (mode.roles.find_first_not_of("FPB") == std::string::npos) {
            modes.push_back(mode);
        }
    }
    return modes;
}

std::string tilt_shown(double tilt) {
    return tilt < degrees(90) ? human_number(tilt / degrees(1), 4) : "none";
}

struct ToeMotion {
    char role;
    std::string_view legend;
    Colour colour;
    double along;  // motion of the toe along the plane, in widths of a block
};

constexpr std::array toe_motions{ToeMotion{row_role::forward, "F: toe slides forward", Colour::blue, -0.7},
                                 ToeMotion{row_role::backward, "B: toe slides backward", Colour::vermilion, 0.7}};

// Returns the modes in the order of the thesis's letters. Those of three blocks follow from (14) to (17); its figure of
// four blocks is not legible, so they keep the order of the model.
std::vector<RowModeSummary> lettered_modes(int count) {
    constexpr std::array<std::string_view, 5> printed{"FFP", "FPB", "PBB", "FBB", "FFB"};
    std::vector<RowModeSummary> modes = whole_row_modes(count, 3, 20, 30);
    if (count == 3) {
        std::ranges::sort(modes, {},
                          [&](const RowModeSummary& mode) { return std::ranges::find(printed, mode.roles); });
    }
    return modes;
}

// Draws all modes side by side: each block turned, its letter below its toe, and the direction in which the toe slides.
// A turn of 15 deg moves toes apart by only 1 / cos 15 deg - 1 = 4 % of a width, too little to be seen.
Figure mode_gallery(int count) {
    constexpr double slenderness = 3;
    constexpr double tilt = degrees(20);
    constexpr double turn = degrees(15);
    constexpr double below = 0.3;  // of the arrows, below the plane
    const Point along(std::cos(tilt), std::sin(tilt));
    const Point up(-along.y(), along.x());
    std::array<Arrows, toe_motions.size()> slips;
    for (std::size_t index = 0; index < slips.size(); ++index) {
        slips[index].legend = toe_motions[index].legend;
        slips[index].colour = toe_motions[index].colour;
    }
    Points pivots{.legend = "P: toe does not slide"};
    BlockDrawing gallery{.title = "Fig 4.9: " + number_in_words(count) + " blocks, every block turns",
                         .displaced_legend = "turned by 15 deg"};
    std::vector<Label> letters;
    int place = 0;
    for (const RowModeSummary& mode : lettered_modes(count)) {
        const int in_a_row = count == 3 ? 3 : 4;
        const int line = place / in_a_row;
        const Point shift((count + 2.2) * (place % in_a_row), -(slenderness + count / 2.0 + 1) * line);
        BlockDrawing drawing = row_drawing(equal_row(count, slenderness, 20, 30), mode.roles, tilt, {}, "", turn);
        for (std::size_t index = 0; index < drawing.blocks.size(); ++index) {
            DrawnBlock& block = drawing.blocks[index];
            block.label.clear();
            for (Point& corner : block.outline) {
                corner += shift;
            }
            for (Point& corner : block.displaced) {
                corner += shift;
            }
            const Point toe = shift + static_cast<double>(index) * along;
            letters.push_back({.at = toe - 0.95 * up,
                               .text = std::string(1, mode.roles[index]),
                               .align = Label::Align::centre,
                               .boxed = false});
            for (std::size_t kind = 0; kind < slips.size(); ++kind) {
                if (toe_motions[kind].role == mode.roles[index]) {
                    const Point middle = toe - below * up;
                    const Point half = toe_motions[kind].along / 2 * along;
                    slips[kind].shafts.push_back({middle - half, middle + half});
                }
            }
            if (mode.roles[index] == row_role::pivot) {
                pivots.points.push_back(toe);
            }
            block.mode = DrawnMode::plain;
            gallery.blocks.push_back(std::move(block));
        }
        letters.push_back({.at = shift + (slenderness + 1.3) * up,
                           .text = "(" + std::string(1, static_cast<char>('a' + place)) + ")",
                           .boxed = false});
        ++place;
    }
    Figure figure = block_figure(gallery);
    figure.labels.insert(figure.labels.end(), letters.begin(), letters.end());
    figure.frame = false;
    constexpr int axis = 75;  // px, which only a frame has
    figure.height -= axis;
    for (Arrows& arrows : slips) {
        figure.series.emplace_back(std::move(arrows));
    }
    figure.series.emplace_back(std::move(pivots));
    return figure;
}

Line mode_line(double slenderness, const std::string& legend, Colour colour, Dash dash,
               double (*formula)(double, double, double, double)) {
    const auto tilt = [&](double friction) {
        return tilt_or_gap(formula(slenderness, 1.0, tangent(friction), tangent(friction)));
    };
    return curve(in_degrees(1 / slenderness), 45, legend, colour, dash, tilt, 80);
}

}  // namespace

Reproduction reproduce_fig_4_9(const Sheet& sheet) {
    constexpr std::array<std::string_view, 3> printed{"3", "5", "7"};
    Reproduction result;
    Table table{"Modes in which every block turns; a/b = 3, interface 20 deg, base 30 deg",
                {"blocks"_number, "mode", "begins at tilt, °"_number, "what the model says of it"}};
    for (int count = 2; count <= 4; ++count) {
        const std::vector<RowModeSummary> modes = whole_row_modes(count, 3, 20, 30);
        const std::string words = std::to_string(count);
        result.add("modes of " + words + " blocks", std::string(printed[static_cast<std::size_t>(count) - 2]),
                   std::to_string(modes.size()),
                   statement(std::to_string(modes.size()) == printed[static_cast<std::size_t>(count) - 2]));
        for (const RowModeSummary& mode : modes) {
            table.rows.push_back(
                {words, mode.roles, tilt_shown(mode.critical_tilt), human_name(word_of(mode.admissibility))});
            result.json["modes_of_" + words + "_blocks"].push_back(mode.roles);
        }
    }
    sheet.add(Heading{"Fig 4.9: the modes of three and four blocks"});
    sheet.add(
        Paragraph{"The figure is lost, its counts are in the text. Blocks that turn by one angle with faces in contact "
                  "need more room along the plane, so their toes move apart: from below, first toes that slide forward "
                  "(F), then at most one that does not slide (P), then toes that slide backward (B). N blocks have N "
                  "modes with a pivot and N - 1 without, 2N - 1 in all: the counts of the text."});
    sheet.add(printed_table("Counts", result.rows));
    sheet.draw(mode_gallery(3), "fig_4_9_three",
               "The five modes of three blocks, with the letters of (14) to (17) and (e) for the fifth; arrows show "
               "which way a toe slides, not how far.");
    sheet.draw(mode_gallery(4), "fig_4_9_four",
               "The seven modes of four blocks, whose letters in the thesis are not legible; arrows show which way a "
               "toe slides, not how far.");
    sheet.add(table);
    return result;
}

Reproduction reproduce_fig_4_10(const Sheet& sheet) {
    Reproduction result;
    sheet.add(Heading{"Fig 4.10: three blocks, one friction angle"});
    sheet.add(Paragraph{
        "Mode (a) is FFP, (b) FPB, (c) PBB. The printed (14) is the formula of two blocks and lies below FFP as "
        "derived; so (a) is the least stable one only up to a friction angle that falls as the columns get taller."});
    for (const int ratio : {3, 5, 7}) {
        const std::string words = std::to_string(ratio);
        Figure figure = tilt_figure("Fig 4.10: three blocks, a/b = " + words, "friction φ = ψ", "deg");
        figure.x.range = figure.y.range = std::pair{5.0, 47.0};
        figure.series.emplace_back(mode_line(ratio, "(a) as printed, (14) = (8)", Colour::grey, Dash::dashed,
                                             closed_form::two_equal_blocks_forward));
        figure.series.emplace_back(
            mode_line(ratio, "(a) FFP as derived", Colour::blue, Dash::solid, closed_form::three_blocks_two_forward));
        figure.series.emplace_back(
            mode_line(ratio, "(b) FPB, (15)", Colour::green, Dash::solid, closed_form::three_blocks_forward_backward));
        figure.series.emplace_back(
            mode_line(ratio, "(c) PBB, (16)", Colour::vermilion, Dash::solid, closed_form::three_blocks_two_backward));
        sheet.draw(figure, "fig_4_10_ratio_" + words, "Tilt by mode, blocks in contact.");
        const auto line = [&](std::size_t index) -> const Polyline& {
            return std::get<Line>(figure.series[index]).points;
        };
        constexpr std::array<std::string_view, 3> letters{"(a)", "(b)", "(c)"};
        const auto least_of_three = [&](std::size_t point, std::size_t first) {
            const std::array tilts{line(first)[point].y(), line(2)[point].y(), line(3)[point].y()};
            return static_cast<std::size_t>(std::ranges::min_element(tilts) - tilts.begin());
        };
        // The results are for (14) as printed and as derived; the common end points of the curves are left out.
        const auto least_in_words = [&](std::size_t first) {
            std::size_t least = least_of_three(1, first);
            std::string text(letters[least]);
            for (std::size_t point = 1; point + 1 < line(first).size(); ++point) {
                if (const std::size_t now = least_of_three(point, first); now != least) {
                    least = now;
                    text += " up to " + human_number(line(first)[point].x(), 3) + " deg, then " +
                            std::string(letters[least]);
                }
            }
            return text;
        };
        double highest_up_to = 45;
        for (std::size_t point = 1; point + 1 < line(3).size(); ++point) {
            if (line(3)[point].y() < std::max(line(1)[point].y(), line(2)[point].y())) {
                highest_up_to = std::min(highest_up_to, line(3)[point].x());
            }
        }
        const std::string derived = least_in_words(1);
        const std::string as_printed = least_in_words(0);
        result.add("a/b = " + words + ": least stable mode", "(a)", derived,
                   statement(derived == letters.front()) +
                       ": (14) leaves the third block out of the thrusts; with it as printed: " + as_printed);
        result.add("a/b = " + words + ": most unlikely mode", "(c)",
                   "(c) up to " + human_number(highest_up_to, 3) + " deg",
                   statement(highest_up_to >= 45) + (highest_up_to < 45 ? ": only below that" : ""));
        result.json["ratio_" + words] = {{"least_stable", derived}, {"backward_mode_highest_up_to_deg", highest_up_to}};
    }
    sheet.add(printed_table("Statements on Fig 4.10", result.rows));
    return result;
}

Reproduction reproduce_equations_14_to_19(const Sheet& sheet) {
    namespace form = closed_form;
    constexpr double a = 3;
    constexpr double b = 1;
    const double mu = tangent(20);
    const double c = tangent(30);
    const double m = mu * c;
    Reproduction result;
    const auto row = [&](const std::string& name, double printed, double derived, const std::string& remark) {
        constexpr double rounding = 1e-12;  // of tangents near one
        result.add({name, human_number(in_degrees(printed), 5) + " deg", human_number(in_degrees(derived), 5) + " deg",
                    difference_in_words(in_degrees(derived) - in_degrees(printed)) + " deg",
                    statement(std::abs(derived - printed) < rounding) + (remark.empty() ? "" : ": " + remark)});
        result.json[name] = {{"printed_deg", in_degrees(printed)}, {"derived_deg", in_degrees(derived)}};
    };
    row("(14) FFP", form::two_equal_blocks_forward(a, b, mu, c), form::three_blocks_two_forward(a, b, mu, c),
        "printed equal to (8): the third block left out of the thrusts");
    row("(15) FPB", form::three_blocks_forward_backward(a, b, mu, c), form::equal_blocks(1, 1, a, b, mu, c), "");
    const double lost = form::equal_blocks(0, 2, a, b, mu, c);
    result.add("(16) PBB", "lost", human_number(in_degrees(lost), 5) + " deg",
               "tan θ = b(1 + 3μc) / [a(1 + μc) - 2bμ]");
    row("(17) FBB, equal thrusts", form::three_blocks_equal_thrusts(mu, c), c * (3 * m - 1) / (3 - m),
        "but over-determined: no dimension of the blocks in it");
    row("(18) FFPB", form::four_blocks_printed(a, b, mu, c), form::four_blocks_two_forward_one_backward(a, b, mu, c),
        "(2 + μc) where 2(1 + μc) belongs, μ by itself in the numerator");
    const double same = tangent(30);
    row("(19) FFPB, μ = c = tan 30", form::four_blocks_one_friction_printed(a, b, same),
        form::four_blocks_two_forward_one_backward(a, b, same, same),
        "besides, a sign of its denominator differs from (18)");
    row("(18) at μ = c against (19)", form::four_blocks_one_friction_printed(a, b, same),
        form::four_blocks_printed(a, b, same, same), "(18) reduces to another formula than (19)");

    Table stability{
        "Equal blocks, a/b = 3, interface 20 deg, base 30 deg",
        {"blocks"_number, "free: begins at, °"_number, "mode", "pressed together: stands up to, °"_number, "mode"}};
    std::vector<double> pressed;
    for (int count = 1; count <= 5; ++count) {
        const RowAnswer answer = analyse(equal_row(count, a, 20, 30)).answer;
        pressed.push_back(answer.critical_tilt_in_contact);
        stability.rows.push_back({std::to_string(count), tilt_shown(answer.critical_tilt), answer.mode,
                                  tilt_shown(answer.critical_tilt_in_contact), answer.mode_in_contact});
        result.json["tilt_by_blocks"].push_back({{"blocks", count},
                                                 {"free_deg", answer.critical_tilt / degrees(1)},
                                                 {"in_contact_deg", answer.critical_tilt_in_contact / degrees(1)}});
    }
    const double ceiling = form::three_blocks_two_forward(a, b, mu, c);
    const bool adds = pressed[2] > pressed[1] + 1e-9;  // rad; tilts are solved to rounding
    result.add("does a third block add stability?", "no: (14) = (8)",
               "free: no; in contact: " + std::string(adds ? "yes" : "no"),
               statement(!adds) + ": up to the ceiling of " + human_number(in_degrees(ceiling), 5) +
                   " deg, beyond which those above cannot hold the lowest block; (14) leaves the third "
                   "block out of the thrusts");
    result.json["ceiling_deg"] = in_degrees(ceiling);
    sheet.add(Heading{"Equations (14) to (19): three and four blocks"});
    sheet.add(Paragraph{"Printed and derived tilts for a/b = 3, an interface of 20 deg and a base of 30 deg."});
    sheet.add(printed_table("Printed against derived", result.rows));
    sheet.add(stability);
    return result;
}

}  // namespace delabole
