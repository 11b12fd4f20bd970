// The clean engine's answers where the thesis's program leaves doubts: at which tilt one and two blocks fail, at which
// friction the stepped base does, and how stiffness, time step, damping and start change that.
#include "cases/program/terminal/interrupt.hpp"
#include "cases/program/thesis/chapter_5/chapter_5.hpp"
#include "dynamic_relaxation/scene/scenes.hpp"
#include "dynamic_relaxation/step/simulation.hpp"
#include "limit_equilibrium/block_row/closed_forms.hpp"
#include "plots/drawing/text.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace delabole {

namespace {

constexpr double slenderness = 3;
constexpr double friction = degrees(20);
constexpr double accuracy = degrees(0.002);

Chapter5Run row_of(int count) {
    return chapter_5_runs(count == 1 ? "fixed_inclination" : "double_fixed").front();
}

bool stands(const Chapter5Run& run, RelaxationStart start) {
    RelaxationSettings settings = clean_settings(run, start);
    settings.stop_at_equilibrium = true;
    // A block that rocks slowly over the point of toppling is all but balanced for a while.
    settings.equilibrium_ratio = 1e-8;
    settings.collapse_rotation = run.settings.failure_rotation;
    settings.duration = 20;
    return relax(clean_scene(run, exact_blocks(run)), settings).outcome == RelaxationOutcome::equilibrium;
}

// Greatest tilt at which the blocks come to rest.
double threshold(Chapter5Run run, RelaxationStart start) {
    double low = degrees(16.5);
    double high = degrees(19);
    while (high - low > accuracy) {
        stop_if_interrupted();
        run.columns.dip = (low + high) / 2;
        (stands(run, start) ? low : high) = run.columns.dip;
    }
    return (low + high) / 2;
}

double weight(const HockingSettings& settings) {
    return settings.density * settings.gravity * slenderness * inch * inch;
}

// One block, preloaded: the heel's spring is spent, the toe's carries all.
double law(const HockingSettings& settings) {
    return std::atan(1 / slenderness - weight(settings) / (settings.stiffness * inch) * std::hypot(1, 1 / slenderness));
}

// Least of forward and backward mode, (8) and (10).
double two_blocks_in_theory() {
    const double mu = std::tan(friction);
    return std::atan(std::min(closed_form::equal_blocks(1, 0, slenderness, 1.0, mu, mu),
                              closed_form::equal_blocks(0, 1, slenderness, 1.0, mu, mu)));
}

std::string shown(double angle) {
    return human_number(angle / degrees(1), 5);
}

// Tilts of one and two blocks, dropped and preloaded.
struct Thresholds {
    std::array<double, 2> dropped = {};
    std::array<double, 2> preloaded = {};
};

Thresholds thresholds(const std::function<void(HockingSettings&)>& change) {
    Thresholds found;
    for (const int count : {1, 2}) {
        Chapter5Run run = row_of(count);
        change(run.settings);
        const auto index = static_cast<std::size_t>(count) - 1;
        found.dropped[index] = threshold(run, RelaxationStart::dropped);
        found.preloaded[index] = threshold(run, RelaxationStart::preloaded);
    }
    return found;
}

std::vector<std::string> in_words(const Thresholds& found) {
    return {shown(found.dropped[0]), shown(found.preloaded[0]), shown(found.dropped[1]), shown(found.preloaded[1])};
}

Json json_of(const Thresholds& found) {
    return {{"one_dropped", found.dropped[0] / degrees(1)},
            {"one_preloaded", found.preloaded[0] / degrees(1)},
            {"two_dropped", found.dropped[1] / degrees(1)},
            {"two_preloaded", found.preloaded[1] / degrees(1)}};
}

const std::vector<TableColumn>& threshold_columns() {
    static const std::vector<TableColumn> columns = {"one, dropped"_number, "one, preloaded"_number,
                                                     "two, dropped"_number, "two, preloaded"_number};
    return columns;
}

Polyline marks(const std::vector<double>& logarithms, double tilt) {
    return {Point(logarithms.front(), tilt), Point(logarithms.back(), tilt)};
}

constexpr std::array stiffnesses{1e6, 2e6, 6e6, 12e6, 1e8, 1e9};

void stiffness_part(const ResultFolder& folder, Report& report, Reproduction& result) {
    Table table{"Greatest tilt that stands against stiffness, clean engine, deg", {"stiffness, N/m"_number}};
    table.columns.insert(table.columns.end(), threshold_columns().begin(), threshold_columns().end());
    table.columns.emplace_back("law of one, preloaded", true);
    std::array<Line, 4> lines = {Line{.legend = "one, dropped", .colour = Colour::blue, .dash = Dash::dashed},
                                 Line{.legend = "one, preloaded", .colour = Colour::blue},
                                 Line{.legend = "two, dropped", .colour = Colour::vermilion, .dash = Dash::dashed},
                                 Line{.legend = "two, preloaded", .colour = Colour::vermilion}};
    Points of_law{.legend = "one, law", .colour = Colour::black, .marker = Marker::circle};
    std::vector<double> logarithms;
    double farthest_from_law = 0;
    double softest = 0;
    double stiffest = 0;
    for (const double stiffness : stiffnesses) {
        const Thresholds found = thresholds([&](HockingSettings& settings) { settings.stiffness = stiffness; });
        HockingSettings settings = row_of(1).settings;
        settings.stiffness = stiffness;
        std::vector<std::string> row = {human_number(stiffness / 1e6, 4) + "e6"};
        for (const std::string& tilt : in_words(found)) {
            row.push_back(tilt);
        }
        row.push_back(shown(law(settings)));
        table.rows.push_back(row);
        logarithms.push_back(std::log10(stiffness));
        const std::array tilts = {found.dropped[0], found.preloaded[0], found.dropped[1], found.preloaded[1]};
        for (std::size_t index = 0; index < lines.size(); ++index) {
            lines[index].points.emplace_back(logarithms.back(), tilts[index] / degrees(1));
        }
        of_law.points.emplace_back(logarithms.back(), law(settings) / degrees(1));
        farthest_from_law = std::max(farthest_from_law, std::abs(found.preloaded[0] - law(settings)));
        softest = softest == 0 ? found.dropped[1] : softest;
        stiffest = found.dropped[1];
        result.json["threshold_deg"][row.front()] = json_of(found);
        result.json["threshold_deg"][row.front()]["law"] = law(settings) / degrees(1);
    }
    result.json["farthest_from_law_deg"] = farthest_from_law / degrees(1);
    result.rows.push_back({"one block, preloaded: farthest from tan(tilt) = b/a - W/(k b) sqrt(1 + (b/a)^2)", "",
                           human_number(farthest_from_law / degrees(1), 2) + " deg", "", "bisected to 0.002 deg"});
    result.rows.push_back({"two blocks, dropped: stands up to, 1e6 and 1e9 N/m", "softer fails; stiffer fails faster",
                           "", "", "stiffer stands longer, without exception",
                           shown(softest) + " and " + shown(stiffest) + " deg"});
    Figure figure{.title = "5.3.1 and 5.3.2: greatest tilt that stands, a/b = 3"};
    figure.x = {.title = "stiffness of a corner",
                .unit = "N/m",
                .range = std::pair(5.8, 9.2),
                .ticks = {{6, "1e6"}, {7, "1e7"}, {8, "1e8"}, {9, "1e9"}}};
    figure.y = {.title = "tilt", .unit = "deg", .range = std::pair(17.5, 18.75)};
    const double one = std::atan(1 / slenderness) / degrees(1);
    const double two = two_blocks_in_theory() / degrees(1);
    figure.series.emplace_back(Line{.points = marks({5.8, 9.2}, one),
                                    .legend = "equilibrium, one: " + human_number(one, 5) + " deg",
                                    .colour = Colour::sky,
                                    .dash = Dash::dotted});
    figure.series.emplace_back(Line{.points = marks({5.8, 9.2}, two),
                                    .legend = "equilibrium, two: " + human_number(two, 5) + " deg",
                                    .colour = Colour::orange,
                                    .dash = Dash::dotted});
    for (const Line& line : lines) {
        figure.series.emplace_back(line);
    }
    figure.series.emplace_back(of_law);
    const double thesis = std::log10(row_of(1).settings.stiffness);
    figure.series.emplace_back(Points{.points = {Point(thesis, 18.15), Point(thesis, 18.3)},
                                      .legend = "printed: 18.15 (one) and 18.3 (two) stand",
                                      .colour = Colour::black,
                                      .marker = Marker::filled_diamond});
    report.blocks.emplace_back(Paragraph{
        "What falls onto its springs rocks, and may rock past its limit: a drop of W/k has the energy to lift the "
        "block over what is left of the barrier, which is why the tilt lost by dropping falls with the root of the "
        "stiffness. Preloaded, one block follows its law. Two preloaded blocks gain by each other only where stiffness "
        "is high: they jam after leaning by sqrt(2 g / b), g the compliance of the contact, and soft ones are past "
        "their own limit by then."});
    report.blocks.emplace_back(table);
    report.blocks.emplace_back(folder.draw(figure, "thresholds", "Stiffness and start decide, not the blocks alone."));
}

void step_and_damping_part(Report& report, Reproduction& result) {
    Table table{"Greatest tilt that stands against time step and damping, 6e6 N/m, clean engine, deg",
                {"time step, s", "damping"_number}};
    table.columns.insert(table.columns.end(), threshold_columns().begin(), threshold_columns().end());
    struct Setting {
        double step, damping;
    };
    double least = 90;
    double greatest = 0;
    double of_step = 0;
    std::optional<Thresholds> reference;
    for (const Setting& setting : {Setting{1e-4, 0.5}, Setting{0.5e-4, 0.5}, Setting{0.25e-4, 0.5}, Setting{1e-4, 0.2},
                                   Setting{1e-4, 0.6}, Setting{1e-4, 0.7}, Setting{1e-4, 1.0}}) {
        const Thresholds found = thresholds([&](HockingSettings& settings) {
            settings.time_step = setting.step;
            settings.damping = setting.damping;
        });
        std::vector<std::string> row = {human_number(setting.step * 1e4, 2) + "e-4", human_number(setting.damping, 2)};
        for (const std::string& tilt : in_words(found)) {
            row.push_back(tilt);
        }
        table.rows.push_back(row);
        reference = reference.value_or(found);
        for (const std::size_t index : {0U, 1U}) {
            least = std::min(least, found.preloaded[index] / degrees(1));
            greatest = std::max(greatest, found.preloaded[index] / degrees(1));
            if (setting.damping == 0.5) {
                of_step = std::max(of_step, std::abs(found.dropped[index] - reference->dropped[index]));
            }
        }
    }
    result.json["preloaded_spread_deg"] = greatest - least;
    result.json["dropped_spread_by_step_deg"] = of_step / degrees(1);
    result.rows.push_back({"preloaded: largest change by step or damping",
                           "halving the step: more than twice the cycles", human_number(greatest - least, 2) + " deg",
                           "", ""});
    result.rows.push_back({"dropped: largest change by the step", "", "", "",
                           "damping matters there: it takes the energy of the drop",
                           human_number(of_step / degrees(1), 2) + " deg"});
    report.blocks.emplace_back(table);
}

}  // namespace

Reproduction reproduce_thresholds(const ResultFolder& folder, Report& report) {
    Reproduction result;
    report.blocks.emplace_back(Heading{"Stiffness, step and damping in the clean engine"});
    stiffness_part(folder, report, result);
    step_and_damping_part(report, result);
    report.blocks.emplace_back(printed_table("Observations 1 to 4, clean engine", result.rows));
    return result;
}

}  // namespace delabole
