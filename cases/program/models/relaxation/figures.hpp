// Figures and tables of a run of dynamic relaxation, and of the section of a slope cut by joints.
#pragma once

#include "cases/program/results/analysis.hpp"
#include "cases/program/results/result_folder.hpp"
#include "dynamic_relaxation/scene/slope_scene.hpp"
#include "dynamic_relaxation/study/relaxation_study.hpp"
#include "plots/report/report.hpp"

#include <cmath>
#include <string>

namespace delabole {

// Rotates points from the scene's frame, in which gravity is tilted, to one with gravity downwards.
class Upright {
  public:
    explicit Upright(double tilt) : cosine_(std::cos(tilt)), sine_(std::sin(tilt)) {}

    Point operator()(const PlanePoint<>& point) const {
        return {cosine_ * point.x() - sine_ * point.y(), sine_ * point.x() + cosine_ * point.y()};
    }

  private:
    double cosine_;
    double sine_;
};

inline constexpr std::size_t most_drawn_blocks = 2500;

// The label of a block in a figure: its number, counted from 1, or F if it is fixed.
inline std::string label_of(std::size_t block, bool fixed) {
    return fixed ? "F" : std::to_string(block + 1);
}

// A length in metres or, below one metre, in millimetres (feet or inches); a rounding error is shown as 0.
std::string length_in_words(double length);

// An angle in degrees, for a column whose title names the unit; 0 if it is too small to be seen.
std::string degrees_in_words(double angle);

// Blocks at the start and at the end, velocities, contact forces, and the table of blocks; nothing without a run.
void append_block_figures(const RelaxationRun& made, const Sheet& sheet);

// Blocks at the end of the run at the nearest value that fails; those that have begun to move are marked.
void append_failure_figure(const RelaxationRun& failed, const std::string& title, const std::string& name,
                           const Sheet& sheet);

// The end of a run: how each block has moved, the velocities, and what has broken.
Figure mechanism_figure(const RelaxationRun& made, const std::string& title);

// Warns of cuts that divided nothing, of intact rock that had to be divided and of joints along each other.
// `materials`: those of the slope's joints.
void append_cutting_warnings(const RelaxationSlope& slope, const SlopeScene& made,
                             const std::vector<JointMaterial>& materials, const std::optional<CriticalPlan>& plan,
                             Analysis& analysis);

// Figure of the blocks shaded by rock with the water table, and the table of cuts.
void append_section_figure(const RelaxationSlope& slope, const SlopeScene& made, const Sheet& sheet);

// Cracks, crest and the ground left standing of a jointed slope as figure, tables and *.csv; nothing for other scenes.
void append_post_failure(const RelaxationSlope* slope, const RelaxationRun& made, const Sheet& sheet);
// The blocks at their positions in a frame; those that fail in the end are marked.
Figure moved_slope_figure(const RelaxationRun& made, const MotionFrame& frame, const PostFailure& end,
                          const std::string& title);
// The blocks in the initial geometry, those that have failed marked, with the ground left standing.
Figure left_standing_figure(const RelaxationRun& made, const PostFailure& failure, const std::string& title);

// history.csv, movements.csv and their figures; nothing if the run kept no history.
void append_history(const HistoryRequest& request, const RelaxationRun& made, const Sheet& sheet);

// Tension of the bolts over time, from the history or otherwise from the frames; nothing without bolts.
void append_bolt_forces(const RelaxationRun& made, const Sheet& sheet);

// The moving blocks, in the report and as frames/ for ParaView; nothing if the run kept no frames.
void append_frames(const RelaxationRun& made, const Sheet& sheet);

}  // namespace delabole
