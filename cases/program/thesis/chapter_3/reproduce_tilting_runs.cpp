// Runs Figs 3.4, 3.6, 3.7 and Plate 3.XIV of the thesis on a tilting frame, with the scatter of plaster.
#include "cases/program/models/relaxation/figures.hpp"
#include "cases/program/terminal/interrupt.hpp"
#include "cases/program/thesis/chapter_3/chapter_3.hpp"
#include "cases/program/thesis/chapter_3/tilting_runs.hpp"
#include "cases/program/thesis/chapter_4/chapter_4.hpp"
#include "cases/program/thesis/chapter_5/relaxation_drawing.hpp"
#include "cases/program/thesis/physical_models.hpp"
#include "fitting/probability/moments.hpp"
#include "fitting/work/words.hpp"
#include "plots/drawing/extent.hpp"
#include "plots/drawing/text.hpp"
#include "plots/figures/block_figures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <mutex>
#include <numeric>
#include <set>

namespace delabole {

namespace {

constexpr std::uint64_t samples = 4;

// Short slips occur at 8 to 22 deg between columns, lasting sliding at 29 to 36.5 deg (3.3.2.1, 4.2): both are taken at
// their middle, with two standard deviations to the ends.
PlasterFriction scattered_plaster_friction() {
    return {degrees(15), degrees(33), degrees(3.5)};
}

// Mean and range over the samples at one point of a figure.
struct Sampled {
    double x = 0;
    std::vector<double> value = {};  // rad

    double mean() const { return mean_of(value); }
    double deviation() const { return value.size() < 2 ? 0 : deviation_of(value); }
};

struct Curve {
    std::string legend;
    Colour colour;
    std::vector<Sampled> at;
};

// Runs all points of the curves; `value` gives the tilt at a point, by its curve, number and sample.
void sample(std::vector<Curve>& curves, std::uint64_t per_place, const ResultFolder& folder, const PartOfWork& part,
            const std::function<std::optional<double>(std::size_t, const Sampled&, std::uint64_t)>& value) {
    struct Task {
        std::size_t curve;
        std::size_t place;
        std::uint64_t seed;
    };
    std::vector<Task> tasks;
    for (std::size_t curve = 0; curve < curves.size(); ++curve) {
        for (std::size_t place = 0; place < curves[curve].at.size(); ++place) {
            for (std::uint64_t seed = 1; seed <= per_place; ++seed) {
                tasks.push_back({curve, place, seed});
            }
        }
    }
    std::vector<std::optional<double>> found(tasks.size());
    run_part(folder, part, tasks.size(), [&](std::size_t number) {
        const Task& task = tasks[number];
        found[number] = value(task.curve, curves[task.curve].at[task.place], task.seed);
    });
    for (std::size_t number = 0; number < tasks.size(); ++number) {
        if (found[number]) {
            curves[tasks[number].curve].at[tasks[number].place].value.push_back(*found[number]);
        }
    }
}

std::vector<Sampled> places(int from, int to) {
    std::vector<Sampled> result;
    for (int place = from; place <= to; ++place) {
        result.push_back({static_cast<double>(place), {}});
    }
    return result;
}

// Draws means with their standard deviations. Points of several curves are drawn side by side, without lines.
void draw_curves(Figure& figure, const std::vector<Curve>& curves) {
    constexpr std::array markers{Marker::filled_circle, Marker::filled_square, Marker::filled_triangle,
                                 Marker::filled_diamond, Marker::cross};
    constexpr double apart = 0.12;
    constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
    Line bars{.legend = "standard deviation", .colour = Colour::grey, .width = 2};
    std::vector<Points> means;
    for (const Curve& curve : curves) {
        const auto number = static_cast<double>(means.size());
        Points points{.legend = "mean: " + curve.legend, .colour = curve.colour, .marker = markers[means.size()]};
        for (const Sampled& at : curve.at) {
            const double x = at.x + apart * (number - (static_cast<double>(curves.size()) - 1) / 2);
            points.points.emplace_back(x, at.mean() / degrees(1));
            bars.points.insert(bars.points.end(),
                               {Point(x, (at.mean() - at.deviation()) / degrees(1)),
                                Point(x, (at.mean() + at.deviation()) / degrees(1)), Point(x, nothing)});
        }
        means.push_back(points);
    }
    if (means.size() == 1) {
        figure.series.emplace_back(Line{.points = means.front().points, .colour = means.front().colour});
    }
    figure.series.emplace_back(bars);
    figure.series.insert(figure.series.end(), means.begin(), means.end());
}

Line single_column_theory(double from, double to) {
    return curve(from, to, "atan(b / a)", Colour::grey, Dash::dashed,
                 [](double height) { return std::atan(1 / height) / degrees(1); });
}

std::string angle_in_words(double angle) {
    return human_number(angle / degrees(1), 3) + " deg";
}

void add_single_columns(const Sheet& sheet, Reproduction& result) {
    constexpr double wear = 0.022;   // in: a column of 2 in then fails a degree early
    constexpr double offset = 0.04;  // in
    std::vector<Curve> curves = {
        {"one piece, worn edges", Colour::blue, places(least_height, most_height)},
        {"cubes, worn edges, out of line", Colour::vermilion, places(least_height, most_height)}};
    sample(curves, samples, sheet.folder, {"single columns", 0, 0.2},
           [&](std::size_t number, const Sampled& at, std::uint64_t seed) -> std::optional<double> {
               const bool cubes = number == 1;
               if (!cubes && seed > 1) {
                   return std::nullopt;
               }
               return critical_tilt(WornColumn{static_cast<int>(at.x), cubes, wear, offset, seed});
           });
    const auto deficit = [&](std::size_t number, std::size_t place) {
        const Sampled& at = curves[number].at[place];
        return std::atan(1 / at.x) - at.mean();
    };
    const std::size_t last = curves.front().at.size() - 1;
    result.add("column of 2 in, one piece: tilt below atan(b/a)", "1 deg", angle_in_words(deficit(0, 0)),
               "the wear of the edges, 0.56 mm, is chosen for this");
    result.add("column of 9 in, one piece", "no difference", angle_in_words(deficit(0, last)),
               statement(deficit(0, last) < degrees(0.5)) + ": below half a degree");
    int about_one = 0;
    int less_stable = 0;
    for (std::size_t place = 0; place <= last; ++place) {
        about_one += deficit(1, place) > degrees(0.5) && deficit(1, place) < degrees(1.5) ? 1 : 0;
        less_stable += deficit(1, place) > deficit(0, place) ? 1 : 0;
    }
    const std::string heights = " of " + std::to_string(last + 1) + " heights";
    const auto shift_of_a_degree = [&](std::size_t place) {
        const double height = curves.front().at[place].x;
        return (1 - height * std::tan(std::atan(1 / height) - degrees(1))) / 2 * inch;
    };
    result.add(
        "cubes: tilt below atan(b/a)", "roughly 1 deg for almost all heights",
        angle_in_words(deficit(1, 0)) + " at 2 in to " + angle_in_words(deficit(1, last)) + " at 9 in",
        statement(about_one + 1 >= static_cast<int>(last + 1)) + ": 0.5 to 1.5 deg at " + std::to_string(about_one) +
            heights + "; a degree takes a centre of gravity " + human_number(1e3 * shift_of_a_degree(0), 2) +
            " mm nearer to the toe at 2 in, " + human_number(1e3 * shift_of_a_degree(last), 2) +
            " at 9 in, more than cubes that lie up to 1 mm out of line either way, an assumption, come to in a tall "
            "column");
    result.add("cubes against one piece", "the least stable", std::to_string(less_stable) + heights,
               statement(less_stable == static_cast<int>(last + 1)) + ": means of " + std::to_string(samples) +
                   " columns each");
    Figure figure = tilt_figure("Fig 3.4 as runs: single columns", "height", "in");
    figure.series.emplace_back(single_column_theory(least_height, most_height));
    draw_curves(figure, curves);
    figure.x.range = std::pair{1.72, 9.28};
    figure.y.range = tilts_of_single_columns;
    sheet.draw(figure, "fig_3_4_runs", "Fig 3.4; the tests' points are not printed.");
}

void add_equal_columns(const Sheet& sheet, Reproduction& result) {
    constexpr std::array colours{Colour::grey, Colour::blue, Colour::vermilion, Colour::green};
    constexpr std::array legends{"one column", "two", "three", "four"};
    std::vector<Curve> curves;
    for (std::size_t count = 1; count <= legends.size(); ++count) {
        curves.push_back({legends[count - 1], colours[count - 1], places(least_height, most_height)});
    }
    curves.push_back({"two on tin", Colour::purple, places(least_height, most_height)});
    const double tin = degrees(18);
    sample(curves, samples, sheet.folder, {"equal columns", 0.2, 0.55},
           [&](std::size_t number, const Sampled& at, std::uint64_t seed) -> std::optional<double> {
               const bool on_tin = number == 4;
               FrameRow row{std::vector<double>(on_tin ? 2 : number + 1, at.x), scattered_plaster_friction(), seed};
               if (on_tin) {
                   row.friction.base = tin;
                   row.friction.deviation = degrees(0.5);
               }
               const std::optional<FrameFailure> failure = tilt_until_failure(row);
               return failure ? std::optional(failure->tilt) : std::nullopt;
           });
    std::vector<Curve> even(legends.size(), {"", Colour::black, places(least_height, most_height)});
    sample(even, 1, sheet.folder, {"equal columns without scatter", 0.55, 0.6},
           [&](std::size_t number, const Sampled& at, std::uint64_t seed) -> std::optional<double> {
               FrameRow row{std::vector<double>(number + 1, at.x), scattered_plaster_friction(), seed};
               row.friction.deviation = 0;
               const std::optional<FrameFailure> failure = tilt_until_failure(row);
               return failure ? std::optional(failure->tilt) : std::nullopt;
           });
    // Counts the steps in which one column more stands at a greater tilt.
    const auto stabler = [&](const std::vector<Curve>& rows) {
        int number = 0;
        for (std::size_t count = 1; count < legends.size(); ++count) {
            for (std::size_t place = 0; place < rows[count].at.size(); ++place) {
                number += rows[count].at[place].mean() > rows[count - 1].at[place].mean() ? 1 : 0;
            }
        }
        return number;
    };
    const int steps = static_cast<int>((legends.size() - 1) * curves.front().at.size());
    double gain = 0;
    double on_tin = 0;
    for (std::size_t place = 0; place < curves[0].at.size(); ++place) {
        gain = std::max(gain, curves[3].at[place].mean() - curves[0].at[place].mean());
        if (curves[0].at[place].x > 3) {
            on_tin = std::max(on_tin, std::abs(curves[4].at[place].mean() - curves[1].at[place].mean()));
        }
    }
    result.add("one column more", "stands at greater tilt",
               std::to_string(stabler(curves)) + " of " + std::to_string(steps) + " greater",
               statement(stabler(curves) == steps) + ": means of " + std::to_string(samples) +
                   " rows each, whose friction scatters; without scatter " + std::to_string(stabler(even)) +
                   ", in means of 16 rows 23; four over one: at most " + angle_in_words(gain));
    result.add("two columns on tin against plaster, 4 in and more", "quite close", "within " + angle_in_words(on_tin),
               "lower ones slide on the tin first");
    Figure figure = tilt_figure("Fig 3.6 as runs: equal columns", "height", "in");
    draw_curves(figure, curves);
    figure.x.range = heights_of_equal_columns;
    figure.y.range = tilts_of_equal_columns;
    sheet.draw(figure, "fig_3_6_runs", "Fig 3.6: means of " + std::to_string(samples) + " rows each.");
}

void add_rows(const Sheet& sheet, Reproduction& result) {
    constexpr int least = 3;
    constexpr int most = 18;
    std::vector<Curve> curves = {{"rows", Colour::blue, places(least, most)}};
    // Cracks of the rows of 8 to 17 columns but 16, by whether friction scatters; elsewhere: their numbers of columns.
    struct Cracks {
        int at_three_inches = 0;
        std::multiset<int> elsewhere = {};
        std::string words() const {
            return std::to_string(at_three_inches) + " of " + std::to_string(at_three_inches + std::ssize(elsewhere));
        }
    };
    std::mutex counting;
    Cracks scattered;
    Cracks even;
    const auto crack_tilt = [&](const Sampled& at, bool scatters, std::uint64_t seed,
                                Cracks& cracks) -> std::optional<double> {
        const int columns = static_cast<int>(at.x);
        FrameRow row{growing_and_falling(columns), scattered_plaster_friction(), seed};
        row.friction.deviation = scatters ? row.friction.deviation : 0;
        const std::optional<FrameFailure> failure = tilt_until_failure(row);
        if (!failure) {
            return std::nullopt;
        }
        if (columns >= 8 && columns <= 17 && columns != 16) {
            const std::scoped_lock lock(counting);
            if (failure->crack_after + 3 == static_cast<std::size_t>(columns)) {
                ++cracks.at_three_inches;
            } else {
                cracks.elsewhere.insert(columns);
            }
        }
        return std::min(failure->tilt, failure->crack_tilt);
    };
    sample(curves, 2, sheet.folder, {"rows of growing and falling height", 0.6, 0.85},
           [&](std::size_t, const Sampled& at, std::uint64_t seed) { return crack_tilt(at, true, seed, scattered); });
    std::vector<Curve> without_scatter = {{"", Colour::black, places(least, most)}};
    sample(without_scatter, 1, sheet.folder, {"rows without scatter", 0.85, 1},
           [&](std::size_t, const Sampled& at, std::uint64_t seed) { return crack_tilt(at, false, seed, even); });
    const auto steps_down = [](const std::vector<Sampled>& rows) {
        int falling = 0;
        for (std::size_t place = 1; place < rows.size(); ++place) {
            falling += rows[place].mean() <= rows[place - 1].mean() ? 1 : 0;
        }
        return falling;
    };
    const int falling = steps_down(curves.front().at);
    result.add("one column more in a row of growing and falling height", "less stable",
               std::to_string(falling) + " of " + std::to_string(most - least),
               statement(falling == most - least) + ": without scatter " +
                   std::to_string(steps_down(without_scatter.front().at)));
    std::vector<std::string> others;
    std::ranges::transform(even.elsewhere, std::back_inserter(others), [](int one) { return std::to_string(one); });
    result.add("first crack in front of the column of 3 in, 8 to 17 columns but 16", "in all", scattered.words(),
               statement(scattered.elsewhere.empty() && even.elsewhere.empty()) + ": without scatter " + even.words() +
                   ", elsewhere with " + list_in_words(others) + " columns");
    result.json["rows"] = {{"falling", falling}, {"cracks", scattered.words()}, {"without_scatter", even.words()}};
    Figure figure = tilt_figure("Fig 3.7 as runs: growing and falling height", "number of columns", "");
    figure.series.emplace_back(curve(
        least, most, "highest column alone", Colour::grey, Dash::dashed,
        [](double columns) { return std::atan(2 / (std::floor((columns + 1) / 2) * 2)) / degrees(1); }, most - least));
    figure.series.emplace_back(curve(
        least, most, "average height alone", Colour::grey, Dash::dotted,
        [](double columns) {
            const std::vector<double> heights = growing_and_falling(static_cast<int>(columns));
            return std::atan(columns / std::accumulate(heights.begin(), heights.end(), 0.0)) / degrees(1);
        },
        most - least));
    draw_curves(figure, curves);
    figure.series.emplace_back(
        Points{.points = {{9, 16}}, .legend = "printed: nine columns, 16°", .colour = Colour::vermilion});
    figure.y.range = tilts_of_rows;
    sheet.draw(figure, "fig_3_7_runs", "Fig 3.7: means of two rows each.");
}

// The last frame up to that tilt.
const MotionFrame& frame_at(const RelaxationRun& made, double tilt) {
    const auto beyond = std::ranges::find_if(made.frames, [&](const MotionFrame& frame) { return frame.tilt > tilt; });
    return beyond == made.frames.begin() ? made.frames.front() : *std::prev(beyond);
}

// "1 slides; 2 to 6 turn": each column by what it has done since the start.
std::string movements_in_words(const MotionFrame& frame, std::size_t columns) {
    std::string words;
    for (std::size_t column = 0; column < columns; ++column) {
        words += (column > 0 ? ", " : "") + std::to_string(column + 1) + " " +
                 human_name(word_of(frame.outcome[column].movement));
    }
    return words;
}

double fastest(const MotionFrame& frame, std::size_t columns) {
    double speed = 0;
    for (std::size_t column = 0; column < columns; ++column) {
        speed = std::max(speed, std::hypot(frame.motion[column].vx, frame.motion[column].vy));
    }
    return speed;
}

Figure frame_figure(const RelaxationRun& made, const MotionFrame& frame, const std::string& title) {
    const Bodies bodies = make_bodies(made.scene);
    BlockDrawing drawing{.title = title};
    // The base extends for metres; only the part below the columns is drawn.
    constexpr double margin = 0.03;  // m
    Extent columns;
    for (std::size_t index = 0; index < bodies.size(); ++index) {
        for (std::size_t corner = bodies.range[index].begin; corner < bodies.range[index].end; ++corner) {
            if (bodies.fixed[index] == 0) {
                columns.include(moved_corner(bodies, frame.motion, corner).x());
            }
        }
    }
    for (std::size_t index = 0; index < bodies.size(); ++index) {
        DrawnBlock block;
        for (std::size_t corner = bodies.range[index].begin; corner < bodies.range[index].end; ++corner) {
            PlanePoint<> at = moved_corner(bodies, frame.motion, corner);
            at.x() = std::clamp(at.x(), columns.lowest - margin, columns.highest + margin);
            block.outline.emplace_back(std::cos(frame.tilt) * at.x() - std::sin(frame.tilt) * at.y(),
                                       std::sin(frame.tilt) * at.x() + std::cos(frame.tilt) * at.y());
        }
        const bool fixed = bodies.fixed[index] != 0;
        block.label = label_of(index, fixed);
        block.mode = fixed ? DrawnMode::fixed : DrawnMode::plain;
        drawing.blocks.push_back(std::move(block));
    }
    return block_figure(drawing);
}

// Draws an arrow to the crack above that column, counted from 1, with its width at the height of the next one.
void point_at_crack(const RelaxationRun& made, const MotionFrame& frame, std::size_t column, Figure& figure) {
    const Bodies bodies = make_bodies(made.scene);
    // Returns the corner of a block that is farthest in that direction.
    const auto corner = [&](std::size_t block, const PlanePoint<>& way) {
        PlanePoint<> found = moved_corner(bodies, frame.motion, bodies.range[block].begin);
        for (std::size_t at = bodies.range[block].begin + 1; at < bodies.range[block].end; ++at) {
            const PlanePoint<> other = moved_corner(bodies, frame.motion, at);
            found = (other - found).dot(way) > 0 ? other : found;
        }
        return found;
    };
    const PlanePoint<> below = corner(column - 1, {1, -1});
    const PlanePoint<> above = corner(column - 1, {1, 1});
    const PlanePoint<> next = corner(column, {-1, 1});
    const double face = below.x() + (above.x() - below.x()) * (next.y() - below.y()) / (above.y() - below.y());
    const auto turned = [&](double x, double y) {
        return Point(std::cos(frame.tilt) * x - std::sin(frame.tilt) * y,
                     std::sin(frame.tilt) * x + std::cos(frame.tilt) * y);
    };
    const double middle = (face + next.x()) / 2;
    const Arrow arrow{.from = turned(middle + 0.045, next.y() + 0.025), .to = turned(middle, next.y())};
    figure.arrows.push_back(arrow);
    figure.labels.push_back(
        {.at = arrow.from, .text = "crack, " + human_number(1e3 * (next.x() - face), 2) + " mm", .raise = 0.6});
}

// Plate 3.XIV: the friction between columns is chosen to match what is printed, that on the base is the middle of what
// was measured.
void add_nine_columns(const Sheet& sheet, Reproduction& result) {
    constexpr std::size_t columns = 9;
    FrameRow row{growing_and_falling(columns), scattered_plaster_friction(), 0};
    row.friction.deviation = 0;
    row.friction.interface = degrees(10);
    const std::optional<FrameFailure> failure = tilt_until_failure(row);
    const RelaxationRun made = tilt_all_the_way(row);
    if (!failure || made.frames.empty()) {
        result.add("Plate 3.XIV", "", "the run broke off", "");
        return;
    }
    result.add({"nine columns: tilt of the first crack", "16 deg", angle_in_words(failure->crack_tilt),
                angle_in_words(failure->crack_tilt - degrees(16)),
                "friction between columns " + angle_in_words(row.friction.interface) +
                    ", of 8 to 22 deg; on the base " + angle_in_words(row.friction.base) +
                    ", of 29 to 36.5 deg (3.3.2.1, 4.2)"});
    result.add("nine columns: place of the crack", "between 6 and 7",
               "between " + std::to_string(failure->crack_after) + " and " + std::to_string(failure->crack_after + 1),
               statement(failure->crack_after == 6));
    const MotionFrame& at_30 = frame_at(made, degrees(30));
    const MotionFrame& end = made.frames.back();
    result.add("nine columns at 30 deg", "stable, turned columns on their edges",
               "fastest column " + human_number(fastest(at_30, columns) * 1e3, 2) + " mm/s",
               statement(end.tilt >= degrees(30)) +
                   ": whether turned columns wedge again or fall is chance. With 33 and 40 deg on the base they stand "
                   "up to 30.5 and 36.9 deg, from 45 deg on to the end of the frame, with 34.5 and 35 deg to 18.6, and "
                   "with 33 deg and the 5.7 deg between columns that let the crack open at 16 deg to 24.1; " +
                   movements_in_words(at_30, columns));
    result.add({"nine columns: tilt at which all go", "32 deg, sliding on their edges", angle_in_words(end.tilt),
                angle_in_words(end.tilt - degrees(32)), movements_in_words(end, columns)});
    std::vector<Figure> figures;
    for (const auto& [tilt, what] :
         {std::pair{failure->crack_tilt / degrees(1) + 0.5, " (b)"}, {30.0, " (c)"}, {32.0, " (d)"}}) {
        const MotionFrame& frame = frame_at(made, degrees(tilt));
        const std::string number = human_number(frame.tilt / degrees(1), 3);
        figures.push_back(
            frame_figure(made, frame, "Plate 3.XIV" + std::string(what) + ": nine columns at " + number + " deg"));
        if (tilt < 20 && failure->crack_after > 0) {
            point_at_crack(made, frame, failure->crack_after, figures.back());
        }
    }
    set_one_scale(figures);
    sheet.draw(figures[0], "plate_3_xiv_crack", "Gravity downwards; F: the base.");
    sheet.draw(figures[1], "plate_3_xiv_30_deg", "Gravity downwards; F: the base.");
    sheet.draw(figures[2], "plate_3_xiv_end", "Gravity downwards; F: the base.");
}

}  // namespace

Reproduction reproduce_tilting_runs(const Sheet& sheet) {
    Reproduction result;
    stop_if_interrupted();
    sheet.add(Heading{"The tilting frame as runs"});
    add_single_columns(sheet, result);
    add_equal_columns(sheet, result);
    add_rows(sheet, result);
    add_nine_columns(sheet, result);
    sheet.add(printed_table("Statements of section 3.3", result.rows));
    return result;
}

}  // namespace delabole
