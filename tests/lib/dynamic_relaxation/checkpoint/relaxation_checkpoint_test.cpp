// A run continues from a checkpoint to the last bit, and nothing else is accepted as a checkpoint.
#include "dynamic_relaxation/checkpoint/checkpoint.hpp"
#include "dynamic_relaxation/contact/bonds.hpp"
#include "dynamic_relaxation/scene/scenes.hpp"
#include "dynamic_relaxation/step/simulation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>
#include <memory>
#include <new>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace delabole {
namespace {

constexpr double degree = std::numbers::pi / 180;

struct Case {
    const char* name;
    RelaxationScene scene = {};
    RelaxationSettings settings = {};
};

StandingBlocks blocks_of(std::vector<StandingBlock> blocks, double friction, double tilt) {
    const double stiffness = stiffness_of_ratio(1e5, blocks.front(), 2700, 9.80665);
    const JointMaterial joint{stiffness, stiffness, friction * degree};
    return {std::move(blocks), 2700, joint, joint, tilt * degree};
}

// Far beyond the critical tilt, 18.63 deg: contacts open, slip and are searched anew.
Case two_blocks() {
    return {"two blocks", row_scene(blocks_of({{1, 3}, {1, 3}}, 20, 25))};
}

// Appendix A well below its limiting friction, 41.14 deg, over a base that dips at 21.8 deg.
Case eight_columns() {
    std::vector<StandingBlock> columns;
    for (const double height : {1.0, 2.0, 3.0, 4.0, 3.1, 2.2, 1.3, 0.4}) {
        columns.push_back({1, height, 0.5});
    }
    return {"eight columns", column_scene(blocks_of(columns, 30, 21.8))};
}

// Stable: the blocks come to rest, and their contacts are evaluated no more.
Case resting_blocks() {
    Case result{"resting blocks", row_scene(blocks_of({{1, 3}, {1, 3}}, 20, 10))};
    result.settings.stop_at_equilibrium = false;
    return result;
}

// This case has what the others leave out: a peak, cohesion, consolidation, a removal, water, a base that is turned,
// kinetic damping, a start on loose springs.
Case eventful() {
    Case result{"eventful", row_scene(blocks_of({{1, 3}, {1, 2}, {1, 1}}, 30, 12))};
    result.scene.material[0].residual_friction_angle = 20 * degree;
    result.scene.material[0].cohesion = 500;
    result.scene.block[1].held_at_first = true;
    result.scene.removal = {{2, 0.12}};
    result.scene.pressure = {{1, 1, 2e3, 1e3, {}, true}};  // the part beside the block removed drains
    PrescribedMotion turning{3, {}};
    turning.angular_velocity = 0.2;
    turning.start = 0.05;
    turning.duration = 0.1;
    result.scene.motion = {turning};
    result.scene.shaking = {{0, {0, 0}}, {0.1, {0.5, 0}}, {0.2, {0, 0}}};
    result.settings.start = RelaxationStart::dropped;
    result.settings.consolidation_time = 0.08;
    result.settings.kinetic_damping = true;
    return result;
}

// The rock shears off where it is pressed: its shortening stays in the contacts that take its place.
Case breaking_rock() {
    Case result{"breaking rock"};
    RelaxationScene& scene = result.scene;
    const auto square = [](double x, double y, double side) {
        return Polygon<>{{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}};
    };
    scene.block = {{square(0, 0, 1), 2700}, {square(0, 1, 1), 2700}, {square(-5, -10, 10), 2700}};
    scene.block[2].fixed = true;
    const double stiffness = 1e5 * 2700 * 9.80665;
    scene.material = {{stiffness, stiffness, 20 * degree}};
    scene.material[0].bond = BondMaterial{1e8, 4e7, 1e6, 1000, 20 * degree, {}};
    scene.bond = find_bonds(scene);
    scene.gravity.tilt = scene.gravity.final_tilt = 25 * degree;
    return result;
}

std::string saved(const Simulation& simulation) {
    return checkpoint_of(simulation.scene(), simulation.settings(), simulation.state());
}

void advance(Simulation& simulation, int steps) {
    for (int step = 0; step < steps; ++step) {
        simulation.step();
    }
}

// The steps go past all events of the eventful run.
constexpr int steps = 4000;

TEST(RelaxationCheckpoint, GoesOnToTheLastBit) {
    std::mt19937 random(4);
    for (const Case& one : {two_blocks(), eight_columns(), resting_blocks(), eventful(), breaking_rock()}) {
        // Step 0 is tried as well: the scene is consolidated and has not yet moved.
        std::vector<int> stops{0};
        for (int stop = 0; stop < 5; ++stop) {
            stops.push_back(std::uniform_int_distribution(1, steps - 1)(random));
        }
        Simulation whole(one.scene, one.settings);
        std::vector<std::string> checkpoints(stops.size());
        for (int step = 0; step < steps; ++step) {
            for (std::size_t index = 0; index < stops.size(); ++index) {
                if (stops[index] == step) {
                    checkpoints[index] = saved(whole);
                }
            }
            whole.step();
        }
        const std::string expected = saved(whole);
        for (std::size_t index = 0; index < stops.size(); ++index) {
            RestoredState restored = restore_checkpoint(checkpoints[index], one.scene, one.settings);
            ASSERT_EQ(restored.check, CheckpointCheck::ok) << one.name;
            EXPECT_EQ(checkpoint_of(one.scene, one.settings, restored.state), checkpoints[index]) << one.name;
            Simulation rest(one.scene, one.settings, std::move(restored.state));
            advance(rest, steps - stops[index]);
            EXPECT_TRUE(saved(rest) == expected) << one.name << " from step " << stops[index];
        }
    }
}

TEST(RelaxationCheckpoint, EventsOfTheEventfulRunHappen) {
    const Case one = eventful();
    Simulation run(one.scene, one.settings);
    advance(run, steps);
    EXPECT_EQ(run.state().removed[2], 1);
    EXPECT_NEAR(run.state().motion[3].angle, 0.02, 1e-4);  // the last step overshoots by at most its own length
    EXPECT_GT(run.state().energy_balance.kinetic_damping, 0);
}

TEST(RelaxationCheckpoint, ContactsAreSearchedAnewOnTheWay) {
    for (const Case& one : {two_blocks(), eight_columns(), eventful()}) {
        Simulation run(one.scene, one.settings);
        advance(run, 2000);
        EXPECT_GT(run.state().watch.pair_checks, run.state().watch.pair.size()) << one.name;
        EXPECT_GT(run.energy_balance().friction, 0) << one.name;
    }
}

TEST(RelaxationCheckpoint, RestingBlocksCostLess) {
    const Case one = resting_blocks();
    Simulation run(one.scene, one.settings);
    advance(run, 1500);
    const std::uint64_t before = run.state().contacts_evaluated;
    advance(run, 500);
    EXPECT_LT(run.state().contacts_evaluated - before, 500 * run.state().contacts.contact.size() / 2);
}

// The padding between the members of a struct holds arbitrary bytes.
TEST(RelaxationCheckpoint, PaddingDoesNotShow) {
    const Case one = two_blocks();
    Simulation run(one.scene, one.settings);
    advance(run, 500);
    const RelaxationState& state = run.state();
    ASSERT_FALSE(state.watch.pair.empty());
    static_assert(sizeof(WatchedPair) > 5 * sizeof(double) + 3 * sizeof(std::uint32_t), "it has padding");
    RelaxationState copy = state;
    for (std::size_t index = 0; index < copy.watch.pair.size(); ++index) {
        const WatchedPair& from = state.watch.pair[index];
        void* to = &copy.watch.pair[index];
        std::memset(to, 0x5a, sizeof(WatchedPair));
        auto* pair = new (to) WatchedPair;
        pair->first = from.first;
        pair->second = from.second;
        pair->begin = from.begin;
        pair->pose = from.pose;
        pair->distance = from.distance;
        pair->holds = from.holds;
    }
    EXPECT_EQ(checkpoint_of(one.scene, one.settings, copy), saved(run));
}

TEST(RelaxationCheckpoint, KeepsWhatIsNotANumber) {
    const Case one = two_blocks();
    RelaxationState state = Simulation(one.scene, one.settings).state();
    state.watch.due[0] = std::numeric_limits<double>::infinity();
    state.motion[0].vx = std::numeric_limits<double>::quiet_NaN();
    state.motion[1].vy = -0.0;
    state.step = std::numeric_limits<double>::denorm_min();
    const std::string bytes = checkpoint_of(one.scene, one.settings, state);
    const RestoredState restored = restore_checkpoint(bytes, one.scene, one.settings);
    ASSERT_EQ(restored.check, CheckpointCheck::ok);
    EXPECT_EQ(checkpoint_of(one.scene, one.settings, restored.state), bytes);
}

TEST(RelaxationCheckpoint, RefusesAnotherSceneOrOtherSettings) {
    const Case one = eventful();
    const Simulation run(one.scene, one.settings);
    const std::string bytes = saved(run);
    const auto check = [&](const auto& change) {
        Case other = one;
        change(other.scene, other.settings);
        return restore_checkpoint(bytes, other.scene, other.settings).check;
    };
    constexpr CheckpointCheck refused = CheckpointCheck::other_scene;
    const double bit = std::numeric_limits<double>::epsilon();
    EXPECT_EQ(check([&](auto& scene, auto&) { scene.block[0].outline[2].x() *= 1 + bit; }), refused);
    EXPECT_EQ(check([&](auto& scene, auto&) { scene.material[0].residual_friction_angle.reset(); }), refused);
    EXPECT_EQ(check([&](auto& scene, auto&) { scene.gravity.tilt *= 1 + bit; }), refused);
    EXPECT_EQ(check([&](auto& scene, auto&) { scene.removal[0].time *= 1 + bit; }), refused);
    EXPECT_EQ(check([&](auto& scene, auto&) { scene.removal.pop_back(); }), refused);
    EXPECT_EQ(check([&](auto& scene, auto&) { scene.block[0].fixed = true; }), refused);
    EXPECT_EQ(check([&](auto& scene, auto&) { scene.shaking[1].value.y() = 0.1; }), refused);
    EXPECT_EQ(check([&](auto&, auto& settings) { settings.local_damping += 0.1; }), refused);
    EXPECT_EQ(check([&](auto&, auto& settings) { settings.start = RelaxationStart::ramped; }), refused);
    EXPECT_EQ(check([&](auto&, auto& settings) { settings.time_step = 1e-4; }), refused);
    // Duration, number of steps and number of threads are not part of the state.
    EXPECT_EQ(check([&](auto&, auto& settings) {
                  settings.duration *= 2;
                  settings.most_steps /= 2;
                  settings.threads = 2;
              }),
              CheckpointCheck::ok);
}

class Damage : public testing::Test {
  protected:
    static void SetUpTestSuite() {
        one = std::make_unique<Case>(two_blocks());
        Simulation run(one->scene, one->settings);
        advance(run, 700);
        bytes = saved(run);
    }
    static void TearDownTestSuite() { one.reset(); }

    static CheckpointCheck check(const std::string& changed) {
        return restore_checkpoint(changed, one->scene, one->settings).check;
    }
    static std::string with_checksum(std::string changed) {
        changed.resize(changed.size() - 8);
        std::uint64_t hash = 14695981039346656037U;
        for (const char byte : changed) {
            hash = (hash ^ static_cast<unsigned char>(byte)) * 1099511628211U;
        }
        for (int index = 0; index < 8; ++index) {
            changed += static_cast<char>(hash >> (8 * index));
        }
        return changed;
    }

    static inline std::unique_ptr<Case> one;
    static inline std::string bytes;
};

TEST_F(Damage, EveryAlteredByteIsNoticed) {
    ASSERT_EQ(check(bytes), CheckpointCheck::ok);
    for (std::size_t at = 0; at < bytes.size(); ++at) {
        std::string changed = bytes;
        changed[at] = static_cast<char>(changed[at] ^ (1 << (at % 8)));
        const CheckpointCheck expected = at < 8    ? CheckpointCheck::not_a_checkpoint
                                         : at < 16 ? CheckpointCheck::other_version
                                                   : CheckpointCheck::damaged;
        ASSERT_EQ(check(changed), expected) << at;
    }
}

TEST_F(Damage, EveryCutIsNoticed) {
    for (std::size_t size = 0; size < bytes.size(); ++size) {
        ASSERT_EQ(check(bytes.substr(0, size)), size < 8 ? CheckpointCheck::not_a_checkpoint : CheckpointCheck::damaged)
            << size;
    }
    EXPECT_EQ(check(bytes + '\0'), CheckpointCheck::damaged);
    EXPECT_EQ(check(bytes + bytes), CheckpointCheck::damaged);
}

TEST_F(Damage, OtherFilesAreNone) {
    for (const std::string& text : {std::string(), std::string("schema = 1\n"), std::string(4096, '\0')}) {
        EXPECT_EQ(check(text), CheckpointCheck::not_a_checkpoint);
    }
}

// With the right checksum over the wrong bytes, as nobody but a forger writes it: lengths of vectors that no memory
// holds, indices that lead nowhere. What is taken is a state as it stands there.
TEST_F(Damage, ForgedBytesDoNoHarm) {
    std::mt19937 random(11);
    const auto up_to = [&](std::size_t last) { return std::uniform_int_distribution<std::size_t>(0, last)(random); };
    int refused = 0;
    for (int round = 0; round < 20'000; ++round) {
        std::string changed = bytes;
        const std::size_t blows = 1 + up_to(3);
        for (std::size_t blow = 0; blow < blows; ++blow) {
            const std::size_t at = 16 + up_to(changed.size() - 17);
            if (up_to(3) > 0) {
                changed[at] = static_cast<char>(up_to(255));
            } else {
                for (std::size_t next = at; next < std::min(at + 8, changed.size()); ++next) {
                    changed[next] = static_cast<char>(0xff);
                }
            }
        }
        changed = with_checksum(changed);
        const RestoredState restored = restore_checkpoint(changed, one->scene, one->settings);
        if (restored.check == CheckpointCheck::ok) {
            ASSERT_EQ(checkpoint_of(one->scene, one->settings, restored.state), changed);
        } else {
            ++refused;
        }
    }
    EXPECT_GT(refused, 1000);
}

TEST_F(Damage, LengthsBeyondTheFileAllocateNothing) {
    // The first vector, the motions, stands after five numbers.
    const std::size_t at = 32 + 5 * 8;
    ASSERT_EQ(static_cast<std::size_t>(bytes[at]), one->scene.block.size());
    for (const std::uint64_t count : {std::uint64_t{4}, std::uint64_t{1} << 40U, ~std::uint64_t{0}}) {
        std::string changed = bytes;
        for (std::size_t index = 0; index < 8; ++index) {
            changed[at + index] = static_cast<char>(count >> (8 * index));
        }
        EXPECT_EQ(check(with_checksum(changed)), CheckpointCheck::damaged) << count;
    }
}

TEST_F(Damage, ATextTransferIsNoticed) {
    std::string changed = bytes;
    changed.insert(changed.find('\n'), "\r");
    EXPECT_EQ(check(changed), CheckpointCheck::not_a_checkpoint);
}

}  // namespace
}  // namespace delabole
