// Dynamic relaxation: checks of its case for the reader.
#include "cases/program/case/model_cases.hpp"
#include "cases/program/models/relaxation/jointed_slope_case.hpp"
#include "cases/program/models/relaxation/shaking_file.hpp"
#include "cases/program/reader/names.hpp"
#include "cases/program/reader/units.hpp"
#include "dynamic_relaxation/blocks/joint_water.hpp"
#include "dynamic_relaxation/scene/bolts.hpp"
#include "dynamic_relaxation/step/scene_check.hpp"
#include "dynamic_relaxation/study/relaxation_study.hpp"
#include "dynamic_relaxation/study/strength_reduction.hpp"
#include "fitting/work/words.hpp"

#include <algorithm>

namespace delabole {
namespace {

void check_joint(Checker& checker, const std::string& key, const RelaxationJoint& joint) {
    if (joint.residual_friction_angle && *joint.residual_friction_angle > joint.friction_angle) {
        checker.complain(key + ".residual_friction_angle",
                         "must not exceed the peak, " + readable_quantity(joint.friction_angle, Dimension::angle));
    }
    if (joint.residual_cohesion && *joint.residual_cohesion > joint.cohesion.value_or(0)) {
        checker.complain(
            key + ".residual_cohesion",
            "must not exceed the cohesion, " + readable_quantity(joint.cohesion.value_or(0), Dimension::stress));
    }
    if (joint.shear_stiffness && !joint.normal_stiffness) {
        checker.complain(key + ".shear_stiffness", "needs normal_stiffness beside it");
    }
}

void check_joint_number(Checker& checker, const std::string& key, const std::optional<double>& number,
                        std::size_t count) {
    if (number && (!is_whole(*number) || *number > static_cast<double>(count))) {
        checker.complain(key, "must be the number of a [[scene.joint]], 1 to " + std::to_string(count));
    }
}

// Checks a row of blocks or columns.
void check_blocks(Checker& checker, const auto& standing) {
    if (standing.scatter) {
        check_whole(checker, "scene.scatter.seed", standing.scatter->seed);
    }
    check_joint(checker, "scene.interface", standing.interface);
    check_joint(checker, "scene.base", standing.base);
}

void check_blocks(Checker& checker, const RelaxationPolygons& polygons) {
    if (polygons.joint.empty()) {
        checker.complain("scene.joint", "is required: at least one [[scene.joint]]");
    }
    for (std::size_t index = 0; index < polygons.joint.size(); ++index) {
        check_joint(checker, indexed("scene.joint", index), polygons.joint[index]);
    }
    for (std::size_t index = 0; index < polygons.block.size(); ++index) {
        const RelaxationPolygon& block = polygons.block[index];
        const std::string key = indexed("scene.block", index);
        check_joint_number(checker, key + ".joint", block.joint, polygons.joint.size());
        if (block.vertex.size() < 3) {
            checker.complain(key + ".vertex", "needs at least three corners");
        }
        for (std::size_t vertex = 0; vertex < block.vertex.size(); ++vertex) {
            check_joint_number(checker, indexed(key + ".vertex", vertex) + ".joint", block.vertex[vertex].joint,
                               polygons.joint.size());
        }
    }
}

void check_blocks(Checker& checker, const RelaxationSlope& slope) {
    for (std::size_t index = 0; index < slope.joint.size(); ++index) {
        check_joint(checker, indexed("scene.joint", index), slope.joint[index].strength);
    }
    check_slope(checker, slope);
}

bool has_blocks(const auto& scene) {
    return !scene.block.empty();
}

// A slope makes its own blocks, or reports why it cannot.
bool has_blocks(const RelaxationSlope&) {
    return true;
}

// Complains and returns false unless the number is that of a block; only then can the caller check a property of the
// block.
bool check_block_number(Checker& checker, const std::string& key, double number, const RelaxationScene& scene) {
    if (is_whole(number) && number >= 1 && number <= static_cast<double>(scene.block.size())) {
        return true;
    }
    checker.complain(
        key, "must be the number of a block, 1 to " + std::to_string(scene.block.size()) + ", fixed ones counted last");
    return false;
}

std::size_t index_of(double number) {
    return static_cast<std::size_t>(number) - 1;
}

void check_joint_water(Checker& checker, const std::vector<WaterInJoint>& joint_water, const RelaxationScene& scene) {
    if (joint_water.empty()) {
        return;
    }
    // No bodies are made from outlines that the scene's check rejects.
    const bool drawn = check_scene(scene).check != SceneCheck::outline_not_convex;
    const Bodies bodies = drawn ? make_bodies(scene) : Bodies{};
    for (std::size_t index = 0; index < joint_water.size(); ++index) {
        const WaterInJoint& water = joint_water[index];
        const std::string key = indexed("joint_water", index);
        const bool known = check_block_number(checker, key + ".block", water.block, scene);
        if (!check_block_number(checker, key + ".other", water.other, scene) || !known) {
            continue;
        }
        if (water.block == water.other) {
            checker.complain(key + ".other", "is the block itself: water is between two");
        } else if (drawn && pressures_of({index_of(water.block), index_of(water.other), 0, 0}, bodies).empty()) {
            checker.complain(key + ".other", "shares no face with block " + std::to_string(index_of(water.block) + 1) +
                                                 " in the drawing");
        }
    }
}

void check_loads(Checker& checker, const Relaxation& model, const RelaxationScene& scene) {
    for (std::size_t index = 0; index < model.force.size(); ++index) {
        check_block_number(checker, indexed("force", index) + ".block", model.force[index].block, scene);
    }
    for (std::size_t index = 0; index < model.pressure.size(); ++index) {
        const WaterPressure& pressure = model.pressure[index];
        const std::string key = indexed("pressure", index);
        if (check_block_number(checker, key + ".block", pressure.block, scene)) {
            const std::size_t edges = scene.block[index_of(pressure.block)].outline.size();
            if (!is_whole(pressure.edge) || pressure.edge > static_cast<double>(edges)) {
                checker.complain(key + ".edge",
                                 "must be the number of a face of the block, 1 to " + std::to_string(edges));
            }
        }
    }
    const auto check_bar = [&](const std::string& key, const BoltBar& bar) {
        if (bar.pretension.value_or(0) > bar.capacity) {
            checker.complain(key + ".pretension", "must be at most the bolt's capacity");
        }
        if (bar.grout && !bar.free_length_at_joints) {
            checker.complain(key + ".grout",
                             "needs free_length_at_joints, over which the bolt stretches at each joint");
        }
    };
    for (std::size_t index = 0; index < model.bolt.size(); ++index) {
        check_bar(indexed("bolt", index), model.bolt[index].bar);
    }
    for (std::size_t index = 0; index < model.support.size(); ++index) {
        check_bar(indexed("support", index), model.support[index].bar);
        check_whole(checker, indexed("support", index) + ".rows", model.support[index].rows);
    }
    if (!model.support.empty() && !std::holds_alternative<RelaxationSlope>(model.scene)) {
        checker.complain(
            "support",
            "needs scene.kind = \"jointed_slope\", on whose face the rows begin; in other scenes each bolt "
            "is a [[bolt]] with head_x and head_y");
    }
    check_joint_water(checker, model.joint_water, scene);
    check_increasing(checker, model.shaking, &ShakingPoint::time, "shaking", "time");
    for (std::size_t index = 0; index < model.motion.size(); ++index) {
        const FixedBlockMotion& motion = model.motion[index];
        const std::string key = indexed("motion", index);
        if (check_block_number(checker, key + ".fixed_block", motion.block, scene) &&
            !scene.block[index_of(motion.block)].fixed) {
            checker.complain(key + ".fixed_block", "is free: only a fixed block moves as prescribed");
        }
        check_increasing(checker, motion.velocity, &VelocityPoint::time, key + ".velocity", "time");
        if (!motion.velocity.empty() &&
            (motion.velocity.front().horizontal != 0 || motion.velocity.front().vertical != 0)) {
            checker.complain(key + ".velocity[1]",
                             "must be 0 m/s at first: a base that jumps to a speed deals its blocks a blow");
        }
    }
    for (std::size_t index = 0; index < model.removal.size(); ++index) {
        check_block_number(checker, indexed("removal", index) + ".block", model.removal[index].block, scene);
    }
    if (model.tilting && model.tilting->turned == TiltingFrame::base && !model.motion.empty()) {
        checker.complain("tilting.turned", "turns every fixed block, so that [[motion]] cannot move one otherwise");
    }
}

void check_settings(Checker& checker, const RelaxationNumerics& settings, const RelaxationScene& scene) {
    check_whole(checker, "settings.most_steps", settings.most_steps);
    const bool ramped = settings.start == RelaxationStart::ramped;
    if (ramped != (settings.ramp_time.value_or(0) > 0)) {
        checker.complain(ramped ? "settings.start" : "settings.ramp_time",
                         "a ramped start and a ramp_time of more than 0 go together");
    }
    RelaxationSettings departure;
    departure.taken_away_below = settings.taken_away_below;
    if (const SceneFault fault = check_departure(scene, departure); fault.check != SceneCheck::valid) {
        checker.complain("settings.taken_away_below",
                         "lies above block " + std::to_string(fault.index + 1) + " before it has moved");
    }
    if (settings.watch && (settings.stop || settings.duration)) {
        checker.complain("settings.watch", "takes the place of settings.stop and settings.duration: leave those out");
    }
    if (settings.consolidation_time.value_or(0) > 0 &&
        std::ranges::none_of(scene.block, &RelaxationBlock::held_at_first)) {
        checker.complain("settings.consolidation_time", "no block has hold = \"held_at_first\"");
    }
}

void check_critical(Checker& checker, const RelaxationStudy& study, const RelaxationScene& scene) {
    if (std::ranges::none_of(scene.block, &RelaxationBlock::fixed) && !scene.belt) {
        checker.complain("critical", std::string("has no answer where no block is fixed, since all of them fall: ") +
                                         (std::holds_alternative<RelaxationSlope>(study.model.scene)
                                              ? "add [scene.frame] or a [[scene.fixed]] area"
                                              : "give one of them hold = \"fixed\""));
    }
    if (study.settings && study.settings->watch) {
        checker.complain("settings.watch", "does not go with a search, whose runs end at their verdicts");
    }
    const CriticalPlan plan = critical_plan(study);
    if (!(plan.lower < plan.upper)) {
        const std::string defaults =
            plan.is_ratio() ? " (" + number_in_words(plan.lower) + " and " + number_in_words(plan.upper) + ')' : "";
        checker.complain("critical.lower", "bounds are reversed: must be less than critical.upper" + defaults);
    }
    if (plan.path.front() == LoadingPath::stages && !has_stages(study)) {
        checker.complain("critical.path",
                         "needs stages of excavation: the case has neither [[scene.stage]] nor [[removal]]");
    }
    if (plan.path.front() == LoadingPath::consolidated && has_record_of_shaking(study)) {
        checker.complain("critical.path",
                         "a record of shaking is over before consolidated blocks are at rest: choose "
                         "preloaded, gravity, sudden or stages");
    }
    if (const auto* reduction = std::get_if<ReductionSearch>(&*study.critical)) {
        const std::vector<std::string> names = joint_names(study.model.scene);
        for (const std::string& joint : reduction->joints) {
            if (std::ranges::find(names, joint) == names.end()) {
                checker.complain("critical.joints",
                                 '"' + joint + "\" is no joint of the scene: must be " + choices(names));
            }
        }
    }
}

// Each stage of retrogression is a run of its own up to equilibrium or onset, so options of a single long run are
// refused.
void check_retrogression(Checker& checker, const RelaxationStudy& study) {
    check_whole(checker, "retrogression.most_stages", study.retrogression->most_stages);
    const auto refuse = [&](const std::string& key, bool there, const std::string& why) {
        if (there) {
            checker.complain(key, "does not go with retrogression: " + why);
        }
    };
    const RelaxationNumerics settings = study.settings.value_or(RelaxationNumerics{});
    refuse("scene.kind", !std::holds_alternative<RelaxationSlope>(study.model.scene), "only a jointed_slope retreats");
    refuse("settings.stop", settings.stop.has_value(), "each stage ends at equilibrium or at onset");
    refuse("settings.watch", settings.watch.has_value(), "each stage ends at equilibrium or at onset");
    refuse(study.model.bolt.empty() ? "support" : "bolt", !all_bolts(study.model).empty(),
           "what has lost its hold is found without bolts");
    refuse("history", study.history.has_value(), "its stages have no common time");
    refuse(study.model.removal.empty() ? "scene.stage" : "removal", has_stages(study),
           "draw the slope as it is after excavation");
}

void check_ensemble(Checker& checker, const RelaxationStudy& study) {
    check_whole(checker, "ensemble.runs", study.ensemble->runs);
    const auto* slope = std::get_if<RelaxationSlope>(&study.model.scene);
    if (slope == nullptr) {
        checker.complain("ensemble", "needs scene.kind = \"jointed_slope\", whose joints it moves");
        return;
    }
    const auto is_set = [](const SlopeCut& cut) { return std::holds_alternative<JointSetCut>(cut.trace); };
    if (std::ranges::any_of(slope->geometry.cut, is_set)) {
        return;
    }
    if (study.ensemble->spacing_deviation) {
        checker.complain("ensemble.spacing_deviation", "has no effect: no [[scene.cut]] is a joint set");
    }
    if (study.ensemble->friction_deviation.value_or(0) == 0) {
        checker.complain("ensemble",
                         "has slopes that are all the same: no [[scene.cut]] is a joint set, which it "
                         "would shift, and friction_deviation is absent or 0");
    }
}

}  // namespace

void take_files(Reading& reading, RelaxationStudy& study, const std::filesystem::path& folder,
                const std::string& prefix) {
    take_outline_file(reading, study, folder, prefix);
    take_shaking_file(reading, study, folder, prefix);
}

void check_case(Checker& checker, const RelaxationStudy& study) {
    const RelaxationScene scene = relaxation_scene(study);
    const bool any = std::visit([](const auto& kind) { return has_blocks(kind); }, study.model.scene);
    if (!any) {
        checker.complain("scene.block", "is required: at least one [[scene.block]]");
        return;
    }
    std::visit([&](const auto& kind) { check_blocks(checker, kind); }, study.model.scene);
    if (scene.block.empty()) {
        return;
    }
    check_loads(checker, study.model, scene);
    const RelaxationNumerics settings = study.settings.value_or(RelaxationNumerics{});
    check_settings(checker, settings, scene);
    if (study.critical) {
        check_critical(checker, study, scene);
    }
    if (study.retrogression) {
        check_retrogression(checker, study);
    }
    if (study.ensemble) {
        check_ensemble(checker, study);
    }
    if (study.history) {
        for (std::size_t index = 0; index < study.history->block.size(); ++index) {
            check_block_number(checker, indexed("history.block", index) + ".block", study.history->block[index].block,
                               scene);
        }
        for (std::size_t index = 0; index < study.history->contact.size(); ++index) {
            const ContactMonitor& contact = study.history->contact[index];
            const std::string key = indexed("history.contact", index);
            if (check_block_number(checker, key + ".block", contact.block, scene) &&
                check_block_number(checker, key + ".other", contact.other, scene) && contact.block == contact.other) {
                checker.complain(key + ".other", "must be another block than history.contact.block");
            }
        }
    }
}

std::vector<Quantity> possible_outputs(const RelaxationStudy& study) {
    std::vector<Quantity> outputs = outputs_of_run(study);
    for (std::size_t index = 0; index < enum_names(CriticalParameter{}).size(); ++index) {
        const auto parameter = static_cast<CriticalParameter>(index);
        if (!study.critical || parameter_of(*study.critical) != parameter) {
            outputs.push_back(
                {std::string(name_of_critical(parameter)), dimension_of(parameter), "where it is asked for"});
        }
    }
    return outputs;
}

}  // namespace delabole
