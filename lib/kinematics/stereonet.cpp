#include "kinematics/stereonet.hpp"

#include "numerics/constants.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace delabole {

namespace {

constexpr double half_turn = std::numbers::pi;

// `count` points for equally spaced values from first to last.
template <class Function>
Polyline curve(double first, double last, std::size_t count, Function&& point_at) {
    Polyline points;
    points.reserve(count);
    for (std::size_t index = 0; index < count; ++index) {
        const double share = static_cast<double>(index) / static_cast<double>(count - 1);
        points.push_back(point_at(first + (last - first) * share));
    }
    return points;
}

// Closed outline of the lines between two plunges that change with the trend: out along one limit, back along the
// other. Trends at which the limits cross contain no lines and are skipped.
template <class Lower, class Upper>
Polyline zone(double middle_trend, double half_width, std::size_t count, NetProjection projection, Lower&& lower_plunge,
              Upper&& upper_plunge) {
    Polyline out;
    Polyline back;
    // A vertical face has no apparent dip along its strike.
    const double inner_width = half_width * (1 - 1e-9);
    curve(-inner_width, inner_width, count, [&](double aside) {
        const double lower = lower_plunge(aside);
        const double upper = upper_plunge(aside);
        if (upper > lower) {
            out.push_back(projected_line({lower, middle_trend + aside}, projection));
            back.push_back(projected_line({upper, middle_trend + aside}, projection));
        }
        return Point(0, 0);
    });
    if (out.size() < 2) {
        return {};
    }
    out.insert(out.end(), back.rbegin(), back.rend());
    out.push_back(out.front());
    return out;
}

// Apparent dip of a plane of this dip at an angle in plan from its dip direction.
double apparent(double dip, double aside) {
    return apparent_dip({dip, 0}, aside);
}

// Half the angle in plan within which a plane of `dip` has an apparent dip greater than `least`.
double reach(double dip, double least) {
    if (!(dip > least)) {
        return 0;
    }
    return std::acos(std::clamp(std::tan(least) / std::tan(dip), 0.0, 1.0));
}

}  // namespace

Point projected(const Direction& direction, NetProjection projection) {
    const double stretch = 1 - direction.z();
    const Point horizontal(direction.x(), direction.y());
    // sin t / (1 + cos t) = tan(t / 2) and sin t / sqrt(1 + cos t) = sqrt(2) sin(t / 2), with cos t = -z.
    return projection == NetProjection::equal_angle ? Point(horizontal / stretch)
                                                    : Point(horizontal / std::sqrt(stretch));
}

Direction direction_at(const Point& point, NetProjection projection) {
    const double square = point.squaredNorm();
    if (projection == NetProjection::equal_angle) {
        return Direction(2 * point.x(), 2 * point.y(), square - 1) / (1 + square);
    }
    const double stretch = std::sqrt(std::max(0.0, 2 - square));
    return {point.x() * stretch, point.y() * stretch, square - 1};
}

Point projected_pole(const Orientation& plane, NetProjection projection) {
    return projected(-upward_normal(plane), projection);
}

Point projected_line(const LineOrientation& line, NetProjection projection) {
    return projected(direction_of(line), projection);
}

Polyline great_circle(const Orientation& plane, NetProjection projection, std::size_t count) {
    const Direction down_dip = dip_vector(plane);
    const Direction strike = direction_of({0, plane.dip_direction - right_angle});
    return curve(0, half_turn, count, [&](double rake) {
        return projected(std::cos(rake) * strike + std::sin(rake) * down_dip, projection);
    });
}

Polyline plunge_circle(double plunge, NetProjection projection, std::size_t count) {
    return curve(0, 2 * half_turn, count, [&](double trend) { return projected_line({plunge, trend}, projection); });
}

Polyline daylight_envelope(const SlopeOrientation& slope, NetProjection projection, std::size_t count) {
    return curve(-right_angle, right_angle, count, [&](double aside) {
        return projected_pole({std::max(0.0, apparent(slope.face_dip, aside)), slope.face_dip_direction + aside},
                              projection);
    });
}

Polyline planar_sliding_zone(const SlopeOrientation& slope, double friction_angle, double lateral_limit,
                             NetProjection projection, std::size_t count) {
    const double half_width = std::min(lateral_limit, reach(slope.face_dip, friction_angle));
    return zone(
        slope.face_dip_direction + half_turn, half_width, count, projection,
        [&](double aside) { return right_angle - apparent(slope.face_dip, aside); },
        [&](double) { return right_angle - friction_angle; });
}

Polyline flexural_toppling_zone(const SlopeOrientation& slope, double friction_angle, double lateral_limit,
                                NetProjection projection, std::size_t count) {
    return zone(
        slope.face_dip_direction, lateral_limit, count, projection, [](double) { return 0.0; },
        [&](double aside) { return apparent(std::max(0.0, slope.face_dip - friction_angle), aside); });
}

Polyline wedge_sliding_zone(const SlopeOrientation& slope, double friction_angle, NetProjection projection,
                            std::size_t count) {
    return zone(
        slope.face_dip_direction, reach(slope.face_dip, friction_angle), count, projection,
        [&](double) { return friction_angle; }, [&](double aside) { return apparent(slope.face_dip, aside); });
}

Polyline secondary_wedge_sliding_zone(const SlopeOrientation& slope, double friction_angle, NetProjection projection,
                                      std::size_t count) {
    return zone(
        slope.face_dip_direction, slope.face_dip > friction_angle && friction_angle > 0 ? right_angle : 0, count,
        projection, [&](double aside) { return std::max(0.0, apparent(friction_angle, aside)); },
        [&](double aside) { return std::clamp(apparent(slope.face_dip, aside), 0.0, friction_angle); });
}

Polyline toppling_axis_zone(const SlopeOrientation& slope, double lateral_limit, NetProjection projection,
                            std::size_t count) {
    return zone(
        slope.face_dip_direction + half_turn, lateral_limit, count, projection,
        [&](double) { return right_angle - slope.face_dip; }, [](double) { return right_angle; });
}

Polyline oblique_toppling_axis_zone(const SlopeOrientation& slope, double friction_angle, NetProjection projection,
                                    std::size_t count) {
    return zone(
        slope.face_dip_direction + half_turn, right_angle, count, projection,
        [&](double) { return right_angle - friction_angle; }, [](double) { return right_angle; });
}

double pole_density(const std::vector<Direction>& poles, const Direction& at, double kernel_concentration) {
    return pole_density(poles, std::vector<double>(poles.size(), 1.0), at, kernel_concentration);
}

namespace {

// The sum of the kernels of all poles, times their weights.
double summed_kernels(const std::vector<Direction>& poles, const std::vector<double>& weights, const Direction& at,
                      double kernel_concentration) {
    constexpr double negligible = -30;  // exp(-30) = 1e-13
    const double scale = kernel_concentration / -std::expm1(-2 * kernel_concentration);
    double sum = 0;
    for (std::size_t pole = 0; pole < poles.size(); ++pole) {
        const double cosine = std::abs(poles[pole].dot(at));
        const double exponent = kernel_concentration * (cosine - 1);
        if (exponent > negligible) {
            // The far end of the axis is left out if it is less than the rounding of the near one, exp(-37) = 2^-53.
            const double far_end =
                2 * kernel_concentration * cosine > 37 ? 0 : std::exp(-kernel_concentration * (cosine + 1));
            sum += weights[pole] * (std::exp(exponent) + far_end);
        }
    }
    return scale * sum;
}

}  // namespace

double pole_density(const std::vector<Direction>& poles, const std::vector<double>& weights, const Direction& at,
                    double kernel_concentration) {
    return poles.empty() ? 0
                         : summed_kernels(poles, weights, at, kernel_concentration) /
                               std::accumulate(weights.begin(), weights.end(), 0.0);
}

namespace {

DensityGrid empty_grid(std::size_t side) {
    DensityGrid grid;
    const double cell = 2 / static_cast<double>(side - 3);
    for (std::size_t index = 0; index < side; ++index) {
        grid.coordinates.push_back(cell * (static_cast<double>(index) - static_cast<double>(side - 1) / 2));
    }
    const auto size = static_cast<Eigen::Index>(side);
    grid.values = Eigen::MatrixXd::Constant(size, size, std::numeric_limits<double>::quiet_NaN());
    return grid;
}

// Computes missing values at points on or near the net, in every `stride`th row and column.
template <class Value>
void fill(DensityGrid& grid, Eigen::Index stride, Value&& value) {
    const double cell = grid.coordinates[1] - grid.coordinates[0];
    // The corners of every cell that the primitive crosses lie within a cell's diagonal of it.
    const double reach_out = 1 + std::numbers::sqrt2 * cell;
    for (Eigen::Index row = 0; row < grid.values.rows(); row += stride) {
        for (Eigen::Index column = 0; column < grid.values.cols(); column += stride) {
            const Point point(grid.coordinates[static_cast<std::size_t>(column)],
                              grid.coordinates[static_cast<std::size_t>(row)]);
            if (std::isnan(grid.values(row, column)) && point.norm() <= reach_out) {
                grid.values(row, column) = value(row, column, point);
            }
        }
    }
}

// Value halfway between the second and the third of four points, on the cubic through all of them. NaN if one of them
// has no value or lies off the grid.
double halfway(const Eigen::MatrixXd& values, Eigen::Index row, Eigen::Index column, bool along_row) {
    const Eigen::Index at = along_row ? column : row;
    if (at < 3 || at + 3 >= values.rows()) {
        return std::numeric_limits<double>::quiet_NaN();
    }
    const auto aside = [&](Eigen::Index by) { return along_row ? values(row, column + by) : values(row + by, column); };
    return (9 * (aside(-1) + aside(1)) - aside(-3) - aside(3)) / 16;
}

}  // namespace

DensityGrid density_grid(const std::function<double(const Direction&)>& density, NetProjection projection,
                         std::size_t side) {
    DensityGrid grid = empty_grid(side);
    fill(grid, 1,
         [&](Eigen::Index, Eigen::Index, const Point& point) { return density(direction_at(point, projection)); });
    return grid;
}

DensityGrid pole_density_grid(const std::vector<Direction>& poles, const std::vector<double>& weights,
                              double kernel_concentration, NetProjection projection, std::size_t side) {
    DensityGrid grid = empty_grid(side);
    const double total = poles.empty() ? 1 : std::accumulate(weights.begin(), weights.end(), 0.0);
    const auto summed = [&](Eigen::Index, Eigen::Index, const Point& point) {
        return summed_kernels(poles, weights, direction_at(point, projection), kernel_concentration) / total;
    };
    fill(grid, 2, summed);
    const Eigen::MatrixXd& values = grid.values;
    fill(grid, 1, [&](Eigen::Index row, Eigen::Index column, const Point&) {
        return row % 2 == 0 ? halfway(values, row, column, true) : std::numeric_limits<double>::quiet_NaN();
    });
    fill(grid, 1, [&](Eigen::Index row, Eigen::Index column, const Point&) {
        return row % 2 == 1 ? halfway(values, row, column, false) : std::numeric_limits<double>::quiet_NaN();
    });
    fill(grid, 1, summed);
    return grid;
}

std::vector<Polyline> inside_primitive(const Polyline& line) {
    std::vector<Polyline> parts;
    bool open = false;
    const auto add = [&](const Point& point) {
        if (!open) {
            parts.emplace_back();
            open = true;
        }
        parts.back().push_back(point);
    };
    for (std::size_t index = 0; index < line.size(); ++index) {
        const bool inside = line[index].norm() <= 1;
        if (index > 0 && inside != (line[index - 1].norm() <= 1)) {
            // |a + s (b - a)| = 1 between a point inside and one outside: one root in [0, 1].
            const Point& from = line[index - 1];
            const Point along = line[index] - from;
            const double square = along.squaredNorm();
            const double half = from.dot(along) / square;
            const double root = std::sqrt(std::max(0.0, half * half - (from.squaredNorm() - 1) / square));
            add(from + (inside ? -half - root : -half + root) * along);
        }
        if (inside) {
            add(line[index]);
        } else {
            open = false;
        }
    }
    return parts;
}

}  // namespace delabole
