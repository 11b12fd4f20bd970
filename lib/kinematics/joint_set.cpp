#include "kinematics/joint_set.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <random>

namespace delabole {

namespace {

constexpr double turn = 2 * std::numbers::pi;

double clockwise_width(const OrientationRange& range) {
    const double width = range.last_dip_direction - range.first_dip_direction;
    return width < 0 ? width + turn : width;
}

// Uniform in [0, 1): the upper 53 bits, as many as a double holds.
class UniformStream {
  public:
    UniformStream(std::uint64_t seed, std::uint64_t stream) : engine_(mixed(mixed(seed) + stream)) {}

    double next() { return static_cast<double>(engine_() >> 11U) * 0x1p-53; }

  private:
    // The finaliser of splitmix64 (Steele, Lea & Flood 2014) makes neighbouring seeds independent.
    static std::uint64_t mixed(std::uint64_t value) {
        value += 0x9e3779b97f4a7c15U;
        value = (value ^ (value >> 30U)) * 0xbf58476d1ce4e5b9U;
        value = (value ^ (value >> 27U)) * 0x94d049bb133111ebU;
        return value ^ (value >> 31U);
    }

    std::mt19937_64 engine_;
};

Orientation sampled_plane(const OrientationRange& range, UniformStream& uniform) {
    const double dip = range.lower_dip + (range.upper_dip - range.lower_dip) * uniform.next();
    const double azimuth = range.first_dip_direction + clockwise_width(range) * uniform.next();
    return {dip, wrapped_azimuth(azimuth)};
}

// The cosine w of the angle to the mean has the density K exp(K w) / (2 sinh K) between -1 and 1; solving its
// distribution function for 1 - w gives -log(1 + u (exp(-2K) - 1)) / K, without loss of digits at any K.
Orientation sampled_plane(const MeanOrientation& mean, UniformStream& uniform) {
    const Orientation centre{mean.dip, mean.dip_direction};
    if (!mean.concentration) {
        return centre;
    }
    const double concentration = *mean.concentration;
    const double versine = -std::log1p(uniform.next() * std::expm1(-2 * concentration)) / concentration;
    const double sine = std::sqrt(std::max(0.0, versine * (2 - versine)));
    const double turned = turn * uniform.next();
    // The frame is fixed to the plane, so that a set rotated about the vertical has the same samples, rotated.
    const Direction normal = upward_normal(centre);
    const Direction down_dip = dip_vector(centre);
    const Direction strike = normal.cross(down_dip);
    return plane_with_normal((1 - versine) * normal + sine * (std::cos(turned) * down_dip + std::sin(turned) * strike));
}

Orientation sampled_plane(const PoleWindow& window, UniformStream&) {
    return {window.window_dip, window.window_dip_direction};
}

}  // namespace

Orientation mean_orientation(const JointSet& set) {
    if (const auto* range = std::get_if<OrientationRange>(&set.orientation)) {
        return {std::midpoint(range->lower_dip, range->upper_dip),
                wrapped_azimuth(range->first_dip_direction + clockwise_width(*range) / 2)};
    }
    if (const auto* window = std::get_if<PoleWindow>(&set.orientation)) {
        return {window->window_dip, wrapped_azimuth(window->window_dip_direction)};
    }
    const auto& mean = std::get<MeanOrientation>(set.orientation);
    return {mean.dip, wrapped_azimuth(mean.dip_direction)};
}

std::vector<Orientation> sampled_planes(const JointSet& set, std::size_t count, std::uint64_t seed,
                                        std::uint64_t stream) {
    UniformStream uniform(seed, stream);
    std::vector<Orientation> planes;
    planes.reserve(count);
    while (planes.size() < count) {
        planes.push_back(
            std::visit([&](const auto& orientation) { return sampled_plane(orientation, uniform); }, set.orientation));
    }
    return planes;
}

std::vector<Orientation> drawn_planes(const std::vector<Orientation>& measured, const std::vector<double>& weights,
                                      std::size_t count, std::uint64_t seed, std::uint64_t stream) {
    std::vector<double> up_to(weights.size());
    std::partial_sum(weights.begin(), weights.end(), up_to.begin());
    UniformStream uniform(seed, stream);
    std::vector<Orientation> planes;
    planes.reserve(count);
    while (planes.size() < count) {
        const auto place = std::ranges::upper_bound(up_to, uniform.next() * up_to.back()) - up_to.begin();
        planes.push_back(measured[std::min(static_cast<std::size_t>(place), measured.size() - 1)]);
    }
    return planes;
}

OrientationStatistics orientation_statistics(const std::vector<Orientation>& planes,
                                             const std::vector<double>& weights) {
    Eigen::Matrix3d tensor = Eigen::Matrix3d::Zero();
    for (const Orientation& plane : planes) {
        const Direction normal = upward_normal(plane);
        tensor += normal * normal.transpose();
    }
    // Eigenvalues are in ascending order.
    const Direction axis = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(tensor).eigenvectors().col(2);
    Direction sum = Direction::Zero();
    double total = 0;
    for (std::size_t index = 0; index < planes.size(); ++index) {
        const Direction normal = upward_normal(planes[index]);
        const double weight = weights.empty() ? 1 : weights[index];
        sum += (normal.dot(axis) < 0 ? -weight : weight) * normal;
        total += weight;
    }
    const auto count = static_cast<double>(planes.size());
    sum *= count / total;
    const double resultant = std::min(sum.norm(), count);
    const double missing = count - resultant;
    // The error of the resultant itself is about `count` rounding errors.
    const bool scatters = planes.size() > 1 && missing > count * count * std::numeric_limits<double>::epsilon();
    return {plane_with_normal(sum), resultant,
            scatters ? (count - 1) / missing : std::numeric_limits<double>::infinity(),
            scatters ? std::acos(1 - missing / count) : 0};
}

}  // namespace delabole
