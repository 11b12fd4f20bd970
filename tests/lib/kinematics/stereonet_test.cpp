#include "kinematics/stereonet.hpp"
#include "kinematics/criteria.hpp"

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace delabole {
namespace {

constexpr double pi = std::numbers::pi;
constexpr NetProjection projections[] = {NetProjection::equal_area, NetProjection::equal_angle};

TEST(Stereonet, ProjectsByHand) {
    for (const NetProjection projection : projections) {
        EXPECT_NEAR(projected_line({degrees(90), 0}, projection).norm(), 0, 1e-15);
        EXPECT_NEAR((projected_line({0, degrees(90)}, projection) - Point(1, 0)).norm(), 0, 1e-15);
        EXPECT_NEAR((projected_line({0, 0}, projection) - Point(0, 1)).norm(), 0, 1e-15);
    }
    // 45 deg down: sqrt(2) sin 22.5 deg and tan 22.5 deg.
    EXPECT_NEAR(projected_line({degrees(45), degrees(180)}, NetProjection::equal_area).y(),
                -std::sqrt(2) * std::sin(pi / 8), 1e-15);
    EXPECT_NEAR(projected_line({degrees(45), degrees(180)}, NetProjection::equal_angle).y(), -std::tan(pi / 8), 1e-15);
    // The pole of a plane dipping 30 deg east plunges 60 deg west.
    EXPECT_NEAR(
        (projected_pole({degrees(30), degrees(90)}, NetProjection::equal_angle) - Point(-std::tan(pi / 12), 0)).norm(),
        0, 1e-15);
}

TEST(Stereonet, DirectionsComeBack) {
    for (const NetProjection projection : projections) {
        for (double x = -1.1; x <= 1.1; x += 0.1) {
            for (double y = -0.8; y <= 0.8; y += 0.1) {
                const Direction direction = direction_at({x, y}, projection);
                EXPECT_NEAR(direction.norm(), 1, 1e-14);
                // Away from the outer rim of the equal-area net only rounding is lost.
                EXPECT_NEAR((projected(direction, projection) - Point(x, y)).norm(), 0, 1e-14);
            }
        }
    }
}

// The images of two short perpendicular steps span (area scale) times the area on the sphere: 1/2 everywhere on the
// equal-area net (pi for 2 pi). On the equal-angle net they stay perpendicular and equally long.
TEST(Stereonet, KeepsAreasAndAngles) {
    constexpr double step = 1e-5;  // central differences: error step^2
    for (int plunge = 0; plunge <= 85; plunge += 5) {
        for (int trend = 0; trend < 360; trend += 30) {
            const Direction at = direction_of({degrees(plunge), degrees(trend)});
            const Direction east = at.cross(Direction(0, 0, 1)).normalized();
            const Direction steep = east.cross(at);
            const auto image = [&](const Direction& along, NetProjection projection) {
                return Point((projected((at + step * along).normalized(), projection) -
                              projected((at - step * along).normalized(), projection)) /
                             (2 * step));
            };
            const Point area_east = image(east, NetProjection::equal_area);
            const Point area_steep = image(steep, NetProjection::equal_area);
            EXPECT_NEAR(std::abs(area_east.x() * area_steep.y() - area_east.y() * area_steep.x()), 0.5, 1e-8);
            const Point angle_east = image(east, NetProjection::equal_angle);
            const Point angle_steep = image(steep, NetProjection::equal_angle);
            EXPECT_NEAR(angle_east.dot(angle_steep), 0, 1e-8);
            EXPECT_NEAR(angle_east.norm(), angle_steep.norm(), 1e-8);
        }
    }
}

TEST(Stereonet, GreatCirclesLieInTheirPlane) {
    for (const NetProjection projection : projections) {
        for (const double dip : {0.0, 20.0, 70.0, 90.0}) {
            const Orientation plane{degrees(dip), degrees(102.5)};
            const Polyline circle = great_circle(plane, projection, 31);
            ASSERT_EQ(circle.size(), 31U);
            EXPECT_NEAR(circle.front().norm(), 1, 1e-14);
            EXPECT_NEAR(circle.back().norm(), 1, 1e-14);
            for (const Point& point : circle) {
                EXPECT_LE(point.norm(), 1 + 1e-14);
                EXPECT_NEAR(direction_at(point, projection).dot(upward_normal(plane)), 0, 1e-14);
            }
        }
    }
}

TEST(Stereonet, PolesOnTheEnvelopeHaveTheirDipVectorInTheFace) {
    const SlopeOrientation slope{degrees(70), degrees(102.5), {}};
    for (const NetProjection projection : projections) {
        for (const Point& point : daylight_envelope(slope, projection, 61)) {
            const Orientation plane = plane_with_normal(direction_at(point, projection));
            if (plane.dip > degrees(1)) {  // the ends have no dip direction
                EXPECT_NEAR(dip_vector(plane).dot(upward_normal({degrees(70), degrees(102.5)})), 0, 1e-12);
            }
        }
    }
}

bool inside(const Polyline& outline, const Point& point) {
    bool result = false;
    for (std::size_t index = 0; index + 1 < outline.size(); ++index) {
        const Point& a = outline[index];
        const Point& b = outline[index + 1];
        if ((a.y() > point.y()) != (b.y() > point.y()) &&
            point.x() < a.x() + (b.x() - a.x()) * (point.y() - a.y()) / (b.y() - a.y())) {
            result = !result;
        }
    }
    return result;
}

// The zones drawn agree with the verdicts.
TEST(Stereonet, ZonesHoldExactlyWhatIsFeasible) {
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> share(0, 1);
    for (const double face_dip : {30.0, 70.0, 90.0}) {
        for (const double friction_deg : {0.0, 20.0, 45.0}) {
            const SlopeOrientation slope{degrees(face_dip), degrees(350), {}};
            const double friction = degrees(friction_deg);
            const double limit = degrees(25);
            for (const NetProjection projection : projections) {
                // 2001 points on a curve keep the outline within 1e-6 of it.
                const Polyline planar = planar_sliding_zone(slope, friction, limit, projection, 2001);
                const Polyline toppling = flexural_toppling_zone(slope, friction, limit, projection, 2001);
                const Polyline axes = toppling_axis_zone(slope, limit, projection, 2001);
                const Polyline oblique = oblique_toppling_axis_zone(slope, friction, projection, 2001);
                const Polyline wedge = wedge_sliding_zone(slope, friction, projection, 2001);
                int differences = 0;
                int feasible = 0;
                for (int trial = 0; trial < 2000; ++trial) {
                    const Orientation plane{degrees(90) * share(random), degrees(360) * share(random)};
                    const LineOrientation line{plane.dip, plane.dip_direction};
                    const Point pole = projected_pole(plane, projection);
                    const bool slides =
                        planar_sliding(slope, plane, friction, limit).feasibility == Feasibility::feasible;
                    const bool topples =
                        flexural_toppling(slope, plane, friction, limit).feasibility == Feasibility::feasible;
                    const bool axis = toppling_axis(slope, line, friction, limit) == Feasibility::feasible;
                    // A plane dipping along the line slides on it, without a limit in plan, as a wedge does.
                    const bool wedges =
                        planar_sliding(slope, plane, friction, degrees(90)).feasibility == Feasibility::feasible;
                    feasible += (slides ? 1 : 0) + (topples ? 1 : 0) + (axis ? 1 : 0) + (wedges ? 1 : 0);
                    differences += slides != inside(planar, pole) ? 1 : 0;
                    differences += topples != inside(toppling, pole) ? 1 : 0;
                    const Point image = projected_line(line, projection);
                    differences += axis != (inside(axes, image) || inside(oblique, image)) ? 1 : 0;
                    differences += wedges != inside(wedge, image) ? 1 : 0;
                }
                // The outlines follow the curves to 1e-6: one of 2000 points in 500 runs would fall between.
                EXPECT_EQ(differences, 0) << face_dip << ' ' << friction_deg;
                EXPECT_GT(feasible, 0);
            }
        }
    }
    const SlopeOrientation gentle{degrees(30), 0, {}};
    EXPECT_TRUE(planar_sliding_zone(gentle, degrees(30), degrees(20), NetProjection::equal_area).empty());
    EXPECT_TRUE(wedge_sliding_zone(gentle, degrees(89.9), NetProjection::equal_area).empty());
    EXPECT_TRUE(flexural_toppling_zone(gentle, degrees(31), degrees(30), NetProjection::equal_area).empty());
}

// Outside the primary zone a wedge slides only within the secondary one.
TEST(Stereonet, TheSecondaryZoneHoldsTheFlatLinesAlongWhichWedgesSlide) {
    std::mt19937_64 random(4);
    std::uniform_real_distribution<double> share(0, 1);
    const SlopeOrientation slope{degrees(68), degrees(130), {}};
    const double friction = degrees(30);
    const Polyline primary = wedge_sliding_zone(slope, friction, NetProjection::equal_area, 2001);
    const Polyline secondary = secondary_wedge_sliding_zone(slope, friction, NetProjection::equal_area, 2001);
    int flat = 0;
    for (int trial = 0; trial < 5000; ++trial) {
        const Orientation first{degrees(90) * share(random), degrees(360) * share(random)};
        const Orientation second{degrees(90) * share(random), degrees(360) * share(random)};
        const LineOrientation line = *intersection(first, second);
        const Point image = projected_line(line, NetProjection::equal_area);
        if (wedge_sliding(slope, first, second, friction).feasibility == Feasibility::feasible) {
            const bool in_secondary = inside(secondary, image);
            EXPECT_NE(inside(primary, image), in_secondary) << line.plunge << ' ' << line.trend;
            flat += in_secondary ? 1 : 0;
        }
    }
    EXPECT_GT(flat, 50);
    EXPECT_TRUE(secondary_wedge_sliding_zone(slope, 0, NetProjection::equal_area).empty());
    EXPECT_TRUE(secondary_wedge_sliding_zone(slope, degrees(68), NetProjection::equal_area).empty());
}

std::vector<Direction> random_poles(std::size_t count) {
    std::mt19937_64 random(9);
    std::normal_distribution<double> normal;
    std::vector<Direction> poles;
    while (poles.size() < count) {
        poles.push_back(Direction(normal(random), normal(random), normal(random)).normalized());
    }
    return poles;
}

// Over the equal-area net every cell is the same share of the hemisphere, so that density (multiples of uniform) times
// the number of poles, averaged over the net, is the number of poles.
TEST(PoleDensity, IntegratesToTheNumberOfPoles) {
    const std::vector<Direction> poles = random_poles(25);
    for (const double concentration : {0.01, 5.0, 100.0}) {
        constexpr std::size_t side = 203;
        const DensityGrid grid =
            pole_density_grid(poles, std::vector<double>(25, 1.0), concentration, NetProjection::equal_area, side);
        double sum = 0;
        double points = 0;
        for (Eigen::Index row = 0; row < grid.values.rows(); ++row) {
            for (Eigen::Index column = 0; column < grid.values.cols(); ++column) {
                const Point at(grid.coordinates[static_cast<std::size_t>(column)],
                               grid.coordinates[static_cast<std::size_t>(row)]);
                if (at.norm() <= 1) {
                    sum += grid.values(row, column) * static_cast<double>(poles.size());
                    ++points;
                }
            }
        }
        // The rim of the net runs through 1 % of its cells, which are in or out with what density they have.
        EXPECT_NEAR(sum / points, 25, 0.01 * 25) << concentration;
    }
}

TEST(PoleDensity, OfOnePoleIsFishersKernelOnBothItsEnds) {
    const Direction pole = direction_of({degrees(10), degrees(40)});
    const Direction at = direction_of({degrees(5), degrees(230)});
    const double cosine = pole.dot(at);
    ASSERT_LT(cosine, 0);  // near the other end of the axis
    const double concentration = 50;
    // Terms under 1e-13 of the kernel's peak are left out.
    EXPECT_NEAR(pole_density({pole}, at, concentration),
                concentration * std::cosh(concentration * cosine) / std::sinh(concentration), 1e-11);
    EXPECT_EQ(pole_density({}, at, concentration), 0);
    EXPECT_NEAR(pole_density({pole}, pole, customary_kernel_concentration), 100, 1e-11);
}

// Between the points at which it is summed up the grid follows the kernel as far as its header says, and by the fourth
// power of the distance: half of it leaves less than a tenth.
TEST(PoleDensity, OfAGridIsThatOfItsPointsWithinThePromisedShare) {
    const auto greatest_error = [](NetProjection projection, std::size_t side) {
        double greatest = 0;
        for (const Direction& pole : random_poles(30)) {
            const DensityGrid grid = pole_density_grid({pole}, {1.0}, customary_kernel_concentration, projection, side);
            for (Eigen::Index row = 0; row < grid.values.rows(); ++row) {
                for (Eigen::Index column = 0; column < grid.values.cols(); ++column) {
                    const Point at(grid.coordinates[static_cast<std::size_t>(column)],
                                   grid.coordinates[static_cast<std::size_t>(row)]);
                    if (at.norm() <= 1) {
                        const double exact =
                            pole_density({pole}, direction_at(at, projection), customary_kernel_concentration);
                        greatest = std::max(greatest, std::abs(grid.values(row, column) - exact));
                    }
                }
            }
        }
        return greatest;
    };
    for (const NetProjection projection : {NetProjection::equal_area, NetProjection::equal_angle}) {
        const double usual = greatest_error(projection, 121);
        EXPECT_LT(usual, projection == NetProjection::equal_area ? 1.1 : 2.1);
        EXPECT_GT(usual, 0.01) << "it is not summed up everywhere";
        EXPECT_LT(greatest_error(projection, 241), 0.1 * usual);
    }
}

TEST(PoleDensity, IsFiniteOverTheWholeNetOnly) {
    const DensityGrid grid = pole_density_grid(random_poles(3), {1, 1, 1}, 20, NetProjection::equal_angle, 41);
    for (Eigen::Index row = 0; row < 41; ++row) {
        for (Eigen::Index column = 0; column < 41; ++column) {
            const double radius = std::hypot(grid.coordinates[static_cast<std::size_t>(column)],
                                             grid.coordinates[static_cast<std::size_t>(row)]);
            if (radius <= 1) {
                EXPECT_TRUE(std::isfinite(grid.values(row, column)));
            }
            if (radius > 1.2) {
                EXPECT_FALSE(std::isfinite(grid.values(row, column)));
            }
        }
    }
}

TEST(Stereonet, CutsLinesAtThePrimitive) {
    const std::vector<Polyline> parts = inside_primitive({{-2, 0}, {0, 0}, {0, 2}, {2, 2}, {2, 0}, {0.5, 0}});
    ASSERT_EQ(parts.size(), 2U);
    ASSERT_EQ(parts[0].size(), 3U);
    EXPECT_NEAR((parts[0][0] - Point(-1, 0)).norm(), 0, 1e-15);
    EXPECT_NEAR((parts[0][2] - Point(0, 1)).norm(), 0, 1e-15);
    ASSERT_EQ(parts[1].size(), 2U);
    EXPECT_NEAR((parts[1][0] - Point(1, 0)).norm(), 0, 1e-15);
    EXPECT_TRUE(inside_primitive({{2, 0}, {0, 3}}).empty());
}

}  // namespace
}  // namespace delabole
