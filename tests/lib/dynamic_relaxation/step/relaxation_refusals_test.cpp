// Dynamic relaxation refuses impossible scenes, and names what is wrong and where.
#include "dynamic_relaxation/step/scene_check.hpp"
#include "tests/lib/dynamic_relaxation/relaxation_scenes.hpp"

#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <limits>
#include <string>

namespace delabole {
namespace {

using namespace relaxation_scenes;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

std::string word(SceneCheck check) {
    return std::string(enum_names(check)[static_cast<std::size_t>(check)]);
}

SceneFault fault_of(const RelaxationScene& scene, const RelaxationSettings& settings = {}) {
    const RelaxationResult result = relax(scene, settings);
    EXPECT_EQ(result.outcome == RelaxationOutcome::scene_not_valid, result.fault.check != SceneCheck::valid);
    return result.fault;
}

void expect_refused(const RelaxationScene& scene, SceneCheck check, std::size_t index, const std::string& what) {
    const SceneFault fault = fault_of(scene);
    EXPECT_EQ(word(fault.check), word(check)) << what;
    EXPECT_EQ(fault.index, index) << what;
}

// A valid scene with everything in it.
RelaxationScene full_scene() {
    RelaxationScene scene = scene_of(OnPlane{});
    scene.block.push_back({rectangle(1, 0, 1, 1), density, false, true, {0, 0, 0, 0}});
    scene.force = {{0, {0.5, 0.5}, {1, 1}}};
    scene.pressure = {{0, 0, 10, 20}};
    scene.shaking = {{0, {0, 0}}, {0.1, {0.1, 0}}, {0.2, {0, 0}}};
    PrescribedMotion motion{1, {{0, {0, 0}}, {0.1, {1e-3, 0}}, {0.2, {0, 0}}}};
    motion.angular_velocity = 1e-3;
    motion.duration = 0.1;
    scene.motion = {motion};
    scene.removal = {{2, 0.5}};
    return scene;
}

TEST(Refusals, TheFullSceneItselfRuns) {
    EXPECT_EQ(word(fault_of(full_scene()).check), "valid");
}

TEST(Refusals, NumbersThatAreNone) {
    using Spoil = std::function<void(RelaxationScene&, double)>;
    const std::vector<std::pair<std::string, Spoil>> places{
        {"corner x", [](RelaxationScene& scene, double bad) { scene.block[0].outline[2].x() = bad; }},
        {"corner y", [](RelaxationScene& scene, double bad) { scene.block[1].outline[0].y() = bad; }},
        {"density", [](RelaxationScene& scene, double bad) { scene.block[0].density = bad; }},
        {"normal stiffness", [](RelaxationScene& scene, double bad) { scene.material[0].normal_stiffness = bad; }},
        {"shear stiffness", [](RelaxationScene& scene, double bad) { scene.material[0].shear_stiffness = bad; }},
        {"friction", [](RelaxationScene& scene, double bad) { scene.material[0].friction_angle = bad; }},
        {"residual", [](RelaxationScene& scene, double bad) { scene.material[0].residual_friction_angle = bad; }},
        {"cohesion", [](RelaxationScene& scene, double bad) { scene.material[0].cohesion = bad; }},
        {"tension", [](RelaxationScene& scene, double bad) { scene.material[0].tensile_strength = bad; }},
        {"gravity", [](RelaxationScene& scene, double bad) { scene.gravity.acceleration = bad; }},
        {"tilt", [](RelaxationScene& scene, double bad) { scene.gravity.tilt = bad; }},
        {"final tilt", [](RelaxationScene& scene, double bad) { scene.gravity.final_tilt = bad; }},
        {"rate", [](RelaxationScene& scene, double bad) { scene.gravity.rate = bad; }},
        {"interval", [](RelaxationScene& scene, double bad) { scene.gravity.interval = bad; }},
        {"start", [](RelaxationScene& scene, double bad) { scene.gravity.start = bad; }},
        {"force", [](RelaxationScene& scene, double bad) { scene.force[0].force.x() = bad; }},
        {"place of force", [](RelaxationScene& scene, double bad) { scene.force[0].at.y() = bad; }},
        {"pressure", [](RelaxationScene& scene, double bad) { scene.pressure[0].at_first = bad; }},
        {"other pressure", [](RelaxationScene& scene, double bad) { scene.pressure[0].at_second = bad; }},
        {"shaking", [](RelaxationScene& scene, double bad) { scene.shaking[1].value.x() = bad; }},
        {"time of shaking", [](RelaxationScene& scene, double bad) { scene.shaking[2].time = bad; }},
        {"velocity", [](RelaxationScene& scene, double bad) { scene.motion[0].velocity[1].value.y() = bad; }},
        {"time of velocity", [](RelaxationScene& scene, double bad) { scene.motion[0].velocity[1].time = bad; }},
        {"spin", [](RelaxationScene& scene, double bad) { scene.motion[0].angular_velocity = bad; }},
        {"pivot", [](RelaxationScene& scene, double bad) { scene.motion[0].pivot.x() = bad; }},
        {"start of motion", [](RelaxationScene& scene, double bad) { scene.motion[0].start = bad; }},
        {"duration of motion", [](RelaxationScene& scene, double bad) { scene.motion[0].duration = bad; }},
        {"removal", [](RelaxationScene& scene, double bad) { scene.removal[0].time = bad; }},
    };
    for (const auto& [what, spoil] : places) {
        for (const double bad : {nan, infinity, -infinity}) {
            RelaxationScene scene = full_scene();
            spoil(scene, bad);
            EXPECT_EQ(word(fault_of(scene).check), "number_not_finite") << what << " " << bad;
        }
    }
}

TEST(Refusals, PartsThatAreNotOfTheirEdge) {
    const auto check_of = [](const EdgePart& part) {
        RelaxationScene scene = full_scene();
        scene.pressure[0].part = part;
        return word(fault_of(scene).check);
    };
    EXPECT_EQ(check_of({0, 1}), "valid");
    EXPECT_EQ(check_of({0.25, 0.5}), "valid");
    for (const EdgePart& part : {EdgePart{-0.1, 1}, EdgePart{0, 1.1}, EdgePart{0.5, 0.5}, EdgePart{0.5, 0.25}}) {
        EXPECT_EQ(check_of(part), "load_out_of_range") << part.begin << " to " << part.end;
    }
    EXPECT_EQ(check_of({nan, 1}), "number_not_finite");
    EXPECT_EQ(check_of({0, infinity}), "number_not_finite");
}

TEST(Refusals, UnknownBlocksEdgesAndMaterials) {
    const auto spoilt = [](const std::function<void(RelaxationScene&)>& spoil) {
        RelaxationScene scene = full_scene();
        spoil(scene);
        return scene;
    };
    const std::size_t nowhere = static_cast<std::size_t>(-1);
    for (const std::size_t bad : {std::size_t{3}, nowhere}) {
        expect_refused(spoilt([&](RelaxationScene& scene) { scene.force[0].block = bad; }), SceneCheck::unknown_block,
                       0, "force");
        expect_refused(spoilt([&](RelaxationScene& scene) { scene.pressure[0].block = bad; }),
                       SceneCheck::unknown_block, 0, "pressure");
        expect_refused(spoilt([&](RelaxationScene& scene) { scene.motion[0].block = bad; }), SceneCheck::unknown_block,
                       0, "motion");
        expect_refused(spoilt([&](RelaxationScene& scene) { scene.removal[0].block = bad; }), SceneCheck::unknown_block,
                       0, "removal");
        expect_refused(spoilt([&](RelaxationScene& scene) { scene.pressure[0].edge = bad + 1 == 0 ? bad : 4; }),
                       SceneCheck::unknown_edge, 0, "edge");
        expect_refused(spoilt([&](RelaxationScene& scene) { scene.block[2].joint[1] = bad; }),
                       SceneCheck::unknown_material, 2, "material");
    }
    expect_refused(spoilt([](RelaxationScene& scene) { scene.block[2].joint.pop_back(); }), SceneCheck::unknown_edge, 2,
                   "an edge without material");
    expect_refused(spoilt([](RelaxationScene& scene) { scene.material.clear(); }), SceneCheck::unknown_material, 0,
                   "no material");
    expect_refused(spoilt([](RelaxationScene& scene) { scene.motion[0].block = 0; }), SceneCheck::motion_of_free_block,
                   0, "motion of a free block");
    expect_refused(spoilt([](RelaxationScene& scene) { scene.shaking[1].time = 0; }), SceneCheck::times_not_increasing,
                   0, "two shakings at once");
    expect_refused(spoilt([](RelaxationScene& scene) { scene.motion[0].velocity[2].time = 0.05; }),
                   SceneCheck::times_not_increasing, 0, "velocity back in time");
    RelaxationScene nothing_free = full_scene();
    nothing_free.block[0].fixed = nothing_free.block[2].fixed = true;
    expect_refused(nothing_free, SceneCheck::no_free_block, 0, "all fixed");
    RelaxationScene all_gone = full_scene();
    all_gone.removal = {{0, 0.5}, {2, -1}};
    expect_refused(all_gone, SceneCheck::no_block_left, 0, "all taken away");
    RelaxationScene empty;
    empty.material = {joint(1e8, 0.5)};
    expect_refused(empty, SceneCheck::no_free_block, 0, "no block");
}

TEST(Refusals, Outlines) {
    const std::vector<std::pair<std::string, Polygon<>>> not_convex{
        {"no corner", {}},
        {"two corners", {{0, 0}, {1, 0}}},
        {"clockwise", {{0, 0}, {0, 1}, {1, 1}, {1, 0}}},
        {"bow tie", {{0, 0}, {1, 0}, {0, 1}, {1, 1}}},
        {"bow tie with area", {{0, 0}, {2, 0}, {0.5, 1}, {1, 1}}},
        {"dart", {{0, 0}, {1, 0.2}, {2, 0}, {1, 2}}},
        {"line", {{0, 0}, {1, 0}, {2, 0}}},
        {"pentagram", {{0, 1}, {-0.588, -0.809}, {0.951, 0.309}, {-0.951, 0.309}, {0.588, -0.809}}},
        {"there and back", {{0, 0}, {1, 0}, {1, 1}, {0.5, 1}, {0.75, 1}, {0, 1}}},
        {"twice round", {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}, {1, 0}, {1, 1}, {0, 1}}},
    };
    for (const auto& [what, outline] : not_convex) {
        RelaxationScene scene = scene_of(OnPlane{});
        scene.block.push_back({outline, density});
        expect_refused(scene, SceneCheck::outline_not_convex, 2, what);
    }
    RelaxationScene repeated = scene_of(OnPlane{});
    repeated.block[0].outline.push_back(repeated.block[0].outline.front());
    expect_refused(repeated, SceneCheck::edge_too_short, 0, "first corner repeated");
    RelaxationScene tiny = scene_of(OnPlane{});
    tiny.block[0].outline = {{0, 0}, {1, 0}, {1, 1 - 1e-7}, {1 - 1e-7, 1}, {0, 1}};
    expect_refused(tiny, SceneCheck::edge_too_short, 0, "an edge of 1e-7");
}

TEST(Refusals, MaterialsOutOfRange) {
    const auto with = [](const std::function<void(JointMaterial&)>& change) {
        RelaxationScene scene = scene_of(OnPlane{});
        change(scene.material[0]);
        return scene;
    };
    expect_refused(with([](JointMaterial& one) { one.normal_stiffness = 0; }), SceneCheck::stiffness_not_positive, 0,
                   "zero stiffness");
    expect_refused(with([](JointMaterial& one) { one.shear_stiffness = 0; }), SceneCheck::stiffness_not_positive, 0,
                   "zero shear stiffness");
    expect_refused(with([](JointMaterial& one) { one.normal_stiffness = -1; }), SceneCheck::stiffness_not_positive, 0,
                   "negative stiffness");
    expect_refused(with([](JointMaterial& one) { one.friction_angle = degrees(90); }),
                   SceneCheck::friction_out_of_range, 0, "90 deg");
    expect_refused(with([](JointMaterial& one) { one.friction_angle = -0.1; }), SceneCheck::friction_out_of_range, 0,
                   "negative friction");
    expect_refused(with([](JointMaterial& one) { one.residual_friction_angle = degrees(31); }),
                   SceneCheck::friction_out_of_range, 0, "residual above the peak");
    expect_refused(with([](JointMaterial& one) { one.cohesion = -1; }), SceneCheck::strength_negative, 0, "cohesion");
    expect_refused(with([](JointMaterial& one) { one.residual_cohesion = 1; }), SceneCheck::strength_negative, 0,
                   "residual cohesion without cohesion");
    expect_refused(with([](JointMaterial& one) { one.tensile_strength = -1; }), SceneCheck::strength_negative, 0,
                   "tensile strength");
    for (const double bad : {0.0, -1.0}) {
        RelaxationScene scene = scene_of(OnPlane{});
        scene.block[0].density = bad;
        expect_refused(scene, SceneCheck::density_not_positive, 0, "density");
    }
    OnPlane soft;
    soft.stiffness_ratio = 1;
    expect_refused(scene_of(soft), SceneCheck::stiffness_too_soft, 0, "k b/W = 1");
    soft.stiffness_ratio = 1e14;
    expect_refused(scene_of(soft), SceneCheck::stiffness_too_stiff, 0, "k b/W = 1e14");
}

// The unit of overlap is what the block's own weight would make: W/k, here 1e-6 m.
TEST(Refusals, OverlapsNameBothBlocks) {
    const auto sunk = [](double overlap) {
        RelaxationScene scene = scene_of(OnPlane{});
        for (PlanePoint<>& vertex : scene.block[0].outline) {
            vertex.y() -= overlap;
        }
        return scene;
    };
    for (const double overlap : {9e-6, 11e-6, 9e-4}) {
        EXPECT_EQ(word(fault_of(sunk(overlap)).check), "valid") << "on a closed joint, " << overlap;
    }
    for (const double overlap : {1.1e-3, 0.1, 0.4, 0.5, 0.9}) {
        const SceneFault fault = fault_of(sunk(overlap));
        EXPECT_EQ(word(fault.check), "overlap_at_start") << overlap;
        ASSERT_TRUE(fault.other) << overlap;
        EXPECT_EQ(std::min(fault.index, *fault.other), 0U) << overlap;
        EXPECT_EQ(std::max(fault.index, *fault.other), 1U) << overlap;
    }
    // A corner alone, which no face lies on, of a block of a quarter of the weight.
    for (const double overlap : {2e-6, 3e-6}) {
        RelaxationScene tip = scene_of(OnPlane{});
        tip.block[0].outline = {{0.5, -overlap}, {1, 0.5}, {0, 0.5}};
        EXPECT_EQ(word(fault_of(tip).check), overlap < 2.5e-6 ? "valid" : "overlap_at_start") << overlap;
    }
    // The blocks form a cross: no corner of one is in the other.
    RelaxationScene cross = scene_of(OnPlane{});
    cross.block.push_back({rectangle(-1, 0.4, 3, 0.2), density});
    const SceneFault crossed = fault_of(cross);
    EXPECT_EQ(word(crossed.check), "overlap_at_start");
    EXPECT_EQ(crossed.index, 0U);
    EXPECT_EQ(crossed.other, 2U);
    // One block lies within the other, or both lie on the very same place.
    RelaxationScene inside = scene_of(OnPlane{});
    inside.block.push_back({rectangle(0.4, 0.4, 0.2, 0.2), density});
    EXPECT_EQ(word(fault_of(inside).check), "overlap_at_start");
    RelaxationScene same = scene_of(OnPlane{});
    same.block.push_back(same.block[0]);
    EXPECT_EQ(word(fault_of(same).check), "overlap_at_start");
    // Fixed blocks may overlap each other: they never touch.
    RelaxationScene fixed = scene_of(OnPlane{});
    fixed.block.push_back(fixed_block(rectangle(-2, -0.5, 1.5, 1)));
    EXPECT_EQ(word(fault_of(fixed).check), "valid");
}

TEST(Refusals, SizesTooDifferent) {
    // A pebble of 1 mm and a block of 100 m cannot share a step.
    RelaxationScene scene;
    scene.block = {{rectangle(0, 0, 100, 100), density}, {rectangle(-1, 0, 1e-3, 1e-3), density}};
    scene.block.push_back(fixed_block(rectangle(-10, -10, 120, 10)));
    scene.material = {joint(1e9, degrees(30))};
    expect_refused(scene, SceneCheck::sizes_too_different, 1, "1 mm beside 100 m");
}

TEST(Refusals, LoadsOutOfRange) {
    RelaxationScene upward = scene_of(OnPlane{});
    upward.gravity.acceleration = -1;
    expect_refused(upward, SceneCheck::load_out_of_range, 0, "negative gravity");
    RelaxationScene backward = scene_of(OnPlane{});
    backward.gravity.rate = -1;
    expect_refused(backward, SceneCheck::load_out_of_range, 0, "negative rate");
    RelaxationScene interval = scene_of(OnPlane{});
    interval.gravity.interval = -1;
    expect_refused(interval, SceneCheck::load_out_of_range, 0, "negative interval");
    RelaxationScene motion = full_scene();
    motion.motion[0].duration = -1;
    expect_refused(motion, SceneCheck::load_out_of_range, 0, "negative duration");
}

TEST(Refusals, SettingsOutOfRange) {
    using Spoil = std::function<void(RelaxationSettings&)>;
    const std::vector<std::pair<std::string, Spoil>> bad{
        {"step too near critical", [](RelaxationSettings& one) { one.step_fraction = 0.81; }},
        {"no step", [](RelaxationSettings& one) { one.step_fraction = 0; }},
        {"step without number", [](RelaxationSettings& one) { one.step_fraction = nan; }},
        {"time step of zero", [](RelaxationSettings& one) { one.time_step = 0; }},
        {"negative time step", [](RelaxationSettings& one) { one.time_step = -1e-5; }},
        {"time step without number", [](RelaxationSettings& one) { one.time_step = nan; }},
        {"viscous damping", [](RelaxationSettings& one) { one.viscous_damping = -0.1; }},
        {"too much viscous damping", [](RelaxationSettings& one) { one.viscous_damping = 3; }},
        {"local damping", [](RelaxationSettings& one) { one.local_damping = 1; }},
        {"negative local damping", [](RelaxationSettings& one) { one.local_damping = -0.2; }},
        {"ramp", [](RelaxationSettings& one) { one.ramp_time = -1; }},
        {"consolidation", [](RelaxationSettings& one) { one.consolidation_time = infinity; }},
        {"equilibrium ratio", [](RelaxationSettings& one) { one.equilibrium_ratio = nan; }},
        {"duration", [](RelaxationSettings& one) { one.duration = nan; }},
        {"onset", [](RelaxationSettings& one) { one.onset_rotation = nan; }},
        {"overlap limit", [](RelaxationSettings& one) { one.overlap_limit = 0.01; }},
        {"threads", [](RelaxationSettings& one) { one.threads = 0; }},
    };
    for (const auto& [what, spoil] : bad) {
        RelaxationSettings settings;
        spoil(settings);
        EXPECT_EQ(word(fault_of(scene_of(OnPlane{}), settings).check), "setting_out_of_range") << what;
    }
}

}  // namespace
}  // namespace delabole
