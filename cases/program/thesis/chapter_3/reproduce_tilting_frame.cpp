// Figs 3.6 and 3.7 of the thesis: rows of columns on the tilting frame, by limit equilibrium.
//
// The points of the tests are not printed; what the text says of them is held against the calculation. Columns are 1
// inch thick; heights are in inches.
#include "cases/program/thesis/chapter_3/chapter_3.hpp"
#include "cases/program/thesis/chapter_3/tilting_runs.hpp"
#include "cases/program/thesis/chapter_4/chapter_4.hpp"
#include "cases/program/thesis/imperial.hpp"
#include "cases/program/thesis/physical_models.hpp"
#include "fitting/work/words.hpp"
#include "limit_equilibrium/block_row/block_row.hpp"
#include "numerics/scalar_search.hpp"
#include "plots/drawing/text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <utility>

namespace delabole {

namespace {

// Returns nothing if no mode is admissible (block_row_search.hpp tells when that may be).
std::optional<RowAnswer> row_answer(const std::vector<double>& heights, double interface_friction,
                                    double base_friction) {
    BlockRow row{};
    row.base = {degrees(10), base_friction};
    row.interface = {interface_friction};
    for (const double height : heights) {
        row.block.push_back({height * inch, inch, UnitWeightOfBlock{13e3}, {}, {}});
    }
    const BlockRowResult result = analyse(row);
    const bool has_mode = result.check == BlockRowCheck::valid && result.answer.search != RowSearchKind::upper_bound;
    return has_mode ? std::optional(result.answer) : std::nullopt;
}

double angle_of(std::string_view key) {
    const std::vector<TiltingFrameAngle> angles = rows_of<TiltingFrameAngle>();
    const auto found = std::ranges::find(angles, key, &TiltingFrameAngle::key);
    if (found == angles.end()) {
        throw std::logic_error("tilting_frame.csv has no " + std::string(key));
    }
    return (found->least + found->most) / 2;
}

// "6 and 7": the last column that moves and the first that stands; empty if all or none move.
std::string crack_place(const std::string& mode) {
    const std::size_t first = mode.find(row_role::stands);
    if (first == std::string::npos || first == 0) {
        return {};
    }
    return std::to_string(first) + " and " + std::to_string(first + 1);
}

// Equal columns turn one by one if they may part; if they are pressed together they drag on one another.
struct EqualColumns {
    bool slides;    // before any turns
    double parted;  // rad, critical tilts
    double pressed;
};

EqualColumns equal_columns(int count, double height, double interface_friction, double base_friction) {
    const std::vector<double> heights(static_cast<std::size_t>(count), height);
    // Equal blocks always have an answer.
    const RowAnswer answer = row_answer(heights, interface_friction, base_friction).value();
    const bool slides = answer.mode.find_first_not_of(row_role::slides) == std::string::npos;
    const bool pressed = count > 1 && !slides;
    return {slides, answer.critical_tilt, pressed ? answer.critical_tilt_in_contact : answer.critical_tilt};
}

constexpr double slip_friction = degrees(20);     // of interfaces: what chapter 4 takes for short slips
constexpr double plaster_friction = degrees(35);  // of the base
constexpr double same_tilt = 1e-12;               // rad, rounding of closed forms

struct EqualRows {
    std::array<Line, 4> pressed;  // deg over inches, one to four columns
    Line on_tin;                  // two columns
    Table table{"Critical tilt, deg: interfaces 20 deg, base 35 deg, on tin 18 deg",
                {"height, in"_number, "one"_number, "two or more, parted"_number, "two, pressed"_number, "three"_number,
                 "four"_number, "two on tin, pressed"_number}};
    int steps = 0;    // one column more, at each height
    int stabler = 0;  // of these, with a greater tilt
    int less_stable = 0;
    double pairs_gain = 0;      // rad, greatest of two pressed over one
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
            if (count > 1) {
                const double gain = columns.pressed - pressed[pressed.size() - 2];
                ++rows.steps;
                rows.stabler += gain > same_tilt ? 1 : 0;
                rows.less_stable += gain < -same_tilt ? 1 : 0;
                rows.pairs_gain = count == 2 ? std::max(rows.pairs_gain, gain) : rows.pairs_gain;
            }
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

Reproduction reproduce_fig_3_6(const Sheet& sheet) {
    constexpr std::array colours{Colour::grey, Colour::blue, Colour::vermilion, Colour::green};
    constexpr std::array legends{"one column, and any that part", "two, pressed together", "three", "four"};
    EqualRows rows = equal_rows();
    Figure figure = tilt_figure("Fig 3.6: equal columns on the tilting frame", "height", "in");
    figure.x.range = heights_of_equal_columns;
    figure.y.range = tilts_of_equal_columns;
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
    result.add("one column more, pressed together", "stands at greater tilt",
               std::to_string(rows.stabler) + " of " + std::to_string(rows.steps) + " greater, " +
                   std::to_string(rows.less_stable) + " less",
               statement(rows.less_stable == 0) +
                   ": no more is gained where the lowest column cannot be held however hard it is pressed");
    result.add("columns that part", "gently touching ones separate and topple",
               "as one column does, within " + human_number(rows.parted_spread / degrees(1), 2) + " deg",
               "the number of columns matters only while they are held together");
    result.add("two columns against one (4.2)", "quite close at all heights",
               "up to " + human_number(rows.pairs_gain / degrees(1), 3) + " deg pressed, 0 parted",
               "points to columns that parted");
    result.add("two columns on tin (17 to 19 deg) against plaster", "quite close",
               "up to " + human_number(rows.tin_difference / degrees(1), 3) + " deg apart",
               std::to_string(rows.slides_on_tin) +
                   " of 8 heights slide on the tin before they topple; the text does not say so");
    result.json["one_column_more"] = {
        {"steps", rows.steps}, {"stabler", rows.stabler}, {"less_stable", rows.less_stable}};
    result.json["parted_spread_deg"] = rows.parted_spread / degrees(1);
    result.json["heights_that_slide_on_tin"] = rows.slides_on_tin;
    sheet.add(Heading{"Fig 3.6: columns of equal height"});
    sheet.add(printed_table("Statements of 3.3.2.1", result.rows));
    sheet.add(rows.table);
    sheet.draw(figure, "fig_3_6", "Critical tilt by limit equilibrium.");
    return result;
}

namespace {

constexpr int least_in_a_row = 3;
constexpr int most_in_a_row = 18;  // of the tests

struct RowOfHeights {
    int columns;
    double highest_alone;             // rad, tilt at which the highest column would topple by itself
    double average_alone;             // the same of a column of average height
    std::optional<RowAnswer> answer;  // where a motion is admissible

    double tilt() const { return answer ? answer->critical_tilt : std::numeric_limits<double>::quiet_NaN(); }
    std::string crack() const { return answer ? crack_place(answer->mode) : std::string(); }
};

// If all turning toes slide forward below standing columns, the mode is no motion but the limit of pressing.
bool is_limit_of_pressing(const std::string& mode) {
    return mode.find(row_role::stands) != std::string::npos && mode.find(row_role::forward) != std::string::npos &&
           mode.find_first_of({row_role::pivot, row_role::backward}) == std::string::npos;
}

RowOfHeights row_of_heights(int columns, double friction) {
    const std::vector<double> heights = growing_and_falling(columns);
    const double sum = std::accumulate(heights.begin(), heights.end(), 0.0);
    std::optional<RowAnswer> answer = row_answer(heights, friction, friction);
    if (answer && is_limit_of_pressing(answer->mode)) {
        answer.reset();
    }
    return {columns, std::atan(1 / *std::ranges::max_element(heights)), std::atan(columns / sum), std::move(answer)};
}

std::vector<RowOfHeights> rows_of_heights(double friction) {
    std::vector<RowOfHeights> rows;
    for (int columns = least_in_a_row; columns <= most_in_a_row; ++columns) {
        rows.push_back(row_of_heights(columns, friction));
    }
    return rows;
}

// Finds the friction, the same everywhere, at which nine columns begin to move at a tilt other than by sliding alone.
std::optional<double> friction_of_nine_columns(double tilt) {
    std::vector<double> candidates;
    // The scan begins where nothing slides at that tilt.
    for (double friction = tilt / degrees(1) + 0.5; friction <= 44.5; friction += 1) {
        candidates.push_back(degrees(friction));
    }
    return find_root([&](double friction) { return row_of_heights(9, friction).tilt() - tilt; }, candidates).position;
}

// How many of the rows that have an answer meet a statement.
struct Tally {
    int met = 0;
    int of = 0;
    std::vector<std::string> exceptions{};  // numbers of columns

    void add(bool meets, int columns) {
        met += meets ? 1 : 0;
        ++of;
        if (!meets) {
            exceptions.push_back(std::to_string(columns));
        }
    }
    std::string words() const { return std::to_string(met) + " of " + std::to_string(of); }
    Remark remark() const {
        return statement(met == of) + (exceptions.empty() ? "" : " by " + list_in_words(exceptions) + " columns");
    }
    Json json() const { return {{"met", met}, {"of", of}}; }
};

// Counts cracks in front of the column of 3 inches, which is the third from the top.
Tally cracks_at_three_inches(const std::vector<RowOfHeights>& rows) {
    Tally score;
    for (const RowOfHeights& row : rows) {
        if (row.columns >= 8 && row.columns <= 17 && row.columns != 16) {
            score.add(row.crack() == std::to_string(row.columns - 3) + " and " + std::to_string(row.columns - 2),
                      row.columns);
        }
    }
    return score;
}

Tally fall_with_number(const std::vector<RowOfHeights>& rows) {
    Tally score;
    for (std::size_t index = 1; index < rows.size(); ++index) {
        if (rows[index].answer && rows[index - 1].answer) {
            score.add(rows[index].tilt() <= rows[index - 1].tilt() + same_tilt, rows[index].columns);
        }
    }
    return score;
}

Tally within_thesis_limits(const std::vector<RowOfHeights>& rows) {
    Tally score;
    for (const RowOfHeights& row : rows) {
        if (row.answer) {
            score.add(row.tilt() > row.highest_alone && row.tilt() < row.average_alone, row.columns);
        }
    }
    return score;
}

// Compares even numbers of columns with the mean of both odd neighbours, where columns turn.
Tally even_numbers_stabler(const std::vector<RowOfHeights>& rows) {
    Tally score;
    for (std::size_t index = 1; index + 1 < rows.size(); ++index) {
        const bool turns = !rows[index - 1].crack().empty() && !rows[index + 1].crack().empty();
        if (rows[index].columns % 2 == 0 && turns) {
            score.add(rows[index].tilt() > (rows[index - 1].tilt() + rows[index + 1].tilt()) / 2, rows[index].columns);
        }
    }
    return score;
}

Table heights_table(const std::vector<RowOfHeights>& rows, Json& json) {
    Table table{
        "Critical tilt of rows, deg",
        {"columns"_number, "highest alone"_number, "average alone"_number, "row"_number, "mode", "crack between"}};
    for (const RowOfHeights& row : rows) {
        const std::string number = std::to_string(row.columns);
        table.rows.push_back({number, human_number(row.highest_alone / degrees(1), 4),
                              human_number(row.average_alone / degrees(1), 4),
                              row.answer ? human_number(row.tilt() / degrees(1), 4) : "none found",
                              row.answer ? row.answer->mode : "", row.crack()});
        if (row.answer) {
            json["tilt_deg"][number] = row.tilt() / degrees(1);
            json["mode"][number] = row.answer->mode;
        }
    }
    return table;
}

Line heights_line(const std::vector<RowOfHeights>& rows, const std::string& legend, Colour colour, Dash dash,
                  const std::function<double(const RowOfHeights&)>& value) {
    Line line{.legend = legend, .colour = colour, .dash = dash};
    for (const RowOfHeights& row : rows) {
        line.points.emplace_back(row.columns, value(row) / degrees(1));
    }
    return line;
}

Figure heights_figure(const std::vector<RowOfHeights>& rows, double friction, double printed_tilt) {
    Figure figure = tilt_figure("Fig 3.7: columns of growing and falling height", "number of columns", "");
    figure.y.range = tilts_of_rows;
    Points printed;
    printed.legend = "printed: nine columns, 16°";
    printed.colour = Colour::vermilion;
    printed.points = {Point(9, printed_tilt / degrees(1))};
    figure.series = {heights_line(rows, "highest column alone", Colour::grey, Dash::solid,
                                  [](const RowOfHeights& row) { return row.highest_alone; }),
                     heights_line(rows, "average height alone", Colour::grey, Dash::dashed,
                                  [](const RowOfHeights& row) { return row.average_alone; }),
                     heights_line(rows, "friction " + human_number(friction / degrees(1), 3) + "°", Colour::blue,
                                  Dash::solid, [](const RowOfHeights& row) { return row.tilt(); }),
                     printed};
    return figure;
}

}  // namespace

Reproduction reproduce_fig_3_7(const Sheet& sheet) {
    const double tilt = angle_of("nine_columns_crack");
    const std::optional<double> fitted = friction_of_nine_columns(tilt);
    const double friction = fitted.value_or(degrees(30));
    const std::vector<RowOfHeights> rows = rows_of_heights(friction);
    const RowOfHeights nine = row_of_heights(9, friction);
    Reproduction result;
    result.add({"nine columns: tilt of the first crack", value_in_words(tilt, Dimension::angle),
                value_in_words(nine.tilt(), Dimension::angle),
                difference_in_words((nine.tilt() - tilt) / degrees(1)) + " deg",
                fitted ? "solved for the friction: " + value_in_words(friction, Dimension::angle) +
                             "; chapter 4 takes 20 deg for short slips"
                       : "no friction gives it; shown for 30 deg"});
    result.add("nine columns: place of the crack", "between 6 and 7", "between " + nine.crack(),
               statement(nine.crack() == "6 and 7"));
    const std::string mode = nine.answer ? nine.answer->mode : "";
    const auto sliding = std::ranges::count(mode, row_role::slides);
    const auto turning = std::ssize(mode) - sliding - std::ranges::count(mode, row_role::stands);
    result.add("nine columns: which slide, which turn", "1 slides, 2 to 6 turn", mode,
               statement(sliding == 1 && turning == 5) + ": " + std::to_string(sliding) +
                   " slide (S), the next turn (F with a sliding toe, P not), the last stand (0), all with one "
                   "friction");
    const auto score_row = [&](const std::string& what, const std::string& printed, const Tally& score,
                               const std::string& why = "") {
        result.add(what, printed, score.words(), score.remark() + (score.met == score.of ? std::string() : why));
        result.json[what] = score.json();
    };
    score_row("crack in front of the column of 3 in, 8 to 17 columns but 16", "in all", cracks_at_three_inches(rows),
              "; those of 13 and 14 fail below 14.04 deg with this one friction, where the column of 4 in still stands "
              "by itself, the others have no admissible mode, but fail in motion (Fig 3.7 as runs)");
    score_row("one column more", "less stable", fall_with_number(rows));
    score_row("even numbers of columns against odd ones", "slightly more stable", even_numbers_stabler(rows));
    score_row("rows between the highest column alone and the average one", "may be the limits",
              within_thesis_limits(rows), ", which slide at their friction before a column of theirs topples");
    result.json["friction_deg"] = friction / degrees(1);
    result.json["friction_found"] = fitted.has_value();
    result.json["crack"] = nine.crack();
    sheet.add(Heading{"Fig 3.7 and Plate 3.XIV: columns of growing and falling height"});
    sheet.add(Paragraph{
        "One friction everywhere, solved from the tilt at which the nine columns of Plate 3.XIV cracked; all else is "
        "predicted. A crack in front of the 3 inch column says that the 4 inch column has turned, which by itself it "
        "does from 14.04 deg on: the rows of 13 to 17 columns must have stood up to that tilt, at more friction than "
        "this one. Where no tilt is given, no motion among those examined is admissible."});
    sheet.add(printed_table("Statements of 3.3.2.2", result.rows));
    sheet.add(heights_table(rows, result.json));
    sheet.draw(heights_figure(rows, friction, tilt), "fig_3_7",
               "The thesis takes the two grey curves for the limits of instability.");
    return result;
}

}  // namespace delabole
