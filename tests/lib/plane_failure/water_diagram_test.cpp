#include "plane_failure/water_diagram.hpp"

#include "plane_failure/plane_failure.hpp"
#include "water/column_tilt.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace delabole {
namespace {

PlaneFailure<> slope_with(Water<> water) {
    PlaneFailure<> slope{};
    slope.slope = {
        .height = 30, .face_dip = degrees(65), .upper_surface_dip = degrees(5), .bench = {}, .toe_elevation = 100};
    slope.failure_plane.dip = degrees(38);
    slope.tension_crack = TensionCrack<>{degrees(80), CrackAtDistance<>{6}};
    slope.rock.unit_weight = 26e3;
    slope.strength = Coulomb<>{20e3, degrees(35)};
    slope.water = std::move(water);
    return slope;
}

double integral(const SurfacePressure& surface) {
    double force = 0;
    for (std::size_t index = 1; index < surface.surface.size(); ++index) {
        force += (surface.surface[index] - surface.surface[index - 1]).norm() *
                 (surface.pressure[index] + surface.pressure[index - 1]) / 2;
    }
    return force;
}

TEST(WaterDiagram, IntegratesToTheForcesOfTheBalance) {
    const std::vector<Water<>> forms = {
        Dry{},
        CrackAndBaseWater<>{9810, FilledRatio<>{0.7}},
        CrackOnlyWater<>{9810, WaterDepth<>{5}},
        BasePeakMidHeightWater<>{9810, FilledRatio<>{0.9}},
        PeakAtToeWater<>{9810, WaterElevation<>{120}},
        PiezometricLineWater<>{9810, {{0, 5}, {10, 14}, {40, 26}}},
        CustomWater<>{{{0, 60e3}, {0.8, 0}}, {{0, 40e3}, {0.5, 30e3}, {1, 60e3}}},
    };
    for (const bool pond : {false, true}) {
        for (const Water<>& form : forms) {
            PlaneFailure<> slope = slope_with(form);
            if (pond) {
                slope.pond = Pond<>{4, 9810};
            }
            const PlaneFailureResult result = analyse(slope);
            ASSERT_EQ(result.check, PlaneFailureCheck::valid) << form.index();
            const WaterDiagram diagram = water_diagram(slope);
            // 200 intervals: a kink inside one costs at most an eighth of (spacing / length)^2 of peak times length,
            // some 1e-5 of the force; 1e-3 leaves room for forms that wet a small part of the surface.
            const auto expect_same = [&](double integrated, double force) {
                EXPECT_NEAR(integrated, force, 1e-3 * force + 1e-9) << "form " << form.index() << " pond " << pond;
            };
            expect_same(integral(diagram.base), result.base_water_force);
            expect_same(integral(diagram.crack), result.crack_water_force);
        }
    }
}

TEST(WaterDiagram, IsEmptyForAnImpossibleSlope) {
    PlaneFailure<> slope = slope_with(Dry{});
    slope.failure_plane.dip = degrees(70);
    EXPECT_TRUE(water_diagram(slope).base.surface.empty());
}

TEST(ColumnTilt, FollowsFromTheSaturatedTilt) {
    const TiltedColumn<> saturated{degrees(70), degrees(47.5), 1};
    // The input comes back: atan2 and tan are inverse to a few rounding errors.
    EXPECT_NEAR(analyse(saturated).tilt, degrees(47.5), 1e-15);
    const ColumnTilt half = analyse(TiltedColumn<>{degrees(70), degrees(47.5), 0.5});
    EXPECT_NEAR(half.tilt / degrees(1), 12, 0.5);  // thesis 2.3.5 prints whole degrees
    EXPECT_DOUBLE_EQ(half.water_force_over_weight, analyse(saturated).water_force_over_weight / 4);
    EXPECT_EQ(analyse(TiltedColumn<>{degrees(70), degrees(47.5), 0}).tilt, 0);
}

TEST(ColumnTilt, InterfaceRefusesWhatIsOutOfRange) {
    const ModelInterface model = model_interface(TiltedColumn<>{degrees(70), degrees(47.5), 0.5});
    ASSERT_EQ(model.inputs.size(), 3U);
    const Assignment full{2, 1.0};
    EXPECT_NEAR(model.predict(std::span(&full, 1)).outputs.front(), degrees(47.5), 1e-15);
    const Assignment overfull{2, 1.5};
    EXPECT_EQ(model.predict(std::span(&overfull, 1)).failure, "input_out_of_range");
}

}  // namespace
}  // namespace delabole
