#include "kinematics/kinematics.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace delabole {
namespace {

Orientation plane(double dip, double dip_direction) {
    return {degrees(dip), degrees(dip_direction)};
}

SlopeOrientation face(double dip, double dip_direction) {
    return {degrees(dip), degrees(dip_direction), {}};
}

Feasibility slides(const SlopeOrientation& slope, const Orientation& joint, double friction = 30, double limit = 20) {
    return planar_sliding(slope, joint, degrees(friction), degrees(limit)).feasibility;
}

Feasibility topples(const SlopeOrientation& slope, const Orientation& layers, double friction = 30, double limit = 30) {
    return flexural_toppling(slope, layers, degrees(friction), degrees(limit)).feasibility;
}

TEST(PlanarSliding, NamesTheReason) {
    const SlopeOrientation slope = face(60, 90);
    EXPECT_EQ(slides(slope, plane(45, 90)), Feasibility::feasible);
    EXPECT_EQ(slides(slope, plane(60, 90)), Feasibility::does_not_daylight);  // parallel to the face
    EXPECT_EQ(slides(slope, plane(75, 90)), Feasibility::does_not_daylight);
    EXPECT_EQ(slides(slope, plane(45, 270)), Feasibility::does_not_daylight);
    EXPECT_EQ(slides(slope, plane(45, 115)), Feasibility::outside_lateral_limit);
    EXPECT_EQ(slides(slope, plane(25, 90)), Feasibility::flatter_than_friction);
    EXPECT_EQ(slides(slope, plane(30, 90)), Feasibility::flatter_than_friction);  // limiting equilibrium
    EXPECT_EQ(slides(slope, plane(0, 270), 0), Feasibility::flatter_than_friction);
    // The face's apparent dip towards 140 is atan(tan 60 cos 50) = 48.07 deg.
    EXPECT_EQ(slides(slope, plane(48, 140), 30, 60), Feasibility::feasible);
    EXPECT_EQ(slides(slope, plane(48.1, 140), 30, 60), Feasibility::does_not_daylight);
    // Ground behind the crest as steep as the plane, and steeper, never meets it.
    SlopeOrientation hillside = face(60, 90);
    hillside.upper_surface = plane(45, 90);
    EXPECT_EQ(slides(hillside, plane(45, 90)), Feasibility::does_not_surface);
    EXPECT_EQ(slides(hillside, plane(44, 90)), Feasibility::does_not_surface);
    EXPECT_EQ(slides(hillside, plane(46, 90)), Feasibility::feasible);
    hillside.upper_surface = plane(45, 270);
    EXPECT_EQ(slides(hillside, plane(44, 90)), Feasibility::feasible);
}

TEST(PlanarSliding, CriticalFrictionIsTheDip) {
    const auto verdict = planar_sliding(face(60, 90), plane(45, 100), degrees(50), degrees(20));
    EXPECT_EQ(verdict.feasibility, Feasibility::flatter_than_friction);
    EXPECT_EQ(verdict.critical_friction_angle, degrees(45));
    EXPECT_EQ(planar_sliding(face(60, 90), plane(70, 90), 0, degrees(20)).critical_friction_angle, 0);
}

// Goodman & Bray (1976): 70 >= (90 - 85) + 30. The critical friction angle is 65 deg.
TEST(FlexuralToppling, GoodmanAndBraysCriterion) {
    const auto verdict = flexural_toppling(face(70, 102.5), plane(85, 282.5), degrees(30), degrees(30));
    EXPECT_EQ(verdict.feasibility, Feasibility::feasible);
    EXPECT_NEAR(verdict.critical_friction_angle, degrees(65), 1e-14);
    EXPECT_EQ(topples(face(70, 102.5), plane(85, 282.5), 64.99), Feasibility::feasible);
    EXPECT_EQ(topples(face(70, 102.5), plane(85, 282.5), 65), Feasibility::no_slip_between_layers);
    EXPECT_EQ(topples(face(70, 102.5), plane(85, 102.5)), Feasibility::does_not_dip_into_slope);
    EXPECT_EQ(topples(face(70, 102.5), plane(85, 315)), Feasibility::outside_lateral_limit);
    EXPECT_EQ(topples(face(70, 102.5), plane(15, 282.5), 0), Feasibility::no_slip_between_layers);
    EXPECT_EQ(topples(face(70, 102.5), plane(0, 282.5), 0), Feasibility::does_not_dip_into_slope);
    // Vertical layers may be written with either of two dip directions: only the face has to be steep enough.
    for (const double dip_direction : {102.5, 282.5}) {
        EXPECT_NEAR(
            flexural_toppling(face(70, 102.5), plane(90, dip_direction), 0, degrees(30)).critical_friction_angle,
            degrees(70), 1e-14);
    }
}

// Layers that strike 25 deg aside have, in the section across the face, the apparent dip atan(tan 80 cos 25).
TEST(FlexuralToppling, ObliqueLayersByTheirApparentDip) {
    const double apparent = std::atan(std::tan(degrees(80)) * std::cos(degrees(25)));
    const auto verdict = flexural_toppling(face(70, 0), plane(80, 205), 0, degrees(30));
    EXPECT_NEAR(verdict.critical_friction_angle, degrees(70) - (degrees(90) - apparent), 1e-14);
}

TEST(DirectToppling, AxisAndBase) {
    const SlopeOrientation slope = face(65, 0);
    const auto axis = [&](double plunge, double trend, double friction = 20) {
        return toppling_axis(slope, {degrees(plunge), degrees(trend)}, degrees(friction), degrees(20));
    };
    EXPECT_EQ(axis(60, 180), Feasibility::feasible);
    EXPECT_EQ(axis(60, 195), Feasibility::feasible);
    EXPECT_EQ(axis(60, 205), Feasibility::outside_lateral_limit);
    EXPECT_EQ(axis(60, 0), Feasibility::does_not_dip_into_slope);
    EXPECT_EQ(axis(24, 180), Feasibility::too_flat_to_topple);
    EXPECT_EQ(axis(26, 180), Feasibility::feasible);
    EXPECT_EQ(axis(75, 100), Feasibility::feasible);  // oblique: within 20 deg of vertical
    EXPECT_EQ(axis(75, 100, 10), Feasibility::outside_lateral_limit);
    EXPECT_EQ(axis(75, 80), Feasibility::does_not_dip_into_slope);  // leans back
    EXPECT_EQ(axis(90, 0), Feasibility::feasible);                  // vertical: has no trend
    EXPECT_EQ(axis(0, 180), Feasibility::too_flat_to_topple);
    const auto base = [&](double dip, double dip_direction) {
        return toppling_base(slope, plane(dip, dip_direction), degrees(20), degrees(20));
    };
    EXPECT_EQ(base(15, 180), Feasibility::feasible);
    EXPECT_EQ(base(25, 180), Feasibility::base_steeper_than_friction);
    EXPECT_EQ(base(40, 10), Feasibility::feasible);
    EXPECT_EQ(base(40, 30), Feasibility::outside_lateral_limit);
    EXPECT_EQ(base(65, 0), Feasibility::does_not_daylight);
}

// Two planes of equal dip d either side of the slope line, dip directions -a and +a: the line plunges atan(tan d cos
// a). Wedge theory for the symmetric wedge: with half the opening angle h between the planes measured across the line,
// each normal force is W cos(plunge) / (2 sin h), so that tan(friction) = tan(plunge) sin h.
TEST(WedgeSliding, SymmetricWedgeByHand) {
    const double dip = degrees(55);
    const double aside = degrees(50);
    const Orientation first{dip, degrees(360) - aside};
    const Orientation second{dip, aside};
    const WedgeVerdict verdict = wedge_sliding(face(70, 0), first, second, degrees(20));
    const double plunge = std::atan(std::tan(dip) * std::cos(aside));
    EXPECT_EQ(verdict.feasibility, Feasibility::feasible);
    EXPECT_EQ(verdict.contact, SlidingContact::both_planes);
    EXPECT_NEAR(verdict.critical_friction_angle, plunge, 1e-14);
    const double half_opening = (degrees(180) - std::acos(upward_normal(first).dot(upward_normal(second)))) / 2;
    EXPECT_NEAR(verdict.limiting_friction_angle, std::atan(std::tan(plunge) * std::sin(half_opening)), 1e-14);
    EXPECT_LT(verdict.limiting_friction_angle, plunge);  // wedging helps
}

TEST(WedgeSliding, NamesTheReason) {
    const auto verdict = [](double face_dip, double friction) {
        return wedge_sliding(face(face_dip, 180), plane(50, 150), plane(60, 250), degrees(friction)).feasibility;
    };
    // Line 41.9 -> 191.2 (orientation tests). The face's apparent dip there is atan(tan(face dip) cos 11.2 deg).
    EXPECT_EQ(verdict(70, 30), Feasibility::feasible);
    EXPECT_EQ(verdict(70, 43), Feasibility::flatter_than_friction);
    EXPECT_EQ(verdict(42, 30), Feasibility::does_not_daylight);
    EXPECT_EQ(verdict(43, 30), Feasibility::feasible);
    EXPECT_EQ(wedge_sliding(face(70, 0), plane(50, 150), plane(60, 250), degrees(30)).feasibility,
              Feasibility::does_not_daylight);
    EXPECT_EQ(wedge_sliding(face(70, 0), plane(50, 150), plane(50, 150), degrees(30)).feasibility,
              Feasibility::planes_parallel);
    // Planes with opposite dips meet in a level line, whatever direction the face has.
    for (const double azimuth : {0.0, 60.0, 150.0, 240.0}) {
        EXPECT_EQ(wedge_sliding(face(70, azimuth), plane(50, 150), plane(60, 330), 0).feasibility,
                  Feasibility::flatter_than_friction);
    }
}

TEST(WedgeSliding, OnOnePlaneItIsPlanarSliding) {
    // The intersection of 45/20 and 70/80 lies west of 20 in plan; with the face dipping to 60 the first carries.
    const WedgeVerdict verdict = wedge_sliding(face(75, 60), plane(45, 20), plane(70, 80), degrees(30));
    EXPECT_EQ(verdict.feasibility, Feasibility::feasible);
    EXPECT_EQ(verdict.contact, SlidingContact::first_plane);
    EXPECT_EQ(verdict.critical_friction_angle, degrees(45));
    EXPECT_EQ(verdict.limiting_friction_angle, degrees(45));
}

// Old Delabole, west face; angles in degrees. The face's dip direction is that of joint set A.
KinematicsStudy delabole_sets() {
    KinematicsStudy study;
    study.model.slope = face(70, 102.5);
    study.model.strength = {degrees(20)};
    study.model.lateral_limit = {degrees(20), degrees(30), degrees(20)};
    const auto range = [](std::string name, double lower, double upper, double first, double last) {
        return JointSet{std::move(name),
                        OrientationRange{degrees(lower), degrees(upper), degrees(first), degrees(last)}};
    };
    study.model.joint_set = {range("joint_set_a", 70, 90, 100, 105),
                             {"joint_set_b", MeanOrientation{degrees(85), degrees(282.5), 200.0}},
                             range("joint_set_c", 30, 65, 90, 130),
                             range("cleavage", 20, 30, 245, 260),
                             range("faults", 70, 90, 90, 120)};
    study.sampling = OrientationSampling{.sample_count = 1000, .seed = 1967};
    return study;
}

KinematicsStudy turned(KinematicsStudy study, double angle) {
    const auto turn = [&](double& azimuth) { azimuth = wrapped_azimuth(azimuth + angle); };
    turn(study.model.slope.face_dip_direction);
    for (JointSet& set : study.model.joint_set) {
        if (auto* range = std::get_if<OrientationRange>(&set.orientation)) {
            turn(range->first_dip_direction);
            turn(range->last_dip_direction);
        } else {
            turn(std::get<MeanOrientation>(set.orientation).dip_direction);
        }
    }
    return study;
}

KinematicsStudy mirrored(KinematicsStudy study) {
    const auto mirror = [](double azimuth) { return wrapped_azimuth(-azimuth); };
    study.model.slope.face_dip_direction = mirror(study.model.slope.face_dip_direction);
    for (JointSet& set : study.model.joint_set) {
        if (auto* range = std::get_if<OrientationRange>(&set.orientation)) {
            const double first = range->first_dip_direction;
            range->first_dip_direction = mirror(range->last_dip_direction);
            range->last_dip_direction = mirror(first);
        } else {
            auto& mean = std::get<MeanOrientation>(set.orientation);
            mean.dip_direction = mirror(mean.dip_direction);
        }
    }
    return study;
}

void expect_same(const MechanismFeasibility& one, const MechanismFeasibility& other, double share_tolerance) {
    EXPECT_EQ(one.at_mean, other.at_mean);
    EXPECT_NEAR(one.critical_friction_angle, other.critical_friction_angle, 1e-12);
    EXPECT_NEAR(one.feasible_share, other.feasible_share, share_tolerance);
}

void expect_same(const KinematicsResult& one, const KinematicsResult& other, double share_tolerance) {
    ASSERT_EQ(one.check, KinematicsCheck::valid);
    ASSERT_EQ(other.check, KinematicsCheck::valid);
    for (std::size_t set = 0; set < one.joint_set.size(); ++set) {
        SCOPED_TRACE(one.joint_set[set].name);
        expect_same(one.joint_set[set].planar_sliding, other.joint_set[set].planar_sliding, share_tolerance);
        expect_same(one.joint_set[set].flexural_toppling, other.joint_set[set].flexural_toppling, share_tolerance);
        EXPECT_EQ(one.joint_set[set].toppling_base, other.joint_set[set].toppling_base);
        EXPECT_NEAR(one.joint_set[set].toppling_base_share, other.joint_set[set].toppling_base_share, share_tolerance);
    }
    for (std::size_t pair = 0; pair < one.pair.size(); ++pair) {
        SCOPED_TRACE(one.pair[pair].first + " " + one.pair[pair].second);
        expect_same(one.pair[pair].wedge_sliding, other.pair[pair].wedge_sliding, share_tolerance);
        EXPECT_EQ(one.pair[pair].wedge_contact, other.pair[pair].wedge_contact);
        EXPECT_NEAR(one.pair[pair].wedge_limiting_friction_angle, other.pair[pair].wedge_limiting_friction_angle,
                    1e-12);
        EXPECT_EQ(one.pair[pair].direct_toppling, other.pair[pair].direct_toppling);
        EXPECT_NEAR(one.pair[pair].direct_toppling_share, other.pair[pair].direct_toppling_share, share_tolerance);
        EXPECT_EQ(one.pair[pair].toppling_base, other.pair[pair].toppling_base);
    }
}

TEST(Kinematics, TurningTheMapChangesNothing) {
    // 0.25 deg keeps sets that are parallel or exactly at a limit from being decided by rounding after the turn.
    KinematicsStudy study = delabole_sets();
    study.model.slope.face_dip_direction = degrees(102.75);
    const KinematicsResult result = analyse(study);
    for (const double angle : {33.0, 180.0, 255.0, 340.0}) {
        // The samples turn along; one of 1000 may lie within rounding of a limit.
        expect_same(result, analyse(turned(study, degrees(angle))), 1.5e-3);
    }
}

// The side of a plane on which the block lies is decided by rounding where the plane dips exactly as the face does.
TEST(Kinematics, APlaneThatDipsAsTheFaceDoesCarriesTheWedgeAtEveryAzimuth) {
    for (int azimuth = 0; azimuth < 360; azimuth += 5) {
        const double along = degrees(azimuth);
        const SlopeOrientation slope{degrees(90), along, std::nullopt};
        const Orientation first{degrees(45), along};
        const Orientation second{degrees(90), along + degrees(8)};
        const WedgeVerdict verdict = wedge_sliding(slope, first, second, degrees(30));
        EXPECT_EQ(verdict.feasibility, Feasibility::feasible) << azimuth;
        EXPECT_EQ(verdict.contact, SlidingContact::first_plane) << azimuth;
        EXPECT_EQ(wedge_sliding(slope, second, first, degrees(30)).contact, SlidingContact::second_plane) << azimuth;
    }
}

TEST(Kinematics, MirrorImageBehavesAlike) {
    KinematicsStudy study = delabole_sets();
    study.model.slope.face_dip_direction = degrees(102.75);
    study.sampling = OrientationSampling{.sample_count = 4000, .seed = 3};
    // The samples are others: four standard errors of the difference of two shares, at most 4 sqrt(2 * 0.25 / 4000).
    expect_same(analyse(study), analyse(mirrored(study)), 4 * std::sqrt(0.5 / 4000));
}

TEST(Kinematics, DelaboleSets) {
    const KinematicsResult result = analyse(delabole_sets());
    ASSERT_EQ(result.check, KinematicsCheck::valid);
    ASSERT_EQ(result.joint_set.size(), 5U);
    ASSERT_EQ(result.pair.size(), 10U);
    const JointSetFeasibility& shorters = result.joint_set[0];
    const JointSetFeasibility& toppling_set = result.joint_set[1];
    const JointSetFeasibility& flat_set = result.joint_set[2];
    const JointSetFeasibility& cleavage = result.joint_set[3];
    // Shorters are steeper than the face: they release blocks but do not carry them.
    EXPECT_EQ(shorters.planar_sliding.at_mean, Feasibility::does_not_daylight);
    EXPECT_EQ(shorters.planar_sliding.feasible_share, 0);
    // 70 - (90 - 85).
    EXPECT_EQ(toppling_set.flexural_toppling.at_mean, Feasibility::feasible);
    EXPECT_NEAR(toppling_set.flexural_toppling.critical_friction_angle, degrees(65), 1e-12);
    EXPECT_GT(toppling_set.flexural_toppling.feasible_share, 0.4);
    // Set C would slide if it were not scarce. The dip is always under the apparent face dip; 5/8 of its dip
    // directions, 90 to 122.5, lie within the limit: four standard errors.
    EXPECT_EQ(flat_set.planar_sliding.at_mean, Feasibility::feasible);
    EXPECT_NEAR(flat_set.planar_sliding.feasible_share, 32.5 / 40, 4 * std::sqrt(0.81 * 0.19 / 1000));
    // Cleavage dips into the slope, steeper than 20 deg: neither slides nor makes a base.
    EXPECT_EQ(cleavage.planar_sliding.at_mean, Feasibility::does_not_daylight);
    EXPECT_EQ(cleavage.toppling_base, Feasibility::base_steeper_than_friction);
    EXPECT_EQ(cleavage.toppling_base_share, 0);
}

// Three sets that make columns: two vertical joints and a base dipping 10 deg out of the slope.
TEST(Kinematics, ColumnsNeedABase) {
    KinematicsStudy study;
    study.model.slope = face(75, 90);
    study.model.strength = {degrees(30)};
    study.model.lateral_limit = {degrees(20), degrees(30), degrees(20)};
    study.model.joint_set = {{"back", MeanOrientation{degrees(75), degrees(270), {}}},
                             {"side", MeanOrientation{degrees(90), degrees(0), {}}},
                             {"base", MeanOrientation{degrees(10), degrees(90), {}}}};
    KinematicsResult result = analyse(study);
    ASSERT_EQ(result.pair.size(), 3U);
    EXPECT_EQ(result.pair[0].direct_toppling, Feasibility::feasible);
    EXPECT_EQ(result.pair[0].direct_toppling_share, 1);
    EXPECT_EQ(result.pair[0].toppling_base, "base");
    EXPECT_NEAR(result.pair[0].intersection.plunge, degrees(75), 1e-12);
    EXPECT_NEAR(result.pair[0].intersection.trend, degrees(270), 1e-12);
    // Of two bases the flatter one is named.
    study.model.joint_set.push_back({"flatter", MeanOrientation{degrees(5), degrees(40), {}}});
    EXPECT_EQ(analyse(study).pair[0].toppling_base, "flatter");
    study.model.joint_set.pop_back();
    // A set cannot be both a side of the columns and their base: 20 deg into the slope is flat enough to lie on and,
    // cut by the vertical joint, steep enough for an axis.
    study.model.joint_set[2].orientation = MeanOrientation{degrees(20), degrees(270), {}};
    result = analyse(study);
    EXPECT_EQ(result.pair[0].toppling_base, "base");
    EXPECT_EQ(result.pair[2].direct_toppling, Feasibility::no_base_plane);
    EXPECT_EQ(result.pair[2].direct_toppling_share, 0);
    study.model.joint_set.pop_back();
    result = analyse(study);
    EXPECT_EQ(result.pair[0].direct_toppling, Feasibility::no_base_plane);
    EXPECT_EQ(result.pair[0].direct_toppling_share, 0);
    EXPECT_EQ(result.pair[0].toppling_base, "");
}

// More friction never makes sliding or flexural toppling easier, and the critical angle is where it changes.
TEST(Kinematics, CriticalFrictionParts) {
    KinematicsStudy study = delabole_sets();
    const KinematicsResult base = analyse(study);
    for (const double friction : {0.0, 10.0, 45.0, 60.0, 89.9}) {
        study.model.strength.friction_angle = degrees(friction);
        const KinematicsResult result = analyse(study);
        const auto expect_parted = [&](const MechanismFeasibility& mechanism, const MechanismFeasibility& before) {
            EXPECT_EQ(mechanism.critical_friction_angle, before.critical_friction_angle);
            EXPECT_EQ(mechanism.at_mean == Feasibility::feasible,
                      mechanism.critical_friction_angle > degrees(friction));
            if (friction > 20) {
                EXPECT_LE(mechanism.feasible_share, before.feasible_share);
            } else {
                EXPECT_GE(mechanism.feasible_share, before.feasible_share);
            }
        };
        for (std::size_t set = 0; set < result.joint_set.size(); ++set) {
            expect_parted(result.joint_set[set].planar_sliding, base.joint_set[set].planar_sliding);
            expect_parted(result.joint_set[set].flexural_toppling, base.joint_set[set].flexural_toppling);
        }
        for (std::size_t pair = 0; pair < result.pair.size(); ++pair) {
            expect_parted(result.pair[pair].wedge_sliding, base.pair[pair].wedge_sliding);
        }
    }
}

TEST(Kinematics, ExtremesGiveNumbers) {
    const double dips[] = {0, 1e-9, 45, 90 - 1e-9, 90};
    const double azimuths[] = {0, 90, 180, 359.999, 360};
    for (const double face_dip : {1e-6, 45.0, 90.0}) {
        for (const double friction : {0.0, 89.9}) {
            for (const double limit : {0.0, 90.0}) {
                KinematicsStudy study;
                study.model.slope = face(face_dip, 360);
                study.model.slope.upper_surface = plane(90, 0);
                study.model.strength = {degrees(friction)};
                study.model.lateral_limit = {degrees(limit), degrees(limit), degrees(limit)};
                for (const double dip : dips) {
                    for (const double azimuth : azimuths) {
                        study.model.joint_set.push_back(
                            {"set " + std::to_string(study.model.joint_set.size()),
                             MeanOrientation{degrees(dip), degrees(azimuth), azimuth == 90 ? 0.001 : 1e9}});
                    }
                }
                study.sampling = OrientationSampling{.sample_count = 3, .seed = {}};
                const KinematicsResult result = analyse(study);
                ASSERT_EQ(result.check, KinematicsCheck::valid);
                for_each_named_number(result, [&](const std::string& name, const FieldInfo&, double value) {
                    EXPECT_TRUE(std::isfinite(value)) << name;
                    EXPECT_GE(value, name.ends_with("apparent_dip") ? degrees(-90) : 0) << name;
                    EXPECT_LE(value, degrees(360)) << name;
                });
            }
        }
    }
}

TEST(Kinematics, RefusesImpossibleInputByName) {
    const auto check = [](auto&& change) {
        KinematicsStudy study = delabole_sets();
        change(study);
        const KinematicsResult result = analyse(study);
        EXPECT_TRUE(result.check == KinematicsCheck::valid || result.joint_set.empty());
        return result.check;
    };
    using C = KinematicsCheck;
    const auto range_of = [](KinematicsStudy& study) -> OrientationRange& {
        return std::get<OrientationRange>(study.model.joint_set[0].orientation);
    };
    EXPECT_EQ(check([](KinematicsStudy&) {}), C::valid);
    EXPECT_EQ(check([](KinematicsStudy& study) { study.model.joint_set.clear(); }), C::no_joint_set);
    EXPECT_EQ(check([](KinematicsStudy& study) {
                  study.model.joint_set.resize(most_joint_sets + 1, study.model.joint_set.front());
              }),
              C::too_many_joint_sets);
    EXPECT_EQ(check([](KinematicsStudy& study) { study.model.joint_set[1].name = ""; }), C::joint_set_without_name);
    EXPECT_EQ(check([](KinematicsStudy& study) { study.model.joint_set[1].name = "faults"; }),
              C::joint_set_name_repeated);
    EXPECT_EQ(check([&](KinematicsStudy& study) { range_of(study).lower_dip = degrees(91); }), C::input_out_of_range);
    EXPECT_EQ(check([&](KinematicsStudy& study) { range_of(study).upper_dip = degrees(69); }),
              C::lower_dip_above_upper_dip);
    EXPECT_EQ(check([&](KinematicsStudy& study) { range_of(study).upper_dip = std::nan(""); }), C::input_out_of_range);
    EXPECT_EQ(check([](KinematicsStudy& study) { study.model.slope.face_dip = 0; }), C::input_out_of_range);
    EXPECT_EQ(check([](KinematicsStudy& study) { study.model.strength.friction_angle = degrees(90); }),
              C::input_out_of_range);
    EXPECT_EQ(check([](KinematicsStudy& study) { study.sampling->sample_count = 10.5; }), C::setting_not_whole);
    EXPECT_EQ(check([](KinematicsStudy& study) { study.sampling->seed = 0.5; }), C::setting_not_whole);
    EXPECT_EQ(check([](KinematicsStudy& study) { study.sampling->sample_count = 0; }), C::input_out_of_range);
}

TEST(Kinematics, InterfaceNamesSharesAndCriticalFriction) {
    const KinematicsStudy study = delabole_sets();
    const ModelInterface model = model_interface(study);
    const auto index_of = [](const std::vector<Quantity>& quantities, std::string_view name) {
        const auto found = std::ranges::find(quantities, name, &Quantity::name);
        EXPECT_NE(found, quantities.end()) << name;
        return static_cast<std::size_t>(found - quantities.begin());
    };
    const std::size_t friction = index_of(model.inputs, "strength.friction_angle");
    const std::size_t face_dip = index_of(model.inputs, "slope.face_dip");
    const std::size_t share = index_of(model.outputs, "joint_set[3].planar_sliding.feasible_share");
    const std::size_t critical = index_of(model.outputs, "joint_set[2].flexural_toppling.critical_friction_angle");
    const Prediction base = model.predict({});
    ASSERT_EQ(base.outputs.size(), model.outputs.size());
    EXPECT_EQ(base.outputs[share], analyse(study).joint_set[2].planar_sliding.feasible_share);
    const std::vector<Assignment> steeper{{face_dip, degrees(80)}, {friction, degrees(64)}};
    const Prediction changed = model.predict(steeper);
    EXPECT_NEAR(changed.outputs[critical], degrees(75), 1e-12);
    EXPECT_LT(changed.outputs[share], base.outputs[share]);
    const std::vector<Assignment> impossible{{face_dip, degrees(100)}};
    EXPECT_EQ(model.predict(impossible).failure, "input_out_of_range");
}

}  // namespace
}  // namespace delabole
