#include "cases/program/thesis/hocking/chapter_5.hpp"

#include "parameters/fields.hpp"

#include <cmath>
#include <random>
#include <utility>

namespace delabole {

namespace {

constexpr double stiffness_per_width = 2e6;  // N/m

HockingColumns equal_columns(int count, double slenderness, double inclination) {
    HockingColumns columns;
    columns.heights.assign(static_cast<std::size_t>(count), slenderness * inch);
    columns.width = inch;
    columns.dip = degrees(inclination);
    columns.base = HockingBase::one_block;
    columns.base_height = slenderness * inch;
    columns.downhill_bases = columns.uphill_bases = 8;
    columns.coordinate_unit = typed_digit;
    return columns;
}

HockingSettings settings_of(double stiffness, double joint_friction, double base_friction, int cycles) {
    HockingSettings settings;
    settings.time_step = 1e-4;
    settings.damping = 0.5;
    settings.stiffness = stiffness;
    settings.density = plaster_density;
    settings.gravity = 9.81;
    settings.joints = {degrees(joint_friction), degrees(joint_friction)};
    settings.bases = {degrees(base_friction), degrees(base_friction)};
    settings.cycles = cycles;
    settings.print_interval = 100;
    settings.failure_rotation = degrees(5);
    settings.stop_rotation = degrees(5);
    // A hundredth of what the thesis's six printed digits can show over the thousands of cycles of a run.
    settings.settled_speed = 1e-6;
    // Landing of a fallen column gives some tens of its weight, a change of face some ten thousand times the weight.
    settings.blow_out_force = 1e3;
    return settings;
}

std::string in_degrees(double value) {
    std::string text = std::to_string(value);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') {
        text.pop_back();
    }
    return text + " deg";
}

Chapter5Run equal_run(int count, double slenderness, double inclination, double friction, int cycles) {
    Chapter5Run made;
    made.name = in_degrees(inclination);
    made.columns = equal_columns(count, slenderness, inclination);
    made.settings = settings_of(stiffness_per_width * slenderness, friction, friction, cycles);
    return made;
}

constexpr int long_run = 15000;
constexpr double double_friction = 20;
constexpr double longest_drawn = 80;  // deg, where runs that are drawn and counted end

Chapter5Run tilted(int count, TiltedPart part, double from, double to, int consolidation, int every) {
    Chapter5Run made = equal_run(count, 3, from, double_friction, 20000);
    made.columns.base_height = part == TiltedPart::base ? inch : made.columns.base_height;
    made.name = in_degrees(from) + " to " + in_degrees(to) + ", every " + std::to_string(every) + " cycles";
    // 0.1 deg in 1000 cycles for 10, in 2000 for 20.
    made.settings.tilting = HockingTilting{part, consolidation, every, degrees(1e-3), degrees(to - from)};
    return made;
}

// Stands as in the thesis, or counts what a row of its tables counts.
Chapter5Run row(int count, double slenderness, double inclination, double joints, double bases, int first_print,
                int cycles) {
    Chapter5Run made = equal_run(count, slenderness, inclination, joints, cycles);
    made.settings.bases = {degrees(bases), degrees(bases)};
    made.settings.stop_rotation = degrees(longest_drawn);
    made.first_print = first_print;
    made.printed = PrintedOutcome::fails;
    return made;
}

}  // namespace

std::vector<Chapter5Run> fixed_inclination_runs() {
    struct Printed {
        double inclination, damping;
        std::optional<SettledCycles> settled;
    };
    const std::vector<Printed> printed = {
        {17, 0.5, SettledCycles{800, 900}},
        {17.5, 0.5, SettledCycles{1100, 1200}},
        {18, 0.5, SettledCycles{2200, 2200}},
        {18, 1, SettledCycles{1100, 800}},
        {18.1, 0.5, SettledCycles{3200, 2900}},
        {18.15, 0.5, SettledCycles{4900, 5000}},
        {18.2, 0.5, std::nullopt},
    };
    std::vector<Chapter5Run> runs;
    for (const Printed& one : printed) {
        Chapter5Run made = equal_run(1, 3, one.inclination, double_friction, 10000);
        made.name += one.damping == 0.5 ? "" : ", damping 1";
        made.settings.damping = one.damping;
        made.printed = one.settled ? PrintedOutcome::stands : PrintedOutcome::fails;
        made.printed_settled = one.settled;
        runs.push_back(made);
    }
    return runs;
}

std::vector<Chapter5Run> single_tilting_runs(TiltedPart part) {
    struct Printed {
        double from, to;
        int consolidation;
        std::optional<SettledCycles> settled;
        std::optional<int> momentum;
    };
    const std::vector<Printed> printed = {
        {18, 18.2, 2500, SettledCycles{6700, 6000}, {}},
        {18, 18.3, 2500, SettledCycles{11000, 9200}, {}},
        {18, 18.4, 2500, {}, 8000},
        {18.15, 18.3, 5500, SettledCycles{12100, 10600}, {}},
        {18.15, 18.4, 5500, {}, 10700},
    };
    std::vector<Chapter5Run> runs;
    for (const Printed& one : printed) {
        Chapter5Run made = tilted(1, part, one.from, one.to, one.consolidation, 10);
        made.printed = one.settled ? PrintedOutcome::stands : PrintedOutcome::fails;
        made.printed_settled = one.settled;
        made.printed_cycle = one.momentum;
        runs.push_back(made);
    }
    return runs;
}

Chapter5Run horizontal_start_run(TiltedPart part, int cycles_per_degree) {
    constexpr int consolidation = 500;
    constexpr int most_tilt = 25;  // deg
    Chapter5Run made = equal_run(1, 3, 0, double_friction, consolidation + cycles_per_degree * (most_tilt + 5));
    made.columns.base_height = part == TiltedPart::base ? inch : made.columns.base_height;
    made.name = std::to_string(cycles_per_degree) + " cycles for a degree";
    made.settings.tilting =
        HockingTilting{part, consolidation, 1, degrees(1.0 / cycles_per_degree), degrees(most_tilt)};
    made.settings.stop_rotation = degrees(longest_drawn);
    made.printed = PrintedOutcome::fails;
    return made;
}

std::vector<Chapter5Run> double_fixed_runs() {
    std::vector<Chapter5Run> runs = {equal_run(2, 3, 18.3, double_friction, long_run),
                                     equal_run(2, 3, 18.4, double_friction, long_run)};
    runs[0].printed = PrintedOutcome::stands;
    runs[1].printed = PrintedOutcome::fails;
    return runs;
}

std::vector<Chapter5Run> double_tilting_runs(TiltedPart part) {
    constexpr int consolidation = 2500;
    struct Printed {
        double from, to;
        int every;
        bool stands;
    };
    const std::vector<Printed> printed = {{18.3, 18.5, 10, false}, {18.3, 18.4, 10, false}, {18.3, 18.4, 20, false},
                                          {18.2, 18.3, 10, false}, {18.2, 18.3, 20, true},  {18, 18.3, 10, false}};
    std::vector<Chapter5Run> runs;
    for (const Printed& one : printed) {
        runs.push_back(tilted(2, part, one.from, one.to, consolidation, one.every));
        runs.back().printed = one.stands ? PrintedOutcome::stands : PrintedOutcome::fails;
    }
    return runs;
}

std::vector<Chapter5Run> slenderness_runs() {
    std::vector<Chapter5Run> runs;
    for (const double slenderness : {3.0, 5.0, 10.0}) {
        const double inclination = std::round(10 * (std::atan(1 / slenderness) / degrees(1) + 0.5)) / 10;
        Chapter5Run made = row(2, slenderness, inclination, double_friction, double_friction, 100, 6000);
        made.name = "a/b " + std::to_string(static_cast<int>(slenderness)) + " at " + in_degrees(inclination);
        made.printed_behaviour = {"forward", "backward in the end"};
        runs.push_back(made);
    }
    return runs;
}

Chapter5Run blow_out_run() {
    Chapter5Run made = equal_run(2, 7, 8, double_friction, 1500);
    made.columns.coordinate_unit = typed_digit / 10;
    made.settings.cycles_after_blow_out = 12;
    made.printed = PrintedOutcome::blows_up;
    made.printed_cycle = 677;
    return made;
}

std::vector<Chapter5Run> stiffness_observation() {
    std::vector<Chapter5Run> runs;
    for (const double stiffness : {6e6, 1e6}) {
        Chapter5Run made = equal_run(2, 3, 18.3, double_friction, long_run);
        made.settings.stiffness = stiffness;
        made.name = stiffness > 2e6 ? "6e6 N/m" : "1e6 N/m";
        made.printed = stiffness > 2e6 ? PrintedOutcome::stands : PrintedOutcome::fails;
        runs.push_back(made);
    }
    return runs;
}

std::vector<Chapter5Run> displacement_observations() {
    struct Printed {
        const char* name;
        double stiffness, step;
        int cycle;
    };
    std::vector<Chapter5Run> runs;
    for (const Printed& one :
         {Printed{"12e6 N/m, step 1e-4 s", 12e6, 1e-4, 2500}, Printed{"6e6 N/m, step 1e-4 s", 6e6, 1e-4, 7000},
          Printed{"12e6 N/m, step 0.5e-4 s", 12e6, 0.5e-4, 6000}}) {
        Chapter5Run made = equal_run(2, 3, 18.4, double_friction, long_run);
        made.name = one.name;
        made.settings.stiffness = one.stiffness;
        made.settings.time_step = one.step;
        made.settings.stop_rotation = degrees(longest_drawn);
        made.printed = PrintedOutcome::fails;
        made.printed_cycle = one.cycle;
        runs.push_back(made);
    }
    return runs;
}

std::vector<Chapter5Run> damping_observation() {
    std::vector<Chapter5Run> runs;
    for (const double damping : {0.5, 0.6, 0.7}) {
        Chapter5Run made = equal_run(2, 3, 18.4, double_friction, long_run);
        made.name = "damping 0." + std::to_string(static_cast<int>(std::lround(10 * damping)));
        made.settings.damping = damping;
        made.settings.stop_rotation = degrees(longest_drawn);
        made.printed = PrintedOutcome::fails;
        runs.push_back(made);
    }
    return runs;
}

std::vector<Chapter5Run> triple_runs() {
    constexpr int cycles = 2500;
    std::vector<Chapter5Run> runs = {row(3, 3, 25, 26, 26, 100, cycles), row(3, 3, 35, 20, 40, 100, cycles),
                                     row(3, 5, 15, 20, 20, 100, cycles), row(3, 5, 15, 30, 30, 100, cycles)};
    runs[0].printed_behaviour = {"always forward", "always forward", "forward, stops, then backward"};
    runs[1].printed_behaviour = {"forward from cycle 400", "backward at cycle 1500", "backward from cycle 600"};
    runs[2].printed_behaviour = {"forward", "forward, later not", "backward"};
    runs[3].printed_behaviour = {"always forward", "mostly backward", "mostly backward"};
    for (std::size_t index = 0; index < runs.size(); ++index) {
        runs[index].name = std::vector<std::string>{"(i)", "(ii)", "(iii)", "(iv)"}[index];
    }
    return runs;
}

std::vector<Chapter5Run> quadruple_runs() {
    std::vector<Chapter5Run> runs = {
        row(4, 5, 20, 30, 30, 400, 2500), row(4, 5, 18.5, 40, 20, 400, 3000),  row(4, 7, 10.5, 20, 20, 300, 3000),
        row(4, 7, 33, 40, 40, 300, 2800), row(4, 10, 11.5, 30, 30, 700, 3100),
    };
    // Forward, backward, none, "?".
    runs[0].printed_totals = {{18, 0, 4, 0}, {7, 3, 12, 0}, {1, 8, 12, 1}, {2, 13, 7, 0}};
    runs[1].printed_totals = {{26, 0, 1, 0}, {16, 3, 8, 0}, {7, 5, 15, 0}, {1, 15, 10, 1}};
    runs[2].printed_totals = {{18, 0, 6, 0}, {10, 3, 11, 0}, {3, 9, 12, 0}, {1, 13, 10, 0}};
    runs[3].printed_totals = {{15, 0, 3, 0}, {1, 3, 13, 1}, {0, 2, 16, 0}, {0, 4, 13, 1}};
    runs[4].printed_totals = {{14, 0, 8, 0}, {4, 12, 6, 0}, {3, 5, 14, 0}, {0, 16, 6, 0}};
    for (std::size_t index = 0; index < runs.size(); ++index) {
        runs[index].name = "Table 5." + std::to_string(index + 1);
    }
    return runs;
}

Chapter5Run plane_base_run() {
    Chapter5Run made = equal_run(9, 1, 25, 30, 2000);
    made.name = "nine columns";
    made.columns.heights.clear();
    for (const double height : {1.0, 2.0, 3.0, 4.0, 5.0, 4.0, 3.0, 2.0, 1.0}) {
        made.columns.heights.push_back(height * inch);
    }
    made.settings.stop_rotation = degrees(longest_drawn);
    made.printed = PrintedOutcome::fails;
    made.printed_behaviour = {"slides",  "topples", "topples", "topples", "topples",
                              "topples", "topples", "stays",   "stays"};
    return made;
}

std::vector<Chapter5Run> stepped_base_runs() {
    std::vector<Chapter5Run> runs;
    for (const double friction : {38.0, 40.0, 42.0, 44.0, 46.0}) {
        Chapter5Run made;
        made.name = in_degrees(friction);
        for (const double height : {1.0, 2.0, 3.0, 4.0, 3.1, 2.2, 1.3, 0.4}) {
            made.columns.heights.push_back(height * inch);
        }
        made.columns.width = inch;
        made.columns.step = 0.5 * inch;
        made.columns.dip = degrees(21.8);
        made.columns.base_height = inch;
        made.columns.coordinate_unit = typed_digit;
        made.settings = settings_of(stiffness_per_width, friction, friction, long_run);
        // Columns that stand turn by less than half a degree; those that fail wedge again after some degrees.
        made.settings.failure_rotation = degrees(1);
        made.settings.stop_rotation = degrees(longest_drawn);
        made.printed = friction < 43 ? PrintedOutcome::fails : PrintedOutcome::stands;
        made.printed_behaviour = {"slides", "topples", "topples", "topples", "topples", "stays", "stays", "stays"};
        runs.push_back(made);
    }
    return runs;
}

std::vector<HockingBlock> perturbed(std::vector<HockingBlock> blocks, double unit, unsigned seed) {
    std::mt19937 random(seed);
    const auto shift = [&] { return unit * (static_cast<int>(random() % 3) - 1); };
    for (HockingBlock& block : blocks) {
        if (!block.fixed) {
            block.centroid.x() += shift();
            block.centroid.y() += shift();
        }
    }
    return blocks;
}

HockingResult run(const Chapter5Run& run) {
    return run_hocking(make_blocks(run.columns), run.settings);
}

SettledCycles settled_cycles(const HockingResult& result, std::size_t block, double tolerance) {
    SettledCycles settled;
    const Point& end = result.prints.back().blocks[block].centroid;
    for (const HockingPrint& print : result.prints) {
        const Point& centroid = print.blocks[block].centroid;
        settled.x = std::abs(centroid.x() - end.x()) > tolerance ? print.cycle : settled.x;
        settled.y = std::abs(centroid.y() - end.y()) > tolerance ? print.cycle : settled.y;
    }
    return settled;
}

double rotation_in(const Chapter5Run& run, const HockingPrint& print, std::size_t block) {
    const bool base_turned = run.settings.tilting && run.settings.tilting->part == TiltedPart::base;
    return print.blocks[block].angle - (base_turned ? print.tilt : 0);
}

std::optional<int> cycle_of_rotation(const Chapter5Run& run, const HockingResult& result, std::size_t block,
                                     double rotation) {
    for (const HockingPrint& print : result.prints) {
        if (rotation_in(run, print, block) > rotation) {
            return print.cycle;
        }
    }
    return std::nullopt;
}

double displacement_at(const HockingResult& result, std::size_t block, int cycle) {
    const Point& start = result.prints.front().blocks[block].centroid;
    double displacement = 0;
    for (const HockingPrint& print : result.prints) {
        if (print.cycle <= cycle) {
            displacement = (print.blocks[block].centroid - start).norm();
        }
    }
    return displacement;
}

std::optional<int> cycle_of_displacement(const HockingResult& result, std::size_t block, double displacement) {
    const Point& start = result.prints.front().blocks[block].centroid;
    for (const HockingPrint& print : result.prints) {
        if ((print.blocks[block].centroid - start).norm() >= displacement) {
            return print.cycle;
        }
    }
    return std::nullopt;
}

std::vector<SlidingTotals> count_sliding(const HockingResult& result, std::size_t columns, int first_print) {
    constexpr int table_interval = 100;
    std::vector<SlidingTotals> totals(columns);
    for (const HockingPrint& print : result.prints) {
        bool any = false;
        for (std::size_t column = 0; column < columns; ++column) {
            any = any || print.blocks[column].sliding != BaseSliding::none;
        }
        if (!any || print.cycle < first_print || print.cycle % table_interval != 0) {
            continue;
        }
        for (std::size_t column = 0; column < columns; ++column) {
            SlidingTotals& total = totals[column];
            switch (print.blocks[column].sliding) {
            case BaseSliding::none:
                ++total.none;
                break;
            case BaseSliding::forward:
                ++total.forward;
                break;
            case BaseSliding::backward:
                ++total.backward;
                break;
            case BaseSliding::both:
                ++total.unclear;
                break;
            }
        }
    }
    return totals;
}

std::optional<int> first_sliding(const HockingResult& result, std::size_t column, BaseSliding sense) {
    for (const HockingPrint& print : result.prints) {
        if (print.blocks[column].sliding == sense) {
            return print.cycle;
        }
    }
    return std::nullopt;
}

}  // namespace delabole
