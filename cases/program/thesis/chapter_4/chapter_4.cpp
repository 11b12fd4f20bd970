// The thesis's chapter 4, except Bray's analysis (Appendix A), with the theoretical curve of Fig 3.4. Most figures are
// cases; this file has the code for single blocks, reproduce_two_blocks.cpp and reproduce_multiple_blocks.cpp that for
// rows.
#include "cases/program/thesis/chapter_4/chapter_4.hpp"
#include "cases/program/models/single_block/chart.hpp"
#include "cases/program/thesis/reproduction.hpp"
#include "fitting/work/words.hpp"
#include "plots/drawing/text.hpp"

#include <cmath>
#include <limits>

namespace delabole {

namespace {

Reproduction reproduce_fig_4_1(const Sheet& sheet) {
    Reproduction result = reproduce_cases("thesis/chapter_4", {"fig_4_1"}, "Fig 4.1", sheet);
    sheet.draw(mode_chart_figure(single_block_chart(degrees(35), BlockCriteria::superposed_static,
                                                    "Fig 4.1: static criteria, friction 35 deg")),
               "fig_4_1_static", "As printed: sliding and toppling criteria superposed.");
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
    return {
        "chapter4",
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
            {"eq12-13", "4.2, eqs (12), (13)", "two blocks: the force between them, and where it is compressive",
             reproduce_force_between_two_blocks},
            {"fig4.9", "Fig 4.9", "the modes of three and four blocks", reproduce_fig_4_9},
            {"fig4.10", "Fig 4.10", "three blocks, friction the same everywhere", reproduce_fig_4_10},
            {"eq14-19", "4.3, eqs (14) to (19)", "equations (14) to (19) printed and derived; does a third block help?",
             reproduce_equations_14_to_19},
            data_item("blocks", "4.4, 3.3.1", "the columns of Appendix A and the west face cut into blocks, in motion",
                      folder, {"appendix_a_blocks", "west_face_blocks"}),
        }};
}

}  // namespace delabole
