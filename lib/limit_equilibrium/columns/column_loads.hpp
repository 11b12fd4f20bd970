// Resultants on each column of weight, earthquake, water and loads, about the toe corner of its base.
//
// Water (Wyllie & Mah 2004, ch. 9): joints are open and water stands still in each, so that pressure grows along a
// joint by unit weight times cos(base dip); under a base it varies linearly between the bottoms of the two joints. With
// y and z the heights of water above the base in the upper and lower joint and w the width,
//   V1 = unit weight cos(base dip) y^2 / 2          out of the slope, at y / 3
//   V2 = unit weight cos(base dip) (y + z) w / 2    lifting, at w (2 y + z) / (3 (y + z)) from the toe corner
//   V3 = unit weight cos(base dip) z^2 / 2          into the slope, at z / 3.
// The level in a joint is where the joint meets the water surface, but not above the top of the lower of the two
// columns beside it; a joint extends down to the base of its lower column. The face of the first column drains, z = 0.
// If a water surface slopes, the levels in the joints differ.
#pragma once

#include "limit_equilibrium/columns/column.hpp"
#include "limit_equilibrium/columns/column_layout.hpp"

namespace delabole::detail {

// Force and moment (anticlockwise, about `origin`) in turned axes.
template <class T>
struct TurnedResultant {
    T u = T(0);
    T v = T(0);
    T moment = T(0);

    void add(const T& arm_u, const T& arm_v, const T& force_u, const T& force_v) {
        u += force_u;
        v += force_v;
        moment += arm_u * force_v - arm_v * force_u;
    }
    // Adds a force given in section axes.
    void add_turned(const SineCosine<T>& base, const T& arm_u, const T& arm_v, const T& force_x, const T& force_y) {
        const PlanePoint<T> force = turned(base, force_x, force_y);
        add(arm_u, arm_v, force.x(), force.y());
    }
};

// Water surface: gives the v at which it meets the joint at u, in turned axes; the smallest v if there is no water at
// all.
template <class T>
class WaterSurface {
  public:
    // `end`: upper end of the base, section axes.
    ColumnCheck set(const ColumnWater<T>& water, const std::optional<SlopeSection<T>>& slope, const SineCosine<T>& base,
                    const PlanePoint<T>& end) {
        base_ = base;
        if (const auto* table = std::get_if<WaterTable<T>>(&water)) {
            unit_weight_ = table->unit_weight;
            return set_level(table->level, slope);
        }
        if (const auto* drawn = std::get_if<DrawnDownWater<T>>(&water)) {
            unit_weight_ = drawn->unit_weight;
            const ColumnCheck check = set_level(drawn->level, slope);
            line_ = {PlanePoint<T>(T(0), T(0)), turned(base, end.x(), level_)};
            return check;
        }
        if (const auto* line = std::get_if<PiezometricLineWater<T>>(&water)) {
            unit_weight_ = line->unit_weight;
            if (line->point.size() < 2) {
                return ColumnCheck::water_points_not_increasing;
            }
            for (std::size_t index = 0; index < line->point.size(); ++index) {
                if (index > 0 && !(line->point[index].x > line->point[index - 1].x)) {
                    return ColumnCheck::water_points_not_increasing;
                }
                line_.push_back(turned(base, line->point[index].x, line->point[index].y));
            }
        } else if (const auto* filled = std::get_if<FilledJointsWater<T>>(&water)) {
            unit_weight_ = filled->unit_weight;
            filled_ratio_ = filled->filled_ratio;
        }
        return ColumnCheck::valid;
    }

    bool dry() const { return line_.empty() && !filled_ratio_; }

    // Increase of pressure per metre along a joint.
    T gradient() const { return T(unit_weight_ * base_.cosine); }

    // Height of water above `base_v` in a joint of the given height; 0 if there is none.
    T height_in_joint(const T& u, const T& base_v, const T& joint_height) const {
        if (dry() || !(joint_height > 0)) {
            return T(0);
        }
        T height = filled_ratio_ ? T(*filled_ratio_ * joint_height) : T(level(u) - base_v);
        if (height < 0) {
            height = T(0);
        }
        return height < joint_height ? height : joint_height;
    }

  private:
    ColumnCheck set_level(const WaterLevel<T>& level, const std::optional<SlopeSection<T>>& slope) {
        T height(0);
        if (const auto* depth = std::get_if<WaterDepth<T>>(&level)) {
            height = depth->water_depth;
        } else if (!slope) {
            return ColumnCheck::load_needs_slope;
        } else if (const auto* ratio = std::get_if<FilledRatio<T>>(&level)) {
            height = ratio->filled_ratio * slope->height;
        } else if (!slope->toe_elevation) {
            return ColumnCheck::elevation_without_datum;
        } else {
            height = std::get<WaterElevation<T>>(level).water_elevation - *slope->toe_elevation;
        }
        level_ = height;
        line_ = {turned(base_, T(0), height)};
        return ColumnCheck::valid;
    }

    // The surface is level beyond its ends; if a steep line meets the joint more than once, the highest point counts.
    T level(const T& u) const {
        const T fall = base_.sine / base_.cosine;
        std::optional<T> highest;
        const auto consider = [&](const T& v) {
            if (!highest || v > *highest) {
                highest = v;
            }
        };
        if (u <= line_.front().x()) {
            consider(T(line_.front().y() + (line_.front().x() - u) * fall));
        }
        if (u >= line_.back().x()) {
            consider(T(line_.back().y() - (u - line_.back().x()) * fall));
        }
        for (std::size_t index = 1; index < line_.size(); ++index) {
            const PlanePoint<T>& a = line_[index - 1];
            const PlanePoint<T>& b = line_[index];
            if ((a.x() - u) * (b.x() - u) <= 0 && a.x() != b.x()) {
                consider(T(a.y() + (b.y() - a.y()) * ((u - a.x()) / (b.x() - a.x()))));
            }
        }
        return *highest;
    }

    SineCosine<T> base_{};
    T unit_weight_ = T(0);
    T level_ = T(0);
    std::vector<PlanePoint<T>> line_;
    std::optional<T> filled_ratio_;
};

template <class T>
void add_column_water(TurnedResultant<T>& resultant, const T& gradient, const T& width, const T& lower,
                      const T& upper) {
    resultant.add(width, T(upper / 3), T(-gradient * upper * upper / 2), T(0));
    resultant.add(T(0), T(lower / 3), T(gradient * lower * lower / 2), T(0));
    // The trapezoid under the base is divided into two triangles.
    resultant.add(T(width / 3), T(0), T(0), T(gradient * lower * width / 2));
    resultant.add(T(width * 2 / 3), T(0), T(0), T(gradient * upper * width / 2));
}

// Adds the weight of a polygon (turned axes) with its inertia force. Returns the weight.
template <class T>
T add_weight(TurnedResultant<T>& resultant, const Polygon<T>& outline, const PlanePoint<T>& origin,
             const SineCosine<T>& base, const T& unit_weight, const std::optional<SeismicLoad<T>>& seismic) {
    const AreaProperties<T> section = area_properties(outline);
    const T weight = section.area * unit_weight;
    const PlanePoint<T> arm = difference(section.centroid, origin);
    const T horizontal = seismic ? T(-seismic->horizontal_coefficient * weight) : T(0);
    const T vertical = seismic ? T(-(1 + seismic->vertical_coefficient) * weight) : T(-weight);
    resultant.add_turned(base, arm.x(), arm.y(), horizontal, vertical);
    return weight;
}

// Horizontal position of a point given in turned axes. A point that differs from the crest by less than a nanometre, so
// by rounding alone, lies on it: on a vertical face every point does.
template <class T>
T position_in_plan(const SineCosine<T>& base, const PlanePoint<T>& point, const T& crest_x) {
    constexpr double rounding = 1e-9;
    const T x = turned_back(base, point).x();
    return x - crest_x < rounding && crest_x - x < rounding ? crest_x : x;
}

// Adds loads on a stretch of ground, given in turned axes from its lower end up, where it lies in front of `end_x` in
// plan. A line load on a common corner of two stretches belongs to the upper one.
template <class T>
void add_ground_loads(TurnedResultant<T>& resultant, const std::vector<PlanePoint<T>>& ground, const T& end_x,
                      const PlanePoint<T>& origin, const SineCosine<T>& base, const T& crest_x,
                      const std::vector<Surcharge<T>>& surcharges, const std::vector<LineLoad<T>>& line_loads) {
    for (std::size_t index = 1; index < ground.size(); ++index) {
        const T left = position_in_plan(base, ground[index - 1], crest_x);
        const T right = position_in_plan(base, ground[index], crest_x);
        const T last = end_x < right ? end_x : right;
        if (!(last > left)) {
            continue;
        }
        const auto add_at = [&](const T& x, const T& force_x, const T& force_y) {
            const T lower = turned_back(base, ground[index - 1]).y();
            const T upper = turned_back(base, ground[index]).y();
            const T y = lower + (upper - lower) * ((x - left) / (right - left));
            const PlanePoint<T> arm = difference(turned(base, x, y), origin);
            resultant.add_turned(base, arm.x(), arm.y(), force_x, force_y);
        };
        for (const Surcharge<T>& surcharge : surcharges) {
            const T from = crest_x + surcharge.from_distance;
            const T to = crest_x + surcharge.to_distance;
            const T start = from > left ? from : left;
            const T end = to < last ? to : last;
            if (end > start) {
                add_at(T((start + end) / 2), T(0), T(-surcharge.pressure * (end - start)));
            }
        }
        for (const LineLoad<T>& load : line_loads) {
            const T x = crest_x + load.distance_behind_crest;
            if (x >= left && x < last) {
                const SineCosine<T> plunge = sine_cosine(load.plunge);
                add_at(x, T(load.force * plunge.cosine), T(-load.force * plunge.sine));
            }
        }
    }
}

}  // namespace delabole::detail
