#include "cases/program/live/handles.hpp"

#include "cases/program/results/analysis.hpp"
#include "dynamic_relaxation/study/relaxation_study.hpp"
#include "kinematics/stereonet.hpp"
#include "limit_equilibrium/block_row/block_row.hpp"
#include "plane_failure/water_diagram.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <string_view>

namespace delabole {

namespace {

// The first of these inputs that the model has.
std::vector<std::string> first_of(const std::vector<Quantity>& inputs, std::initializer_list<std::string_view> names) {
    for (const std::string_view name : names) {
        if (find_quantity(inputs, name) != nullptr) {
            return {std::string(name)};
        }
    }
    return {};
}

std::vector<std::string> joined(std::vector<std::string> first, const std::vector<std::string>& second) {
    first.insert(first.end(), second.begin(), second.end());
    return first;
}

void add(std::vector<Handle>& handles, std::string name, std::vector<std::string> inputs, const Point& at) {
    if (!inputs.empty() && at.allFinite()) {
        handles.push_back({std::move(name), std::move(inputs), at});
    }
}

// Adds the far end of a line that begins at `from` and rises at the dip, plus `turned`, towards +x.
void add_spoke(const std::vector<Quantity>& inputs, std::vector<Handle>& handles, const std::string& name,
               const std::string& input, const Point& from, double length, double turned = 0) {
    if (const Quantity* dip = find_quantity(inputs, input)) {
        const double angle = dip->value + turned;
        add(handles, name, {input}, from + length * Point(std::cos(angle), std::sin(angle)));
        handles.back().from = from;
    }
}

// Adds two handles for each pattern: the lowest head, which stays on the face, and the end of its bolt.
template <class Support>
void add_support(const SlopeSection<>& slope, const std::vector<Support>& support, std::vector<Handle>& handles) {
    for (std::size_t index = 0; index < support.size(); ++index) {
        const BoltPattern<>& pattern = [&]() -> const BoltPattern<>& {
            if constexpr (requires { support[index].pattern; }) {
                return support[index].pattern;
            } else {
                return support[index];
            }
        }();
        const std::string key = "support[" + std::to_string(index + 1) + "].";
        const Point head(pattern.lowest_height / std::tan(slope.face_dip),
                         pattern.lowest_height + slope.toe_elevation.value_or(0));
        add(handles, "lowest bolt of support " + std::to_string(index + 1), {key + "lowest_height"}, head);
        add(handles, "its end, support " + std::to_string(index + 1), {key + "length", key + "plunge"},
            head + pattern.length * Point(std::cos(pattern.plunge), -std::sin(pattern.plunge)));
    }
}

// Returns the level in m above the toe; nothing if the water has no level. Depths and ratios count from `bottom`.
std::optional<double> level_of(const std::vector<Quantity>& inputs, double bottom, double top, double toe_elevation) {
    if (const Quantity* depth = find_quantity(inputs, "water.water_depth")) {
        return bottom + depth->value;
    }
    if (const Quantity* elevation = find_quantity(inputs, "water.water_elevation")) {
        return elevation->value - toe_elevation;
    }
    if (const Quantity* ratio = find_quantity(inputs, "water.filled_ratio")) {
        return bottom + ratio->value * (top - bottom);
    }
    return std::nullopt;
}

double toe_of(const SlopeSection<>& slope) {
    return slope.toe_elevation.value_or(0);
}

void add_slope(const SlopeSection<>& slope, std::vector<Handle>& handles) {
    const Point up(0, toe_of(slope));
    const Point crest(slope.height / std::tan(slope.face_dip), slope.height);
    if (slope.toe_elevation) {
        add(handles, "toe", {"slope.toe_elevation"}, up);
    } else {
        add(handles, "toe", {"slope.height", "slope.face_dip"}, up);
        handles.back().is_origin = true;
    }
    add(handles, "crest", {"slope.height", "slope.face_dip"}, crest + up);
    if (slope.bench) {
        add(handles, "end of the bench", {"slope.bench.width", "slope.bench.dip"},
            crest + slope.bench->width * Point(1, std::tan(slope.bench->dip)) + up);
    }
}

void add_handles(const PlaneFailureStudy<>& study, const std::vector<Quantity>& inputs, std::vector<Handle>& handles) {
    const PlaneFailure<>& slope = study.model;
    const Point up(0, toe_of(slope.slope));
    add_slope(slope.slope, handles);
    add_support(slope.slope, slope.support, handles);
    const WaterDiagram water = water_diagram(slope);
    if (water.base.surface.empty()) {
        return;
    }
    add(handles, "failure plane", {"failure_plane.dip"},
        (water.base.surface.front() + water.base.surface.back()) / 2 + up);
    add(handles, "where the plane daylights", first_of(inputs, {"failure_plane.daylight_height"}),
        water.base.surface.front() + up);
    if (!water.crack.surface.empty()) {
        add(handles, "tension crack",
            joined(first_of(inputs, {"tension_crack.distance_behind_crest", "tension_crack.depth",
                                     "tension_crack.base_below_crest", "tension_crack.base_elevation"}),
                   first_of(inputs, {"tension_crack.dip"})),
            water.crack.surface.back() + up);
    }
    const Point bottom = water.crack.surface.empty() ? water.base.surface.back() : water.crack.surface.front();
    const Point top = water.crack.surface.empty() ? bottom : water.crack.surface.back();
    const std::optional<double> level = level_of(inputs, bottom.y(), top.y(), toe_of(slope.slope));
    if (level && top.y() > bottom.y()) {
        const Point along = (top - bottom) / (top.y() - bottom.y());
        add(handles, "water level",
            first_of(inputs, {"water.water_depth", "water.water_elevation", "water.filled_ratio"}),
            bottom + (*level - bottom.y()) * along + up);
    }
}

// Adds the uphill top corner of each block of a row, which changes its width and height; the row leans by `dip`.
template <class Blocks>
void add_row(const Blocks& blocks, const std::string& key, double dip, const std::string& dip_input, double toe,
             std::vector<Handle>& handles) {
    const Point along(std::cos(dip), std::sin(dip));
    const Point across(-std::sin(dip), std::cos(dip));
    double u = 0;
    double v = 0;
    for (std::size_t index = 0; index < blocks.size(); ++index) {
        const std::string name = key + "[" + std::to_string(index + 1) + "]";
        u += blocks[index].width;
        add(handles, name, {name + ".width", name + ".height"},
            u * along + (v + blocks[index].height) * across + Point(0, toe));
        if constexpr (requires { blocks[index].step_above; }) {
            v += blocks[index].step_above;
        }
    }
    if (!dip_input.empty()) {
        add(handles, "base", {dip_input}, 1.05 * u * along + Point(0, toe));
    }
}

void add_handles(const SteppedBaseStudy<>& study, const std::vector<Quantity>& inputs, std::vector<Handle>& handles) {
    if (const auto* blocks = std::get_if<BlockColumns<>>(&study.model.scene.columns)) {
        const double toe = study.model.scene.slope ? toe_of(*study.model.scene.slope) : 0;
        add_row(blocks->block, "columns.block", degrees(90) - blocks->joint_dip, "columns.joint_dip", toe, handles);
    }
    if (!study.model.scene.slope) {
        return;
    }
    const SlopeSection<>& slope = *study.model.scene.slope;
    add_slope(slope, handles);
    add_support(slope, study.model.scene.support, handles);
    if (const Quantity* inclination = find_quantity(inputs, "columns.base_inclination")) {
        const Point toe(0, toe_of(slope));
        const Point along(std::cos(inclination->value), std::sin(inclination->value));
        add_spoke(inputs, handles, "base", inclination->name, toe, slope.height);
        // Joints rise out of the slope.
        const Quantity& dip = *find_quantity(inputs, "columns.joint_dip");
        const Point foot = toe + slope.height / 2 * along;
        add(handles, "joints", {dip.name},
            foot + 0.3 * slope.height * Point(-std::cos(dip.value), std::sin(dip.value)));
        handles.back().from = foot;
    }
    if (const std::optional<double> level = level_of(inputs, 0, slope.height, toe_of(slope))) {
        add(handles, "water level",
            first_of(inputs, {"water.water_depth", "water.water_elevation", "water.filled_ratio"}),
            Point(0, *level + toe_of(slope)));
    }
}

// Dips are positive out of the slope. The lines of steep sets are drawn behind the crest.
void add_handles(const SteppedPath& path, const std::vector<Quantity>& inputs, std::vector<Handle>& handles) {
    const SlopeSection<>& slope = path.slope;
    add_slope(slope, handles);
    const Point toe(0, toe_of(slope));
    const Point behind = toe + slope.height * Point(1 / std::tan(slope.face_dip) + 0.3, 0.6);
    const double length = 0.3 * slope.height;
    add_spoke(inputs, handles, "steps", "steps.dip", toe, 2 * length);
    add_spoke(inputs, handles, "risers", "risers.dip", behind, length);
    add_spoke(inputs, handles, "columns", "columns.dip", behind, length, degrees(180));
}

void add_handles(const SingleBlock& problem, const std::vector<Quantity>&, std::vector<Handle>& handles) {
    const double inclination = problem.base.inclination;
    const Point along(std::cos(inclination), std::sin(inclination));
    const Point up(-along.y(), along.x());
    add(handles, "corner", {"block.width", "block.height"}, problem.block.width * along + problem.block.height * up);
    add(handles, "base", {"base.inclination"},
        (problem.block.width + 0.5 * std::max(problem.block.width, problem.block.height)) * along);
}

// The handles are the poles on the net of the figure.
void add_handles(const KinematicsStudy& study, const std::vector<Quantity>&, std::vector<Handle>& handles) {
    constexpr NetProjection projection = NetProjection::equal_area;
    const Kinematics& model = study.model;
    add(handles, "face", {"slope.face_dip", "slope.face_dip_direction"},
        projected_pole({model.slope.face_dip, model.slope.face_dip_direction}, projection));
    add(handles, "friction circle", {"strength.friction_angle"},
        projected_line({degrees(90) - model.strength.friction_angle, 0}, projection));
    for (std::size_t index = 0; index < model.joint_set.size(); ++index) {
        const JointSet& set = model.joint_set[index];
        if (!std::holds_alternative<OrientationRange>(set.orientation)) {
            const std::string key = "joint_set[" + std::to_string(index + 1) + "]." +
                                    (std::holds_alternative<PoleWindow>(set.orientation) ? "window_" : "");
            add(handles, set.name, {key + "dip", key + "dip_direction"},
                projected_pole(mean_orientation(set), projection));
        }
    }
}

void add_handles(const FlexuralSlope& slope, const std::vector<Quantity>&, std::vector<Handle>& handles) {
    add_row(slope.column, "column", slope.base_dip, "base_dip", 0, handles);
}

// The row is drawn at the tilt at which its governing mode begins, whatever the inclination of its base.
void add_handles(const BlockRow& row, const std::vector<Quantity>&, std::vector<Handle>& handles) {
    const BlockRowResult result = analyse(row);
    if (result.check == BlockRowCheck::valid && !result.block.empty()) {
        add_row(row.block, "block", result.answer.critical_tilt, "", 0, handles);
    }
}

// The handle of each joint set is on a spoke from the middle of the section, inclined at the dip of the set.
void add_sets(const RelaxationSlope& slope, const std::vector<Quantity>& inputs, std::vector<Handle>& handles) {
    Eigen::AlignedBox2d box;
    for (const SectionPoint& corner : slope.geometry.outline) {
        box.extend(Point(corner.x, corner.y));
    }
    if (box.isEmpty()) {
        return;
    }
    constexpr double spoke = 0.3;
    const double length = spoke * box.sizes().minCoeff();
    for (std::size_t index = 0; index < slope.geometry.cut.size(); ++index) {
        const std::string key = "scene.cut[" + std::to_string(index + 1) + "].trace";
        const Quantity* dip = find_quantity(inputs, key + ".dip");
        const Quantity* spacing = find_quantity(inputs, key + ".spacing");
        if (dip != nullptr && spacing != nullptr) {
            add_spoke(inputs, handles, "joint set " + slope.geometry.cut[index].name, key + ".dip", box.center(),
                      length);
        }
    }
}

void add_handles(const RelaxationStudy& study, const std::vector<Quantity>& inputs, std::vector<Handle>& handles) {
    if (const auto* slope = std::get_if<RelaxationSlope>(&study.model.scene)) {
        add_sets(*slope, inputs, handles);
    } else if (const auto* row = std::get_if<RelaxationRow>(&study.model.scene)) {
        add_row(row->block, "scene.block", 0, "", 0, handles);
    }
    for (std::size_t index = 0; index < study.model.bolt.size(); ++index) {
        const std::string key = "bolt[" + std::to_string(index + 1) + "]";
        const auto& bolt = study.model.bolt[index];
        const Point head(bolt.head_x, bolt.head_y);
        add(handles, "head of " + key, {key + ".head_x", key + ".head_y"}, head);
        add(handles, "end of " + key, {key + ".length", key + ".plunge"},
            head + bolt.bar.length * Point(std::cos(bolt.bar.plunge), -std::sin(bolt.bar.plunge)));
    }
}

template <class Study>
void add_handles(const Study&, const std::vector<Quantity>&, std::vector<Handle>&) {}

void add_points(const std::vector<Quantity>& inputs, std::vector<Handle>& handles) {
    std::map<std::string, double, std::less<>> height;
    for (const Quantity& input : inputs) {
        if (input.dimension == Dimension::length && input.name.ends_with(".y")) {
            height.emplace(input.name.substr(0, input.name.size() - 2), input.value);
        }
    }
    for (const Quantity& input : inputs) {
        if (input.dimension == Dimension::length && input.name.ends_with(".x")) {
            const std::string name = input.name.substr(0, input.name.size() - 2);
            const auto y = height.find(name);
            if (y != height.end()) {
                add(handles, name, {name + ".x", name + ".y"}, {input.value, y->second});
            }
        }
    }
}

// Positions are measured from the toe: if it moves, the crest stays, and height and dip of the face change.
std::vector<Condition> with_toe_at(const Point& to, const std::vector<Quantity>& inputs) {
    const Quantity& height = *find_quantity(inputs, "slope.height");
    const Quantity& dip = *find_quantity(inputs, "slope.face_dip");
    const Point crest(height.value / std::tan(dip.value), height.value);
    const Point face = crest - to;
    const double new_dip = std::atan2(face.y(), face.x());
    const bool possible = height.range.contains(face.y()) && dip.range.contains(new_dip);
    return {{height.name, possible ? face.y() : height.value}, {dip.name, possible ? new_dip : dip.value}};
}

const Handle& named(const std::vector<Handle>& handles, const std::string& name) {
    const auto found = std::ranges::find(handles, name, &Handle::name);
    if (found == handles.end()) {
        throw std::invalid_argument("the section has no handle '" + name + "'");
    }
    return *found;
}

}  // namespace

std::vector<Handle> handles_of(const CaseModel& model) {
    const std::vector<Quantity> inputs = named_inputs(model);
    std::vector<Handle> handles;
    std::visit([&](const auto& study) { add_handles(study, inputs, handles); }, model);
    add_points(inputs, handles);
    return handles;
}

std::vector<Condition> dragged(const CaseModel& model, const std::string& name, const Point& to) {
    const std::vector<Quantity> inputs = named_inputs(model);
    std::vector<Condition> values;
    std::vector<const Quantity*> quantities;
    const std::vector<Handle> before = handles_of(model);
    const Handle& handle = named(before, name);
    if (handle.is_origin) {
        return with_toe_at(to, inputs);
    }
    for (const std::string& input : handle.inputs) {
        quantities.push_back(find_quantity(inputs, input));
        values.push_back({input, quantities.back()->value});
    }
    // Returns nothing if the slope is impossible with these values.
    const auto place = [&](const std::vector<Condition>& at) -> std::optional<Point> {
        for (std::size_t index = 0; index < at.size(); ++index) {
            if (!quantities[index]->range.contains(at[index].value)) {
                return std::nullopt;
            }
        }
        const std::vector<Handle> handles = handles_of(with_conditions(model, at));
        const auto found = std::ranges::find(handles, name, &Handle::name);
        return found == handles.end() ? std::nullopt : std::optional(found->at);
    };
    constexpr int most_steps = 12;
    constexpr double shortest = 1.0 / 32;  // of the change
    constexpr double share = 1e-6;         // steps for differences, as shares of the input or of its unit
    std::optional<Point> here = place(values);
    for (int step = 0; here && step < most_steps; ++step) {
        Eigen::MatrixXd slope = Eigen::MatrixXd::Zero(2, static_cast<Eigen::Index>(values.size()));
        for (std::size_t index = 0; index < values.size(); ++index) {
            std::vector<Condition> other = values;
            const double change = share * std::max(1.0, std::abs(values[index].value));
            for (const double by : {change, -change}) {
                other[index].value = values[index].value + by;
                if (const std::optional<Point> there = place(other)) {
                    slope.col(static_cast<Eigen::Index>(index)) = (*there - *here) / by;
                    break;
                }
            }
        }
        // The shortest change; the small term gives one where the point moves along a line only.
        Eigen::Matrix2d square = slope * slope.transpose();
        if (!(square.trace() > 0)) {
            break;  // nothing moves the point
        }
        square.diagonal().array() += 1e-8 * square.trace();
        const Eigen::VectorXd move = slope.transpose() * (square.inverse() * (to - *here));
        const double distance = (to - *here).norm();
        bool nearer = false;
        for (double length = 1; length >= shortest && !nearer; length /= 2) {
            std::vector<Condition> next = values;
            for (std::size_t index = 0; index < values.size(); ++index) {
                next[index].value += length * move[static_cast<Eigen::Index>(index)];
                if (next[index].input.ends_with("dip_direction")) {  // an azimuth goes on beyond north
                    next[index].value = wrapped_azimuth(next[index].value);
                }
            }
            const std::optional<Point> there = place(next);
            if (there && (to - *there).norm() < distance) {
                nearer = true;
                values = next;
                here = there;
            }
        }
        if (!nearer) {
            break;
        }
    }
    return values;
}

}  // namespace delabole
