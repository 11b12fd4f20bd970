#include "kinematics/poles.hpp"

#include "kinematics/joint_set.hpp"
#include "kinematics/kinematics.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

namespace delabole {
namespace {

std::vector<double> alike(std::size_t count) {
    return std::vector<double>(count, 1.0);
}

void append(std::vector<Orientation>& planes, double dip, double dip_direction, double concentration, std::size_t count,
            std::uint64_t stream) {
    const JointSet set{"set", MeanOrientation{degrees(dip), degrees(dip_direction), concentration}};
    const std::vector<Orientation> more = sampled_planes(set, count, 5, stream);
    planes.insert(planes.end(), more.begin(), more.end());
}

// Fisher, Lewis & Embleton, Statistical Analysis of Spherical Data, table B2: declinations and inclinations of natural
// remanent magnetisation.
std::vector<Orientation> table_b2() {
    constexpr std::pair<double, double> directions[] = {
        {122.5, 55.5}, {130.5, 58.0}, {132.5, 44.0}, {148.5, 56.0}, {140.0, 63.0}, {133.0, 64.5}, {157.5, 53.0},
        {153.0, 44.5}, {140.0, 61.5}, {147.5, 54.5}, {142.0, 51.0}, {163.5, 56.0}, {141.0, 59.5}, {156.0, 56.5},
        {139.5, 54.0}, {153.5, 47.5}, {151.5, 61.0}, {147.5, 58.5}, {141.0, 57.0}, {143.5, 67.5}, {131.5, 62.5},
        {147.5, 63.5}, {147.0, 55.5}, {149.0, 62.0}, {144.0, 53.5}, {139.5, 58.0}};
    std::vector<Orientation> planes;
    for (const auto& [declination, inclination] : directions) {
        planes.push_back(plane_with_normal(direction_of({degrees(inclination), degrees(declination)})));
    }
    return planes;
}

// Printed there, examples 5.21 and 5.23: mean 144.2, 57.2; K = 109; cone of confidence 2.7 deg.
TEST(Poles, StatisticsOfAPublishedTable) {
    const std::vector<Orientation> planes = table_b2();
    const FisherStatistics statistics = fisher_statistics(planes, alike(planes.size()));
    const LineOrientation mean = line_along(upward_normal({statistics.mean_dip, statistics.mean_dip_direction}));
    EXPECT_NEAR(mean.trend, degrees(144.2), degrees(0.05));
    EXPECT_NEAR(mean.plunge, degrees(57.2), degrees(0.05));
    EXPECT_NEAR(statistics.concentration, 109, 0.5);
    EXPECT_NEAR(statistics.confidence_cone, degrees(2.7), degrees(0.05));
    EXPECT_LT(statistics.lower_concentration, 109);
    EXPECT_GT(statistics.upper_concentration, 109);
    EXPECT_EQ(find_clusters(planes, alike(planes.size()), 6).sets.size(), 1U);
}

// Over many samples of a known K its 95 % bounds hold it, and the cone of confidence holds the mean, in 95 % of them:
// within three standard deviations of that share.
TEST(Poles, BoundsHoldWhatTheyPromise) {
    constexpr int repetitions = 2000;
    constexpr double concentration = 40;
    const Direction mean = upward_normal({degrees(40), degrees(95)});
    int held_concentration = 0;
    int held_mean = 0;
    double inside = 0;
    for (int repetition = 0; repetition < repetitions; ++repetition) {
        std::vector<Orientation> planes;
        append(planes, 40, 95, concentration, 25, static_cast<std::uint64_t>(repetition));
        const FisherStatistics own = fisher_statistics(planes, alike(planes.size()));
        held_concentration +=
            own.lower_concentration <= concentration && concentration <= own.upper_concentration ? 1 : 0;
        const Direction found = upward_normal({own.mean_dip, own.mean_dip_direction});
        held_mean += std::acos(std::min(1.0, found.dot(mean))) <= own.confidence_cone ? 1 : 0;
        inside += static_cast<double>(std::ranges::count_if(planes, [&](const Orientation& plane) {
            return std::acos(std::min(1.0, found.dot(upward_normal(plane)))) <= own.variability_cone;
        }));
    }
    const double deviation = std::sqrt(0.95 * 0.05 / repetitions);
    EXPECT_NEAR(static_cast<double>(held_concentration) / repetitions, 0.95, 3 * deviation);
    EXPECT_NEAR(static_cast<double>(held_mean) / repetitions, 0.95, 3 * deviation);
    // The mean is that of the same poles, which lie up to 1 / (2 N) nearer to it than to the true one.
    EXPECT_NEAR(inside / (25.0 * repetitions), 0.683, 0.02);
}

TEST(Poles, OneOrEqualPolesScatterNot) {
    const FisherStatistics one = fisher_statistics({{degrees(30), 0}}, {1});
    EXPECT_EQ(one.concentration, std::numeric_limits<double>::infinity());
    EXPECT_EQ(one.confidence_cone, std::numbers::pi);
    const FisherStatistics equal = fisher_statistics({{degrees(30), 0}, {degrees(30), 0}}, {1, 1});
    EXPECT_EQ(equal.concentration, std::numeric_limits<double>::infinity());
    EXPECT_EQ(equal.confidence_cone, 0);
}

TEST(Poles, SteepPlanesAreOneSetAcrossTheirDipDirections) {
    std::vector<Orientation> planes;
    append(planes, 88, 90, 60, 80, 1);  // half of them dip to the west
    const PoleClusters clusters = find_clusters(planes, alike(planes.size()), 6);
    ASSERT_EQ(clusters.sets.size(), 1U);
    const Direction mean = upward_normal({degrees(88), degrees(90)});
    // Three times the standard error of the mean, 81 deg / sqrt(K N).
    EXPECT_GT(std::abs(clusters.sets[0].axis.dot(mean)), std::cos(degrees(3.5)));
}

TEST(Poles, SetsAreFoundAmongPolesThatBelongToNone) {
    std::vector<Orientation> planes;
    append(planes, 80, 275, 50, 80, 2);
    append(planes, 40, 95, 80, 60, 1);
    append(planes, 85, 185, 120, 40, 3);
    append(planes, 45, 0, 1e-3, 20, 4);
    const PoleClusters clusters = find_clusters(planes, alike(planes.size()), 8);
    ASSERT_EQ(clusters.sets.size(), 3U);
    const double means[3][2] = {{80, 275}, {40, 95}, {85, 185}};
    for (std::size_t set = 0; set < 3; ++set) {
        const Direction mean = upward_normal({degrees(means[set][0]), degrees(means[set][1])});
        EXPECT_GT(std::abs(clusters.sets[set].axis.dot(mean)), std::cos(degrees(4))) << set;  // 3 standard errors
    }
    int right = 0;
    for (std::size_t pole = 0; pole < 180; ++pole) {
        const std::size_t from = pole < 80 ? 0 : pole < 140 ? 1 : 2;
        right += clusters.of[pole] == from ? 1 : 0;
    }
    EXPECT_GE(right, 171);  // 95 %: what scatters farthest is taken for background
    ASSERT_EQ(clusters.information_criterion.size(), 9U);
    EXPECT_EQ(std::ranges::min_element(clusters.information_criterion) - clusters.information_criterion.begin(), 3);
}

std::vector<Orientation> two_sets_and_two_lone_poles() {
    std::vector<Orientation> planes;
    append(planes, 42, 210, 60, 14, 1);
    append(planes, 78, 30, 50, 14, 2);
    planes.push_back({degrees(34), degrees(318)});
    planes.push_back({degrees(50), degrees(120)});
    return planes;
}

// The criterion alone would take each for a set: with the greatest K, 1e4, log(K / N) is more than a set costs.
TEST(Poles, ALonePoleIsNoSet) {
    const std::vector<Orientation> planes = two_sets_and_two_lone_poles();
    const PoleClusters clusters = find_clusters(planes, alike(planes.size()), 6);
    EXPECT_EQ(clusters.sets.size(), 2U);
    EXPECT_FALSE(clusters.of[28]);
    EXPECT_FALSE(clusters.of[29]);
}

TEST(Poles, AStrayBelongsToNoSet) {
    std::vector<Orientation> planes;
    append(planes, 76, 310, 60, 14, 1);
    append(planes, 84, 214, 60, 13, 2);
    planes.push_back({degrees(61), degrees(190)});  // 32 deg from the mean; the cone of 99 % reaches to 26 deg
    const PoleClusters clusters = find_clusters(planes, alike(planes.size()), 3);
    ASSERT_EQ(clusters.sets.size(), 2U);
    EXPECT_FALSE(clusters.of[27]);
    std::size_t members = 0;
    for (const std::optional<std::size_t>& set : clusters.of) {
        members += set ? 1 : 0;
    }
    EXPECT_EQ(members, 27U);
    // Each set is described by its members alone.
    const std::vector<Orientation> second(planes.begin() + 14, planes.begin() + 27);
    const FisherStatistics statistics = fisher_statistics(second, alike(13));
    EXPECT_NEAR(clusters.sets[1].concentration, statistics.concentration, 1e-9 * statistics.concentration);
}

// Two sets without strays, 25 times: the F test takes 1 % of 800 poles, and the cones of confidence hold the means in
// 95 % of 50. The bounds allow three standard deviations, and for the cones also what they lose by the poles taken.
TEST(Poles, FewMembersAreTakenForStrays) {
    int taken = 0;
    int held = 0;
    int means = 0;
    for (std::uint64_t repetition = 0; repetition < 25; ++repetition) {
        std::vector<Orientation> planes;
        append(planes, 38, 125, 70, 18, 2 * repetition);
        append(planes, 76, 310, 50, 14, 2 * repetition + 1);
        const PoleClusters clusters = find_clusters(planes, alike(planes.size()), 2);
        ASSERT_EQ(clusters.sets.size(), 2U);
        taken += static_cast<int>(std::ranges::count_if(clusters.of, [](const auto& set) { return !set; }));
        for (std::size_t set = 0; set < 2; ++set) {
            std::vector<Orientation> members;
            for (std::size_t pole = 0; pole < planes.size(); ++pole) {
                if (clusters.of[pole] == set) {
                    members.push_back(planes[pole]);
                }
            }
            const FisherStatistics own = fisher_statistics(members, alike(members.size()));
            const Direction mean = upward_normal({own.mean_dip, own.mean_dip_direction});
            const double first = std::abs(mean.dot(upward_normal({degrees(38), degrees(125)})));
            const double second = std::abs(mean.dot(upward_normal({degrees(76), degrees(310)})));
            held += std::acos(std::min(1.0, std::max(first, second))) <= own.confidence_cone ? 1 : 0;
            ++means;
        }
    }
    EXPECT_GE(taken, 1);
    EXPECT_LE(taken, 16);
    EXPECT_EQ(means, 50);
    EXPECT_GE(held, 41);
}

TEST(Poles, SaysWhichNumbersGiveSetsThatAreTooSmall) {
    const std::vector<Orientation> planes = two_sets_and_two_lone_poles();
    const PoleClusters clusters = find_clusters(planes, alike(planes.size()), 4);
    EXPECT_EQ(clusters.too_small, (std::vector<bool>{false, false, false, true, true}));
    EXPECT_LT(clusters.information_criterion[3], clusters.information_criterion[2]);
}

// Evidence is not certainty: of 20 samples of even scatter at most two show a set.
TEST(Poles, EvenlyScatteredPolesHardlyFormSets) {
    int found = 0;
    for (std::uint64_t stream = 0; stream < 20; ++stream) {
        std::vector<Orientation> planes;
        append(planes, 45, 0, 1e-3, 100, stream);
        found += find_clusters(planes, alike(planes.size()), 4).sets.empty() ? 0 : 1;
    }
    EXPECT_LE(found, 2);
}

TEST(Poles, OrderAndTurningChangeNothing) {
    std::vector<Orientation> planes;
    append(planes, 40, 95, 80, 30, 1);
    append(planes, 80, 275, 50, 50, 2);
    std::vector<Orientation> other(planes.rbegin(), planes.rend());
    for (Orientation& plane : other) {
        plane.dip_direction = wrapped_azimuth(plane.dip_direction + degrees(123));
    }
    const PoleClusters first = find_clusters(planes, alike(planes.size()), 5);
    const PoleClusters second = find_clusters(other, alike(planes.size()), 5);
    ASSERT_EQ(first.sets.size(), second.sets.size());
    for (std::size_t set = 0; set < first.sets.size(); ++set) {
        // Iterations end where the likelihood grows by less than 1e-7 for each pole.
        EXPECT_NEAR(first.sets[set].concentration / second.sets[set].concentration, 1, 0.01);
    }
    for (std::size_t pole = 0; pole < planes.size(); ++pole) {
        EXPECT_EQ(first.of[pole], second.of[planes.size() - 1 - pole]);
    }
}

TEST(Poles, AScanlineSeesPlanesParallelToItLess) {
    // A horizontal line to the east meets a vertical plane that dips east square on, and one dipping north at 0 deg.
    const LineOrientation line{0, degrees(90)};
    EXPECT_NEAR(terzaghi_weight({degrees(90), degrees(90)}, line, degrees(15)), 1, 1e-12);
    EXPECT_NEAR(terzaghi_weight({degrees(90), degrees(60)}, line, degrees(15)), 1 / std::cos(degrees(30)), 1e-12);
    EXPECT_NEAR(terzaghi_weight({degrees(90), 0}, line, degrees(15)), 1 / std::sin(degrees(15)), 1e-12);
    // Weights of 2 are planes counted twice, but for their number.
    const std::vector<Orientation> planes{{degrees(30), degrees(90)}, {degrees(40), degrees(100)}};
    const FisherStatistics weighted = fisher_statistics(planes, {2, 1});
    const FisherStatistics repeated = fisher_statistics({planes[0], planes[0], planes[1]}, {1, 1, 1});
    EXPECT_NEAR(weighted.mean_dip, repeated.mean_dip, 1e-13);
    EXPECT_NEAR(weighted.resultant / 2, repeated.resultant / 3, 1e-13);
    EXPECT_EQ(weighted.count, 2);
}

TEST(Poles, KambsDensityIsTheExcessOverUniform) {
    std::vector<Direction> poles;
    std::vector<Orientation> planes;
    append(planes, 45, 0, 1e-3, 4000, 9);
    for (const Orientation& plane : planes) {
        poles.push_back(upward_normal(plane));
    }
    // Over many places the standard deviation is as it is defined.
    double sum = 0;
    double squares = 0;
    std::vector<Orientation> places;
    append(places, 45, 0, 1e-3, 500, 10);
    for (const Orientation& place : places) {
        const double density = kamb_density(poles, alike(poles.size()), upward_normal(place));
        sum += density;
        squares += density * density;
    }
    EXPECT_NEAR(sum / 500, 0, 0.2);      // 3 / sqrt(500) and what the poles share
    EXPECT_NEAR(squares / 500, 1, 0.3);  // likewise
    // All poles lie at one place: N out of N, against N A +- sqrt(N A (1 - A)) with A = 9 / (N + 9).
    const std::vector<Direction> together(9, Direction(0, 0, 1));
    EXPECT_NEAR(kamb_density(together, alike(9), Direction(0, 0, 1)), (9 - 4.5) / std::sqrt(9 * 0.25), 1e-12);
}

KinematicsStudy study_of(const std::vector<Orientation>& planes) {
    KinematicsStudy study{};
    study.model.slope = {degrees(70), degrees(95), std::nullopt};
    study.model.strength = {degrees(30)};
    study.model.lateral_limit = {degrees(20), degrees(30), degrees(20)};
    study.model.poles = {{std::nullopt, planes, std::nullopt}};
    return study;
}

TEST(Poles, KinematicsCountsEveryPoleAndEveryIntersection) {
    std::vector<Orientation> planes;
    append(planes, 40, 95, 80, 30, 1);
    append(planes, 80, 275, 50, 40, 2);
    const KinematicsStudy study = study_of(planes);
    const KinematicsResult result = analyse(study);
    ASSERT_EQ(result.check, KinematicsCheck::valid);
    ASSERT_TRUE(result.poles);
    EXPECT_EQ(result.poles->count, 70);
    EXPECT_EQ(result.poles->intersections, 70 * 69 / 2);
    double sliding = 0;
    double in_sets = 0;
    for (const Orientation& plane : planes) {
        sliding +=
            planar_sliding(study.model.slope, plane, degrees(30), degrees(20)).feasibility == Feasibility::feasible ? 1
                                                                                                                    : 0;
    }
    EXPECT_EQ(result.poles->planar_sliding, sliding);
    EXPECT_GT(sliding, 10);
    // A line that plunges less than the friction angle belongs to the secondary zone.
    double primary = 0;
    double secondary = 0;
    for (std::size_t first = 0; first < planes.size(); ++first) {
        for (std::size_t second = 0; second < first; ++second) {
            if (wedge_sliding(study.model.slope, planes[second], planes[first], degrees(30)).feasibility ==
                Feasibility::feasible) {
                (intersection(planes[second], planes[first])->plunge > degrees(30) ? primary : secondary) += 1;
            }
        }
    }
    EXPECT_EQ(result.poles->wedge_sliding, primary + secondary);
    EXPECT_EQ(result.poles->wedge_sliding_secondary, secondary);
    EXPECT_GT(secondary, 0);
    for (const JointSetFeasibility& set : result.joint_set) {
        ASSERT_TRUE(set.measured);
        in_sets += set.measured->count;
    }
    EXPECT_EQ(in_sets + result.poles->without_set, 70);
    ASSERT_EQ(result.sets_of_pole.size(), 70U);
    EXPECT_EQ(std::ranges::count_if(result.sets_of_pole, [](const auto& sets) { return sets.size() == 1; }), in_sets);
}

TEST(Poles, AWindowPicksASet) {
    std::vector<Orientation> planes;
    append(planes, 40, 95, 200, 30, 1);
    append(planes, 80, 275, 200, 40, 2);
    KinematicsStudy study = study_of(planes);
    study.model.joint_set = {{"bedding", PoleWindow{degrees(42), degrees(90), degrees(25)}}};
    const KinematicsResult result = analyse(study);
    ASSERT_EQ(result.check, KinematicsCheck::valid);
    ASSERT_EQ(result.joint_set.size(), 1U);
    EXPECT_EQ(result.joint_set[0].measured->count, 30);
    EXPECT_EQ(result.poles->without_set, 40);
    EXPECT_NEAR(result.joint_set[0].mean.dip, degrees(40), degrees(3));  // 3 standard errors
    study.model.joint_set = {{"nothing", PoleWindow{degrees(5), degrees(90), degrees(5)}}};
    EXPECT_EQ(analyse(study).check, KinematicsCheck::window_without_poles);
    study.model.joint_set.clear();
    study.model.poles[0].plane.clear();
    EXPECT_EQ(analyse(study).check, KinematicsCheck::survey_without_planes);
}

TEST(Poles, AScanlineWeighsTheScatterOfASet) {
    KinematicsStudy study = study_of({{degrees(30), degrees(90)}, {degrees(50), degrees(90)}});
    study.model.poles[0].scanline = Scanline{degrees(90), 0, std::nullopt};
    study.model.joint_set = {{"bedding", PoleWindow{degrees(40), degrees(90), degrees(15)}}};
    const KinematicsResult result = analyse(study);
    ASSERT_EQ(result.joint_set.size(), 1U);
    // A vertical line meets planes in proportion to the cosines of their dips.
    const double flat = 1 / std::cos(degrees(30));
    const double steep = 1 / std::cos(degrees(50));
    const double resultant = std::sqrt(flat * flat + steep * steep + 2 * flat * steep * std::cos(degrees(20)));
    EXPECT_NEAR(result.joint_set[0].angular_standard_deviation, std::acos(resultant / (flat + steep)), 1e-12);
}

}  // namespace
}  // namespace delabole
