#include "cases/program/thesis/chapter_3/tilting_runs.hpp"

#include "cases/program/thesis/imperial.hpp"
#include "jointed_slope/counted_random.hpp"

#include <algorithm>
#include <cmath>

namespace delabole {

namespace {

constexpr double column_density = 1400;  // kg/m3; matters to nothing
constexpr double frame_limit = degrees(40);
constexpr double faster_rate = degrees(0.5);  // per s: the frame turns by 0.1 deg while a column begins to fall
constexpr double height_deviation = 0.005;

RelaxationStudy tilted(BlockScene scene, double to) {
    RelaxationStudy study{};
    study.model.scene = std::move(scene);
    study.model.tilting = Tilting{TiltingFrame::gravity, to, faster_rate, {}, {}, {}, {}};
    RelaxationNumerics numerics{};
    numerics.quality = RelaxationQuality::draft;
    numerics.stiffness_ratio = 1e5;  // hundreds of runs of 120 s
    numerics.stop = RelaxationStop::onset;
    numerics.duration = 120;
    study.settings = numerics;
    return study;
}

RelaxationJoint plaster(double friction) {
    RelaxationJoint joint{};
    joint.friction_angle = friction;
    return joint;
}

RelaxationRow row_of(const FrameRow& row) {
    RelaxationRow made{};
    // A column topples at atan(b / a) at the earliest, and slides only later.
    made.tilt = 0.85 * std::atan(1 / *std::ranges::max_element(row.heights));
    made.density = column_density;
    made.interface = plaster(row.friction.interface);
    made.base = plaster(row.friction.base);
    if (row.friction.deviation > 0) {
        made.scatter = RelaxationScatter{static_cast<double>(row.seed), height_deviation, row.friction.deviation};
    }
    for (const double height : row.heights) {
        made.block.push_back({inch, height * inch, {}});
    }
    return made;
}

// The outline is anticlockwise and lacks the corners.
RelaxationPolygon worn_block(double left, double bottom, double height, double wear) {
    RelaxationPolygon block{};
    block.density = column_density;
    const double right = left + 1;
    const double top = bottom + height;
    const auto add = [&](double x, double y) { block.vertex.push_back({x * inch, y * inch, {}}); };
    add(left + wear, bottom);
    add(right - wear, bottom);
    add(right, bottom + wear);
    add(right, top - wear);
    add(right - wear, top);
    add(left + wear, top);
    add(left, top - wear);
    add(left, bottom + wear);
    return block;
}

}  // namespace

std::vector<double> growing_and_falling(int count) {
    std::vector<double> heights;
    for (int column = 1; column <= count; ++column) {
        heights.push_back(std::min(column, count + 1 - column));
    }
    return heights;
}

std::optional<FrameFailure> tilt_until_failure(const FrameRow& row) {
    const RelaxationRun made = run(tilted(row_of(row), frame_limit));
    if (made.result.outcome != RelaxationOutcome::onset && made.result.outcome != RelaxationOutcome::collapse) {
        return std::nullopt;
    }
    const RelaxationAnswer answer{made.result};
    return FrameFailure{answer.tilt_of_base, answer.crack_tilt(), static_cast<std::size_t>(answer.crack_block())};
}

std::optional<double> critical_tilt(const WornColumn& column) {
    RelaxationPolygons scene{};
    const int pieces = column.cubes ? column.height : 1;
    const double height = static_cast<double>(column.height) / pieces;
    scene.tilt = 0.6 * std::atan(1.0 / column.height);
    scene.joint = {plaster(degrees(36))};
    double left = 0;
    for (int piece = 0; piece < pieces; ++piece) {
        scene.block.push_back(worn_block(left, piece * height, height, column.wear));
        left += column.offset * (2 * counted_uniform(column.seed, 1, piece) - 1);
    }
    RelaxationPolygon base{};
    base.density = column_density;
    base.hold = BlockHold::fixed;
    for (const auto& [x, y] : {std::pair{-4.0, -1.0}, {5.0, -1.0}, {5.0, 0.0}, {-4.0, 0.0}}) {
        base.vertex.push_back({x * inch, y * inch, {}});
    }
    scene.block.push_back(std::move(base));
    const RelaxationRun made = run(tilted(std::move(scene), frame_limit));
    return made.result.outcome == RelaxationOutcome::onset ? std::optional(made.result.tilt) : std::nullopt;
}

RelaxationRun tilt_all_the_way(const FrameRow& row) {
    RelaxationStudy study = tilted(row_of(row), frame_limit);
    study.settings->stop = RelaxationStop::collapse;
    study.settings->collapse_rotation = degrees(80);
    study.settings->collapse_displacement = 5;
    StudyWork work;
    work.frames = KeepFrames::yes;
    return run(study, work);
}

}  // namespace delabole
