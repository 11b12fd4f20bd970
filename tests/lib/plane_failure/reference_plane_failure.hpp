// Plane failure written again from first principles, for tests: ground, plane and crack as straight lines in the axes
// of the toe, the mass as a polygon measured by the shoelace formula, every force as a vector at a point. It shares no
// formula with lib/, and cancels without shame: it is meant for 50 digits.
//
// It expects a valid problem.
#pragma once

#include "plane_failure/parameters.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <algorithm>
#include <vector>

namespace delabole::reference {

namespace multiprecision = boost::multiprecision;
using Real = multiprecision::number<multiprecision::cpp_bin_float<50>, multiprecision::et_off>;

struct Vector {
    Real x;
    Real y;
};

inline Vector operator+(const Vector& a, const Vector& b) {
    return {a.x + b.x, a.y + b.y};
}
inline Vector operator-(const Vector& a, const Vector& b) {
    return {a.x - b.x, a.y - b.y};
}
inline Vector operator*(const Real& factor, const Vector& a) {
    return {factor * a.x, factor * a.y};
}
inline Real dot(const Vector& a, const Vector& b) {
    return a.x * b.x + a.y * b.y;
}
inline Real cross(const Vector& a, const Vector& b) {
    return a.x * b.y - a.y * b.x;
}
inline Vector direction(const Real& dip) {
    return {cos(dip), sin(dip)};
}

struct Solution {
    std::vector<Vector> polygon;
    Real area;
    Vector centroid;  // axes of the toe
    Real base_length;
    Real weight;
    Real base_water;
    Real crack_water;
    Real face_water;
    Real normal;
    Real driving;
    Real resisting;
    Real factor_of_safety;
    Real overturning_moment;  // net, about the lower end of the base
    Real normal_magnitude;    // sums of the magnitudes of the terms
    Real driving_magnitude;
    Real resisting_magnitude;
};

struct PressureNode {
    Real s;
    Real pressure;
};

struct Pressure {
    Real force = 0;
    Real moment = 0;
};

inline Pressure integrate(const std::vector<PressureNode>& nodes) {
    Pressure total;
    for (std::size_t index = 1; index < nodes.size(); ++index) {
        PressureNode a = nodes[index - 1];
        PressureNode b = nodes[index];
        if (a.pressure <= 0 && b.pressure <= 0) {
            continue;
        }
        const Real zero =
            a.pressure == b.pressure ? a.s : Real(a.s - a.pressure * (b.s - a.s) / (b.pressure - a.pressure));
        if (a.pressure < 0) {
            a = {zero, 0};
        }
        if (b.pressure < 0) {
            b = {zero, 0};
        }
        const Real middle_s = (a.s + b.s) / 2;
        const Real middle_pressure = (a.pressure + b.pressure) / 2;
        total.force += (b.s - a.s) * middle_pressure;
        // Simpson's rule, exact for the parabola s p(s).
        total.moment += (b.s - a.s) * (a.s * a.pressure + 4 * middle_s * middle_pressure + b.s * b.pressure) / 6;
    }
    return total;
}

class Analysis {
  public:
    explicit Analysis(const PlaneFailure<Real>& problem) : problem_(problem) {}

    Solution solve() {
        place();
        Solution result;
        measure(result);
        const Real& plane = problem_.failure_plane.dip;
        const Vector into = {sin(plane), -cos(plane)};
        const Vector down = {-cos(plane), -sin(plane)};
        result.weight = problem_.rock.unit_weight * result.area;
        add({0, -result.weight}, result.centroid);
        if (problem_.seismic) {
            add({-problem_.seismic->horizontal_coefficient * result.weight, 0}, result.centroid);
            add({0, -problem_.seismic->vertical_coefficient * result.weight}, result.centroid);
        }
        add_water(result);
        add_loads();
        Real passive = 0;
        for (const Bolt<Real>& bolt : problem_.bolt) {
            const Vector along = {cos(bolt.plunge), -sin(bolt.plunge)};
            const Vector head = {bolt.head_height * cos(problem_.slope.face_dip) / sin(problem_.slope.face_dip),
                                 bolt.head_height};
            const Vector force = (leaves_into_rock(result, head, along) ? bolt.force : Real(0)) * along;
            moment_ += cross(head - daylight_, force);
            normal_.push_back(dot(force, into));
            if (bolt.action == BoltAction::active) {
                driving_.push_back(dot(force, down));
            } else {
                passive -= dot(force, down);
            }
        }
        for (const Vector& force : forces_) {
            normal_.push_back(dot(force, into));
            driving_.push_back(dot(force, down));
        }
        const auto sum = [](const std::vector<Real>& terms, Real& total, Real& magnitude) {
            total = 0;
            magnitude = 0;
            for (const Real& term : terms) {
                total += term;
                magnitude += abs(term);
            }
        };
        sum(normal_, result.normal, result.normal_magnitude);
        sum(driving_, result.driving, result.driving_magnitude);
        const Real stress = result.normal / result.base_length;
        const bool lifted = stress < -(problem_.tension_cutoff ? problem_.tension_cutoff->tensile_strength : 0);
        const Real strength = std::max(Real(0), strength_at(stress));
        result.resisting = lifted ? Real(0) : std::max(Real(0), Real(strength * result.base_length + passive));
        // Envelope at the stress as tangent: intercept and slope are the terms that may cancel.
        const Real step = Real(1e-20) * (abs(stress) + Real(1e-20) * result.weight / result.base_length);
        const Real slope = (strength_at(stress + step) - strength_at(stress - step)) / (2 * step);
        const Real intercept = strength_at(stress) - slope * stress;
        result.resisting_magnitude =
            abs(passive) + abs(intercept) * result.base_length + abs(slope) * result.normal_magnitude;
        result.factor_of_safety = result.resisting / result.driving;
        result.overturning_moment = moment_;
        return result;
    }

  private:
    // Whether a line from the face leaves the moving mass through the plane or the crack.
    bool leaves_into_rock(const Solution& result, const Vector& head, const Vector& along) const {
        Real nearest = 1e300;
        bool into_rock = false;
        for (std::size_t index = 0; head.y >= daylight_.y && index < result.polygon.size(); ++index) {
            const Vector& from = result.polygon[index];
            const Vector step = result.polygon[(index + 1) % result.polygon.size()] - from;
            const Real across = cross(along, step);
            const Real distance = across == 0 ? Real(-1) : Real(cross(from - head, step) / across);
            const Real place = across == 0 ? Real(-1) : Real(cross(from - head, along) / across);
            if (distance > 1e-20 && distance < nearest && place >= 0 && place <= 1) {
                nearest = distance;
                into_rock = index < 2;  // the base, then the crack
            }
        }
        return into_rock;
    }

    Vector meets_plane(const Vector& point, const Vector& along) const {
        const Vector up = direction(problem_.failure_plane.dip);
        return point + (cross(daylight_ - point, up) / cross(along, up)) * along;
    }

    Real ground_height(const Real& x) const {
        std::size_t index = 1;
        while (index + 1 < ground_.size() && ground_[index].x < x) {
            ++index;
        }
        const Vector step = ground_[index] - ground_[index - 1];
        return ground_[index - 1].y + (x - ground_[index - 1].x) * step.y / step.x;
    }

    void place() {
        const SlopeSection<Real>& slope = problem_.slope;
        const Vector face = direction(slope.face_dip);
        ground_ = {{0, 0}, (slope.height / face.y) * face};
        crest_ = ground_[1];
        if (slope.bench) {
            const Vector bench = direction(slope.bench->dip);
            ground_.push_back(crest_ + (slope.bench->width / bench.x) * bench);
        }
        ground_.push_back(ground_.back() + Real(1e9) * slope.height * direction(slope.upper_surface_dip));
        const Real daylight_height = problem_.failure_plane.daylight_height.value_or(Real(0));
        daylight_ = (daylight_height / face.y) * face;
        const Vector plane = direction(problem_.failure_plane.dip);
        if (!problem_.tension_crack) {
            crack_ = {0, 1};
            for (std::size_t index = 2; index < ground_.size(); ++index) {
                const Vector step = ground_[index] - ground_[index - 1];
                const Real position = cross(daylight_ - ground_[index - 1], plane) / cross(step, plane);
                if (position >= 0 && position <= 1) {
                    base_top_ = crack_top_ = ground_[index - 1] + position * step;
                    return;
                }
            }
            return;
        }
        crack_ = direction(problem_.tension_crack->dip);
        std::visit([&](const auto& position) { place_crack(position); }, problem_.tension_crack->position);
    }

    void place_crack(const CrackAtDistance<Real>& crack) {
        crack_top_.x = crest_.x + crack.distance_behind_crest;
        crack_top_.y = ground_height(crack_top_.x);
        base_top_ = meets_plane(crack_top_, crack_);
    }

    void place_crack(const CrackOfDepth<Real>& crack) {
        const auto depth = [&](const Vector& point) { return Real(point.y - meets_plane(point, crack_).y); };
        for (std::size_t index = 2; index < ground_.size(); ++index) {
            const Real before = depth(ground_[index - 1]);
            const Real after = depth(ground_[index]);
            if (before == crack.depth || (before < crack.depth) != (after < crack.depth)) {
                const Real position = before == crack.depth ? Real(0) : Real((crack.depth - before) / (after - before));
                crack_top_ = ground_[index - 1] + position * (ground_[index] - ground_[index - 1]);
                base_top_ = meets_plane(crack_top_, crack_);
                return;
            }
        }
    }

    void place_crack(const CrackBaseBelowCrest<Real>& crack) {
        place_base(problem_.slope.height - crack.base_below_crest);
    }
    void place_crack(const CrackBaseElevation<Real>& crack) {
        place_base(crack.base_elevation - *problem_.slope.toe_elevation);
    }

    void place_base(const Real& height) {
        const Vector plane = direction(problem_.failure_plane.dip);
        base_top_ = daylight_ + ((height - daylight_.y) / plane.y) * plane;
        Real nearest = 1e300;
        for (std::size_t index = 1; index < ground_.size(); ++index) {
            const Vector step = ground_[index] - ground_[index - 1];
            const Vector offset = ground_[index - 1] - base_top_;
            const Real along_crack = cross(offset, step) / cross(crack_, step);
            const Real along_ground = cross(offset, crack_) / cross(crack_, step);
            if (along_ground >= 0 && along_ground <= 1 && along_crack >= 0 && along_crack < nearest) {
                nearest = along_crack;
                crack_top_ = base_top_ + along_crack * crack_;
            }
        }
    }

    void measure(Solution& result) const {
        result.polygon = {daylight_, base_top_, crack_top_};
        for (std::size_t index = ground_.size() - 1; index-- > 1;) {
            if (ground_[index].x < crack_top_.x) {
                result.polygon.push_back(ground_[index]);
            }
        }
        Real twice = 0;
        Vector first = {0, 0};
        for (std::size_t index = 0; index < result.polygon.size(); ++index) {
            const Vector a = result.polygon[index] - daylight_;
            const Vector b = result.polygon[(index + 1) % result.polygon.size()] - daylight_;
            twice += cross(a, b);
            first = first + cross(a, b) * (a + b);
        }
        result.area = twice / 2;
        result.centroid = daylight_ + (1 / (3 * twice)) * first;
        result.base_length = length(base_top_ - daylight_);
    }

    static Real length(const Vector& a) { return sqrt(dot(a, a)); }

    void add(const Vector& force, const Vector& point) {
        forces_.push_back(force);
        moment_ += cross(point - daylight_, force);
    }

    // Pressure on a surface from `start` along `along`, pushing along `push`.
    Pressure push(const std::vector<PressureNode>& nodes, const Vector& start, const Vector& along,
                  const Vector& push_direction) {
        const Pressure total = integrate(nodes);
        forces_.push_back(total.force * push_direction);
        moment_ += total.force * cross(start - daylight_, push_direction) + total.moment * cross(along, push_direction);
        return total;
    }

    Real depth_of(const WaterLevel<Real>& level, const Real& reference_y, const Real& full) const {
        if (const auto* depth = std::get_if<WaterDepth<Real>>(&level)) {
            return depth->water_depth;
        }
        if (const auto* ratio = std::get_if<FilledRatio<Real>>(&level)) {
            return ratio->filled_ratio * full;
        }
        const Real y = std::get<WaterElevation<Real>>(level).water_elevation - *problem_.slope.toe_elevation;
        return std::max(Real(0), Real(y - reference_y));
    }

    void add_water(Solution& result) {
        const Real base = length(base_top_ - daylight_);
        const Real crack = length(crack_top_ - base_top_);
        const Vector plane = direction(problem_.failure_plane.dip);
        const Real base_rise = base * plane.y;
        const Real crack_rise = crack * crack_.y;
        Real pond_height = 0;
        Real pond_weight = 0;
        std::vector<PressureNode> on_base;
        std::vector<PressureNode> on_crack;
        if (problem_.pond) {
            const Vector face = direction(problem_.slope.face_dip);
            pond_height = std::max(Real(0), Real(problem_.pond->depth - daylight_.y));
            pond_weight = problem_.pond->unit_weight;
            // The pond presses on the face of the mass alone: up to the crest, or to a crack in the face.
            const Real top = std::min(crest_.x, crack_top_.x) == crest_.x ? crest_.y : crack_top_.y;
            const Real face_length = (top - daylight_.y) / face.y;
            result.face_water = push({{0, pond_weight * pond_height},
                                      {face_length, pond_weight * (pond_height - face_length * face.y)}},
                                     daylight_, face, {face.y, -face.x})
                                    .force;
        }
        const std::vector<PressureNode> pond_on_base = {{0, pond_weight * pond_height},
                                                        {base, pond_weight * (pond_height - base_rise)}};
        const auto fill_crack = [&](const Real& weight, const Real& depth) {
            on_crack = {{0, weight * depth}, {crack, weight * (depth - crack_rise)}};
        };
        // The pond stands over the top of a crack in the face; water from one behind the crest would run off.
        const Real pond_in_crack = std::max(Real(0), Real(pond_height - base_rise));
        const bool covered = problem_.tension_crack && crack_top_.x < crest_.x && pond_in_crack > crack_rise;
        const Real full_crack = covered ? pond_in_crack : crack_rise;
        if (std::holds_alternative<Dry>(problem_.water)) {
            on_base = pond_on_base;
            if (problem_.tension_crack) {
                fill_crack(pond_weight, std::min(pond_in_crack, full_crack));
            }
        } else if (const auto* both = std::get_if<CrackAndBaseWater<Real>>(&problem_.water)) {
            const Real depth = depth_of(both->level, base_top_.y, full_crack);
            fill_crack(both->unit_weight, depth);
            on_base = {{0, pond_weight * pond_height}, {base, both->unit_weight * depth}};
        } else if (const auto* only = std::get_if<CrackOnlyWater<Real>>(&problem_.water)) {
            fill_crack(only->unit_weight, depth_of(only->level, base_top_.y, full_crack));
            on_base = pond_on_base;
        } else if (const auto* middle = std::get_if<BasePeakMidHeightWater<Real>>(&problem_.water)) {
            const Real height = depth_of(middle->level, daylight_.y, base_rise);
            on_base = {{0, pond_weight * pond_height},
                       {height / 2 / plane.y, middle->unit_weight * height / 2},
                       {height / plane.y, 0}};
        } else if (const auto* toe = std::get_if<PeakAtToeWater<Real>>(&problem_.water)) {
            const Real height = depth_of(toe->level, daylight_.y, base_rise + full_crack);
            on_base = {{0, toe->unit_weight * height}, {base, toe->unit_weight * (height - base_rise)}};
            on_crack = {{0, toe->unit_weight * (height - base_rise)},
                        {crack, toe->unit_weight * (height - base_rise - crack_rise)}};
        } else if (const auto* line = std::get_if<PiezometricLineWater<Real>>(&problem_.water)) {
            on_base = below_line(*line, daylight_, plane, base);
            on_crack = below_line(*line, base_top_, crack_, crack);
        } else {
            const auto& custom = std::get<CustomWater<Real>>(problem_.water);
            for (const PressurePoint<Real>& point : custom.base) {
                on_base.push_back({point.position * base, point.pressure});
            }
            for (const PressurePoint<Real>& point : custom.crack) {
                on_crack.push_back({point.position * crack, point.pressure});
            }
        }
        result.base_water = push(on_base, daylight_, plane, {-plane.y, plane.x}).force;
        result.crack_water = push(on_crack, base_top_, crack_, {-crack_.y, crack_.x}).force;
    }

    static std::vector<PressureNode> below_line(const PiezometricLineWater<Real>& line, const Vector& start,
                                                const Vector& along, const Real& length) {
        const auto level = [&](const Real& x) {
            if (x <= line.point.front().x) {
                return line.point.front().y;
            }
            for (std::size_t index = 1; index < line.point.size(); ++index) {
                const auto& a = line.point[index - 1];
                const auto& b = line.point[index];
                if (x <= b.x) {
                    return Real(a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x));
                }
            }
            return line.point.back().y;
        };
        std::vector<Real> stations = {0, length};
        for (const PiezometricPoint<Real>& point : line.point) {
            const Real s = (point.x - start.x) / along.x;
            if (s > 0 && s < length) {
                stations.push_back(s);
            }
        }
        std::sort(stations.begin(), stations.end());
        std::vector<PressureNode> nodes;
        for (const Real& s : stations) {
            const Vector point = start + s * along;
            nodes.push_back({s, line.unit_weight * (level(point.x) - point.y)});
        }
        return nodes;
    }

    void add_loads() {
        for (const Surcharge<Real>& load : problem_.surcharge) {
            const Real from = crest_.x + load.from_distance;
            const Real to = std::min(Real(crest_.x + load.to_distance), crack_top_.x);
            if (to > from) {
                add({0, -load.pressure * (to - from)}, {(from + to) / 2, 0});
            }
        }
        for (const LineLoad<Real>& load : problem_.line_load) {
            const Real x = crest_.x + load.distance_behind_crest;
            if (x <= crack_top_.x) {
                add(load.force * Vector{cos(load.plunge), -sin(load.plunge)}, {x, ground_height(x)});
            }
        }
    }

    Real strength_at(const Real& stress) const {
        if (const auto* law = std::get_if<Coulomb<Real>>(&problem_.strength)) {
            return law->cohesion + stress * tan(law->friction_angle);
        }
        if (const auto* law = std::get_if<SteppedSurface<Real>>(&problem_.strength)) {
            return law->cohesion + stress * tan(law->friction_angle + law->roughness_angle);
        }
        if (const auto* law = std::get_if<PattonBilinear<Real>>(&problem_.strength)) {
            const Real rough = tan(law->friction_angle + law->roughness_angle);
            const Real smooth = tan(law->friction_angle);
            // The lower of two straight lines that cross at the transition.
            return std::min(Real(stress * rough), Real(law->transition_stress * (rough - smooth) + stress * smooth));
        }
        if (const auto* law = std::get_if<BartonBandis<Real>>(&problem_.strength)) {
            if (stress <= 0) {
                return 0;
            }
            const Real dilation =
                law->joint_roughness_coefficient * log10(law->joint_wall_strength / stress) * Real(degrees(1));
            const Real angle = law->residual_friction_angle + std::max(Real(0), dilation);
            return stress * tan(std::min(Real(degrees(70)), angle));
        }
        const auto& law = std::get<PowerCurve<Real>>(problem_.strength);
        const Real shifted = stress + law.stress_offset;
        return law.cohesion + (shifted > 0 ? Real(law.coefficient * law.reference_stress *
                                                  pow(shifted / law.reference_stress, law.exponent))
                                           : Real(0));
    }

    const PlaneFailure<Real>& problem_;
    std::vector<Vector> ground_;
    Vector crest_, daylight_, base_top_, crack_top_, crack_;
    std::vector<Vector> forces_;
    std::vector<Real> normal_;
    std::vector<Real> driving_;
    Real moment_ = 0;
};

inline Solution solve(const PlaneFailure<Real>& problem) {
    return Analysis(problem).solve();
}
inline Solution solve(const PlaneFailure<>& problem) {
    return solve(with_scalar<PlaneFailure<Real>>(problem));
}

}  // namespace delabole::reference
