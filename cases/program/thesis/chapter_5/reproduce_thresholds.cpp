// The clean engine's answers where the thesis's program leaves doubts: at which tilt one and two blocks fail, at which
// friction the stepped base does, and how stiffness, time step, damping and start change that.
#include "cases/program/thesis/appendix_a.hpp"
#include "cases/program/thesis/chapter_5/chapter_5.hpp"
#include "dynamic_relaxation/scene/scenes.hpp"
#include "dynamic_relaxation/step/simulation.hpp"
#include "limit_equilibrium/block_row/closed_forms.hpp"
#include "plots/drawing/text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace delabole {

namespace {

constexpr double slenderness = 3;

std::string in_degrees(double value, int digits = 5) {
    return human_number(value, digits) + " deg";
}

bool stands(const Chapter5Run& run, RelaxationStart start, double rotation, double equilibrium_ratio) {
    RelaxationSettings settings = clean_settings(run, start);
    settings.stop_at_equilibrium = true;
    settings.equilibrium_ratio = equilibrium_ratio;
    settings.collapse_rotation = rotation;
    settings.duration = 20;
    return relax(clean_scene(run, exact_blocks(run)), settings).outcome == RelaxationOutcome::equilibrium;
}

// Greatest tilts, deg, at which one and two blocks come to rest, dropped or consolidated.
using Thresholds = std::array<double, 4>;
constexpr std::array keys{"one_dropped", "one_preloaded", "two_dropped", "two_preloaded"};
enum { one_dropped, one_preloaded, two_dropped, two_preloaded };

Thresholds thresholds(const std::function<void(HockingSettings&)>& change) {
    Thresholds found{};
    std::size_t index = 0;
    for (const std::string_view group : {"fixed_inclination", "double_fixed"}) {
        for (const RelaxationStart start : {RelaxationStart::dropped, RelaxationStart::preloaded}) {
            Chapter5Run run = chapter_5_runs(group).front();
            change(run.settings);
            const auto [low, high] = bisect(degrees(16.5), degrees(19), degrees(0.002), [&](double tilt) {
                run.columns.dip = tilt;
                // A block that rocks slowly over the point of toppling is all but balanced for a while.
                return stands(run, start, run.settings.failure_rotation, 1e-8);
            });
            found[index++] = std::midpoint(low, high) / degrees(1);
        }
    }
    return found;
}

void add_in_words(const Thresholds& found, std::vector<std::string>& row) {
    for (const double tilt : found) {
        row.push_back(human_number(tilt, 5));
    }
}

// Tilt, deg, at which a single consolidated block fails: the heel's spring is spent, and the toe's carries all.
double law(double stiffness) {
    const HockingSettings settings = chapter_5_runs("fixed_inclination").front().settings;
    const double weight = settings.density * settings.gravity * slenderness * inch * inch;
    return std::atan(1 / slenderness - weight / (stiffness * inch) * std::hypot(1, 1 / slenderness)) / degrees(1);
}

// The smaller tilt, deg, of the forward and the backward mode, (8) and (10).
double two_blocks_in_theory() {
    const double mu = std::tan(degrees(20));
    return std::atan(std::min(closed_form::equal_blocks(1, 0, slenderness, 1.0, mu, mu),
                              closed_form::equal_blocks(0, 1, slenderness, 1.0, mu, mu))) /
           degrees(1);
}

Line level(double value, double from, double to, const std::string& legend, Colour colour, Dash dash) {
    return {.points = {Point(from, value), Point(to, value)}, .legend = legend, .colour = colour, .dash = dash};
}

}  // namespace

void thresholds_by_stiffness(Chapter5Item& item) {
    Reproduction& result = item.result;
    std::array<Line, 4> lines = {Line{.legend = "one, dropped", .colour = Colour::blue, .dash = Dash::dashed},
                                 Line{.legend = "one, preloaded", .colour = Colour::blue},
                                 Line{.legend = "two, dropped", .colour = Colour::vermilion, .dash = Dash::dashed},
                                 Line{.legend = "two, preloaded", .colour = Colour::vermilion}};
    Points of_law{.legend = "one, law", .colour = Colour::black, .marker = Marker::circle};
    double farthest_from_law = 0;
    for (const double stiffness : {1e6, 2e6, 6e6, 12e6, 1e8, 1e9}) {
        const Thresholds found = thresholds([&](HockingSettings& settings) { settings.stiffness = stiffness; });
        std::vector<std::string>& row =
            item.table.rows.emplace_back(std::vector{human_number(stiffness / 1e6, 4) + "e6"});
        add_in_words(found, row);
        row.push_back(human_number(law(stiffness), 5));
        for (std::size_t index = 0; index < found.size(); ++index) {
            lines[index].points.emplace_back(std::log10(stiffness), found[index]);
            result.json["threshold_deg"][row.front()][keys[index]] = found[index];
        }
        result.json["threshold_deg"][row.front()]["law"] = law(stiffness);
        of_law.points.emplace_back(std::log10(stiffness), law(stiffness));
        farthest_from_law = std::max(farthest_from_law, std::abs(found[one_preloaded] - law(stiffness)));
    }
    const Polyline& two = lines[two_dropped].points;
    result.json["farthest_from_law_deg"] = farthest_from_law;
    result.add("one block, preloaded: farthest from tan(tilt) = b/a - W/(k b) sqrt(1 + (b/a)^2)", "",
               in_degrees(farthest_from_law, 2), "bisected to 0.002 deg");
    result.add("two blocks, dropped: stands up to, 1e6 and 1e9 N/m", "softer fails; stiffer fails faster", "",
               "stiffer stands longer, without exception",
               human_number(two.front().y(), 5) + " and " + in_degrees(two.back().y()));
    Figure figure{.title = "5.3.1 and 5.3.2: greatest tilt that stands, a/b = 3"};
    figure.x = {.title = "stiffness of a corner",
                .unit = "N/m",
                .range = std::pair(5.8, 9.2),
                .ticks = {{6, "1e6"}, {7, "1e7"}, {8, "1e8"}, {9, "1e9"}}};
    figure.y = {.title = "tilt", .unit = "deg", .range = std::pair(17.5, 18.75)};
    const double one_in_theory = std::atan(1 / slenderness) / degrees(1);
    const double two_in_theory = two_blocks_in_theory();
    figure.series = {
        level(one_in_theory, 5.8, 9.2, "equilibrium, one: " + in_degrees(one_in_theory), Colour::sky, Dash::dotted),
        level(two_in_theory, 5.8, 9.2, "equilibrium, two: " + in_degrees(two_in_theory), Colour::orange, Dash::dotted)};
    figure.series.insert(figure.series.end(), lines.begin(), lines.end());
    figure.series.emplace_back(of_law);
    figure.series.emplace_back(Points{.points = {Point(std::log10(6e6), 18.15), Point(std::log10(6e6), 18.3)},
                                      .legend = "printed: 18.15 (one) and 18.3 (two) stand",
                                      .colour = Colour::black,
                                      .marker = Marker::filled_diamond});
    item.draw(figure, "thresholds", "Stiffness and start decide, not the blocks alone.");
}

void thresholds_by_step_and_damping(Chapter5Item& item) {
    double least = 90;
    double greatest = 0;
    double of_step = 0;
    std::optional<Thresholds> reference;
    const std::vector<std::pair<double, double>> varied{{1e-4, 0.5}, {0.5e-4, 0.5}, {0.25e-4, 0.5}, {1e-4, 0.2},
                                                        {1e-4, 0.6}, {1e-4, 0.7},   {1e-4, 1.0}};
    for (const auto& [step, damping] : varied) {
        const Thresholds found = thresholds([step = step, damping = damping](HockingSettings& settings) {
            settings.time_step = step;
            settings.damping = damping;
        });
        add_in_words(found, item.table.rows.emplace_back(
                                std::vector{human_number(step * 1e4, 2) + "e-4", human_number(damping, 2)}));
        reference = reference.value_or(found);
        for (const std::size_t index : {one_preloaded, two_preloaded}) {
            least = std::min(least, found[index]);
            greatest = std::max(greatest, found[index]);
        }
        for (const std::size_t index : {one_dropped, two_dropped}) {
            of_step = damping == 0.5 ? std::max(of_step, std::abs(found[index] - (*reference)[index])) : of_step;
        }
    }
    item.result.json["preloaded_spread_deg"] = greatest - least;
    item.result.json["dropped_spread_by_step_deg"] = of_step;
    item.result.add("preloaded: largest change by step or damping", "halving the step: more than twice the cycles",
                    in_degrees(greatest - least, 2), "");
    item.result.add("dropped: largest change by the step", "", "",
                    "damping matters there: it takes the energy of the drop", in_degrees(of_step, 2));
}

namespace {

// Greatest friction, deg, at which the slope does not stand: `moves` tells that of a friction angle.
double limit(const std::function<bool(double)>& moves) {
    const auto [low, high] = bisect(degrees(39), degrees(45), degrees(0.005), moves);
    return std::midpoint(low, high) / degrees(1);
}

// Onset of the stepped base with columns a metre wide, as rock, from a consolidated start.
double onset_at(double stiffness_ratio) {
    constexpr double density = 2700;
    StandingBlocks columns{};
    for (const ColumnBlock<>& block : appendix_a_columns().block) {
        columns.block.push_back({block.width, block.height, block.step_above});
    }
    columns.density = density;
    columns.tilt = degrees(21.8);
    const double stiffness = stiffness_of_ratio(stiffness_ratio, columns.block[3], density, Gravity{}.acceleration);
    RelaxationSettings settings;
    settings.stop_at_onset = true;
    return limit([&](double friction) {
        columns.interface = columns.base = {stiffness, stiffness, friction};
        return relax(column_scene(columns), settings).outcome != RelaxationOutcome::equilibrium;
    });
}

// For the thesis's inch blocks onset is at 0.01 rad, collapse at the rotation that counts as failure.
double limit_of_inches(Chapter5Run run, RelaxationStart start, double rotation) {
    return limit([&](double friction) {
        run.settings.joints = run.settings.bases = {friction, friction};
        return !stands(run, start, rotation, RelaxationSettings{}.equilibrium_ratio);
    });
}

}  // namespace

// 5.3.4.2 finely resolved: at which friction the stepped base begins to move, apart from where it collapses.
void onset_of_the_stepped_base(Chapter5Item& item) {
    constexpr double theory = 41.14;  // deg, Appendix A
    Reproduction& result = item.result;
    const auto add = [&](const std::string& blocks, double ratio, const std::string& start, const std::string& counts,
                         double friction) {
        const std::string words = human_number(ratio, blocks == "metres" ? 2 : 3);
        item.table.rows.push_back({blocks, words, start, counts, human_number(friction, 5)});
        result.json["friction_deg"].push_back(
            {{"blocks", blocks}, {"ratio", words}, {"start", start}, {"counts", counts}, {"friction_deg", friction}});
        return friction;
    };
    Line onset{.legend = "clean engine, preloaded, onset", .colour = Colour::blue};
    for (const double power : {4.0, 4.5, 5.0, 5.5, 6.0, 7.0}) {
        const double ratio = std::pow(10, power);
        onset.points.emplace_back(power, add("metres", ratio, "preloaded", "0.01 rad", onset_at(ratio)));
        result.json["onset_deg"].push_back(onset.points.back().y());
    }
    const double finest = onset.points.back().y();
    const Chapter5Run& inches = item.runs.front();
    const double ratio = inches.settings.stiffness * inches.columns.width /
                         (inches.settings.density * inches.settings.gravity * inches.columns.width * 4 * inch);
    const double preloaded =
        add("inches", ratio, "preloaded", "1 deg", limit_of_inches(inches, RelaxationStart::preloaded, degrees(1)));
    const double dropped =
        add("inches", ratio, "dropped", "1 deg", limit_of_inches(inches, RelaxationStart::dropped, degrees(1)));
    add("inches", ratio, "dropped", "10 deg", limit_of_inches(inches, RelaxationStart::dropped, degrees(10)));
    result.json["inches_dropped_deg"] = dropped;
    result.json["inches_preloaded_deg"] = preloaded;
    result.add({"stepped base: onset at k b/W = 1e7", "41.14 deg", "", in_degrees(finest - theory, 2),
                "printed: limit equilibrium", in_degrees(finest)});
    result.add("the thesis's blocks, dropped: limit", "between 42 and 44 deg", "",
               statement(dropped > 42 && dropped < 44), in_degrees(dropped));
    Figure figure{.title = "5.3.4.2: friction at which the stepped base begins to move"};
    figure.x = {.title = "stiffness k b / W of the tallest column",
                .range = std::pair(2.8, 7.2),
                .ticks = {{3, "1e3"}, {4, "1e4"}, {5, "1e5"}, {6, "1e6"}, {7, "1e7"}}};
    figure.y = {.title = "friction angle", .unit = "deg", .range = std::pair(40.5, 44.5)};
    const auto point = [&](double friction, const std::string& start, Colour colour, Marker marker) {
        return Points{.points = {Point(std::log10(ratio), friction)},
                      .legend = "the thesis's blocks, " + start + ", 1 deg",
                      .colour = colour,
                      .marker = marker};
    };
    figure.series = {Region{.outline = {Point(2.8, 42), Point(7.2, 42), Point(7.2, 44), Point(2.8, 44)},
                            .legend = "thesis: 42 deg fails, 44 deg stands",
                            .colour = Colour::light_grey},
                     level(theory, 2.8, 7.2, "equilibrium, Appendix A: 41.14 deg", Colour::black, Dash::dashed),
                     onset,
                     Points{.points = onset.points, .colour = Colour::blue},
                     point(dropped, "dropped", Colour::vermilion, Marker::filled_triangle),
                     point(preloaded, "preloaded", Colour::green, Marker::filled_square)};
    item.draw(figure, "stepped_base_onset", "Onset converges with stiffness.");
}

}  // namespace delabole
