#include "wedge_failure/wedge_failure.hpp"

#include "kinematics/criteria.hpp"

#include "tests/lib/wedge_failure/reference_wedge.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <string_view>

namespace delabole {
namespace {

constexpr double foot = 0.3048;
constexpr double pound_per_square_foot = 47.880258980335839;
constexpr double pound_per_cubic_foot = pound_per_square_foot / foot;

// Hoek & Bray's example of the complete solution.
WedgeFailure example() {
    WedgeFailure wedge{};
    wedge.slope = {100 * foot, degrees(65), degrees(185), degrees(12), degrees(195)};
    wedge.plane_1 = {degrees(45), degrees(105), Coulomb<>{500 * pound_per_square_foot, degrees(20)}};
    wedge.plane_2 = {degrees(70), degrees(235), Coulomb<>{1000 * pound_per_square_foot, degrees(30)}};
    wedge.tension_crack = WedgeCrack{degrees(70), degrees(165), 40 * foot};
    wedge.rock = {160 * pound_per_cubic_foot};
    wedge.water = FilledFissures{62.5 * pound_per_cubic_foot, 1};
    return wedge;
}

// Draws any planes and loads: most do not make a wedge, and the caller skips them.
class RandomWedges {
  public:
    explicit RandomWedges(unsigned seed) : generator_(seed) {}

    double between(double lower, double upper) {
        return lower + (upper - lower) * static_cast<double>(generator_()) / 4294967296.0;
    }

    WedgeFailure next() {
        WedgeFailure wedge{};
        const double azimuth = between(0, degrees(360));
        const auto aside = [&](double most) {
            return std::fmod(azimuth + degrees(360) + between(-most, most), degrees(360));
        };
        wedge.slope = {between(1, 100), between(degrees(30), degrees(110)), azimuth, between(0, degrees(25)),
                       aside(degrees(180))};
        wedge.plane_1 = {between(degrees(5), degrees(90)), aside(degrees(150)), strength()};
        wedge.plane_2 = {between(degrees(5), degrees(90)), aside(degrees(150)), strength()};
        wedge.rock = {between(15e3, 30e3)};
        const double weight = wedge.rock.unit_weight * std::pow(wedge.slope.height, 3);
        if (between(0, 1) < 0.5) {
            wedge.tension_crack =
                WedgeCrack{between(degrees(50), degrees(90)), aside(degrees(60)), between(0, wedge.slope.height)};
        }
        wedge.water = between(0, 1) < 0.5 ? WedgeWater(Dry{}) : FilledFissures{9810, between(0, 1)};
        if (between(0, 1) < 0.3) {
            wedge.seismic = WedgeSeismicLoad{between(-0.3, 0.3), {}, {}};
        }
        if (between(0, 1) < 0.3) {
            wedge.load = {{between(0, 0.02) * weight, between(degrees(-90), degrees(90)), between(0, degrees(360))}};
        }
        for (const BoltAction action : {BoltAction::active, BoltAction::passive}) {
            if (between(0, 1) < 0.3) {
                wedge.bolt.push_back({between(0, 0.02) * weight, between(degrees(-30), degrees(30)),
                                      std::fmod(azimuth + degrees(180), degrees(360)), action});
            }
        }
        return wedge;
    }

  private:
    StrengthLaw<> strength() { return Coulomb<>{between(0, 50e3), between(degrees(10), degrees(45))}; }

    std::mt19937 generator_;
};

double factor_of(const WedgeFailure& wedge) {
    const WedgeFailureResult result = analyse(wedge);
    return result.check == WedgeFailureCheck::valid ? result.factor_of_safety : std::nan("");
}

TEST(WedgeFailure, HoekAndBraysExampleAgreesWithFiftyDigits) {
    for (const double ratio : {0.0, 0.5, 1.0}) {
        WedgeFailure wedge = example();
        std::get<FilledFissures>(wedge.water).filled_ratio = ratio;
        const WedgeFailureResult result = analyse(wedge);
        ASSERT_EQ(result.check, WedgeFailureCheck::valid);
        EXPECT_EQ(result.contact, SlidingContact::both_planes);
        const auto reference = reference::solve_wedge(wedge);
        ASSERT_TRUE(reference);
        // A dozen roundings of double precision.
        constexpr double tolerance = 1e-14;
        EXPECT_NEAR(result.factor_of_safety / static_cast<double>(reference->factor_of_safety), 1, tolerance);
        EXPECT_NEAR(result.volume / static_cast<double>(reference->volume), 1, tolerance);
        EXPECT_NEAR(result.area_1 / static_cast<double>(reference->area_1), 1, tolerance);
        EXPECT_NEAR(result.area_2 / static_cast<double>(reference->area_2), 1, tolerance);
        EXPECT_NEAR(result.crack_area / static_cast<double>(reference->crack_area), 1, tolerance);
    }
}

TEST(WedgeFailure, RandomWedgesAgreeWithFiftyDigits) {
    RandomWedges wedges(1967);
    std::map<SlidingContact, int> contacts;
    int cracked = 0;
    for (int count = 0; count < 4000; ++count) {
        const WedgeFailure wedge = wedges.next();
        const WedgeFailureResult result = analyse(wedge);
        if (result.check != WedgeFailureCheck::valid) {
            continue;
        }
        const auto reference = reference::solve_wedge(wedge);
        ASSERT_TRUE(reference) << count;
        // Angles between the surfaces down to some thousandths of a radian, and normal forces that water nearly takes.
        EXPECT_NEAR(result.volume / static_cast<double>(reference->volume), 1, 1e-10) << count;
        EXPECT_NEAR(result.area_1 / static_cast<double>(reference->area_1), 1, 1e-10) << count;
        EXPECT_NEAR(result.area_2 / static_cast<double>(reference->area_2), 1, 1e-10) << count;
        const auto factor = static_cast<double>(reference->factor_of_safety);
        if (std::isfinite(result.factor_of_safety)) {
            EXPECT_NEAR(result.factor_of_safety, factor, 1e-9 * (1 + factor)) << count;
        } else {
            EXPECT_GT(factor, 1e299) << count;
        }
        ++contacts[result.contact];
        cracked += wedge.tension_crack ? 1 : 0;
    }
    EXPECT_GT(cracked, 50);
    for (const SlidingContact contact : {SlidingContact::none, SlidingContact::both_planes, SlidingContact::first_plane,
                                         SlidingContact::second_plane}) {
        EXPECT_GT(contacts[contact], 20) << word_of(contact);
    }
}

TEST(WedgeFailure, LengthsWithCohesionsAndWeightsWithCohesionsScale) {
    const double given = factor_of(example());
    WedgeFailure large = example();
    large.slope.height *= 10;
    large.tension_crack->distance *= 10;
    for (WedgePlane* plane : {&large.plane_1, &large.plane_2}) {
        std::get<Coulomb<>>(plane->strength).cohesion *= 10;
    }
    EXPECT_NEAR(factor_of(large), given, 1e-13);  // roundings of the lengths
    WedgeFailure heavy = example();
    heavy.rock.unit_weight *= 3;
    std::get<FilledFissures>(heavy.water).unit_weight *= 3;
    for (WedgePlane* plane : {&heavy.plane_1, &heavy.plane_2}) {
        std::get<Coulomb<>>(plane->strength).cohesion *= 3;
    }
    EXPECT_NEAR(factor_of(heavy), given, 1e-13);
}

TEST(WedgeFailure, TurningAndMirroringChangeNothing) {
    const double given = factor_of(example());
    const auto with_azimuths = [](auto change) {
        WedgeFailure wedge = example();
        for (double* azimuth :
             {&wedge.slope.face_dip_direction, &wedge.slope.upper_surface_dip_direction, &wedge.plane_1.dip_direction,
              &wedge.plane_2.dip_direction, &wedge.tension_crack->dip_direction}) {
            *azimuth = change(*azimuth);
        }
        return wedge;
    };
    EXPECT_NEAR(factor_of(with_azimuths([](double azimuth) { return azimuth + degrees(77); })), given, 1e-13);
    EXPECT_NEAR(factor_of(with_azimuths([](double azimuth) { return degrees(360) - azimuth; })), given, 1e-13);
}

TEST(WedgeFailure, EitherPlaneMayBeTheFirst) {
    RandomWedges wedges(7);
    int compared = 0;
    for (int count = 0; count < 2000; ++count) {
        WedgeFailure wedge = wedges.next();
        wedge.tension_crack.reset();
        const WedgeEquilibrium forces = evaluate(wedge);
        if (forces.check != WedgeFailureCheck::valid || !(forces.wedge.crest_2.z() > 0)) {
            continue;
        }
        WedgeFailure swapped = wedge;
        std::swap(swapped.plane_1, swapped.plane_2);
        swapped.slope.height = forces.wedge.crest_2.z();
        const double factor = factor_of(wedge);
        if (std::isfinite(factor)) {
            EXPECT_NEAR(factor_of(swapped), factor, 1e-8 * (1 + factor)) << count;  // the same wedge but for roundings
            ++compared;
        }
    }
    EXPECT_GT(compared, 200);
}

TEST(WedgeFailure, TwoPlanesAlikeSlideLikeOne) {
    // Planes that dip 35 deg, turned by an angle to either side of the face: the smaller it is, the nearer they come to
    // one plane that slides at tan(friction) / tan(dip).
    double before = 1;
    for (const double turn : {8.0, 4.0, 2.0, 1.0}) {
        WedgeFailure wedge{};
        wedge.slope = {20, degrees(60), degrees(180), 0, degrees(180)};
        wedge.plane_1 = {degrees(35), degrees(180 - turn), Coulomb<>{0, degrees(30)}};
        wedge.plane_2 = {degrees(35), degrees(180 + turn), Coulomb<>{0, degrees(30)}};
        wedge.rock = {26e3};
        wedge.water = Dry{};
        const double excess = factor_of(wedge) - std::tan(degrees(30)) / std::tan(degrees(35));
        EXPECT_GT(excess, 0) << turn;             // wedging holds
        EXPECT_LT(excess, 0.3 * before) << turn;  // falls with the square of the angle: to a quarter
        before = excess;
    }
    EXPECT_LT(before, 1e-3);
}

TEST(WedgeFailure, DryWedgesSlideAsKinematicsSays) {
    RandomWedges wedges(1977);
    int compared = 0;
    for (int count = 0; count < 4000; ++count) {
        WedgeFailure wedge = wedges.next();
        wedge.slope.face_dip = std::min(wedge.slope.face_dip, degrees(90));
        wedge.tension_crack.reset();
        wedge.water = Dry{};
        wedge.seismic.reset();
        wedge.load.clear();
        wedge.bolt.clear();
        const WedgeVerdict verdict = wedge_sliding(
            {wedge.slope.face_dip, wedge.slope.face_dip_direction,
             Orientation{wedge.slope.upper_surface_dip, wedge.slope.upper_surface_dip_direction}},
            {wedge.plane_1.dip, wedge.plane_1.dip_direction}, {wedge.plane_2.dip, wedge.plane_2.dip_direction}, 0);
        wedge.plane_1.strength = wedge.plane_2.strength = Coulomb<>{0, verdict.limiting_friction_angle};
        const WedgeFailureResult result = analyse(wedge);
        if (result.check == WedgeFailureCheck::line_does_not_daylight ||
            result.check == WedgeFailureCheck::line_does_not_surface) {
            EXPECT_EQ(verdict.contact, SlidingContact::none) << count;
        }
        // Kinematics knows friction angles up to 90 deg, the laws of strength up to 89.9.
        if (result.check == WedgeFailureCheck::valid && verdict.limiting_friction_angle < degrees(89.8)) {
            EXPECT_EQ(result.contact, verdict.contact) << count;
            EXPECT_NEAR(result.factor_of_safety, 1, 1e-8) << count;
            ++compared;
        }
    }
    EXPECT_GT(compared, 300);
}

TEST(WedgeFailure, WaterLiftsALightWedgeOff) {
    WedgeFailure wedge = example();
    wedge.rock.unit_weight = 3e3;
    const WedgeFailureResult result = analyse(wedge);
    EXPECT_EQ(result.check, WedgeFailureCheck::valid);
    EXPECT_EQ(result.contact, SlidingContact::none);
    EXPECT_EQ(result.factor_of_safety, 0);
}

TEST(WedgeFailure, GivenPressuresAreThoseOfFilledFissures) {
    WedgeFailure wedge = example();
    const WedgeFailureResult filled = analyse(wedge);
    const double mean = filled.water_force_1 / filled.area_1;
    wedge.water = MeanPressures{mean, mean, mean};
    EXPECT_NEAR(factor_of(wedge), filled.factor_of_safety, 1e-13);
    EXPECT_NEAR(mean, 62.5 * pound_per_cubic_foot * filled.crack_depth / 3, 1e-9);  // Pa, of 5e4
    wedge.water = MeanPressures{mean, mean, {}};
    EXPECT_GT(factor_of(wedge), filled.factor_of_safety);
}

TEST(WedgeFailure, RequiredBoltForceReachesItsFactor) {
    WedgeFailure wedge = example();
    // Towards the rock, slightly upwards, against the line of intersection.
    wedge.bolt = {{0, degrees(-10), degrees(337), BoltAction::active}};
    const Required force = required_value(wedge, "bolt[1].force", 1.5);
    ASSERT_EQ(force.status, RequiredStatus::found);
    wedge.bolt.front().force = force.value;
    EXPECT_NEAR(factor_of(wedge), 1.5, 1e-10);
}

TEST(WedgeFailure, ImpossibleGeometriesAreNamed) {
    const auto check_of = [](auto change) {
        WedgeFailure wedge = example();
        change(wedge);
        return analyse(wedge).check;
    };
    using Check = WedgeFailureCheck;
    EXPECT_EQ(check_of([](auto& wedge) { wedge.plane_2 = wedge.plane_1; }), Check::planes_parallel);
    EXPECT_EQ(check_of([](auto& wedge) { wedge.slope.face_dip = degrees(30); }), Check::line_does_not_daylight);
    EXPECT_EQ(check_of([](auto& wedge) { wedge.slope.face_dip_direction = degrees(5); }),
              Check::line_does_not_daylight);
    EXPECT_EQ(check_of([](auto& wedge) {
                  wedge.slope.upper_surface_dip = degrees(50);
                  wedge.slope.upper_surface_dip_direction = degrees(158);
              }),
              Check::line_does_not_surface);
    EXPECT_EQ(check_of([](auto& wedge) { wedge.tension_crack->distance = 100; }), Check::crack_misses_wedge);
    EXPECT_EQ(check_of([](auto& wedge) { wedge.tension_crack->dip = degrees(32); }), Check::crack_misses_wedge);
    EXPECT_EQ(check_of([](auto& wedge) {
                  wedge.tension_crack = WedgeCrack{degrees(90), degrees(200), 1};
              }),
              Check::crack_cuts_face);
    EXPECT_EQ(check_of([](auto& wedge) {
                  wedge.tension_crack.reset();
                  wedge.water = MeanPressures{1, 1, 1};
              }),
              Check::water_needs_crack);
    EXPECT_EQ(check_of([](auto& wedge) {
                  wedge.plane_1.strength = SteppedSurface<>{0, degrees(50), degrees(45)};
              }),
              Check::friction_not_below_90_deg);
    EXPECT_EQ(check_of([](auto& wedge) { wedge.slope.height = 0; }), Check::input_out_of_range);
    EXPECT_EQ(check_of([](auto& wedge) { wedge.slope.height = std::nan(""); }), Check::input_out_of_range);
}

TEST(WedgeFailure, LoopsSeeTheSameNumbers) {
    const ModelInterface model = model_interface({example(), {}});
    const auto factor = place_of(model.outputs, "factor_of_safety");
    const auto dip = place_of(model.inputs, "plane_1.dip");
    ASSERT_TRUE(factor && dip);
    EXPECT_EQ(model.predict({}).outputs.at(*factor), factor_of(example()));
    const std::vector<Assignment> flat{{*dip, degrees(1)}};
    EXPECT_EQ(model.predict(flat).failure, "line_does_not_surface");
}

}  // namespace
}  // namespace delabole
