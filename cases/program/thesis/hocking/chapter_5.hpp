// The runs of chapter 5 of the thesis for the re-created program, with what the thesis prints of each.
//
// What the thesis does not give is chosen here, once for all runs, so that the printed cycle counts come out: blocks of
// one inch, plaster, no overlap at the start, centroids typed to 1e-6 m, one long fixed block below plane rows, one
// fixed block below each column of the stepped base (as the listing's data has it), and one stiffness for a run,
// 2e6 N/m for each width of the columns' height; 2e6 N/m where heights differ. A base that is turned is 1.1 inches
// thick: the thicker it is, the more it pushes what stands on it, and from that thickness the printed outcomes come.
#pragma once

#include "cases/program/thesis/hocking/hocking_program.hpp"
#include "cases/program/thesis/imperial.hpp"

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace delabole {

// The base of columns that are made into blocks for the program. The listing's data has one fixed block below each
// column.
enum class HockingBase {
    block_below_each,  // corners of base blocks and of columns meet: contacts at the base are double
    one_block,         // of the whole row's length; needs a plane base
};

struct HockingColumns {
    std::vector<double> heights = {};  // m, from the toe uphill
    double width = 0;                  // m
    double gap = 0;                    // m, between columns; negative: they start with that overlap
    double step = 0;                   // m, from each base to the next, normal to the base
    double dip = 0;                    // rad, of the bases
    HockingBase base = HockingBase::block_below_each;
    double base_height = 0;      // m, of the fixed blocks
    int downhill_bases = 0;      // fixed blocks (one_block: widths) in front of the first column
    int uphill_bases = 0;        // and behind the last
    double coordinate_unit = 0;  // m, to which coordinates of centroids are rounded, as where they are typed; 0: exact
};

// Columns come first, from the toe uphill, then the fixed blocks in the same order. The origin is the toe of the first
// column; blocks touch exactly, except for rounding and the gap.
std::vector<HockingBlock> make_blocks(const HockingColumns& columns);

constexpr double plaster_density = 1400;  // kg/m3; Ashby's mix of three parts of plaster to two of water
constexpr double typed_digit = 1e-6;      // m

// Cycles at which x and y of a centroid came to rest.
struct SettledCycles {
    int x = 0;
    int y = 0;
};

// Print edits in which a block slides on its base, one row of Tables 5.1 to 5.5.
struct SlidingTotals {
    int forward = 0;
    int backward = 0;
    int none = 0;
    int unclear = 0;  // printed "?"; computed: both ways at once
};

struct Chapter5Run {
    std::string name = {};  // "18.15 deg"
    HockingColumns columns = {};
    HockingSettings settings = {};
    HockingOutcome printed = HockingOutcome::undecided;
    std::optional<SettledCycles> printed_settled = {};
    std::optional<int> printed_cycle = {};            // see the table
    std::vector<SlidingTotals> printed_totals = {};   // by column
    std::vector<std::string> printed_behaviour = {};  // by column, in the thesis's sense
    int first_print = 100;                            // from which sliding is counted
};

// Returns the runs of a group of cases/thesis/chapter_5/runs.csv, whose comments explain the groups. In tilted runs
// `tilted` turns.
std::vector<Chapter5Run> chapter_5_runs(std::string_view group, TiltedPart tilted = TiltedPart::gravity);

// Shifts each coordinate of the free blocks at random, by `seed`, by -1, 0 or +1 units.
std::vector<HockingBlock> perturbed(std::vector<HockingBlock> blocks, double unit, unsigned seed);

// Returns the first print at which something holds; nothing if it never does.
std::optional<int> first_cycle(const HockingResult& result, const std::function<bool(const HockingPrint&)>& holds);

// Returns the last print edits at which x and y of the first block are not yet within 1e-8 m of their final values. The
// thesis does not define its counts; that tolerance, a digit of the printed centroids, reproduces them.
SettledCycles settled_cycles(const HockingResult& result);

// Rotation relative to the base, rad.
double rotation_in(const Chapter5Run& run, const HockingPrint& print, std::size_t block);

// Returns the first print at which the first block has turned that far relative to its base.
std::optional<int> cycle_of_rotation(const Chapter5Run& run, const HockingResult& result, double rotation);
// First print at which a column slides that way.
std::optional<int> first_sliding(const HockingResult& result, std::size_t column, BaseSliding sense);

// Prints from `first_print` on, every 100 cycles, as the tables have them: without those in which no block slides.
std::vector<SlidingTotals> count_sliding(const HockingResult& result, std::size_t columns, int first_print);

}  // namespace delabole
