// The base friction models of chapter 2 in motion: parts of their runs, as short as shows what they are to show.
#include "cases/program/thesis/chapter_2/chapter_2.hpp"
#include "cases/program/thesis/thesis_tables.hpp"
#include "dynamic_relaxation/scene/slope_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace delabole {
namespace {

RelaxationSlope& slope_of(RelaxationStudy& study) {
    return std::get<RelaxationSlope>(study.model.scene);
}

RelaxationStudy with_friction(RelaxationStudy study, double friction) {
    for (SlopeJoint& joint : slope_of(study).joint) {
        joint.strength.friction_angle = friction;
    }
    return study;
}

double mean_way(const RelaxationRun& made) {
    double way = 0;
    double mass = 0;
    const Bodies bodies = make_bodies(made.scene);
    for (std::size_t block = 0; block < bodies.size(); ++block) {
        if (bodies.fixed[block] == 0) {
            way += bodies.mass[block] * made.result.block[block].displacement;
            mass += bodies.mass[block];
        }
    }
    return way / mass;
}

double angle_of(const PlanePoint<>& along) {
    return std::atan2(std::abs(along.y()), std::abs(along.x()));
}

TEST(Chapter2Models, AreCasesInOrder) {
    std::size_t count = 0;
    for (const auto& [folder, name, text] : built_in_cases()) {
        if (folder != "thesis/chapter_2") {
            continue;
        }
        ++count;
        RelaxationStudy study = slope_model(name);
        EXPECT_EQ(slope_scene(slope_of(study)).check, SlopeCheck::valid) << name;
        EXPECT_EQ(check(study).check, SceneCheck::valid) << name;
    }
    EXPECT_EQ(count, 13U);
    EXPECT_THROW(slope_model("plate_9"), std::logic_error);
}

// A merged sliver closes the joint between its halves. Joint A of the toppling models must run through: the faces along
// it are as long, on both sides, as its traces in the section, but for what is merged at the face.
TEST(Chapter2Models, JointARunsThrough) {
    RelaxationStudy study = slope_model("plate_2_iii");
    const SlopeScene scene = slope_scene(slope_of(study));
    double faces = 0;
    for (const RelaxationBlock& block : scene.block) {
        for (std::size_t edge = 0; edge < block.outline.size() && !block.fixed; ++edge) {
            const PlanePoint<> along = block.outline[(edge + 1) % block.outline.size()] - block.outline[edge];
            faces += block.joint[edge] == 0 && std::abs(angle_of(along) - degrees(70)) < degrees(1) ? along.norm() : 0;
        }
    }
    // Joint A through the toe and every 50 mm behind it; section of 400 by 343 mm with a face of 60 deg.
    double traces = 0;
    for (double foot = 0.05 / std::sin(degrees(70)); foot < 0.4; foot += 0.05 / std::sin(degrees(70))) {
        // The trace ends in the face, at the top or at the back.
        const double at_face = foot / (1 / std::tan(degrees(60)) - 1 / std::tan(degrees(70)));
        const double at_back = (0.4 - foot) * std::tan(degrees(70));
        traces += std::min({at_face, 0.343, at_back}) / std::sin(degrees(70));
    }
    // What is merged at the face is half a per cent.
    EXPECT_NEAR(faces / 2, traces, 0.005 * traces);
}

// 2.3.3.2 C: the wedge between A and B goes down and drives the columns out; with the friction of the mixture rigid
// blocks stand.
TEST(Chapter2Models, ToppleAtTheFrictionOfSlate) {
    RelaxationStudy study = slope_model("plate_2_iii");
    study.settings->duration = 0.25;
    const RelaxationRun made = run(study);
    ASSERT_TRUE(made.post_failure.has_value());
    const PostFailureAnswer& answer = made.post_failure->answer;
    EXPECT_LT(answer.near_face.horizontal, 0);
    EXPECT_LT(answer.near_face.vertical, -0.002);  // a tenth of a block
    const auto b = std::ranges::find(answer.joint, "joint B", &CrestJoint::joint);
    ASSERT_NE(b, answer.joint.end());
    EXPECT_GT(b->open, 0.9);
}

// The slope of 1500 blocks and its model on the belt are compared block by block.
TEST(Chapter2Models, BeltModelIsTheSlopeAtOneTo200) {
    const auto read = [](const std::string& name) {
        const CaseFile file = read_case(std::string(DELABOLE_CASES) + "/thesis/chapter_2/" + name + ".toml");
        return relaxation_scene(std::get<RelaxationStudy>(file.model));
    };
    const RelaxationScene slope = read("delabole_1500_blocks");
    const RelaxationScene model = read("delabole_1500_blocks_belt");
    ASSERT_EQ(slope.block.size(), model.block.size());
    constexpr double scale = 200;
    for (std::size_t block = 0; block < slope.block.size(); ++block) {
        EXPECT_EQ(slope.block[block].fixed, model.block[block].fixed);
        EXPECT_EQ(slope.block[block].joint, model.block[block].joint);
        const double area = area_properties(slope.block[block].outline).area;
        // Rounding of areas, which are differences of products of coordinates.
        EXPECT_NEAR(area_properties(model.block[block].outline).area * scale * scale, area, 1e-9 * area);
    }
    EXPECT_FALSE(slope.belt.has_value());
    EXPECT_TRUE(model.belt.has_value());
}

// 2.3.5, observations 2 and 3.
TEST(Chapter2Models, ColumnMovesFartherWithWaterAndWithLessFriction) {
    RelaxationStudy dry = slope_model("groundwater_column");
    dry.settings->duration = 0.15;
    RelaxationStudy half = dry;
    slope_of(half).tilt = degrees(12);
    RelaxationStudy full = dry;
    slope_of(full).tilt = degrees(47.5);
    const double rough = mean_way(run(with_friction(half, degrees(43))));
    const double sprayed = mean_way(run(with_friction(half, degrees(29.5))));
    const double dry_way = mean_way(run(with_friction(dry, degrees(43))));
    const double full_way = mean_way(run(with_friction(full, degrees(43))));
    EXPECT_GT(rough, dry_way);
    EXPECT_GT(sprayed, rough);
    EXPECT_GT(full_way, rough);
}

TEST(RankCorrelation, IsSpearmans) {
    const std::vector<double> values = {1, 2, 3, 4, 5};
    EXPECT_NEAR(rank_correlation(values, {0.1, 0.2, 7, 8, 100}).value, 1, 1e-12);
    // 1 - 6 sum d^2 / (n (n^2 - 1)), d = (0, 0, 0, 1, -1).
    EXPECT_NEAR(rank_correlation(values, {-5, -4, -3, -1, -2}).value, 0.9, 1e-12);
    EXPECT_NEAR(rank_correlation(values, {5, 4, 3, 2, 1}).value, -1, 1e-12);
    const RankCorrelation constant = rank_correlation(values, {2, 2, 2, 2, 2});
    EXPECT_EQ(constant.value, 0);
    EXPECT_EQ(constant.significance, 1);
    // Ranks 1.5, 1.5, 3 against 1, 2, 3.
    EXPECT_NEAR(rank_correlation({1, 2, 3}, {4, 4, 9}).value, std::sqrt(3.0) / 2, 1e-12);
}

// Student's t is held against the share of all orders whose correlation is as strong: 0.016 off for eight values.
TEST(RankCorrelation, SignificanceIsTheShareOfOrders) {
    const std::vector<double> values = {1, 2, 3, 4, 5, 6, 7, 8};
    const auto strength = [&](const std::vector<double>& order) {
        double squares = 0;
        for (std::size_t index = 0; index < order.size(); ++index) {
            squares += (order[index] - values[index]) * (order[index] - values[index]);
        }
        return std::abs(1 - 6 * squares / (8.0 * 63));
    };
    for (const std::vector<double>& found :
         {std::vector<double>{2, 1, 4, 3, 8, 6, 5, 7}, {3, 1, 5, 2, 8, 7, 4, 6}, {8, 3, 1, 2, 5, 7, 4, 6}}) {
        std::vector<double> order = values;
        double as_strong = 0;
        double all = 0;
        do {
            as_strong += strength(order) >= strength(found) - 1e-12 ? 1 : 0;
            ++all;
        } while (std::ranges::next_permutation(order).found);
        EXPECT_NEAR(rank_correlation(values, found).significance, as_strong / all, 0.02);
    }
}

}  // namespace
}  // namespace delabole
