// Columns on a stepped base: checks of their case for the reader.
#include "cases/program/case/model_cases.hpp"
#include "cases/program/models/stepped_base/bound.hpp"
#include "cases/program/reader/units.hpp"
#include "limit_equilibrium/stepped_base/stepped_base_study.hpp"

#include <array>
#include <cmath>
#include <utility>
#include <variant>

namespace delabole {
namespace {

void check_layout(Checker& checker, const ColumnLayout<>& layout) {
    if (const auto* blocks = std::get_if<BlockColumns<>>(&layout)) {
        if (blocks->block.empty()) {
            checker.complain("columns", "needs at least one [[columns.block]]");
        }
        return;
    }
    std::visit(
        [&](const auto& cut) {
            if constexpr (requires { cut.base_inclination; }) {
                // The sum is compared as in the model, because the difference of the angles may be only a rounding
                // error.
                if (cut.base_inclination + cut.joint_dip < degrees(90) - 1e-9) {
                    checker.complain("columns.joint_dip",
                                     "cannot topple on this base: bases normal to the joints dip " +
                                         readable_quantity(degrees(90) - cut.joint_dip, Dimension::angle) +
                                         ", more than columns.base_inclination, so that the base would step downwards");
                }
            }
        },
        layout);
}

template <class Load>
void check_blocks(Checker& checker, const ColumnScene<>& scene, const std::vector<Load>& loads,
                  const std::string& list) {
    const auto* blocks = std::get_if<BlockColumns<>>(&scene.columns);
    for (std::size_t index = 0; index < loads.size(); ++index) {
        const double block = loads[index].block;
        const std::string key = indexed(list, index) + ".block";
        if (block != std::floor(block)) {
            checker.complain(key, "must be a whole number, 1 at the toe");
        } else if (blocks != nullptr && !blocks->block.empty() && block > static_cast<double>(blocks->block.size())) {
            checker.complain(key, "there are only " + std::to_string(blocks->block.size()) + " blocks");
        }
    }
}

void check_scene(Checker& checker, const ColumnScene<>& scene) {
    const auto* blocks = std::get_if<BlockColumns<>>(&scene.columns);
    check_layout(checker, scene.columns);
    if (blocks == nullptr && !scene.slope) {
        checker.complain("columns.kind", "cuts the columns out of a slope, so [slope] is required");
    }
    check_water_level(checker, scene.water, scene.slope && scene.slope->toe_elevation);
    if (const auto* line = std::get_if<PiezometricLineWater<>>(&scene.water)) {
        if (line->point.size() < 2) {
            checker.complain("water", "needs at least two [[water.point]]");
        }
        check_increasing(checker, line->point, &PiezometricPoint<>::x, "water.point", "x");
    }
    check_surcharges(checker, scene.surcharge);
    check_blocks(checker, scene, scene.point_load, "point_load");
    check_blocks(checker, scene, scene.bolt, "bolt");
    for (std::size_t index = 0; index < scene.support.size(); ++index) {
        if (!scene.slope) {
            checker.complain(indexed("support", index), "has its heads on the face, so [slope] is required");
        } else {
            check_support(checker, indexed("support", index), scene.support[index], scene.slope->height);
        }
    }
    if (scene.slide_head) {
        const bool ends = std::visit(
            [](const auto& layout) {
                if constexpr (requires { layout.base_end_height; }) {
                    return layout.base_end_height.has_value();
                } else {
                    return false;
                }
            },
            scene.columns);
        if (!ends) {
            checker.complain("slide_head", "rises from the end of the base, so columns.base_end_height is required");
        }
    }
}

// Columns cut by cross joints may carry nothing but their weight.
void check_bound(Checker& checker, const LinearProgrammingBound& bound, const ColumnScene<>& scene) {
    if (!bound.cross_joints) {
        return;
    }
    const std::string key = "linear_programming_bound.cross_joints";
    if (!(bound.cross_joints->stagger < bound.cross_joints->spacing)) {
        checker.complain(key + ".stagger", "must be less than the spacing of the cross joints");
    }
    const std::array<std::pair<std::string_view, bool>, 8> loads{
        {{"[water]", !std::holds_alternative<Dry>(scene.water)},
         {"[seismic]", scene.seismic.has_value()},
         {"[[surcharge]]", !scene.surcharge.empty()},
         {"[[line_load]]", !scene.line_load.empty()},
         {"[[point_load]]", !scene.point_load.empty()},
         {"[[bolt]]", !scene.bolt.empty()},
         {"[[support]]", !scene.support.empty()},
         {"[slide_head]", scene.slide_head.has_value()}}};
    for (const auto& [section, given] : loads) {
        if (given) {
            checker.complain(
                key, "cuts columns that carry nothing but their own weight, but the case has " + std::string(section));
        }
    }
}

}  // namespace

void check_case(Checker& checker, const SteppedBaseStudy<>& study) {
    check_scene(checker, study.model.scene);
    if (study.critical) {
        const CriticalBaseSearch<>& search = *study.critical;
        if (std::holds_alternative<BlockColumns<>>(study.model.scene.columns)) {
            checker.complain("critical", "needs columns cut out of a slope: columns.kind = \"continuous\"");
        }
        check_bounds(checker, "critical", "inclination", search.lower_inclination, search.upper_inclination);
        check_bounds(checker, "critical", "end_height", search.lower_end_height, search.upper_end_height);
    }
    check_required(checker, study.required, study);
    check_blocks(checker, study.model.scene, study.required_cable, "required_cable");
    if (study.linear_programming_bound) {
        check_bound(checker, *study.linear_programming_bound, study.model.scene);
    }
}

std::vector<Quantity> possible_outputs(const SteppedBaseStudy<>&) {
    SteppedBaseStudy<> with_datum{};
    with_datum.model.scene.slope.emplace().toe_elevation = 0;
    std::vector<Quantity> outputs = model_interface(with_datum).outputs;
    for (const std::string_view part : {bound_prefix, bound_of_blocks_prefix}) {
        for (Quantity quantity : outputs_of(BoundResult{})) {
            quantity.name = std::string(part) + "." + quantity.name;
            outputs.push_back(quantity);
        }
    }
    return outputs;
}

}  // namespace delabole
