// The cheapest support against trying everything.
#include "fitting/studies/support_design.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace delabole {
namespace {

// A factor of safety that grows with the force of the bolts, and none for bolts longer than 9 m.
double factor_of(double rows, double spacing, double length) {
    return 0.8 + 0.1 * rows / spacing * std::sqrt(length);
}

ModelInterface bolted() {
    ModelInterface model;
    for (const auto& [name, value] :
         {std::pair{"support[1].rows", 2.0}, {"support[1].spacing", 2.0}, {"support[1].length", 6.0}}) {
        model.inputs.push_back({name, Dimension::ratio, "", {}, value});
    }
    model.outputs = {{"factor_of_safety", Dimension::ratio, ""}};
    model.predict = [](std::span<const Assignment> assignments) {
        std::array<double, 3> value{2, 2, 6};
        for (const Assignment& assignment : assignments) {
            value[assignment.input] = assignment.value;
        }
        return value[2] > 9 ? Prediction{"too_long", {}, {}}
                            : Prediction{{}, {factor_of(value[0], value[1], value[2])}, {}};
    };
    return model;
}

SupportDesign wanted(double factor) {
    return {factor,
            120,
            35,
            {{"support[1].rows", 1, 6, 6}, {"support[1].spacing", 1, 3, 5}, {"support[1].length", 4, 12, 9}}};
}

TEST(SupportDesign, FindsTheCheapestOfAll) {
    for (const double factor : {0.9, 1.3, 1.7, 2.2}) {
        const SupportDesign design = wanted(factor);
        double least = std::numeric_limits<double>::infinity();
        for (double rows = 1; rows <= 6; ++rows) {
            for (double spacing = 1; spacing <= 3; spacing += 0.5) {
                for (double length = 4; length <= 9; ++length) {
                    if (factor_of(rows, spacing, length) >= factor) {
                        least = std::min(least, rows / spacing * (120 + 35 * length));
                    }
                }
            }
        }
        const SupportDesignResult result = design_support(bolted(), design);
        ASSERT_TRUE(result.cheapest);
        EXPECT_NEAR(result.tried[*result.cheapest].cost, least, 1e-9 * least);
        EXPECT_GE(*result.tried[*result.cheapest].factor_of_safety, factor);
        EXPECT_EQ(*result.cheapest + 1, result.tried.size()) << "the search ends with it";
        EXPECT_TRUE(std::ranges::is_sorted(result.tried, {}, &TriedSupport::cost));
        EXPECT_EQ(result.patterns, 270U);
    }
}

// Patterns with bolts shorter than 8 m leave one slope of an ensemble at the lower bound of its search.
TEST(SupportDesign, AMeanThatIsAtMostAFactorDoesNotReachIt) {
    ModelInterface model = bolted();
    const std::size_t length = place_of(model.inputs, "support[1].length").value();
    const std::size_t factor = place_of(model.outputs, "factor_of_safety").value();
    const std::size_t at_lower = model.outputs.size();
    model.outputs.push_back({"at_lower", Dimension::ratio, ""});
    model.outputs.push_back({"at_upper", Dimension::ratio, ""});
    model.bounded_outputs = {{factor, at_lower, at_lower + 1}};
    model.predict = [=, whole = bolted().predict](std::span<const Assignment> assignments) {
        Prediction prediction = whole(assignments);
        if (prediction.failure.empty()) {
            const auto bolt = std::ranges::find(assignments, length, &Assignment::input);
            prediction.outputs.insert(prediction.outputs.end(), {bolt->value < 8 ? 1.0 : 0.0, 0.0});
        }
        return prediction;
    };
    const SupportDesignResult result = design_support(model, wanted(1.3));
    ASSERT_TRUE(result.cheapest);
    EXPECT_GE(result.tried[*result.cheapest].values[2], 8);
    EXPECT_GE(*result.tried[*result.cheapest].factor_of_safety, 1.3);
    EXPECT_GT(result.failed_by_cause.at(std::string(known_as_bound)), 0U);
}

TEST(SupportDesign, TellsTheStrongestWhereNoneSuffices) {
    const SupportDesignResult result = design_support(bolted(), wanted(10));
    EXPECT_FALSE(result.cheapest);
    ASSERT_TRUE(result.strongest);
    EXPECT_EQ(result.tried.size(), 270U);
    EXPECT_EQ(*result.tried[*result.strongest].factor_of_safety, factor_of(6, 1, 9));
    EXPECT_EQ(result.failed_by_cause.at("too_long"), 90U);
}

}  // namespace
}  // namespace delabole
