#include "cases/program/thesis/hocking/chapter_5.hpp"

#include "cases/program/thesis/appendix_a.hpp"
#include "cases/program/thesis/thesis_tables.hpp"
#include "parameters/fields.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <span>
#include <sstream>

namespace delabole {

namespace {

Point turned(double along, double normal, double dip) {
    return {along * std::cos(dip) - normal * std::sin(dip), along * std::sin(dip) + normal * std::cos(dip)};
}

HockingBlock block_at(double along, double normal, double width, double height, double dip) {
    HockingBlock block;
    block.width = width;
    block.height = height;
    block.dip = dip;
    block.centroid = turned(along + width / 2, normal + height / 2, dip);
    return block;
}

}  // namespace

std::vector<HockingBlock> make_blocks(const HockingColumns& columns) {
    const auto count = static_cast<int>(columns.heights.size());
    std::vector<HockingBlock> blocks;
    const auto within = [&](int column) { return column >= 0 && column < count ? column : no_block; };
    for (int column = 0; column < count; ++column) {
        HockingBlock block = block_at(column * (columns.width + columns.gap), column * columns.step, columns.width,
                                      columns.heights[static_cast<std::size_t>(column)], columns.dip);
        block.neighbours.downhill = within(column - 1);
        block.neighbours.uphill = within(column + 1);
        blocks.push_back(block);
    }
    const int bases =
        columns.base == HockingBase::one_block ? 1 : columns.downhill_bases + count + columns.uphill_bases;
    for (int number = 0; number < bases; ++number) {
        const int column = number - columns.downhill_bases;
        const bool one = columns.base == HockingBase::one_block;
        const double width = columns.width * (one ? columns.downhill_bases + count + columns.uphill_bases : 1);
        HockingBlock block = block_at(column * columns.width, column * columns.step - columns.base_height, width,
                                      columns.base_height, columns.dip);
        block.fixed = true;
        const int index = count + number;
        if (one) {
            for (int above = 0; above < count; ++above) {
                blocks[static_cast<std::size_t>(above)].neighbours.below = index;
            }
        } else {
            block.neighbours.above = within(column);
            block.neighbours.above_downhill = within(column - 1);
            block.neighbours.above_uphill = within(column + 1);
            const auto stand_on = [&](int above, int HockingNeighbours::*place) {
                if (within(above) != no_block) {
                    blocks[static_cast<std::size_t>(above)].neighbours.*place = index;
                }
            };
            stand_on(column, &HockingNeighbours::below);
            stand_on(column + 1, &HockingNeighbours::below_downhill);
            stand_on(column - 1, &HockingNeighbours::below_uphill);
        }
        blocks.push_back(block);
    }
    if (columns.coordinate_unit > 0) {
        for (HockingBlock& block : blocks) {
            block.centroid = (block.centroid / columns.coordinate_unit).array().round() * columns.coordinate_unit;
        }
    }
    return blocks;
}

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
    // This speed is a hundredth of what six printed digits can show over the thousands of cycles of a run.
    settings.settled_speed = 1e-6;
    // A fallen column lands with some tens of its weight; a change of face gives some ten thousand times the weight.
    settings.blow_out_force = 1e3;
    return settings;
}

// A row of cases/thesis/chapter_5/runs.csv, whose comments say what stands where.
struct PrintedRun {
    std::string group;
    std::string name;
    std::optional<double> blocks;
    std::optional<double> slenderness;  // height over width
    std::string heights;                // in
    double inclination_degrees;
    double joints_degrees;
    double bases_degrees;
    std::optional<double> stiffness;
    std::optional<double> time_step;
    std::optional<double> damping;
    double cycles;
    std::optional<double> tilted_to_degrees;
    std::optional<double> tilt_begins;  // cycle
    std::optional<double> tilt_every;   // cycles between increments of 0.001 deg
    std::optional<double> first_print;
    std::optional<double> stop_rotation_degrees;
    HockingOutcome outcome;
    std::optional<double> settled_x;  // cycle at which x came to rest
    std::optional<double> settled_y;
    std::optional<double> printed_cycle;
    std::string behaviour;
    std::string totals;
    static constexpr std::string_view file = "thesis/chapter_5/runs.csv";
    static constexpr auto fields() {
        using R = PrintedRun;
        constexpr Interval angles = within(0, 90);
        return joined(
            table_columns<&R::group, &R::name, &R::heights, &R::outcome, &R::behaviour, &R::totals>(),
            table_columns<&R::blocks, &R::cycles, &R::tilt_every, &R::first_print>(at_least(1)),
            table_columns<&R::slenderness, &R::stiffness, &R::stop_rotation_degrees>(more_than(0)),
            table_columns<&R::inclination_degrees, &R::joints_degrees, &R::bases_degrees, &R::tilted_to_degrees>(
                angles),
            table_columns<&R::time_step>(Dimension::time, more_than(0)),
            table_columns<&R::damping, &R::tilt_begins, &R::settled_x, &R::settled_y, &R::printed_cycle>(at_least(0)));
    }
};

std::vector<std::string> parts_of(const std::string& list) {
    std::vector<std::string> parts;
    std::istringstream text(list);
    for (std::string part; std::getline(text >> std::ws, part, ';');) {
        parts.push_back(part);
    }
    return parts;
}

std::vector<SlidingTotals> totals_of(const std::string& list) {
    std::vector<SlidingTotals> totals;
    for (const std::string& part : parts_of(list)) {
        SlidingTotals& total = totals.emplace_back();
        std::istringstream(part) >> total.forward >> total.backward >> total.none >> total.unclear;
    }
    return totals;
}

std::optional<int> whole(const std::optional<double>& number) {
    return number ? std::optional(static_cast<int>(*number)) : std::nullopt;
}

// Makes the columns of Appendix A, with an inch in place of a metre.
HockingColumns stepped_columns(double inclination) {
    const BlockColumns<> columns = appendix_a_columns();
    HockingColumns made;
    for (const ColumnBlock<>& block : columns.block) {
        made.heights.push_back(block.height * inch);
    }
    made.width = columns.block.front().width * inch;
    made.step = columns.block.front().step_above * inch;
    made.dip = degrees(inclination);
    made.base_height = inch;
    made.coordinate_unit = typed_digit;
    return made;
}

HockingColumns columns_of(const PrintedRun& row) {
    if (!row.blocks && row.heights.empty()) {
        return stepped_columns(row.inclination_degrees);
    }
    HockingColumns columns =
        equal_columns(static_cast<int>(row.blocks.value_or(0)), row.slenderness.value_or(1), row.inclination_degrees);
    std::istringstream heights(row.heights);
    for (double height = 0; heights >> height;) {
        columns.heights.push_back(height * inch);
    }
    return columns;
}

Chapter5Run run_of(const PrintedRun& row, TiltedPart tilted) {
    Chapter5Run made;
    made.name = row.name;
    made.columns = columns_of(row);
    HockingSettings& settings = made.settings;
    settings = settings_of(row.stiffness.value_or(stiffness_per_width * row.slenderness.value_or(1)),
                           row.joints_degrees, row.bases_degrees, static_cast<int>(row.cycles));
    settings.time_step = row.time_step.value_or(settings.time_step);
    settings.damping = row.damping.value_or(settings.damping);
    if (row.stop_rotation_degrees) {
        settings.stop_rotation = degrees(*row.stop_rotation_degrees);
    }
    if (made.columns.step > 0) {
        // Columns that stand turn by less than half a degree; those that fail wedge again after some degrees.
        settings.failure_rotation = degrees(1);
    }
    if (row.outcome == HockingOutcome::blows_out) {
        made.columns.coordinate_unit = typed_digit / 10;
        settings.cycles_after_blow_out = 12;
    }
    if (row.tilted_to_degrees) {
        made.columns.base_height = tilted == TiltedPart::base ? 1.1 * inch : made.columns.base_height;
        // The tilt is 0.1 deg in 1000 cycles if it grows every 10 cycles, in 2000 if every 20.
        settings.tilting = HockingTilting{tilted, whole(row.tilt_begins).value_or(0), whole(row.tilt_every).value_or(1),
                                          degrees(1e-3), degrees(*row.tilted_to_degrees - row.inclination_degrees)};
    }
    made.printed = row.outcome;
    if (row.settled_x && row.settled_y) {
        made.printed_settled = SettledCycles{static_cast<int>(*row.settled_x), static_cast<int>(*row.settled_y)};
    }
    made.printed_cycle = whole(row.printed_cycle);
    made.printed_behaviour = parts_of(row.behaviour);
    made.printed_totals = totals_of(row.totals);
    made.first_print = whole(row.first_print).value_or(made.first_print);
    return made;
}

}  // namespace

std::vector<Chapter5Run> chapter_5_runs(std::string_view group, TiltedPart tilted) {
    static const std::vector<PrintedRun> rows = rows_of<PrintedRun>();
    std::vector<Chapter5Run> runs;
    for (const PrintedRun& row : rows) {
        if (row.group == group) {
            runs.push_back(run_of(row, tilted));
        }
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

std::optional<int> first_cycle(const HockingResult& result, const std::function<bool(const HockingPrint&)>& holds) {
    const auto found = std::ranges::find_if(result.prints, holds);
    return found == result.prints.end() ? std::nullopt : std::optional(found->cycle);
}

SettledCycles settled_cycles(const HockingResult& result) {
    constexpr double tolerance = 1e-8;  // m
    SettledCycles settled;
    const Point& end = result.prints.back().blocks.front().centroid;
    for (const HockingPrint& print : result.prints) {
        const Point& centroid = print.blocks.front().centroid;
        settled.x = std::abs(centroid.x() - end.x()) > tolerance ? print.cycle : settled.x;
        settled.y = std::abs(centroid.y() - end.y()) > tolerance ? print.cycle : settled.y;
    }
    return settled;
}

double rotation_in(const Chapter5Run& run, const HockingPrint& print, std::size_t block) {
    const bool base_turned = run.settings.tilting && run.settings.tilting->part == TiltedPart::base;
    return print.blocks[block].angle - (base_turned ? print.tilt : 0);
}

std::optional<int> cycle_of_rotation(const Chapter5Run& run, const HockingResult& result, double rotation) {
    return first_cycle(result, [&](const HockingPrint& print) { return rotation_in(run, print, 0) > rotation; });
}

std::optional<int> first_sliding(const HockingResult& result, std::size_t column, BaseSliding sense) {
    return first_cycle(result, [&](const HockingPrint& print) { return print.blocks[column].sliding == sense; });
}

std::vector<SlidingTotals> count_sliding(const HockingResult& result, std::size_t columns, int first_print) {
    constexpr int table_interval = 100;
    constexpr std::array total_of{&SlidingTotals::none, &SlidingTotals::forward, &SlidingTotals::backward,
                                  &SlidingTotals::unclear};  // by BaseSliding
    std::vector<SlidingTotals> totals(columns);
    for (const HockingPrint& print : result.prints) {
        const std::span<const HockingBlockState> blocks(print.blocks.data(), columns);
        const auto slides = [](const HockingBlockState& block) { return block.sliding != BaseSliding::none; };
        if (std::ranges::any_of(blocks, slides) && print.cycle >= first_print && print.cycle % table_interval == 0) {
            for (std::size_t column = 0; column < columns; ++column) {
                ++(totals[column].*total_of[static_cast<std::size_t>(blocks[column].sliding)]);
            }
        }
    }
    return totals;
}

}  // namespace delabole
