// Whether a jointed slope stands does not depend on how it is drawn.
#include "dynamic_relaxation/study/strength_bound.hpp"
#include "tests/support/random_slopes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <map>
#include <numeric>
#include <string>
#include <vector>

namespace delabole {
namespace {

// These small slopes are soon decided; DELABOLE_SLOPES=n tests the first n, which takes a minute for every three, and
// counts the variants that agree.
std::vector<std::uint32_t> seeds() {
    if (const char* const count = std::getenv("DELABOLE_SLOPES")) {
        std::vector<std::uint32_t> all(std::stoul(count));
        std::iota(all.begin(), all.end(), 1U);
        return all;
    }
    // Corners hold seed 43; seeds 74 and 89 fell where their edges had more vertices. A sliver at the toe of seed 102
    // is a part of the rock in front. Where the joint of seed 88 is drawn on, a sliver is taken away at the toe: the
    // tip above the gap held a factor of 0.83 instead of 0.47; where that of seed 23 is, a block slid into the gap and
    // stood up to 4.45 instead of 0.76. A run of seed 28 has no verdict.
    return {3, 4, 7, 9, 18, 23, 28, 43, 71, 74, 88, 89, 102};
}

TEST(RandomSlopes, StandOrFailTheSameHoweverTheyAreDrawn) {
    struct Count {
        std::size_t agree = 0;
        std::size_t of = 0;
    };
    std::map<std::string, Count> counts;
    std::size_t stand = 0;
    std::size_t held_by_corners = 0;
    std::size_t caught_otherwise = 0;
    std::size_t drawn_on = 0;
    std::size_t weaker = 0;
    std::size_t stronger = 0;
    for (const std::uint32_t seed : seeds()) {
        const RelaxationStudy study = testing::random_slope(seed);
        const std::vector<testing::Variant> variants = testing::verdicts_of(study, seed);
        const testing::Verdict verdict = variants.front().verdict;
        for (const testing::Variant& variant : variants) {
            EXPECT_EQ(variant.verdict == testing::Verdict::stands, verdict == testing::Verdict::stands)
                << seed << ", " << variant.name << ", " << testing::drawn(study).scene.block.size() << " blocks";
            caught_otherwise += variant.verdict == verdict ? 0 : 1;
            Count& count = counts[variant.name];
            count.agree += variant.verdict == verdict ? 1 : 0;
            ++count.of;
        }
        EXPECT_NE(verdict, testing::Verdict::none) << seed;
        if (testing::has_lines(study)) {
            const bool stands =
                testing::verdict_of(testing::drawn(testing::with_lines_drawn_on(study))) == testing::Verdict::stands;
            ++drawn_on;
            weaker += !stands && verdict == testing::Verdict::stands ? 1 : 0;
            stronger += stands && verdict != testing::Verdict::stands ? 1 : 0;
        }
        const std::optional<double> reduction = greatest_strength_reduction(testing::drawn(study).scene);
        ASSERT_TRUE(reduction) << seed;
        // It could fail: forces in balance promise standing only where joints dilate as they slip. None of 200 does.
        EXPECT_EQ(verdict == testing::Verdict::stands, *reduction >= 1) << seed;
        stand += verdict == testing::Verdict::stands ? 1 : 0;
        held_by_corners += verdict == testing::Verdict::held_by_corners ? 1 : 0;
    }
    EXPECT_GT(stand, 0U);
    EXPECT_GT(held_by_corners, 0U);
    // Corners may catch blocks that do not stand, and rounding decides whether they do: seed 89 is caught if turned.
    EXPECT_LE(caught_otherwise, seeds().size() / 9);
    EXPECT_GT(drawn_on, 0U);
    // A sliver may be just small enough to be taken away, where smaller blocks elsewhere make it none: seed 44.
    EXPECT_LE(stronger, seeds().size() / 200);
    std::cout << drawn_on << " with lines drawn on, of which " << weaker << " stand no longer and " << stronger
              << " stand only then\n";
    std::cout << stand << " stand, " << held_by_corners << " are held by corners\n";
    for (const auto& [name, count] : counts) {
        std::cout << name << ": " << count.agree << " of " << count.of << '\n';
    }
}

// Brackets of a search that begins at the same ratio are the same, or beside each other where rounding decides.
TEST(RandomSlopes, HaveOneFactorOfSafetyHoweverTheyAreDrawn) {
    constexpr std::size_t most_blocks = 60;  // a search takes a second then
    // Corners on corners that carry less than a thousandth of a block's weight are let pass (corner_choice.hpp); the
    // bound of statics allows none. Seed 71 drawn on stands 0.15 % above the bound.
    constexpr double near_bound = 1.002;
    std::map<std::string, std::size_t> agree;
    std::size_t searched = 0;
    std::size_t found = 0;
    std::size_t without_bound = 0;  // the linear programme came to no end
    for (const std::uint32_t seed : seeds()) {
        RelaxationStudy study = testing::random_slope(seed);
        const RelaxationScene scene = testing::drawn(study).scene;
        if (scene.block.size() > most_blocks) {
            continue;
        }
        study.critical = ReductionSearch{};
        const CriticalAnswer answer = find_critical(study);
        const std::optional<double> bound = greatest_strength_reduction(scene);
        ASSERT_TRUE(bound) << seed;
        ++searched;
        // A run that was stopped, by an overlap or its energy, or came to no end must not leave the search unanswered.
        EXPECT_NE(answer.status, CriticalStatus::run_failed) << seed;
        EXPECT_NE(answer.status, CriticalStatus::undecided) << seed;
        if (answer.status == CriticalStatus::found) {
            EXPECT_LE(answer.stands, *bound * near_bound) << seed;
            ASSERT_TRUE(answer.failed) << seed;
            EXPECT_TRUE(std::ranges::any_of(answer.failed->result.block, [](const BlockOutcome& block) {
                return block.movement != BlockMovement::stays && block.movement != BlockMovement::fixed;
            })) << seed;
            ++found;
        }
        const std::vector<std::pair<std::string, RelaxationStudy>> redrawn{
            {"mirrored", testing::mirrored(study)},
            {"set by another trace", testing::with_sets_by_another_trace(study)},
            {"lines drawn on", testing::with_lines_drawn_on(study)},
            {"cuts in reverse", testing::with_cuts_reversed(study)}};
        for (const auto& [name, other] : redrawn) {
            const CriticalAnswer again = find_critical(other);
            if (again.status == CriticalStatus::found) {
                const std::optional<double> of_other = greatest_strength_reduction(testing::drawn(other).scene);
                without_bound += of_other ? 0 : 1;
                EXPECT_LE(again.stands, of_other.value_or(*bound) * near_bound) << seed << ", " << name;
            }
            EXPECT_EQ(again.status, answer.status) << seed << ", " << name;
            const bool weaker = name == "lines drawn on" && again.stands <= answer.fails;
            const bool alike = answer.status != CriticalStatus::found || weaker ||
                               (again.stands <= answer.fails && again.fails >= answer.stands);
            EXPECT_TRUE(alike) << seed << ", " << name << ": " << again.stands << " to " << again.fails << ", not "
                               << answer.stands << " to " << answer.fails;
            agree[name] += alike && again.status == answer.status ? 1 : 0;
        }
    }
    EXPECT_GT(found, 0U);
    EXPECT_LE(without_bound, searched / 25);
    std::cout << searched << " searches, " << found << " with a factor\n";
    for (const auto& [name, count] : agree) {
        std::cout << name << ": " << count << " of " << searched << '\n';
    }
}

}  // namespace
}  // namespace delabole
