// Figs 3.6 and 3.7 of the thesis: rows of columns on the tilting frame, by limit equilibrium.
//
// The points of the tests are not printed; what the text says of them is held against the calculation. Columns are 1
// inch thick; heights are in inches.
#include "cases/physical_models.hpp"
#include "cases/reproduction_chapter_3.hpp"
#include "cases/reproduction_chapter_4.hpp"
#include "fitting/words.hpp"
#include "limit_equilibrium/block_row.hpp"
#include "numerics/scalar_search.hpp"
#include "plots/text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace delabole {

namespace {

constexpr double inch = 0.0254;

RowAnswer row_answer(const std::vector<double>& heights, double interface_friction, double base_friction) {
    BlockRow<> row{};
    row.base = {degrees(10), base_friction};
    row.interface = {interface_friction};
    for (const double height : heights) {
        row.block.push_back({height * inch, inch, UnitWeightOfBlock<>{13e3}, {}, {}});
    }
    return analyse(row).answer;
}

std::vector<double> equal_columns(int count, double height) {
    return std::vector<double>(static_cast<std::size_t>(count), height);
}

// 1, 2, ... up and down again; the greatest height stands twice where the number of columns is even (3.3.2.2).
std::vector<double> growing_and_falling(int count) {
    std::vector<double> heights;
    for (int column = 1; column <= count; ++column) {
        heights.push_back(std::min(column, count + 1 - column));
    }
    return heights;
}

double angle_of(std::string_view key) {
    const std::vector<TiltingFrameAngle> angles = tilting_frame_angles();
    const auto found = std::ranges::find(angles, key, &TiltingFrameAngle::key);
    return (found->least + found->most) / 2;
}

// "6 and 7": between the last column that moves and the first that stands; empty where all or none move.
std::string crack_place(const std::string& mode) {
    const std::size_t first = mode.find(row_role::stands);
    if (first == std::string::npos || first == 0) {
        return {};
    }
    return std::to_string(first) + " and " + std::to_string(first + 1);
}

struct FrameFriction {
    double interface_friction;
    double base_friction;
};

}  // namespace

Reproduction reproduce_fig_3_6(const ResultFolder& folder, Report& report) {
    constexpr std::array colours{Colour::grey, Colour::blue, Colour::vermilion, Colour::green};
    constexpr std::array names{"one column", "two columns", "three columns", "four columns"};
    const FrameFriction plaster{degrees(20), degrees(35)};
    const double tin = angle_of("tin_friction");
    Figure figure = tilt_figure("Equal columns on the tilting frame", "height", "in");
    Table table{
        "Critical tilt, deg: interfaces 20 deg, base 35 deg; on tin 18 deg",
        {{"height, in", true}, {"one", true}, {"two", true}, {"three", true}, {"four", true}, {"two on tin", true}},
        {}};
    std::array<Line, 4> lines;
    Line on_tin;
    on_tin.legend = "two columns on tin";
    on_tin.colour = Colour::blue;
    on_tin.dash = Dash::dotted;
    bool more_is_stabler = true;
    int slides_on_tin = 0;
    double tin_difference = 0;
    Reproduction result;
    for (int height = 2; height <= 9; ++height) {
        std::vector<std::string> cells = {std::to_string(height)};
        double before = 0;
        double two = 0;
        for (int count = 1; count <= 4; ++count) {
            const double tilt =
                row_answer(equal_columns(count, height), plaster.interface_friction, plaster.base_friction)
                    .critical_tilt;
            lines[static_cast<std::size_t>(count - 1)].points.emplace_back(height, tilt / degrees(1));
            cells.push_back(human_number(tilt / degrees(1), 4));
            more_is_stabler = more_is_stabler && tilt > before;
            before = tilt;
            two = count == 2 ? tilt : two;
            result.json["tilt_deg"][std::to_string(height)].push_back(tilt / degrees(1));
        }
        const RowAnswer answer = row_answer(equal_columns(2, height), plaster.interface_friction, tin);
        const bool slides = answer.mode.find_first_not_of(row_role::slides) == std::string::npos;
        slides_on_tin += slides ? 1 : 0;
        tin_difference = std::max(tin_difference, slides ? 0.0 : std::abs(answer.critical_tilt - two));
        on_tin.points.emplace_back(height, answer.critical_tilt / degrees(1));
        cells.push_back(slides ? "slides" : human_number(answer.critical_tilt / degrees(1), 4));
        table.rows.push_back(cells);
    }
    for (std::size_t index = 0; index < lines.size(); ++index) {
        lines[index].legend = names[index];
        lines[index].colour = colours[index];
        figure.series.emplace_back(lines[index]);
    }
    figure.series.emplace_back(on_tin);
    result.rows.push_back({"more columns of equal height", "stand at greater tilt", more_is_stabler ? "yes" : "not all",
                           "", statement(more_is_stabler)});
    result.rows.push_back({"two columns on tin (17 to 19 deg) against plaster", "quite close",
                           "within " + human_number(tin_difference / degrees(1), 2) + " deg where they topple", "",
                           std::to_string(slides_on_tin) + " of 8 heights slide on the tin before they topple"});
    result.json["more_columns_stabler"] = more_is_stabler;
    result.json["heights_that_slide_on_tin"] = slides_on_tin;
    result.json["tin_difference_deg"] = tin_difference / degrees(1);
    report.blocks.emplace_back(Heading{"Fig 3.6: columns of equal height"});
    report.blocks.emplace_back(printed_table("Statements of 3.3.2.1", result.rows));
    report.blocks.emplace_back(table);
    report.blocks.emplace_back(folder.draw(figure, "fig_3_6", "Limit equilibrium, least stable mode of each row."));
    return result;
}

namespace {

constexpr int most_columns = 18;  // of the tests

struct RowOfHeights {
    double highest_alone;  // rad, tilt at which the highest column would topple by itself
    double average_alone;  // the same of a column of average height
    RowAnswer answer;
};

RowOfHeights row_of_heights(int count, double friction) {
    const std::vector<double> heights = growing_and_falling(count);
    const double sum = std::accumulate(heights.begin(), heights.end(), 0.0);
    return {std::atan(1 / *std::ranges::max_element(heights)), std::atan(count / sum),
            row_answer(heights, friction, friction)};
}

// Friction, the same everywhere, at which nine columns begin to move at the tilt of Plate 3.XIV by toppling.
std::optional<double> friction_of_plate_3_14(double tilt) {
    std::vector<double> candidates;
    // From where nothing slides at that tilt.
    for (double friction = tilt / degrees(1) + 0.5; friction <= 44.5; friction += 1) {
        candidates.push_back(degrees(friction));
    }
    return find_root([&](double friction) { return row_of_heights(9, friction).answer.critical_tilt - tilt; },
                     candidates)
        .position;
}

}  // namespace

Reproduction reproduce_fig_3_7(const ResultFolder& folder, Report& report) {
    const double tilt = angle_of("nine_columns_crack");
    const std::optional<double> fitted = friction_of_plate_3_14(tilt);
    const double friction = fitted.value_or(degrees(30));
    Figure figure = tilt_figure("Columns of growing and falling height", "number of columns", "");
    Line highest;
    highest.legend = "highest column alone";
    highest.colour = Colour::grey;
    Line average = highest;
    average.legend = "average height alone";
    average.dash = Dash::dashed;
    Line rows;
    rows.legend = "limit equilibrium, friction " + human_number(friction / degrees(1), 3) + "°";
    rows.colour = Colour::blue;
    Table table{"Critical tilt of rows, deg",
                {{"columns", true},
                 {"highest alone", true},
                 {"average alone", true},
                 {"row", true},
                 {"mode"},
                 {"crack between"}},
                {}};
    Reproduction result;
    std::vector<double> tilts;
    int between = 0;
    int cracks_at_three = 0;
    int cracks_expected = 0;
    for (int count = 3; count <= most_columns; ++count) {
        const RowOfHeights row = row_of_heights(count, friction);
        const std::string crack = crack_place(row.answer.mode);
        tilts.push_back(row.answer.critical_tilt);
        highest.points.emplace_back(count, row.highest_alone / degrees(1));
        average.points.emplace_back(count, row.average_alone / degrees(1));
        rows.points.emplace_back(count, row.answer.critical_tilt / degrees(1));
        between += row.answer.critical_tilt > row.highest_alone && row.answer.critical_tilt < row.average_alone ? 1 : 0;
        if (count >= 8 && count <= 17 && count != 16) {
            ++cracks_expected;
            cracks_at_three += crack == std::to_string(count - 3) + " and " + std::to_string(count - 2) ? 1 : 0;
        }
        table.rows.push_back({std::to_string(count), human_number(row.highest_alone / degrees(1), 4),
                              human_number(row.average_alone / degrees(1), 4),
                              human_number(row.answer.critical_tilt / degrees(1), 4), row.answer.mode, crack});
        result.json["tilt_deg"][std::to_string(count)] = row.answer.critical_tilt / degrees(1);
        result.json["mode"][std::to_string(count)] = row.answer.mode;
    }
    Points printed;
    printed.legend = "printed: nine columns";
    printed.colour = Colour::vermilion;
    printed.points = {Point(9, tilt / degrees(1))};
    figure.series = {highest, average, rows, printed};
    const RowAnswer nine = row_of_heights(9, friction).answer;
    result.rows.push_back({"nine columns: tilt of the first crack", value_in_words(tilt, Dimension::angle),
                           value_in_words(nine.critical_tilt, Dimension::angle),
                           difference_in_words((nine.critical_tilt - tilt) / degrees(1)) + " deg",
                           fitted ? "solved for friction: " + value_in_words(friction, Dimension::angle)
                                  : "no friction gives it; shown for 30 deg"});
    result.rows.push_back({"nine columns: place of the crack", "between 6 and 7", "between " + crack_place(nine.mode),
                           "", statement(crack_place(nine.mode) == "6 and 7") + ", mode " + nine.mode});
    result.rows.push_back({"crack in front of the column of 3 in, 8 to 17 columns but 16", "in all",
                           std::to_string(cracks_at_three) + " of " + std::to_string(cracks_expected), "",
                           statement(cracks_at_three == cracks_expected)});
    const bool falls = std::ranges::is_sorted(tilts, std::ranges::greater{});
    result.rows.push_back({"more columns", "less stable", falls ? "yes" : "not all", "", statement(falls)});
    result.rows.push_back({"rows between highest and average column", "all",
                           std::to_string(between) + " of " + std::to_string(tilts.size()), "",
                           statement(between == static_cast<int>(tilts.size()))});
    result.json["friction_deg"] = friction / degrees(1);
    result.json["friction_found"] = fitted.has_value();
    result.json["crack"] = crack_place(nine.mode);
    result.json["cracks_at_three"] = {{"met", cracks_at_three}, {"of", cracks_expected}};
    report.blocks.emplace_back(Heading{"Fig 3.7 and Plate 3.XIV: columns of growing and falling height"});
    report.blocks.emplace_back(printed_table("Statements of 3.3.2.2", result.rows));
    report.blocks.emplace_back(table);
    report.blocks.emplace_back(
        folder.draw(figure, "fig_3_7", "The thesis takes the two grey curves for the limits of instability."));
    return result;
}

}  // namespace delabole
