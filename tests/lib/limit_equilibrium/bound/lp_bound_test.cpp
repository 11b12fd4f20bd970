// The bound by linear programming on rows of blocks: closed forms, duality, invariance, extremes, refusals.
#include "limit_equilibrium/bound/lp_bound.hpp"
#include "limit_equilibrium/bound/block_assembly.hpp"
#include "tests/lib/limit_equilibrium/bound/least_support.hpp"
#include "tests/support/random_problem.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <thread>

namespace {

using namespace delabole;

constexpr double infinity = std::numeric_limits<double>::infinity();

double random_ratio(RandomProblem& random) {
    return std::exp(random.uniform(std::log(0.05), std::log(100.0)));
}

// Mirrors the assembly in x, so that what slid towards -x slides towards +x.
Assembly mirrored(const Assembly& assembly) {
    Assembly result = assembly;
    for (Body& body : result.bodies) {
        body.centroid.x() *= -1;
        body.load.force.x() *= -1;
        body.load.moment *= -1;
    }
    for (Contact& contact : result.contacts) {
        // Reflection swaps left and right of the way along the face.
        const Point start = contact.start;
        contact.start = {-contact.end.x(), contact.end.y()};
        contact.end = {-start.x(), start.y()};
    }
    return result;
}

// Residuals count forces against the mean weight; a few digits above rounding.
void expect_proven(const LpBound& bound) {
    ASSERT_EQ(bound.status, LpStatus::optimal);
    EXPECT_LT(bound.residuals.imbalance, 1e-9);
    EXPECT_LT(bound.residuals.cone_violation, 1e-9);
    EXPECT_LT(bound.residuals.mechanism_overlap, 1e-9);
    EXPECT_NEAR(bound.residuals.mechanism_value, bound.value, 1e-9 * (1 + std::abs(bound.value)));
}

// Thesis eqs. (8) and (10) for two equal blocks of height a and width b, m interface and c base friction.
double forward_sliding(double a, double b, double m, double c) {
    return b / (a * (1 - m * c) + b * m);
}
double backward_sliding(double a, double b, double m, double c) {
    const double resistance = 2 * a * (1 + m * c) - 2 * b * m;
    return resistance > 0 ? b * (2 * (1 + m * c) + 2 * m * c) / resistance : infinity;
}

TEST(LpBound, OneBlockSlidesOrTopples) {
    RandomProblem random(3001);
    for (int repeat = 0; repeat < 1000; ++repeat) {
        const double ratio = random_ratio(random);
        const double friction = degrees(random.uniform(0, 89.9));
        const LpBound bound = largest_tilt(assemble_row({{2, 2 * ratio, 3e4}}, {friction, 0}));
        expect_proven(bound);
        EXPECT_NEAR(std::atan(bound.value), std::min(friction, std::atan(1 / ratio)), 1e-9);
    }
}

TEST(LeastImbalance, IsNoneWhereTheBoundIsNotReached) {
    RandomProblem random(3003);
    for (int repeat = 0; repeat < 300; ++repeat) {
        std::vector<RectangularBlock> row;
        const int blocks = 1 + static_cast<int>(random.uniform(0, 12));
        for (int block = 0; block < blocks; ++block) {
            row.push_back({1, std::exp(random.uniform(-1, 1.5)), std::exp(random.uniform(8, 11))});
        }
        const Assembly level = assemble_row(row, {degrees(random.uniform(1, 60)), degrees(random.uniform(1, 60))});
        const LpBound bound = largest_tilt(level);
        ASSERT_EQ(bound.status, LpStatus::optimal);
        for (const double share : {0.999, 1.001}) {
            Assembly pushed = level;
            for (Body& body : pushed.bodies) {
                body.load.force.x() -= share * bound.value * body.weight;
            }
            const LeastImbalance found = least_imbalance(pushed);
            ASSERT_EQ(found.status, LpStatus::optimal);
            EXPECT_EQ(found.stands(), share < 1) << repeat << ", " << found.sum;
            EXPECT_EQ(found.mechanism.size(), pushed.bodies.size());
        }
    }
}

// GLPK would end the process.
TEST(LeastImbalance, HasNoAnswerWhereStrengthIsBeyondNumbers) {
    Assembly held = assemble_row({{1, 1, 2e4}}, {degrees(30), degrees(30)});
    held.contacts[0].cohesion = 1e300;
    EXPECT_EQ(least_imbalance(held).status, LpStatus::not_converged);
    held.contacts[0].cohesion = 1e12;
    EXPECT_EQ(least_imbalance(held).status, LpStatus::optimal);
}

TEST(LeastImbalance, IsTheWeightOfABodyOnNothing) {
    Assembly falling = assemble_row({{1, 1, 2e4}}, {degrees(30), degrees(30)});
    falling.contacts.clear();
    const LeastImbalance found = least_imbalance(falling);
    ASSERT_EQ(found.status, LpStatus::optimal);
    EXPECT_NEAR(found.sum, 1, 1e-6);
    ASSERT_EQ(found.mechanism.size(), 1U);
    EXPECT_NEAR(found.mechanism[0].displacement.y(), -1, 1e-6) << "it falls";
    falling.bodies.clear();
    EXPECT_EQ(least_imbalance(falling).check, AssemblyCheck::no_bodies);
}

TEST(LpBound, TwoEqualBlocksFailInTheLeastStableOfThreeModes) {
    RandomProblem random(3002);
    for (int repeat = 0; repeat < 10000; ++repeat) {
        const double width = std::exp(random.uniform(-3, 3));
        const double height = width * random_ratio(random);
        const double weight = std::exp(random.uniform(-5, 15));
        const double base = random.uniform(0, 89.9);
        const double interface = degrees(random.uniform(0, 89.9 - base));
        const LpBound bound =
            largest_tilt(assemble_row({{width, height, weight}, {width, height, weight}}, {degrees(base), interface}));
        expect_proven(bound);
        const double m = std::tan(interface);
        const double c = std::tan(degrees(base));
        const double expected =
            std::min({c, forward_sliding(height, width, m, c), backward_sliding(height, width, m, c)});
        EXPECT_NEAR(std::atan(bound.value), std::atan(expected), 1e-9)
            << "a/b " << height / width << " base " << base << " interface " << interface / degrees(1);
    }
}

TEST(LpBound, StopsWhenAskedTo) {
    const Assembly assembly = assemble_row({{2, 3, 3e4}, {2, 3, 3e4}}, {degrees(30), degrees(20)});
    const std::atomic<bool> stop{true};
    const LpBound bound = least_strength_factor(assembly, &stop);
    EXPECT_EQ(bound.status, LpStatus::interrupted);
    EXPECT_EQ(bound.iterations, 0);
}

// Forces of a row may be added to those of its continuation, with nothing between them.
TEST(LpBound, MoreEqualBlocksAreNoWeaker) {
    for (const double ratio : {0.5, 3.0, 20.0}) {
        for (const double friction : {20.0, 35.0, 60.0}) {
            double last = 0;
            for (const std::size_t count : {1U, 2U, 4U, 8U, 16U}) {
                const LpBound bound = largest_tilt(assemble_row(std::vector<RectangularBlock>(count, {1, ratio, 1e4}),
                                                                {degrees(friction), degrees(friction)}));
                expect_proven(bound);
                EXPECT_GE(bound.value, last - 1e-12);
                last = bound.value;
            }
        }
    }
}

std::vector<RectangularBlock> random_row(RandomProblem& random, std::size_t count) {
    std::vector<RectangularBlock> blocks;
    for (std::size_t index = 0; index < count; ++index) {
        const double width = random.uniform(0.5, 2);
        const double height = random.uniform(0.5, 8);
        blocks.push_back({width, height, 25e3 * width * height});
    }
    return blocks;
}

// Loads small enough for every block to stand by itself on a level base.
Assembly random_assembly(RandomProblem& random) {
    Assembly assembly = assemble_row(random_row(random, 7), {degrees(random.uniform(5, 60)), degrees(25)});
    for (Contact& contact : assembly.contacts) {
        contact.cohesion = random.uniform(0, 5e3);
        contact.tensile_strength = random.uniform(0, 1) < 0.5 ? 0 : random.uniform(0, 2e3);
    }
    for (Body& body : assembly.bodies) {
        body.load = {{random.uniform(-0.05, 0.05) * body.weight, random.uniform(-0.3, 0) * body.weight},
                     random.uniform(-0.02, 0.02) * body.weight};
    }
    return assembly;
}

TEST(LpBound, CohesionTensionAndLoadsKeepDuality) {
    RandomProblem random(3003);
    for (int repeat = 0; repeat < 200; ++repeat) {
        expect_proven(largest_tilt(random_assembly(random)));
    }
}

// What mirrored blocks do under a mirrored load.
TEST(LpBound, Symmetric) {
    RandomProblem random(3004);
    for (int repeat = 0; repeat < 50; ++repeat) {
        const Assembly assembly = random_assembly(random);
        std::vector<BodyLoad> loads;
        std::vector<BodyLoad> opposite;
        for (std::size_t index = 0; index < assembly.bodies.size(); ++index) {
            const BodyLoad load{{random.uniform(-2e4, -1e4), random.uniform(-1e4, 0)}, random.uniform(-1e4, 1e4)};
            loads.push_back(load);
            opposite.push_back({{-load.force.x(), load.force.y()}, -load.moment});
        }
        const LpBound bound = largest_load_factor(assembly, loads);
        const LpBound mirror = largest_load_factor(mirrored(assembly), opposite);
        expect_proven(bound);
        expect_proven(mirror);
        EXPECT_NEAR(mirror.value, bound.value, 1e-9 * (1 + std::abs(bound.value)));
    }
}

// Lengths grow by l and unit weights by s: weights by s l^2, moments by s l^3, cohesion and tensile strength by s l.
TEST(LpBound, SimilarAssembliesFailAtOneTilt) {
    RandomProblem random(3005);
    for (int repeat = 0; repeat < 50; ++repeat) {
        const Assembly assembly = random_assembly(random);
        const LpBound bound = largest_tilt(assembly);
        ASSERT_EQ(bound.status, LpStatus::optimal);
        for (const double l : {1e-3, 7.0, 1e3}) {
            const double s = 0.3;
            Assembly similar = assembly;
            for (Body& body : similar.bodies) {
                body.weight *= s * l * l;
                body.centroid *= l;
                body.load.force *= s * l * l;
                body.load.moment *= s * l * l * l;
            }
            for (Contact& contact : similar.contacts) {
                contact.start *= l;
                contact.end *= l;
                contact.cohesion *= s * l;
                contact.tensile_strength *= s * l;
            }
            // Only the rounding of the scaled numbers differs.
            EXPECT_NEAR(largest_tilt(similar).value, bound.value, 1e-12 * (1 + std::abs(bound.value)));
        }
    }
}

// At the tilt that a row just bears, it needs exactly its own friction.
TEST(LpBound, StrengthFactorInvertsTilt) {
    RandomProblem random(3006);
    for (int repeat = 0; repeat < 50; ++repeat) {
        Assembly assembly =
            assemble_row(random_row(random, 5), {degrees(random.uniform(5, 35)), degrees(random.uniform(5, 50))});
        const LpBound level = largest_tilt(assembly);
        ASSERT_EQ(level.status, LpStatus::optimal);
        const double tilt = level.value;
        for (Body& body : assembly.bodies) {
            body.load.force = Point(-tilt * body.weight, 0);
        }
        const LpBound bound = least_strength_factor(assembly);
        ASSERT_EQ(bound.status, LpStatus::optimal);
        // Where toppling does not depend on friction a lower factor may suffice.
        EXPECT_LE(bound.value, 1 + 1e-9);
        for (Contact& contact : assembly.contacts) {
            contact.friction_angle = std::atan(std::tan(contact.friction_angle) * bound.value);
        }
        const LpBound inverted = largest_tilt(assembly);
        ASSERT_EQ(inverted.status, LpStatus::optimal);
        EXPECT_NEAR(inverted.value, 0, 1e-9);
    }
}

TEST(LpBound, StrengthFactorOfASlidingBlockIsExact) {
    Assembly assembly = assemble_row({{4, 1, 1e5}}, {degrees(30), 0});
    assembly.bodies[0].load.force = Point(-2e4, 0);
    const LpBound bound = least_strength_factor(assembly);
    ASSERT_EQ(bound.status, LpStatus::optimal);
    EXPECT_NEAR(bound.value, 0.2 / std::tan(degrees(30)), 1e-10);

    assembly.bodies[0].load.force = Point(0, 0);
    const LpBound standing = least_strength_factor(assembly);  // without friction
    EXPECT_EQ(standing.status, LpStatus::optimal);
    EXPECT_EQ(standing.value, 0);
    ASSERT_EQ(standing.forces.size(), 1U);
    EXPECT_NEAR(standing.forces[0].normal(), 1e5, 1e-6);

    assembly.bodies[0].load.force = Point(0, 1.1e5);  // afloat: no friction holds it
    EXPECT_EQ(least_strength_factor(assembly).status, LpStatus::infeasible);
}

// The edges of a cone are nearly one line at a billionth of the strength, so that the simplex method loses its digits.
// It takes 1647 steps to seek this factor exactly.
TEST(LpBound, StrengthThatIsHardlyNeededIsNotSoughtExactly) {
    constexpr double weight = 1e5;
    Assembly assembly = assemble_row(std::vector<RectangularBlock>(16, {4, 1, weight}), {degrees(30), degrees(30)});
    for (Body& body : assembly.bodies) {
        body.load.force = Point(-1e-9 * weight, 0);
    }
    const LpBound bound = least_strength_factor(assembly);
    EXPECT_EQ(bound.status, LpStatus::optimal);
    EXPECT_GE(bound.value, 1e-9 / std::tan(degrees(30)));
    EXPECT_LE(bound.value, 1e-6);
    EXPECT_LT(bound.iterations, 500);
}

TEST(LpBound, SupportOfASlidingAndOfATopplingBlock) {
    const double weight = 1e5;
    Assembly sliding = assemble_row({{4, 1, weight}}, {degrees(20), 0});
    sliding.bodies[0].load.force = Point(-weight, 0);
    EXPECT_NEAR(least_support_force(sliding, 0, {0, 0}, {3, 0}), weight * (1 - std::tan(degrees(20))), 1e-9 * weight);

    // Moments about the toe: 1.5 W pushed out at half height 2 against W at half width 0.5; support at the top.
    Assembly toppling = assemble_row({{1, 4, weight}}, {degrees(80), 0});
    toppling.bodies[0].load.force = Point(-1.5 * weight, 0);
    EXPECT_NEAR(least_support_force(toppling, 0, {0, 4}, {1, 0}), weight * (1.5 * 2 - 0.5) / 4, 1e-9 * weight);
    EXPECT_EQ(least_support_force(assemble_row({{4, 1, weight}}, {degrees(20), 0}), 0, {0, 0}, {1, 0}), 0);
}

TEST(LpBound, VerticalLoadOnALevelRowIsBorneWithoutLimit) {
    const Assembly row = assemble_row({{1, 3, 1e4}, {1, 3, 1e4}}, {degrees(30), degrees(30)});
    EXPECT_EQ(largest_load_factor(row, {{{0, -1}, 0}, {{0, -1}, 0}}).status, LpStatus::unbounded);
    // The load is an uplift: each block resists by its own weight.
    const LpBound uplift = largest_load_factor(row, {{{0, 1e4}, 0}, {{0, 1e4}, 0}});
    ASSERT_EQ(uplift.status, LpStatus::optimal);
    EXPECT_NEAR(uplift.value, 1, 1e-12);
}

TEST(LpBound, CohesionOfABlockCarriesItsFace) {
    Assembly block = assemble_row({{10, 0.1, 1e4}}, {degrees(30), 0});
    block.contacts[0].cohesion = 1e3;
    const LpBound bound = largest_tilt(block);
    expect_proven(bound);
    EXPECT_NEAR(bound.value, std::tan(degrees(30)) + 1e3 * 10 / 1e4, 1e-12);
}

// Moments about the toe: the weight, the horizontal force at half height, the pull at the heel.
TEST(LpBound, TensionHoldsAColumnBack) {
    constexpr double width = 2;
    constexpr double height = 10;
    constexpr double weight = 5e5;
    Assembly column = assemble_row({{width, height, weight}}, {degrees(60), 0});
    column.contacts[0].tensile_strength = 5e4;
    const LpBound bound = largest_tilt(column);
    expect_proven(bound);
    EXPECT_NEAR(bound.value, (weight * width / 2 + 5e4 * width / 2 * width) / (weight * height / 2), 1e-12);
}

TEST(LpBound, TensionOfARoofCarriesWhatHangsFromIt) {
    constexpr double width = 3;
    constexpr double weight = 6e4;
    Assembly hung = assemble_row({{width, 1, weight}}, {degrees(30), 0});
    Contact& roof = hung.contacts[0];
    std::swap(roof.start, roof.end);  // the block is below it
    roof.start.y() = roof.end.y() = 1;
    roof.tensile_strength = 1;
    const LpBound bound = least_strength_factor(hung);
    ASSERT_EQ(bound.status, LpStatus::infeasible);
    roof.tensile_strength = 1e4;
    EXPECT_NEAR(least_strength_factor(hung).value, weight / (1e4 * width), 1e-9);
}

TEST(LpBound, Extremes) {
    for (const double ratio : {0.05, 0.5, 3.0, 20.0, 100.0}) {
        for (const double base : {0.0, 1e-6, 20.0, 45.0, 60.0, 89.9}) {
            for (const double interface : {0.0, 30.0, 45.0, 89.9}) {
                for (const std::size_t count : {2U, 5U, 30U}) {
                    const LpBound bound = largest_tilt(assemble_row(
                        std::vector<RectangularBlock>(count, {1, ratio, 1e4}), {degrees(base), degrees(interface)}));
                    SCOPED_TRACE(testing::Message() << ratio << ' ' << base << ' ' << interface << ' ' << count);
                    ASSERT_EQ(bound.status, LpStatus::optimal);
                    EXPECT_LT(bound.residuals.imbalance, 1e-7);
                    EXPECT_NEAR(bound.residuals.mechanism_value, bound.value, 1e-9 * (1 + bound.value));
                    // No assembly bears more than its bases' friction, nor more than one body of the same outline; none
                    // less than a block by itself.
                    const double friction = std::tan(degrees(base));
                    const double whole = static_cast<double>(count) / ratio;
                    EXPECT_LE(bound.value, std::min(friction, whole) * (1 + 1e-9) + 1e-12);
                    EXPECT_GE(bound.value, std::min(friction, 1 / ratio) * (1 - 1e-9) - 1e-12);
                }
            }
        }
    }
}

TEST(LpBound, AThousandBlocks) {
    const std::vector<RectangularBlock> blocks(1000, {1, 3, 1e4});
    for (const double friction : {20.0, 35.0, 60.0}) {
        const LpBound bound = largest_tilt(assemble_row(blocks, {degrees(friction), degrees(friction)}));
        SCOPED_TRACE(friction);
        expect_proven(bound);
    }
}

TEST(LpBound, SameAnswerInEveryThread) {
    const Assembly row = assemble_row(std::vector<RectangularBlock>(20, {1, 3, 1e4}), {degrees(35), degrees(35)});
    const LpBound alone = largest_tilt(row);
    std::vector<double> values(4);
    std::vector<std::thread> threads;
    for (double& value : values) {
        threads.emplace_back([&row, &value] { value = largest_tilt(row).value; });
    }
    for (std::thread& thread : threads) {
        thread.join();
    }
    for (const double value : values) {
        EXPECT_EQ(value, alone.value);
    }
}

TEST(LpBound, PrintsNothing) {
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    largest_tilt(assemble_row(std::vector<RectangularBlock>(50, {1, 3, 1e4}), {degrees(89.9), degrees(89.9)}));
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

// A block a thousand and more times heavier than the one that it stands beside, each on its own: the lower one slides.
// The answer is right up to the ratio that is allowed, and refused beyond.
TEST(LpBound, WeightsOfAnyRatioAreBoundedOrRefused) {
    for (const double ratio : {1.0, 1e3, 1e6, 1e7}) {
        const double factor = std::sqrt(ratio);
        const BlockFriction friction{degrees(20), 0};
        const LpBound bound = largest_tilt(assemble_row({{1, 2, 1e4}, {factor, 2 * factor, ratio * 1e4}}, friction));
        ASSERT_EQ(bound.status, LpStatus::optimal) << ratio;
        EXPECT_NEAR(bound.value, std::tan(degrees(20)), 1e-9) << ratio;
    }
    const LpBound refused = largest_tilt(assemble_row({{1, 2, 1e4}, {1e4, 2e4, 1.1e11}}, {degrees(20), 0}));
    EXPECT_EQ(refused.status, LpStatus::invalid_assembly);
    EXPECT_EQ(refused.check, AssemblyCheck::weights_too_different);
}

TEST(LpBound, RefusesByName) {
    const BlockFriction friction{degrees(30), degrees(30)};
    const auto check = [](const Assembly& assembly) {
        const LpBound bound = largest_tilt(assembly);
        EXPECT_EQ(bound.status, LpStatus::invalid_assembly);
        return bound.check;
    };
    EXPECT_EQ(check(Assembly{}), AssemblyCheck::no_bodies);
    EXPECT_EQ(check(assemble_row({}, friction)), AssemblyCheck::no_bodies);
    EXPECT_EQ(check(assemble_row({{1, 0, 1e4}}, friction)), AssemblyCheck::block_without_size);
    EXPECT_EQ(check(assemble_row({{-1, 2, 1e4}}, friction)), AssemblyCheck::block_without_size);
    EXPECT_EQ(check(assemble_row({{1, 2, -1e4}}, friction)), AssemblyCheck::weight_not_positive);
    EXPECT_EQ(check(assemble_row({{1, 2, std::nan("")}}, friction)), AssemblyCheck::input_out_of_range);
    EXPECT_EQ(check(assemble_row({{1, 2, 1e4}}, {degrees(90), 0})), AssemblyCheck::friction_not_below_90_deg);
    EXPECT_EQ(check(assemble_row({{1, 2, 1e4}}, {-0.1, 0})), AssemblyCheck::friction_not_below_90_deg);
    const Assembly block = assemble_row({{1, 2, 1e4}}, friction);
    Assembly broken = block;
    broken.contacts[0].cohesion = -1;
    EXPECT_EQ(check(broken), AssemblyCheck::cohesion_negative);
    broken = block;
    broken.contacts[0].tensile_strength = -1;
    EXPECT_EQ(check(broken), AssemblyCheck::cohesion_negative);
    broken = block;
    broken.contacts[0].end = broken.contacts[0].start;
    EXPECT_EQ(check(broken), AssemblyCheck::contact_without_length);
    broken = block;
    broken.contacts[0].other = 0;
    EXPECT_EQ(check(broken), AssemblyCheck::contact_of_unknown_body);
    EXPECT_EQ(largest_load_factor(block, {}).check, AssemblyCheck::input_out_of_range);
}

}  // namespace
