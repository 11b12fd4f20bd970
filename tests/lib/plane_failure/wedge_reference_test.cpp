// The library in double precision against 50 digits: the same templates over a 50-digit scalar (rounding), and an
// independent derivation by vectors and the shoelace formula (formulas), on the very same double inputs.
#include "plane_failure/plane_failure.hpp"
#include "plane_failure/stability.hpp"
#include "tests/lib/plane_failure/closed_forms.hpp"
#include "tests/lib/plane_failure/reference_plane_failure.hpp"
#include "tests/support/random_problem.hpp"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <sstream>

namespace delabole {
namespace {

using reference::Real;

// Relative error allowed to a quantity without cancellation: issue "Must hold". It is 450 units in the last place of a
// double, for chains of a few dozen operations.
constexpr double bound = 1e-13;

enum Quantity { weight, base_length, base_water, crack_water, normal, driving, resisting, quantity_count };
constexpr std::array<const char*, quantity_count> names = {
    "weight", "base length", "base water", "crack water", "normal force", "driving force", "resisting force"};

template <class T>
using Answers = std::array<T, quantity_count>;

template <class T>
Answers<T> answers_of(const Equilibrium<T>& forces) {
    return {forces.stability.weight,         forces.wedge.base_length,      forces.water.base.force,
            forces.water.crack.force,        forces.stability.normal_force, forces.stability.driving_force,
            forces.stability.resisting_force};
}

// How far an answer moves when every input moves by half a unit in its last place: no algorithm in double can do
// better than that order, and where it exceeds `bound` the problem itself is nearly singular.
Answers<Real> inherent_error(const PlaneFailure<>& problem, const Answers<Real>& base) {
    Answers<Real> error{};
    PlaneFailure<Real> varied = with_scalar<PlaneFailure<Real>>(problem);
    std::vector<Real*> numbers;
    for_each_number(varied, [&](Real& number, const FieldInfo&) { numbers.push_back(&number); });
    for (Real* number : numbers) {
        const Real kept = *number;
        Answers<Real> largest{};
        for (const double sign : {-1.0, 1.0}) {
            const Real step = kept * sign * Real("1e-30");
            if (step == 0) {
                continue;
            }
            *number = kept + step;
            const Equilibrium<Real> moved = evaluate(varied);
            *number = kept;
            if (moved.check != PlaneFailureCheck::valid) {
                continue;
            }
            const Answers<Real> answers = answers_of(moved);
            for (std::size_t index = 0; index < quantity_count; ++index) {
                const Real change = abs(answers[index] - base[index]) * Real("1e30") * 1.2e-16;
                largest[index] = std::max(largest[index], change);
            }
        }
        for (std::size_t index = 0; index < quantity_count; ++index) {
            error[index] += largest[index];
        }
    }
    return error;
}

std::string describe(const PlaneFailure<>& problem) {
    std::ostringstream text;
    text.precision(17);
    for_each_named_number(problem, [&](const std::string& path, const FieldInfo&, double value) {
        text << path << " = " << value << "\n";
    });
    text << "strength " << problem.strength.index() << ", water " << problem.water.index();
    if (problem.tension_crack) {
        text << ", crack position " << problem.tension_crack->position.index();
    }
    return text.str();
}

struct Tally {
    int compared = 0;
    int excused = 0;        // beyond `bound`, but within what the rounding of the inputs does
    int check_differs = 0;  // on an edge between two outcomes
    double worst = 0;       // relative error among those that needed no excuse
    std::map<CrackLocation, int> locations;
    std::map<std::size_t, int> positions;
    std::map<std::size_t, int> waters;
};

void compare(const PlaneFailure<>& problem, Tally& tally) {
    const Equilibrium<double> computed = evaluate(problem);
    const Equilibrium<Real> exact = evaluate(with_scalar<PlaneFailure<Real>>(problem));
    if (computed.check != exact.check || computed.wedge.crack_location != exact.wedge.crack_location) {
        if (computed.check == PlaneFailureCheck::valid || exact.check == PlaneFailureCheck::valid) {
            ++tally.check_differs;
        }
        return;
    }
    if (computed.check != PlaneFailureCheck::valid) {
        return;
    }
    ++tally.compared;
    ++tally.locations[computed.wedge.crack_location];
    ++tally.waters[problem.water.index()];
    if (problem.tension_crack) {
        ++tally.positions[problem.tension_crack->position.index()];
    }
    const reference::Solution independent = reference::solve(problem);
    const Answers<double> found = answers_of(computed);
    const Answers<Real> expected = answers_of(exact);
    const Answers<Real> first_principles = {independent.weight,      independent.base_length, independent.base_water,
                                            independent.crack_water, independent.normal,      independent.driving,
                                            independent.resisting};
    const Answers<Real> scale = {independent.weight,
                                 independent.base_length,
                                 independent.base_water,
                                 independent.crack_water,
                                 independent.normal_magnitude,
                                 independent.driving_magnitude,
                                 independent.resisting_magnitude};
    Answers<Real> inherent{};
    bool have_inherent = false;
    // A crack of no depth leaves zero in one derivation and its own rounding in the other.
    const Real floor = 1e-40 * independent.weight;
    for (std::size_t index = 0; index < quantity_count; ++index) {
        SCOPED_TRACE(names[index]);
        // Two derivations in 50 digits: they may lose ten of them by cancellation near singular geometry, no more.
        // Barton-Bandis holds two constants in double (ln 10 and one degree), 1e-16.
        const double formula_tolerance = std::holds_alternative<BartonBandis<>>(problem.strength) ? 1e-14 : 1e-35;
        EXPECT_LE(abs(expected[index] - first_principles[index]), formula_tolerance * abs(scale[index]) + floor)
            << expected[index] << " against " << first_principles[index] << "\n"
            << describe(problem);
        const Real error = abs(Real(found[index]) - expected[index]);
        const Real allowed = bound * abs(scale[index]) + floor;
        if (error <= allowed) {
            if (scale[index] != 0) {
                tally.worst = std::max(tally.worst, static_cast<double>(Real(error / abs(scale[index]))));
            }
            continue;
        }
        if (!have_inherent) {
            inherent = inherent_error(problem, expected);
            have_inherent = true;
        }
        ++tally.excused;
        // Eight times the least possible: a chain of operations rounds more than once.
        EXPECT_LE(error, allowed + 8 * inherent[index])
            << "relative " << static_cast<double>(Real(error / abs(scale[index]))) << "\n"
            << describe(problem);
    }
    // The net moment, whose terms are all of the size of the larger of the two sums.
    const PlaneFailureResult result = analyse(problem);
    ASSERT_EQ(result.check, PlaneFailureCheck::valid) << describe(problem);
    if (!have_inherent) {
        const Real net = Real(result.overturning_moment) - Real(result.restoring_moment);
        const Real size = Real(result.overturning_moment) + Real(result.restoring_moment);
        // Geometry that is excused above would excuse its moments too, so they are only compared without an excuse. The
        // arm of a force may cancel: ten times the bound of a force.
        EXPECT_LE(abs(net - independent.overturning_moment), 10 * bound * size) << describe(problem);
        if (independent.driving > 0) {
            const Real factor = independent.factor_of_safety;
            const Real cancellation = independent.resisting_magnitude / independent.driving +
                                      abs(factor) * independent.driving_magnitude / independent.driving;
            EXPECT_LE(abs(Real(computed.stability.factor_of_safety) - factor), 2 * bound * cancellation)
                << describe(problem);
        }
    }
}

void report(const Tally& tally) {
    ::testing::Test::RecordProperty("compared", tally.compared);
    ::testing::Test::RecordProperty("excused", tally.excused);
    std::cout << "compared " << tally.compared << ", beyond 1e-13 by conditioning " << tally.excused << ", edge cases "
              << tally.check_differs << ", worst of the others " << tally.worst << "\n";
}

TEST(WedgeReference, RandomProblemsOverTheExtremes) {
    RandomProblem random(20240601);
    Tally tally;
    for (int count = 0; count < 12000 && !::testing::Test::HasFailure(); ++count) {
        compare(random.next(), tally);
    }
    report(tally);
    // The sweep reaches every branch, otherwise it would prove nothing.
    EXPECT_GT(tally.compared, 2000);
    EXPECT_EQ(tally.locations.size(), 4U);
    EXPECT_EQ(tally.positions.size(), 4U);
    EXPECT_EQ(tally.waters.size(), 7U);
    for (const auto& [location, count] : tally.locations) {
        EXPECT_GT(count, 50) << enum_names(location)[static_cast<std::size_t>(location)];
    }
    EXPECT_LT(tally.check_differs, 12);
}

// Well-conditioned geometry has no excuse: crack base or depth given, nothing near an outcrop.
TEST(WedgeReference, StructuredSweepWithinTheBound) {
    Tally tally;
    for (const double height : {1e-3, 1.0, 137.2, 5e3}) {
        for (const double face : {30.0, 60.0, 89.99, 89.999999, 90.0}) {
            for (const double gap : {1e-6, 1e-3, 0.01, 5.0, 25.0}) {
                for (const double unit_weight : {100.0, 26e3, 1e5}) {
                    for (const double fraction : {0.02, 0.3, 0.7, 0.98}) {
                        PlaneFailure<> problem = textbook_slope();
                        problem.slope.height = height;
                        problem.slope.face_dip = degrees(face);
                        problem.failure_plane.dip = degrees(face - gap);
                        problem.rock.unit_weight = unit_weight;
                        problem.water = CrackAndBaseWater<>{9810, FilledRatio<>{0.5}};
                        problem.tension_crack = TensionCrack<>{degrees(face - gap < 89 ? 90 : 110),
                                                               CrackBaseBelowCrest<>{height * fraction}};
                        compare(problem, tally);
                        // Greatest depth of a crack behind the crest: crest above the plane.
                        const double crest_above = height * std::sin(degrees(face) - problem.failure_plane.dip) /
                                                   (std::sin(degrees(face)) * std::cos(problem.failure_plane.dip));
                        problem.tension_crack = TensionCrack<>{degrees(90), CrackOfDepth<>{crest_above * fraction}};
                        compare(problem, tally);
                    }
                }
            }
        }
    }
    report(tally);
    EXPECT_GT(tally.compared, 1500);
    EXPECT_EQ(tally.excused, 0);
    EXPECT_EQ(tally.check_differs, 0);
}

// A crack given by its distance ends near the outcrop: its depth is the difference of two positions and loses digits in
// proportion, in any arithmetic; the weight and the base do not. This states the loss.
TEST(WedgeReference, CrackByDistanceNearTheOutcropLosesDepthOnly) {
    PlaneFailure<> problem = textbook_slope();
    const double outcrop = 12 / std::tan(degrees(35)) - 12 / std::tan(degrees(60));
    problem.water = CrackOnlyWater<>{9810, FilledRatio<>{1}};
    for (const double short_of : {1e-1, 1e-4, 1e-7, 1e-10}) {
        std::get<CrackAtDistance<>>(problem.tension_crack->position).distance_behind_crest = outcrop - short_of;
        const Equilibrium<double> computed = evaluate(problem);
        const Equilibrium<Real> exact = evaluate(with_scalar<PlaneFailure<Real>>(problem));
        ASSERT_EQ(computed.check, PlaneFailureCheck::valid);
        const auto relative = [](double value, const Real& reference) {
            return static_cast<double>(Real(abs(Real(value) / reference - 1)));
        };
        EXPECT_LE(relative(computed.stability.weight, exact.stability.weight), bound);
        EXPECT_LE(relative(computed.wedge.base_length, exact.wedge.base_length), bound);
        // Depth = short_of tan(35), off by a few roundings of the 10 m distance: 1e-14 m.
        EXPECT_LE(relative(computed.wedge.crack_depth(), exact.wedge.crack_depth()), bound + 1e-14 / short_of);
    }
}

// The forms of Hoek & Bray as printed, in 50 digits, against the library's rearrangements in double.
TEST(ClosedForms, AgreeWithThePrintedFormsEverywhere) {
    RandomProblem random(7);
    double worst = 0;
    for (int count = 0; count < 20000; ++count) {
        const double height = random.logarithmic(1e-3, 5e3);
        const double face =
            random.chance(0.3) ? degrees(90 - random.logarithmic(1e-7, 1)) : degrees(random.uniform(5, 90));
        const double gap = random.chance(0.3) ? random.logarithmic(1e-6, 0.1) : random.uniform(0.1, 60);
        const double plane = std::max(face - degrees(gap), degrees(random.uniform(0.1, 4)));
        const double gamma = random.logarithmic(100, 1e5);
        const Real h = height;
        const Real cot_face = 1 / tan(Real(face));
        const Real cot_plane = 1 / tan(Real(plane));
        const Real crest_above = h * (1 - cot_face / cot_plane);
        const auto check = [&](double value, const Real& printed, const char* name) {
            const double error = static_cast<double>(Real(abs(Real(value) / printed - 1)));
            worst = std::max(worst, error);
            EXPECT_LE(error, bound) << name << " face " << face << " plane " << plane << " height " << height;
        };
        const double z_behind = static_cast<double>(crest_above) * random.uniform(0, 1);
        check(closed_form::weight_crack_behind_crest(gamma, height, z_behind, face, plane),
              Real(Real(gamma) * h * h / 2 * ((1 - Real(z_behind) * z_behind / (h * h)) * cot_plane - cot_face)),
              "behind crest");
        const double z_face =
            height * (1 - random.logarithmic(1e-6, static_cast<double>(Real(cot_face / cot_plane)) + 1e-6));
        const Real reduced = 1 - Real(z_face) / h;
        check(closed_form::weight_crack_in_face(gamma, height, z_face, face, plane),
              Real(Real(gamma) * h * h / 2 * reduced * reduced * cot_plane * (cot_plane * tan(Real(face)) - 1)),
              "in face");
        check(closed_form::critical_crack_depth_ratio(face, plane), Real(1 - sqrt(cot_face / cot_plane)), "z_c");
        check(closed_form::critical_crack_distance_ratio(face, plane), Real(sqrt(cot_face * cot_plane) - cot_face),
              "b_c");
    }
    std::cout << "worst relative error of the closed forms " << worst << "\n";
}

// Exactly vertical: no crack in the face is possible there, the other forms have their limits.
TEST(ClosedForms, VerticalFace) {
    const double face = degrees(90);
    const double plane = degrees(50);
    // Base triangle H^2 cot p / 2 less the tip z^2 cot p / 2.
    const double cot = 1 / std::tan(plane);
    EXPECT_NEAR(closed_form::weight_crack_behind_crest(1.0, 10.0, 2.0, face, plane), (100 - 4) * cot / 2, 96 * bound);
    // sqrt(cot f) = sqrt(6e-17): the crack goes through the whole height but for 1e-8 of it.
    EXPECT_NEAR(closed_form::critical_crack_depth_ratio(face, plane), 1, 2e-8);
    EXPECT_NEAR(closed_form::critical_crack_distance_ratio(face, plane), 0, 2e-8);
}

// The closed forms against the polygon of the library, both crack positions.
TEST(ClosedForms, AgreeWithTheWedge) {
    RandomProblem random(11);
    int behind = 0;
    int in_face = 0;
    for (int count = 0; count < 4000; ++count) {
        PlaneFailure<> problem = textbook_slope();
        const double face = degrees(random.uniform(20, 89.9));
        const double plane = face * random.uniform(0.1, 0.99);
        const double z = 12 * random.uniform(0, 0.99);
        problem.slope.face_dip = face;
        problem.failure_plane.dip = plane;
        problem.tension_crack = TensionCrack<>{degrees(90), CrackBaseBelowCrest<>{z}};
        const Equilibrium<double> forces = evaluate(problem);
        ASSERT_EQ(forces.check, PlaneFailureCheck::valid);
        const bool is_behind = forces.wedge.crack_location == CrackLocation::upper_surface;
        (is_behind ? behind : in_face) += 1;
        const double expected = is_behind ? closed_form::weight_crack_behind_crest(26e3, 12.0, z, face, plane)
                                          : closed_form::weight_crack_in_face(26e3, 12.0, z, face, plane);
        EXPECT_NEAR(forces.stability.weight / expected, 1, 2 * bound) << face << " " << plane << " " << z;
    }
    EXPECT_GT(behind, 500);
    EXPECT_GT(in_face, 500);
}

}  // namespace
}  // namespace delabole
