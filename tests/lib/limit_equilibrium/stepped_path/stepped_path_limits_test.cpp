// Stepped surfaces at the limits of water, of what is searched and of what there is to find.
#include "limit_equilibrium/stepped_path/stepped_path.hpp"
#include "tests/lib/limit_equilibrium/stepped_path/west_face.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace delabole {
namespace {

// Steps that run down below the toe stand in water that reaches no higher than it.
TEST(SteppedPath, WaterAtTheToeIsTheLimitOfWaterAboveIt) {
    for (const auto mechanism :
         {SteppedPathMechanism::toppling, SteppedPathMechanism::slide_head_toppling, SteppedPathMechanism::sliding}) {
        SteppedPath path = west_face(mechanism);
        path.steps = {degrees(-20), 8, degrees(26.5), 0};
        path.columns->spacing = 4;
        const auto at = [&](double depth) {
            path.water = WaterTable<>{9.81e3, WaterDepth<>{depth}};
            return analyse(path).factor_of_safety;
        };
        const double least = at(1e-6);
        EXPECT_TRUE(at(0) == least || std::abs(at(0) - least) < 1e-6 * least);  // per micrometre some 1e-8
        path.slope.toe_elevation = 100;
        path.water = WaterTable<>{9.81e3, WaterElevation<>{40}};
        const double below = analyse(path).factor_of_safety;
        path.water = Dry{};
        EXPECT_EQ(below, analyse(path).factor_of_safety);
    }
}

// A push steadies squat columns that water turns, so that less push from above may ask more of the toe. If surfaces may
// come out further behind the crest there are more of them, and none is stronger.
TEST(SteppedPath, ColumnsThatAPushSteadiesHideNoWeakerSurface) {
    SteppedPath known = west_face(SteppedPathMechanism::toppling);
    known.search = {SteppedPathMechanism::toppling, 3.682571386414936, std::nullopt};
    known.slope = {18.95182868537451, 1.1019895428700304, 0, std::nullopt, std::nullopt};
    known.steps = {-0.484615727983778, 7.995699246386037, 0.48357044722635795, 34205.85497250976};
    known.columns = PathColumns{-1.355928569880374, 3.9989737544090103, 0.3410203734495386};
    known.rock = {15722.832491810772};
    known.water = WaterTable<>{9.81e3, WaterDepth<>{8.117920095331034}};
    known.search.greatest_retreat = 12;
    const double of_fewer = analyse(known).factor_of_safety;
    known.search.greatest_retreat = 15.447053944406456;
    EXPECT_LE(analyse(known).factor_of_safety, of_fewer * (1 + 1e-9));
}

// On ground that falls behind the crest joints come out closer than on level ground.
TEST(SteppedPath, ExtentCountsWhereTheNextJointComesOut) {
    SteppedPath path = west_face(SteppedPathMechanism::toppling);
    path.columns->spacing = 3;
    path.water = Dry{};
    const double level = path.search.greatest_retreat.value_or(path.slope.height);
    for (const double dip : {-20.0, 0.0, 20.0}) {
        path.slope.upper_surface_dip = degrees(dip);
        path.search.greatest_retreat = level;
        const SteppedPathResult all = analyse(path);
        ASSERT_EQ(all.extent, PathExtent::greatest) << dip;
        const double pitch =
            3 / (std::sin(degrees(85)) + std::cos(degrees(85)) * std::tan(degrees(dip)));  // between outcrops
        for (const double share : {0.01, 0.99}) {
            path.search.greatest_retreat = all.retreat + share * pitch;
            EXPECT_NEAR(analyse(path).retreat, all.retreat, 1e-9 * all.retreat) << dip;
            EXPECT_EQ(analyse(path).extent, PathExtent::greatest) << dip << ' ' << share;
        }
    }
}

}  // namespace
}  // namespace delabole
