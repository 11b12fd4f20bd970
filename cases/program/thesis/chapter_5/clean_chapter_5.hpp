// The thesis's runs of chapter 5 computed by the clean engine: same blocks, stiffness at corners, share of critical
// damping, time step and cycles as the re-created program, so that the histories of both can be set side by side.
//
// Three things differ: coordinates are exact, not typed; the time step is divided where it is more than a stable share;
// tilting turns gravity in increments, or the base smoothly at the same rate. There is no local damping, as in the
// thesis's program.
#pragma once

#include "cases/program/thesis/hocking/chapter_5.hpp"
#include "dynamic_relaxation/scene/scene.hpp"
#include "dynamic_relaxation/scene/settings.hpp"

#include <array>
#include <vector>

namespace delabole {

struct CleanRun {
    // `settled`: nothing moves at the end; `failed`: the run's rotation was exceeded; `blown_out`: a contact force
    // exceeded its limit or the engine stopped by itself. A block slides at a print edit if its base has slipped in the
    // cycle before it.
    HockingResult history = {};
    double energy_error = 0;   // residual of the energy balance over its turnover
    double largest_speed = 0;  // m/s, of any corner of a free block, all run long
};

// Makes the blocks as they are meant: blocks and bases touch exactly.
std::vector<HockingBlock> exact_blocks(const Chapter5Run& run);

// The geometry is along the base, and gravity is tilted. `blocks` are those of make_blocks, with the dip of the run.
RelaxationScene clean_scene(const Chapter5Run& run, const std::vector<HockingBlock>& blocks);
RelaxationSettings clean_settings(const Chapter5Run& run, RelaxationStart start);

CleanRun run_clean(const Chapter5Run& run, const std::vector<HockingBlock>& blocks, RelaxationStart start);

// A run is computed by the re-created program, or by the clean engine: with its blocks dropped onto their springs, as
// in the thesis, or from a consolidated start.
enum class Engine { recreated, dropped, preloaded };

inline constexpr std::array engines{Engine::recreated, Engine::dropped, Engine::preloaded};

HockingResult compute(const Chapter5Run& run, Engine engine, const std::vector<HockingBlock>& blocks);
// The re-created program begins at typed coordinates, the clean engine at exact ones.
HockingResult compute(const Chapter5Run& run, Engine engine);
// Computes so many starts, with the free blocks' typed coordinates shifted at random by a unit. Throws Interrupted once
// the flag of cases/program/terminal/interrupt.hpp is set.
std::vector<HockingResult> compute_shifted(const Chapter5Run& run, Engine engine, double unit, int starts);

}  // namespace delabole
