// The thesis's chapter 4 but for Bray's analysis (Appendix A), with the theoretical curve of Fig 3.4. Most figures are
// cases; here is what needs code of its own for single blocks, in reproduce_two_blocks.cpp and
// reproduce_multiple_blocks.cpp for rows.
#include "cases/program/thesis/chapter_4/chapter_4.hpp"
#include "cases/program/models/single_block/chart.hpp"
#include "cases/program/thesis/reproduction.hpp"
#include "fitting/work/words.hpp"
#include "limit_equilibrium/block_row/single_block.hpp"
#include "plots/drawing/text.hpp"

#include <cmath>
#include <limits>

namespace delabole {

namespace {

BlockMotion onset(double slenderness_angle, double inclination, double friction_angle) {
    SingleBlock<> block{};
    block.block = {.height = 1, .width = std::tan(slenderness_angle), .unit_weight = 24e3};
    block.base = {inclination, friction_angle, 0};
    return analyse(block).onset_mode;
}

Reproduction reproduce_fig_4_1(const ResultFolder& folder, Report& report) {
    constexpr double friction = degrees(35);
    const double slenderness = std::atan(1.0 / 3);
    Reproduction result;
    for (const double inclination : {25.0, 30.0, 45.0}) {
        const double boundary = toe_slip_friction_angle(degrees(inclination), slenderness);
        const bool both_sides =
            onset(slenderness, degrees(inclination), boundary + degrees(0.01)) == BlockMotion::topples &&
            onset(slenderness, degrees(inclination), boundary - degrees(0.01)) == BlockMotion::slides_and_topples;
        const std::string at = number_in_words(inclination);
        result.rows.push_back({"a/b = 3 at " + at + " deg: friction above which it topples without sliding",
                               at + " deg (superposed)", value_in_words(boundary, Dimension::angle),
                               difference_in_words(boundary / degrees(1) - inclination) + " deg",
                               both_sides ? Remark("the equations of motion change over there")
                                          : statement(false) + ": the equations of motion do not change over there"});
        result.json["topples_above_friction_deg"][at] = boundary / degrees(1);
    }
    const BlockMotion stocky = onset(degrees(30), degrees(60), degrees(25));
    result.rows.push_back({"atan(b/a) = 30 deg, friction 25 deg, on 60 deg", "slides and topples",
                           human_name(word_of(stocky)), "",
                           "friction below atan(b/a): the block slides and never topples, however steep"});
    result.json["friction_below_slenderness_angle"] = std::string(word_of(stocky));
    report.blocks.emplace_back(Heading{"Fig 4.1: criteria for a single block"});
    report.blocks.emplace_back(Paragraph{
        "Fig 4.1(b) superposes two static criteria. Where both are exceeded that says nothing of what happens: a block "
        "that slides is not pressed on its toe as a resting one is, and one that turns presses the base with another "
        "force. Solving the motion released from rest gives the same stable region and other regions beyond it."});
    report.blocks.emplace_back(printed_table("Single block", result.rows));
    report.blocks.emplace_back(
        folder.draw(mode_chart_figure(single_block_chart(friction, BlockCriteria::superposed_static,
                                                         "Fig 4.1: static criteria, friction 35 deg")),
                    "fig_4_1_static", "As printed: sliding and toppling criteria superposed."));
    report.blocks.emplace_back(
        folder.draw(mode_chart_figure(single_block_chart(friction, BlockCriteria::onset_of_motion,
                                                         "Fig 4.1 by motion: onset, friction 35 deg")),
                    "fig_4_1_dynamic", "What a dry block released from rest does."));
    return result;
}

}  // namespace

PrintedRow angle_row(const std::string& what, double printed, double computed, const std::string& remark) {
    return {what, number_in_words(printed) + " deg", human_number(computed, 4) + " deg",
            difference_in_words(computed - printed) + " deg", remark};
}

Figure tilt_figure(const std::string& title, const std::string& x, const std::string& x_unit) {
    Figure figure{.title = title, .x = {.title = x, .unit = x_unit}, .y = {.title = "critical tilt θ", .unit = "deg"}};
    return figure;
}

double tangent(double angle_in_degrees) {
    return std::tan(degrees(angle_in_degrees));
}

double in_degrees(double tangent_of_angle) {
    return std::atan(tangent_of_angle) / degrees(1);
}

double tilt_or_gap(double tangent_of_tilt) {
    return tangent_of_tilt > 0 ? in_degrees(tangent_of_tilt) : std::numeric_limits<double>::quiet_NaN();
}

Line curve(double from, double to, const std::string& legend, Colour colour, Dash dash,
           const std::function<double(double)>& value, int steps) {
    Line line{.legend = legend, .colour = colour, .dash = dash, .width = 3.5};
    for (int step = 0; step <= steps; ++step) {
        const double x = from + (to - from) * step / steps;
        line.points.emplace_back(x, value(x));
    }
    return line;
}

ReproductionChapter chapter_4() {
    const std::string folder = "thesis/chapter_4";
    return {"chapter4",
            "blocks on a plane, chapter 4",
            "Thesis, chapter 4: printed and computed",
            {
                data_item("fig3.4", "Fig 3.4", "single column on the tilting frame, theoretical curve", folder,
                          {"fig_3_4"}),
                {"fig4.1", "Fig 4.1", "criteria for a single block, static and dynamic", reproduce_fig_4_1},
                data_item("fig4.3", "Fig 4.3", "two blocks: tilt against base friction for several interfaces", folder,
                          {"fig_4_3"}),
                data_item("fig4.4", "Fig 4.4", "two blocks of 2 to 9 inches, friction 20 against 35 deg", folder,
                          {"fig_4_4"}),
                data_item("fig4.6", "Fig 4.6", "two blocks, forward and backward mode, all fourteen ratios", folder,
                          {"fig_4_6"}),
                {"fig4.7", "Fig 4.7", "two blocks, a/b = 9: boundary friction and the weights behind it",
                 reproduce_fig_4_7},
                data_item("fig4.8", "Fig 4.8", "boundary base friction against a/b", folder, {"fig_4_8"}),
                {"fig4.9", "Fig 4.9", "the modes of three and four blocks", reproduce_fig_4_9},
                {"fig4.10", "Fig 4.10", "three blocks, friction the same everywhere", reproduce_fig_4_10},
                {"eq14-19", "4.3, eqs (14) to (19)",
                 "equations (14) to (19) printed and derived; does a third block help?", reproduce_equations_14_to_19},
                data_item("blocks", "4.4, 3.3.1", "the columns of Appendix A cut into blocks, in motion", folder,
                          {"appendix_a_blocks"}),
            }};
}

}  // namespace delabole
