// Reports of stepped surfaces first name what fails first: the surface, rock on a single riser, or a toe.
#include "cases/program/results/analysis.hpp"
#include "cases/program/results/model_reports.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace delabole {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Made up: the factors of the surface and of a single riser.
SteppedPathResult with_factors(double of_surface, double on_riser, LimitState limit = LimitState::found) {
    SteppedPathResult result;
    result.check = SteppedPathCheck::valid;
    result.limit = limit;
    result.factor_of_safety = of_surface;
    result.factor_on_riser = on_riser;
    result.factor_of_toe = infinity;
    result.failed_area = 100;
    if (of_surface < infinity) {
        result.surface = {{0, 0}, {10, 1}, {12, 20}};
    }
    return result;
}

TEST(SteppedPathReport, TheLeastFactorComesFirst) {
    const HeadCard stands = head_card(SteppedPath{}, with_factors(1.5, infinity));
    EXPECT_EQ(stands.tone, AnswerTone::good);
    EXPECT_EQ(stands.sentences.front(), "FS 1.5: stands.");
    const HeadCard slides = head_card(SteppedPath{}, with_factors(4.43, 0.333));
    EXPECT_EQ(slides.tone, AnswerTone::bad);
    EXPECT_EQ(slides.sentences[0], "FS 0.333, on a single riser: fails.");
    EXPECT_EQ(slides.sentences[1], "Along the surface that is searched for: FS 4.43.");
    const HeadCard no_surface =
        head_card(SteppedPath{}, with_factors(infinity, 0.333, LimitState::holds_at_any_strength));
    EXPECT_EQ(no_surface.tone, AnswerTone::bad);
    EXPECT_EQ(no_surface.sentences[0], "FS 0.333, on a single riser: fails.");
    EXPECT_EQ(no_surface.sentences[1], "No surface along steps and risers moves, even without strength.");
    EXPECT_EQ(named_outputs(SteppedPath{}, with_factors(4.43, 0.333)).warnings.size(), 1U);
    EXPECT_TRUE(named_outputs(SteppedPath{}, with_factors(4.43, infinity)).warnings.empty());
}

TEST(SteppedPathReport, AToeThatFailsBeforeTheMassIsNotSaidToStand) {
    const HeadCard open = head_card(SteppedPath{}, with_factors(8.01, infinity, LimitState::abrupt));
    EXPECT_EQ(open.tone, AnswerTone::open);
    EXPECT_EQ(open.sentences.front(), "FS 8.01 for the mass as a whole; its toe alone fails before.");
    const HeadCard both = head_card(SteppedPath{}, with_factors(8.01, 1.2, LimitState::abrupt));
    EXPECT_EQ(both.tone, AnswerTone::open);
    EXPECT_EQ(both.sentences[0], "FS 1.2, on a single riser.");
    EXPECT_EQ(both.sentences[1], "FS 8.01 for the mass as a whole; its toe alone fails before.");
    EXPECT_EQ(head_card(SteppedPath{}, with_factors(0.8, infinity, LimitState::abrupt)).tone, AnswerTone::bad);
}

TEST(SteppedPathReport, AToeThatFailsByItselfComesFirst) {
    SteppedPathResult result = with_factors(1.28, infinity);
    result.factor_of_toe = 0.748;
    const HeadCard fails = head_card(SteppedPath{}, result);
    EXPECT_EQ(fails.tone, AnswerTone::bad);
    EXPECT_EQ(fails.sentences[0], "FS 0.748, columns at the toe alone: fails.");
    EXPECT_EQ(fails.sentences[1], "Along the surface that is searched for: FS 1.28.");
    EXPECT_EQ(named_outputs(SteppedPath{}, result).warnings.size(), 1U);
    result.factor_on_riser = 0.5;
    const HeadCard both = head_card(SteppedPath{}, result);
    EXPECT_EQ(both.sentences[0], "FS 0.5, on a single riser: fails.");
    EXPECT_EQ(both.sentences[1], "FS 0.748, columns at the toe alone.");
    result = with_factors(8.01, infinity, LimitState::abrupt);
    result.factor_of_toe = 0.9;
    EXPECT_EQ(head_card(SteppedPath{}, result).tone, AnswerTone::bad);
    result.factor_of_toe = 1.1;
    EXPECT_EQ(head_card(SteppedPath{}, result).tone, AnswerTone::open);
    result.factor_of_toe = 9;
    EXPECT_EQ(head_card(SteppedPath{}, result).sentences.front(),
              "FS 8.01 for the mass as a whole; its toe alone fails before.");
}

}  // namespace
}  // namespace delabole
