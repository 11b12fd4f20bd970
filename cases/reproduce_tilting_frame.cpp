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

// Equal columns: those that may part turn one by one; pressed together they drag on one another.
struct EqualColumns {
    bool slides;    // before any turns
    double parted;  // rad, critical tilts
    double pressed;
};

EqualColumns equal_columns(int count, double height, double interface_friction, double base_friction) {
    const std::vector<double> heights(static_cast<std::size_t>(count), height);
    const RowAnswer answer = row_answer(heights, interface_friction, base_friction);
    const bool slides = answer.mode.find_first_not_of(row_role::slides) == std::string::npos;
    const bool pressed = count > 1 && !slides;
    return {slides, answer.critical_tilt, pressed ? answer.critical_tilt_in_contact : answer.critical_tilt};
}

constexpr double slip_friction = degrees(20);     // of interfaces: what chapter 4 takes for short slips
constexpr double plaster_friction = degrees(35);  // of the base
constexpr int least_height = 2;                   // in, of the tests
constexpr int most_height = 9;

struct EqualRows {
    std::array<Line, 4> pressed;  // deg over inches, one to four columns
    Line on_tin;                  // two columns
    Table table{"Critical tilt, deg: interfaces 20 deg, base 35 deg, on tin 18 deg",
                {{"height, in", true},
                 {"one", true},
                 {"two or more, parted", true},
                 {"two, pressed", true},
                 {"three", true},
                 {"four", true},
                 {"two on tin, pressed", true}},
                {}};
    bool more_is_stabler = true;
    double parted_spread = 0;   // rad, of parted rows about the single column
    double tin_difference = 0;  // rad, greatest where columns topple on the tin
    int slides_on_tin = 0;      // heights
};

EqualRows equal_rows() {
    const double tin = angle_of("tin_friction");
    EqualRows rows;
    for (int height = least_height; height <= most_height; ++height) {
        std::vector<double> pressed;
        std::vector<double> parted;
        for (int count = 1; count <= 4; ++count) {
            const EqualColumns columns = equal_columns(count, height, slip_friction, plaster_friction);
            pressed.push_back(columns.pressed);
            parted.push_back(columns.parted);
            rows.pressed[pressed.size() - 1].points.emplace_back(height, columns.pressed / degrees(1));
            rows.more_is_stabler =
                rows.more_is_stabler && (count == 1 || columns.pressed > pressed[pressed.size() - 2]);
            rows.parted_spread = std::max(rows.parted_spread, std::abs(columns.parted - parted.front()));
        }
        const EqualColumns on_tin = equal_columns(2, height, slip_friction, tin);
        rows.on_tin.points.emplace_back(height, on_tin.pressed / degrees(1));
        rows.slides_on_tin += on_tin.slides ? 1 : 0;
        rows.tin_difference =
            std::max(rows.tin_difference, on_tin.slides ? 0.0 : std::abs(on_tin.pressed - pressed[1]));
        const auto shown = [](double tilt) { return human_number(tilt / degrees(1), 4); };
        rows.table.rows.push_back({std::to_string(height), shown(pressed[0]), shown(parted[1]), shown(pressed[1]),
                                   shown(pressed[2]), shown(pressed[3]),
                                   on_tin.slides ? "slides" : shown(on_tin.pressed)});
    }
    return rows;
}

}  // namespace

Reproduction reproduce_fig_3_6(const ResultFolder& folder, Report& report) {
    constexpr std::array colours{Colour::grey, Colour::blue, Colour::vermilion, Colour::green};
    constexpr std::array legends{"one column, and any that part", "two, pressed together", "three", "four"};
    EqualRows rows = equal_rows();
    Figure figure = tilt_figure("Equal columns on the tilting frame", "height", "in");
    for (std::size_t index = 0; index < legends.size(); ++index) {
        rows.pressed[index].legend = legends[index];
        rows.pressed[index].colour = colours[index];
        figure.series.emplace_back(rows.pressed[index]);
    }
    rows.on_tin.legend = "two on tin";
    rows.on_tin.colour = Colour::blue;
    rows.on_tin.dash = Dash::dotted;
    figure.series.emplace_back(rows.on_tin);
    Reproduction result;
    result.rows.push_back({"more columns, pressed together", "stand at greater tilt",
                           rows.more_is_stabler ? "at every height" : "not at every height", "",
                           statement(rows.more_is_stabler)});
    result.rows.push_back({"columns that part", "gently touching ones separate and topple",
                           "as one column does, within " + human_number(rows.parted_spread / degrees(1), 2) + " deg",
                           "", "so the number of columns matters only while they are held together"});
    result.rows.push_back({"two columns on tin (17 to 19 deg) against plaster", "quite close",
                           "up to " + human_number(rows.tin_difference / degrees(1), 3) + " deg apart", "",
                           std::to_string(rows.slides_on_tin) +
                               " of 8 heights slide on the tin before they topple; the text does not say so"});
    result.json["more_columns_stabler"] = rows.more_is_stabler;
    result.json["parted_spread_deg"] = rows.parted_spread / degrees(1);
    result.json["heights_that_slide_on_tin"] = rows.slides_on_tin;
    result.json["tin_difference_deg"] = rows.tin_difference / degrees(1);
    report.blocks.emplace_back(Heading{"Fig 3.6: columns of equal height"});
    report.blocks.emplace_back(printed_table("Statements of 3.3.2.1", result.rows));
    report.blocks.emplace_back(rows.table);
    report.blocks.emplace_back(folder.draw(figure, "fig_3_6", "Critical tilt by limit equilibrium."));
    return result;
}

namespace {

constexpr int most_in_a_row = 18;  // of the tests

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
    for (int count = 3; count <= most_in_a_row; ++count) {
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
