// Tells what is impossible about columns on a stepped base, and which value is to blame.
#include "cases/program/reader/units.hpp"
#include "cases/program/results/model_reports.hpp"
#include "limit_equilibrium/columns/base_profile.hpp"
#include "limit_equilibrium/stepped_base/stepped_base_study.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace delabole {

namespace {

// The first load or bolt that finds no place, and the limit that it breaks.
struct Misplaced {
    std::string key;
    std::string explanation;
};

double highest_point(const ColumnScene<>& scene, const ColumnSlope<>& slope, std::size_t index) {
    const Column<>& column = slope.columns[index];
    double highest = 0;
    const std::vector<Polyline> outlines = column_outlines(scene);
    for (const Point& point : outlines[index]) {
        highest = std::max(highest, point.y() * std::cos(slope.base_dip) - point.x() * std::sin(slope.base_dip));
    }
    return highest - column.base_v;
}

void put_on(ColumnScene<>& scene, const PointLoad<>& load) {
    scene.point_load = {load};
}
void put_on(ColumnScene<>& scene, const ColumnBolt<>& bolt) {
    scene.bolt = {bolt};
}
// The force is what is asked for.
void put_on(ColumnScene<>& scene, const RequiredCable<>& cable) {
    scene.bolt = {{cable.block, 0, cable.plunge, cable.height}};
}

template <class Load>
std::optional<Misplaced> first_misplaced(const ColumnScene<>& bare, const ColumnSlope<>& slope, const std::string& list,
                                         const std::vector<Load>& loads) {
    for (std::size_t index = 0; index < loads.size(); ++index) {
        const Load& load = loads[index];
        ColumnScene<> scene = bare;
        put_on(scene, load);
        if (make_columns(scene).check != ColumnCheck::load_outside_columns) {
            continue;
        }
        const std::string key = list + "[" + std::to_string(index + 1) + "]";
        const auto count = static_cast<double>(slope.columns.size());
        if (load.block > count || load.block != std::floor(load.block)) {
            return Misplaced{key + ".block", "there are only " + std::to_string(slope.columns.size()) + " columns"};
        }
        const auto number = static_cast<std::size_t>(load.block);
        return Misplaced{key + ".height",
                         "lies above the top of column " + std::to_string(number) + ", which is " +
                             readable_quantity(highest_point(bare, slope, number - 1), Dimension::length) + " high"};
    }
    return std::nullopt;
}

std::optional<Misplaced> first_misplaced(const SteppedBaseStudy<>& study) {
    const ColumnScene<>& given = study.model.scene;
    SteppedBaseStudy<> unloaded = study;
    unloaded.model.scene.point_load.clear();
    unloaded.model.scene.bolt.clear();
    const ColumnScene<> bare = resolve(unloaded).problem.scene;
    const ColumnSlope<> slope = make_columns(bare);
    if (slope.check != ColumnCheck::valid) {
        return std::nullopt;
    }
    if (auto load = first_misplaced(bare, slope, "point_load", given.point_load)) {
        return load;
    }
    if (auto bolt = first_misplaced(bare, slope, "bolt", given.bolt)) {
        return bolt;
    }
    return first_misplaced(bare, slope, "required_cable", study.required_cable);
}

// Steps that are higher than the block below them.
std::vector<std::string> keys_of_high_steps(const SteppedBaseStudy<>& study) {
    std::vector<std::string> keys;
    const auto* given = std::get_if<BlockColumns<>>(&study.model.scene.columns);
    for (std::size_t index = 0; given != nullptr && index < given->block.size(); ++index) {
        if (given->block[index].step_above > given->block[index].height) {
            keys.push_back("columns.block[" + std::to_string(index + 1) + "].step_above");
        }
    }
    keys.emplace_back("columns.base_inclination");
    return keys;
}

}  // namespace

Impossibility impossibility(const SteppedBaseStudy<>& study, std::string_view failure) {
    switch (value_of<ColumnCheck>(failure).value_or(ColumnCheck::valid)) {
    case ColumnCheck::base_flatter_than_joints_allow:
        return {{"columns.base_inclination"},
                "the base would step downwards: columns.base_inclination must be at least 90 deg - columns.joint_dip"};
    case ColumnCheck::base_does_not_daylight:
        return {
            {"columns.base_inclination"},
            "the base is as steep as the face or steeper: columns.base_inclination must be less than slope.face_dip"};
    case ColumnCheck::base_never_surfaces:
        return {{"columns.base_inclination"},
                "the ground behind the crest is as steep as the base, so the base never meets it: give "
                "columns.base_end_height"};
    case ColumnCheck::base_end_outside_slope:
        return {{"columns.base_end_height"},
                "the base would end above the ground: columns.base_end_height is too large"};
    case ColumnCheck::joints_never_surface:
        return {{"slope.upper_surface_dip", "columns.joint_dip"},
                "part of the ground falls away as steeply as the joints, so that they do not reach it"};
    case ColumnCheck::step_larger_than_block:
        return {keys_of_high_steps(study), "a step is higher than the block below it"};
    case ColumnCheck::no_columns:
        return {{"columns.base_inclination", "columns.spacing"}, "nothing lies between base and ground"};
    case ColumnCheck::too_many_columns:
        return {{"columns.spacing", "columns.block"},
                "gives more than 1 000 000 columns: columns.spacing is too small"};
    case ColumnCheck::slide_head_needs_base_end:
        return {{"slide_head.joint_dip"},
                "the wedge rises from the end of the base, inside the slope: columns.base_end_height is required"};
    case ColumnCheck::head_joint_never_surfaces:
        return {{"slide_head.joint_dip"}, "the ground above the wedge is as steep as its joint, which never meets it"};
    case ColumnCheck::load_outside_columns:
        if (const auto misplaced = first_misplaced(study)) {
            return {{misplaced->key}, misplaced->explanation};
        }
        return {{}, "a load or bolt names a column that does not exist, or lies above its top"};
    case ColumnCheck::load_needs_slope:
        return {{"water.kind", "columns.kind"},
                "loads on the ground and levels as a ratio or an elevation need [slope]"};
    case ColumnCheck::bench_needs_continuous:
        return {{"columns.kind"}, "flat-topped columns know no bench: columns.kind = \"continuous\" does"};
    case ColumnCheck::elevation_without_datum:
        return {{"water.water_elevation"}, "an elevation is given, so slope.toe_elevation is needed"};
    case ColumnCheck::water_points_not_increasing:
        return {{"water.point"}, "the points of the piezometric line must increase, two at least"};
    case ColumnCheck::slope_needed:
        return {{"columns.kind"}, "columns cut out of a slope need [slope]"};
    case ColumnCheck::input_out_of_range:
    case ColumnCheck::valid:
        break;
    }
    return out_of_range();
}

}  // namespace delabole
