// The runs of chapter 5 of the thesis for the re-created program, with what the thesis prints of each.
//
// What the thesis does not give is chosen here, once for all runs, so that the printed cycle counts come out: blocks of
// one inch, plaster, no overlap at the start, centroids typed to 1e-6 m, one long fixed block below plane rows, one
// fixed block below each column of the stepped base (as the listing's data has it), and one stiffness for a run,
// 2e6 N/m for each width of the columns' height; 2e6 N/m where heights differ. A base that is turned is one inch thick:
// the thicker it is, the more it pushes what stands on it.
#pragma once

#include "cases/program/thesis/hocking/columns_on_base.hpp"
#include "cases/program/thesis/imperial.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace delabole {

constexpr double plaster_density = 1400;  // kg/m3; Ashby's mix of three parts of plaster to two of water
constexpr double typed_digit = 1e-6;      // m

enum class PrintedOutcome { not_printed, stands, fails, blows_up };

constexpr std::array<std::string_view, 4> enum_names(PrintedOutcome) {
    return {"not_printed", "stands", "fails", "blows_up"};
}

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
    PrintedOutcome printed = PrintedOutcome::not_printed;
    std::optional<SettledCycles> printed_settled = {};
    std::optional<int> printed_cycle = {};            // see the function that makes the run
    std::vector<SlidingTotals> printed_totals = {};   // by column
    std::vector<std::string> printed_behaviour = {};  // by column, in the thesis's sense
    int first_print = 100;                            // between which sliding is counted
};

// 5.3.1 A: single block, a/b = 3, fixed inclination.
std::vector<Chapter5Run> fixed_inclination_runs();
// 5.3.1 B: tilted from 18 and 18.15 deg. printed_cycle: after which the rotation gained momentum.
std::vector<Chapter5Run> single_tilting_runs(TiltedPart part);
// Fig 5.5: from the horizontal, tilted at every cycle. The rate is not printed.
Chapter5Run horizontal_start_run(TiltedPart part, int cycles_per_degree);
// 5.3.2 A: two blocks, a/b = 3, friction 20 deg.
std::vector<Chapter5Run> double_fixed_runs();
// 5.3.2 B. How long they were consolidated is not printed: 2500 cycles, as for single blocks.
std::vector<Chapter5Run> double_tilting_runs(TiltedPart part);
// Fig 5.12: a/b = 3, 5, 10. Inclinations are not printed: here half a degree above that of a single block.
std::vector<Chapter5Run> slenderness_runs();
// Fig 5.13: a/b = 7. printed_cycle: 677. The inclination is not printed: 8 deg, from which the first rocking carries
// the blocks past atan(1/7) = 8.13 deg, is the one at which the re-created program blows out near that cycle.
Chapter5Run blow_out_run();
// 5.3.2, observations 1 to 4. printed_cycle: of the same displacement. The inclination of the first is not printed:
// 18.3 deg.
std::vector<Chapter5Run> stiffness_observation();
std::vector<Chapter5Run> displacement_observations();
std::vector<Chapter5Run> damping_observation();
// 5.3.3.
std::vector<Chapter5Run> triple_runs();
std::vector<Chapter5Run> quadruple_runs();
// 5.3.4.1: nine columns of 1 2 3 4 5 4 3 2 1 in at 25 deg. Heights are read off the drawing; friction is not printed:
// 30 deg.
Chapter5Run plane_base_run();
// 5.3.4.2: columns of Appendix A, friction 38 to 46 deg.
std::vector<Chapter5Run> stepped_base_runs();

// The free blocks' coordinates changed by -1, 0 or +1 units each, at random by `seed`.
std::vector<HockingBlock> perturbed(std::vector<HockingBlock> blocks, double unit, unsigned seed);

HockingResult run(const Chapter5Run& run);

// The last print edits at which x and y are not yet within `tolerance` of where they end. The thesis does not define
// its counts; 1e-8 m, a digit of the printed centroids, gives them.
SettledCycles settled_cycles(const HockingResult& result, std::size_t block, double tolerance = 1e-8);

// Rotation relative to the base, rad.
double rotation_in(const Chapter5Run& run, const HockingPrint& print, std::size_t block);

// First print at which a block has turned that far relative to its base; none where it does not.
std::optional<int> cycle_of_rotation(const Chapter5Run& run, const HockingResult& result, std::size_t block,
                                     double rotation);

// Cycle at which a block has moved that far, to a print interval; none where it does not.
std::optional<int> cycle_of_displacement(const HockingResult& result, std::size_t block, double displacement);
double displacement_at(const HockingResult& result, std::size_t block, int cycle);

// Prints from `first_print` on, every 100 cycles, as the tables have them: without those in which no block slides.
std::vector<SlidingTotals> count_sliding(const HockingResult& result, std::size_t columns, int first_print);

// First print at which a column slides that way; none where it never does.
std::optional<int> first_sliding(const HockingResult& result, std::size_t column, BaseSliding sense);

}  // namespace delabole
