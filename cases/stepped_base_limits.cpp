// What is impossible about columns on a stepped base, and which value is to blame.
#include "cases/model_reports.hpp"
#include "limit_equilibrium/stepped_base_study.hpp"

namespace delabole {

namespace {

std::string_view in_words(ColumnCheck check) {
    switch (check) {
    case ColumnCheck::base_flatter_than_joints_allow:
        return "the base would step downwards: columns.base_inclination must be at least 90 deg - columns.joint_dip";
    case ColumnCheck::base_does_not_daylight:
        return "the base is as steep as the face or steeper: columns.base_inclination must be less than slope.face_dip";
    case ColumnCheck::base_never_surfaces:
        return "the ground behind the crest is as steep as the base, so the base never meets it: give "
               "columns.base_end_height";
    case ColumnCheck::base_end_outside_slope:
        return "the base would end above the ground: columns.base_end_height is too large";
    case ColumnCheck::joints_never_surface:
        return "part of the ground falls away as steeply as the joints, so that they do not reach it";
    case ColumnCheck::step_larger_than_block:
        return "a step is higher than the block below it";
    case ColumnCheck::no_columns:
        return "nothing lies between base and ground";
    case ColumnCheck::too_many_columns:
        return "gives more than 1 000 000 columns: columns.spacing is too small";
    case ColumnCheck::slide_head_needs_base_end:
        return "the wedge rises from the end of the base, inside the slope: columns.base_end_height is required";
    case ColumnCheck::head_joint_never_surfaces:
        return "the ground above the wedge is as steep as its joint, which never meets it";
    case ColumnCheck::load_outside_columns:
        return "a load or bolt names a column that does not exist, or lies above its top";
    case ColumnCheck::load_needs_slope:
        return "loads on the ground and levels as a ratio or an elevation need [slope]";
    case ColumnCheck::bench_needs_continuous:
        return "flat-topped columns know no bench: columns.kind = \"continuous\" does";
    case ColumnCheck::elevation_without_datum:
        return "an elevation is given, so slope.toe_elevation is needed";
    case ColumnCheck::water_points_not_increasing:
        return "the points of the piezometric line must increase, two at least";
    case ColumnCheck::slope_needed:
        return "columns cut out of a slope need [slope]";
    case ColumnCheck::input_out_of_range:
        return "a number is outside its allowed range";
    case ColumnCheck::valid:
        break;
    }
    return "";
}

ColumnCheck check_of(std::string_view failure) {
    return value_of<ColumnCheck>(failure).value_or(ColumnCheck::valid);
}

}  // namespace

std::vector<std::string> blamed_keys(const SteppedBaseStudy<>& study, std::string_view failure) {
    std::vector<std::string> blocks;
    switch (check_of(failure)) {
    case ColumnCheck::base_flatter_than_joints_allow:
    case ColumnCheck::base_does_not_daylight:
    case ColumnCheck::base_never_surfaces:
        return {"columns.base_inclination"};
    case ColumnCheck::base_end_outside_slope:
        return {"columns.base_end_height"};
    case ColumnCheck::joints_never_surface:
        return {"slope.upper_surface_dip", "columns.joint_dip"};
    case ColumnCheck::step_larger_than_block: {
        const auto* given = std::get_if<BlockColumns<>>(&study.model.scene.columns);
        for (std::size_t index = 0; given != nullptr && index < given->block.size(); ++index) {
            if (given->block[index].step_above > given->block[index].height) {
                blocks.push_back("columns.block[" + std::to_string(index + 1) + "].step_above");
            }
        }
        blocks.emplace_back("columns.base_inclination");
        return blocks;
    }
    case ColumnCheck::no_columns:
        return {"columns.base_inclination", "columns.spacing"};
    case ColumnCheck::too_many_columns:
        return {"columns.spacing", "columns.block"};
    case ColumnCheck::slide_head_needs_base_end:
        return {"slide_head.joint_dip"};
    case ColumnCheck::head_joint_never_surfaces:
        return {"slide_head.joint_dip"};
    case ColumnCheck::load_outside_columns: {
        for (std::size_t index = 0; index < study.model.scene.bolt.size(); ++index) {
            blocks.push_back("bolt[" + std::to_string(index + 1) + "].block");
        }
        for (std::size_t index = 0; index < study.model.scene.point_load.size(); ++index) {
            blocks.push_back("point_load[" + std::to_string(index + 1) + "].block");
        }
        return blocks;
    }
    case ColumnCheck::load_needs_slope:
        return {"water.kind", "columns.kind"};
    case ColumnCheck::bench_needs_continuous:
    case ColumnCheck::slope_needed:
        return {"columns.kind"};
    case ColumnCheck::elevation_without_datum:
        return {"water.water_elevation"};
    case ColumnCheck::water_points_not_increasing:
        return {"water.point"};
    case ColumnCheck::input_out_of_range:
    case ColumnCheck::valid:
        break;
    }
    return {};
}

std::string explain_failure(const SteppedBaseStudy<>&, std::string_view failure, const std::string&) {
    return std::string(in_words(check_of(failure)));
}

}  // namespace delabole
