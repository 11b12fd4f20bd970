// The water surface in a slope along whose joints surfaces step, and what the water below it pushes with.
#include "limit_equilibrium/stepped_path/path_lattice.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace delabole {

void PathLattice::set_water(const SteppedPath& path) {
    const auto level_of = [&](const WaterLevel<>& level) -> std::optional<double> {
        if (const auto* depth = std::get_if<WaterDepth<>>(&level)) {
            return depth->water_depth;
        }
        if (const auto* ratio = std::get_if<FilledRatio<>>(&level)) {
            return ratio->filled_ratio * path.slope.height;
        }
        if (!path.slope.toe_elevation) {
            return std::nullopt;
        }
        return std::get<WaterElevation<>>(level).water_elevation - *path.slope.toe_elevation;
    };
    std::optional<double> level;
    double reach = 0;
    if (const auto* table = std::get_if<WaterTable<>>(&path.water)) {
        level = level_of(table->level);
        water_weight_ = table->unit_weight;
    } else if (const auto* drawn = std::get_if<WaterDrawnDown>(&path.water)) {
        level = level_of(drawn->level);
        reach = drawn->reach;
        water_weight_ = drawn->unit_weight;
    } else {
        return;
    }
    if (!level) {
        check = SteppedPathCheck::elevation_without_datum;
        return;
    }
    const auto surface = [&](double x) {
        const double drawn = reach > 0 && x < reach ? *level * x / reach : *level;
        return std::min(drawn, ground(x));
    };
    // The surface has a kink where another of its lines becomes the lowest.
    std::vector<double> bends{0, crest.x(), reach, *level * cot_face_};
    if (slope_upper_ != 0) {
        bends.push_back(crest.x() + (*level - crest.y()) / slope_upper_);
        if (reach > 0 && *level / reach != slope_upper_) {
            bends.push_back((crest.y() - crest.x() * slope_upper_) / (*level / reach - slope_upper_));
        }
    } else if (reach > 0) {
        bends.push_back(reach * crest.y() / *level);
    }
    std::erase_if(bends, [](double x) { return !(x >= 0) || !std::isfinite(x); });
    std::ranges::sort(bends);
    bends.push_back(bends.back() + crest.y());
    // If bends differ by rounding alone, the last one is kept: at a vertical face the surface rises between them, and
    // its height behind the face counts.
    for (const double x : bends) {
        if (!water_surface_.empty() && !(x > water_surface_.back().x() + tolerance_)) {
            water_surface_.pop_back();
        }
        water_surface_.emplace_back(x, surface(x));
    }
}

PathLattice::EdgeWater PathLattice::water_on(const Point& from, const Point& to) const {
    EdgeWater water;
    if (!(water_weight_ > 0)) {
        return water;
    }
    const Point edge = to - from;
    const double edge_length = edge.norm();
    const auto depth = [&](std::size_t segment, double share) {
        const Point& a = water_surface_[segment];
        const Point& b = water_surface_[segment + 1];
        const Point point = from + share * edge;
        return a.y() + (point.x() - a.x()) * ((b.y() - a.y()) / (b.x() - a.x())) - point.y();
    };
    const double left = std::min(from.x(), to.x());
    const double right = std::max(from.x(), to.x());
    double moment = 0;
    const std::size_t last = water_surface_.size() - 2;
    for (std::size_t segment = 0; segment <= last; ++segment) {
        // The part of the edge below this stretch of the surface.
        double start = 0;
        double end = 1;
        const double lower = segment == 0 ? -std::numeric_limits<double>::infinity() : water_surface_[segment].x();
        const double upper =
            segment == last ? std::numeric_limits<double>::infinity() : water_surface_[segment + 1].x();
        const bool upright = left == right;
        if (upright ? left < lower || left >= upper : right <= lower || left >= upper) {
            continue;
        }
        if (!upright) {
            double at_lower = (lower - from.x()) / edge.x();
            double at_upper = (upper - from.x()) / edge.x();
            if (at_lower > at_upper) {
                std::swap(at_lower, at_upper);
            }
            start = std::max(start, at_lower);
            end = std::min(end, at_upper);
        }
        if (!(end > start)) {
            continue;
        }
        double depth_start = depth(segment, start);
        double depth_end = depth(segment, end);
        if (depth_start <= 0 && depth_end <= 0) {
            continue;
        }
        if (depth_start < 0) {
            start += (end - start) * depth_start / (depth_start - depth_end);
            depth_start = 0;
        } else if (depth_end < 0) {
            end = start + (end - start) * depth_start / (depth_start - depth_end);
            depth_end = 0;
        }
        const double span = end - start;
        water.force += span * (depth_start + depth_end) / 2;
        moment += span * (start * (depth_start + depth_end) / 2 + span * (depth_start + 2 * depth_end) / 6);
    }
    if (water.force > 0) {
        water.position = moment / water.force * edge_length;
        water.force *= water_weight_ * edge_length;
    }
    return water;
}

}  // namespace delabole
