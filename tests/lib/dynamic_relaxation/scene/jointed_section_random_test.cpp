// Random outlines and cuts: whatever comes, the blocks are convex, fill the outline and are taken by the engine.
#include "dynamic_relaxation/scene/slope_scene.hpp"
#include "dynamic_relaxation/step/scene_check.hpp"
#include "dynamic_relaxation/study/relaxation_study.hpp"

#include "tests/support/jointed_slopes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

namespace delabole {
namespace {

using testing::cut;
using testing::joint_set;
using testing::line;
using testing::section;

class RandomSlopes {
  public:
    explicit RandomSlopes(unsigned seed) : engine_(seed) {}

    SlopeGeometry next() {
        SlopeGeometry geometry = section(outline());
        const int count = whole(1, 5);
        for (int index = 0; index < count; ++index) {
            const std::string name = std::string(1, static_cast<char>('a' + index));
            if (chance(0.3)) {
                geometry.cut.push_back(cut(name, random_line()));
                last_line_ = name;
            } else {
                geometry.cut.push_back(cut(name, random_set()));
                last_set_ = name;
            }
        }
        last_line_.clear();
        last_set_.clear();
        return geometry;
    }

  private:
    double between(double lower, double upper) { return std::uniform_real_distribution<double>(lower, upper)(engine_); }
    int whole(int lower, int upper) { return std::uniform_int_distribution<int>(lower, upper)(engine_); }
    bool chance(double share) { return between(0, 1) < share; }

    // A star around its middle, with corners that point inwards.
    std::vector<SectionPoint> outline() {
        const int count = whole(3, 16);
        std::vector<SectionPoint> points;
        for (int index = 0; index < count; ++index) {
            const double angle = 2 * 3.14159265358979 * (index + between(0, 0.8)) / count;
            const double reach = between(6, 30);
            points.push_back({reach * std::cos(angle), reach * std::sin(angle)});
        }
        return points;
    }

    JointSetCut random_set() {
        // Right angles and equal dips on purpose: lines that run along others.
        const double dip = chance(0.3) ? degrees(45.0 * whole(-2, 2)) : degrees(between(-90, 90));
        JointSetCut set = joint_set(dip, between(1.5, 8), between(-2, 2));
        if (chance(0.5)) {
            set.scatter = between(0, 0.9);
        }
        if (chance(0.3)) {
            set.persistence = between(0.2, 1);
            set.trace_length = between(2, 20);
        }
        if (chance(0.2)) {
            set.region = {{-10, -10}, {10, -10}, {0, 0}, {10, 10}, {-10, 10}};
        }
        if (!last_line_.empty() && chance(0.5)) {
            set.ends_on = last_line_;
            set.side = chance(0.5) ? SideOfLine::above : SideOfLine::below;
        }
        if (!last_set_.empty() && chance(0.4)) {
            set.staggered_by = last_set_;
            set.stagger_share = between(0, 1);
        }
        return set;
    }

    LineCut random_line() {
        LineCut made = line({});
        const int count = whole(2, 6);
        double y = between(-10, 10);
        for (int index = 0; index < count; ++index) {
            made.vertex.push_back({-40 + 80.0 * index / (count - 1), y});
            y += between(-15, 15);
        }
        if (chance(0.5)) {
            made.thickness = between(0.2, 1);
            made.gouge = "gouge";
        }
        if (chance(0.5)) {
            made.rock_below = "other";
        }
        return made;
    }

    std::mt19937_64 engine_;
    std::string last_line_ = {};
    std::string last_set_ = {};
};

RelaxationStudy study_of(const SlopeGeometry& geometry) {
    RelaxationSlope slope{};
    slope.geometry = geometry;
    slope.geometry.intact_joint = "joint";
    slope.rock = {{"slate", 2700}, {"gouge", 2000}, {"other", 2600}};
    slope.joint = {{"joint", {}, {}}};
    slope.joint[0].strength.friction_angle = degrees(30);
    RelaxationStudy study{};
    study.model.scene = slope;
    return study;
}

TEST(RandomJointedSections, BlocksAreConvexFillTheOutlineAndRun) {
    RandomSlopes slopes(20);
    std::size_t blocks = 0;
    constexpr int runs = 1000;
    for (int run = 0; run < runs; ++run) {
        const SlopeGeometry geometry = slopes.next();
        const JointedSection made = testing::cut_in_one_rock(geometry);
        ASSERT_EQ(made.check, SlopeCheck::valid) << run << ": " << word_of(made.check);
        blocks += made.block.size();
        double area = made.crushed_area;
        std::map<std::pair<MeshIndex, MeshIndex>, int> edges;
        for (const SlopeBlock& block : made.block) {
            area += area_properties(outline_of(made, block)).area;
            for (std::size_t edge = 0; edge < block.vertex.size(); ++edge) {
                const MeshIndex next = block.vertex[(edge + 1) % block.vertex.size()];
                ASSERT_EQ(++edges[std::pair(block.vertex[edge], next)], 1) << run;
            }
        }
        Polygon<> outline;
        for (const SectionPoint& point : geometry.outline) {
            outline.emplace_back(point.x, point.y);
        }
        ASSERT_NEAR(area / std::abs(area_properties(outline).area), 1, 1e-12) << run;
        const RelaxationScene scene = relaxation_scene(study_of(geometry));
        SceneFault fault = check_scene(scene);
        ASSERT_EQ(fault.check, SceneCheck::valid) << run << ": " << word_of(fault.check) << ", block " << fault.index;
        fault = check_start(scene);
        ASSERT_EQ(fault.check, SceneCheck::valid) << run << ": " << word_of(fault.check) << ", block " << fault.index;
    }
    // The slopes are worth cutting.
    EXPECT_GT(blocks, 20U * runs);
}

}  // namespace
}  // namespace delabole
