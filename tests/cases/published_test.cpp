// The published problems of jointed slopes: all are read, and the quick ones have the factors that they expect.
#include "cases/program/case/case_file.hpp"
#include "cases/program/thesis/thesis_tables.hpp"
#include "dynamic_relaxation/study/relaxation_study.hpp"
#include "dynamic_relaxation/study/strength_bound.hpp"
#include "tests/support/random_slopes.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace delabole {
namespace {

CaseFile published_case(std::string_view name) {
    return built_in_case("published", name);
}

TEST(PublishedProblems, AreReadAndSayWhatTheyExpect) {
    std::size_t count = 0;
    for (const BuiltInCase& built_in : built_in_cases()) {
        if (built_in.folder != "published") {
            continue;
        }
        ++count;
        const CaseFile file = published_case(built_in.name);
        const auto& study = std::get<RelaxationStudy>(file.model);
        ASSERT_TRUE(study.critical) << built_in.name;
        EXPECT_EQ(check(study).check, SceneCheck::valid) << built_in.name;
        ASSERT_EQ(file.expectations.size(), 1U) << built_in.name;
        EXPECT_EQ(file.expectations.front().quantity, name_of_critical(parameter_of(*study.critical)));
        EXPECT_NE(std::string(thesis_published_factors).find("," + std::string(built_in.name) + ","), std::string::npos)
            << built_in.name << " is not in the table of published factors";
    }
    EXPECT_EQ(count, 20U);  // RJ-1 has four
}

// Those whose search takes less than a second or two of processor time.
TEST(PublishedProblems, QuickOnesHaveTheFactorsThatTheyExpect) {
    for (const std::string_view name : {"rj_1a", "rj_1b", "rj_1d", "rj_2", "rj_6"}) {
        const CaseFile file = published_case(name);
        const Expectation& expected = file.expectations.front();
        const CriticalAnswer answer = find_critical(std::get<RelaxationStudy>(file.model));
        ASSERT_EQ(answer.status, CriticalStatus::found) << name;
        EXPECT_NEAR(answer.value(), std::get<double>(expected.value), std::get<double>(*expected.tolerance)) << name;
    }
}

// Columns that topple, and blocks that slide on joints which daylight.
TEST(PublishedProblems, HaveOneFactorHoweverTheyAreDrawn) {
    for (const std::string_view name : {"rj_2", "rj_6"}) {
        const auto study = std::get<RelaxationStudy>(published_case(name).model);
        const CriticalAnswer as_drawn = find_critical(study);
        for (const RelaxationStudy& other : {testing::mirrored(study), testing::with_sets_by_another_trace(study)}) {
            const CriticalAnswer answer = find_critical(other);
            ASSERT_EQ(answer.status, CriticalStatus::found) << name;
            // Rounding may take the bracket to the next one.
            EXPECT_NEAR(answer.value(), as_drawn.value(), 1.01 * (as_drawn.fails - as_drawn.stands)) << name;
        }
    }
}

RelaxationScene published_scene(std::string_view name) {
    return relaxation_scene(std::get<RelaxationStudy>(published_case(name).model));
}

// Of two rigid blocks each, published with five digits; as in RJ-6 the blocks that slide are the ones drawn.
TEST(PublishedProblems, StaticsAloneGivesTheBoundsOfRigidBlocks) {
    const std::vector<std::pair<std::string_view, double>> bounds{
        {"rj_6", 1.3264}, {"rj_11", 1.2148}, {"rj_12", 2.0324}, {"rj_13", 0.9988}, {"rj_14", 1.2686}};
    for (const auto& [name, bound] : bounds) {
        const std::optional<double> found = greatest_strength_reduction(published_scene(name));
        ASSERT_TRUE(found) << name;
        EXPECT_NEAR(*found, bound, 1e-4) << name;  // coordinates are printed to 0.1 mm
    }
}

TEST(PublishedProblems, StaticsAloneSaysNothingOfLoadsToCome) {
    RelaxationScene scene = published_scene("rj_11");
    scene.removal.push_back({0, 1});
    EXPECT_FALSE(greatest_strength_reduction(scene));
    scene = published_scene("rj_11");
    for (JointMaterial& joint : scene.material) {
        joint.friction_angle = 0;
    }
    EXPECT_EQ(greatest_strength_reduction(scene), 0);
}

}  // namespace
}  // namespace delabole
