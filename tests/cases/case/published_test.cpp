// The published problems of jointed slopes: all are read, and the quick ones have the factors that they expect.
#include "cases/program/case/case_file.hpp"
#include "cases/program/thesis/thesis_tables.hpp"
#include "dynamic_relaxation/study/relaxation_study.hpp"
#include "dynamic_relaxation/study/strength_bound.hpp"
#include "tests/support/random_slopes.hpp"
#include "tests/support/redrawn_studies.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <map>
#include <optional>
#include <sstream>
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
        EXPECT_NE(built_in_table("published/published_factors.csv").find("," + std::string(built_in.name) + ","),
                  std::string::npos)
            << built_in.name << " is not in the table of published factors";
    }
    EXPECT_EQ(count, 23U);  // problem RJ-1 has four variants
}

// These are the problems whose search takes less than a second or two of processor time.
TEST(PublishedProblems, QuickOnesHaveTheFactorsThatTheyExpect) {
    for (const std::string_view name : {"rj_1a", "rj_1b", "rj_1d", "rj_2", "rj_6"}) {
        const CaseFile file = published_case(name);
        const Expectation& expected = file.expectations.front();
        const CriticalAnswer answer = find_critical(std::get<RelaxationStudy>(file.model));
        ASSERT_EQ(answer.status, CriticalStatus::found) << name;
        EXPECT_NEAR(answer.value(), std::get<double>(expected.value), std::get<double>(*expected.tolerance)) << name;
    }
}

// The base of RJ-2 ends at the toe: ground drawn level with it meets the sharp tip of the lowest block corner on
// corner. Forces within the strength of the faces alone exist up to 0.940, but only the corner keeps the blocks from
// sliding.
TEST(PublishedProblems, LevelGroundAtTheToeHoldsNothing) {
    const CaseFile file = published_case("rj_2");
    RelaxationStudy study = std::get<RelaxationStudy>(file.model);
    std::vector<SectionPoint>& outline = std::get<RelaxationSlope>(study.model.scene).geometry.outline;
    ASSERT_EQ(std::erase_if(outline, [](const SectionPoint& point) { return point.x == 0 && point.y < 0; }), 1U);
    outline.back().y = 0;
    const CriticalAnswer answer = find_critical(study);
    ASSERT_EQ(answer.status, CriticalStatus::found);
    const Expectation& expected = file.expectations.front();
    EXPECT_NEAR(answer.value(), std::get<double>(expected.value), std::get<double>(*expected.tolerance));
    EXPECT_TRUE(answer.held_by_corners);
}

// A redrawn study; `sign` and `shift` turn the value found there into that of the study as drawn.
struct Redrawn {
    std::string name;
    RelaxationStudy study;
    double sign = 1;
    double shift = 0;  // of a tilt, rad
};

// Draws the study in all possible ways; the first is the study itself. Only jointed slopes can have their sets begin at
// another trace.
std::vector<Redrawn> redrawn(const RelaxationStudy& study) {
    const RelaxationStudy polygons = testing::as_polygons(study);
    const bool tilts = std::holds_alternative<TiltSearch>(*study.critical);
    constexpr double turn = 0.6;
    std::vector<Redrawn> all{{"as drawn", study},
                             {"as polygons", polygons},
                             {"mirrored", testing::polygons_mirrored(polygons), tilts ? -1.0 : 1.0},
                             {"turned", testing::polygons_turned(polygons, turn), 1, tilts ? turn : 0},
                             {"moved by 10 km", testing::polygons_moved_away(polygons, 1e4)},
                             {"a hundredth of the size", testing::polygons_scaled(polygons, 1e-2)},
                             {"a thousand times the size", testing::polygons_scaled(polygons, 1e3)},
                             {"other order", testing::polygons_in_another_order(polygons, 1)},
                             {"more vertices", testing::polygons_with_more_vertices(polygons)}};
    if (std::holds_alternative<RelaxationSlope>(study.model.scene)) {
        all.push_back({"sets by another trace", testing::with_sets_by_another_trace(study)});
        // A set that ends on another has to come after it.
        if (const RelaxationStudy reversed = testing::with_cuts_reversed(study);
            check(reversed).check == SceneCheck::valid) {
            all.push_back({"cuts in reverse", reversed});
        }
    }
    return all;
}

// These have toppling columns with and without a force, blocks that slide on daylighting joints, and bonded rock.
// DELABOLE_PUBLISHED=all (an hour) or a list of names tests others and counts the drawings that agree.
TEST(PublishedProblems, HaveOneFactorHoweverTheyAreDrawn) {
    std::vector<std::string> names{"rj_1d", "rj_2", "rj_6", "rj_19"};
    if (const char* const asked = std::getenv("DELABOLE_PUBLISHED")) {
        names.clear();
        std::istringstream words(asked);
        for (std::string word; words >> word;) {
            names.push_back(word);
        }
        if (names == std::vector<std::string>{"all"}) {
            names.clear();
            for (const BuiltInCase& built_in : built_in_cases()) {
                if (built_in.folder == "published") {
                    names.emplace_back(built_in.name);
                }
            }
        }
    }
    std::map<std::string, std::pair<std::size_t, std::size_t>> held;
    for (const std::string& name : names) {
        const std::vector<Redrawn> drawings = redrawn(std::get<RelaxationStudy>(published_case(name).model));
        std::optional<CriticalAnswer> as_drawn;
        for (const Redrawn& drawing : drawings) {
            const CriticalAnswer answer = find_critical(drawing.study);
            if (!as_drawn) {
                as_drawn = answer;
                StudyWork work;
                work.threads = 2;
                EXPECT_EQ(find_critical(drawing.study, work).value(), answer.value()) << name << ", two threads";
            }
            const double value = drawing.sign * answer.value() + drawing.shift;
            // Rounding may lead the bisection to the neighbouring bracket.
            const double allowed = 1.01 * std::abs(as_drawn->fails - as_drawn->stands);
            const bool same = answer.status == as_drawn->status && std::abs(value - as_drawn->value()) <= allowed;
            EXPECT_TRUE(same) << name << ", " << drawing.name << ": " << word_of(answer.status) << " " << value
                              << ", as drawn " << word_of(as_drawn->status) << " " << as_drawn->value();
            held[drawing.name].first += same ? 1 : 0;
            ++held[drawing.name].second;
        }
    }
    for (const auto& [name, count] : held) {
        std::cout << name << ": " << count.first << " of " << count.second << '\n';
    }
}

RelaxationScene published_scene(std::string_view name) {
    return relaxation_scene(std::get<RelaxationStudy>(published_case(name).model));
}

// The published bounds have five digits and two rigid blocks each; as in RJ-6 the blocks that slide are the ones drawn.
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
