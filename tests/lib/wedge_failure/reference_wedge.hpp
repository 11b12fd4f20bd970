// A wedge written again from first principles, for tests, in 50 digits: half-spaces, their corners by Cramer's rule,
// the one of four blocks that is bounded, its volume by the divergence theorem, forces by a linear system. It shares no
// formula with lib/.
#pragma once

#include "wedge_failure/parameters.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

namespace delabole::reference {

using Real = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;
using Space = std::array<Real, 3>;

inline Space operator+(const Space& a, const Space& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline Space operator*(const Real& factor, const Space& a) {
    return {factor * a[0], factor * a[1], factor * a[2]};
}
inline Space operator-(const Space& a, const Space& b) {
    return a + Real(-1) * b;
}
inline Real dot(const Space& a, const Space& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Space cross(const Space& a, const Space& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline Real norm(const Space& a) {
    return sqrt(dot(a, a));
}

// normal . x <= level
struct HalfSpace {
    Space normal;
    Real level;
};

inline Space compass_normal(const Real& dip, const Real& direction) {
    return {sin(dip) * sin(direction), sin(dip) * cos(direction), cos(dip)};
}

// a x = b, the rows of a given.
inline Space solved(const std::array<Space, 3>& rows, const Space& right) {
    const Real determinant = dot(rows[0], cross(rows[1], rows[2]));
    return (Real(1) / determinant) * (right[0] * cross(rows[1], rows[2]) + right[1] * cross(rows[2], rows[0]) +
                                      right[2] * cross(rows[0], rows[1]));
}

inline bool inside(const std::vector<HalfSpace>& spaces, const Space& point, const Real& tolerance, bool direction) {
    return std::ranges::all_of(spaces, [&](const HalfSpace& space) {
        return dot(space.normal, point) - (direction ? Real(0) : space.level) <= tolerance;
    });
}

struct Body {
    Real volume;
    std::vector<Real> areas;  // in the order of the half-spaces
};

// Nothing where the half-spaces leave no bounded body.
inline std::optional<Body> body_of(const std::vector<HalfSpace>& spaces) {
    const Real tolerance("1e-30");
    std::vector<Space> corners;
    for (std::size_t i = 0; i < spaces.size(); ++i) {
        for (std::size_t j = i + 1; j < spaces.size(); ++j) {
            const Space along = cross(spaces[i].normal, spaces[j].normal);
            if (inside(spaces, along, tolerance, true) || inside(spaces, Real(-1) * along, tolerance, true)) {
                return std::nullopt;  // an edge that never ends
            }
            for (std::size_t k = j + 1; k < spaces.size(); ++k) {
                if (abs(dot(along, spaces[k].normal)) > Real("1e-20")) {
                    const Space corner = solved({spaces[i].normal, spaces[j].normal, spaces[k].normal},
                                                {spaces[i].level, spaces[j].level, spaces[k].level});
                    if (inside(spaces, corner, tolerance, false)) {
                        corners.push_back(corner);
                    }
                }
            }
        }
    }
    if (corners.size() < 4) {
        return std::nullopt;
    }
    Body body{Real(0), {}};
    for (const HalfSpace& space : spaces) {
        std::vector<Space> on_face;
        for (const Space& corner : corners) {
            if (abs(dot(space.normal, corner) - space.level) < tolerance) {
                on_face.push_back(corner);
            }
        }
        Real area = 0;
        if (on_face.size() > 2) {
            Space centre{Real(0), Real(0), Real(0)};
            for (const Space& corner : on_face) {
                centre = centre + (Real(1) / Real(on_face.size())) * corner;
            }
            const Space first = on_face.front() - centre;
            const auto angle = [&](const Space& corner) {
                const Space arm = corner - centre;
                return atan2(dot(space.normal, cross(first, arm)), dot(first, arm));
            };
            std::ranges::sort(on_face, {}, angle);
            for (std::size_t index = 0; index < on_face.size(); ++index) {
                const Space& next = on_face[(index + 1) % on_face.size()];
                area += norm(cross(on_face[index] - centre, next - centre)) / 2;
            }
        }
        body.areas.push_back(area);
        body.volume += space.level * area / 3;
    }
    return body;
}

struct WedgeAnswer {
    Real volume;
    Real area_1;
    Real area_2;
    Real crack_area;
    Real factor_of_safety;  // 0 where the wedge is lifted off
};

inline Space along(const Real& plunge, const Real& trend) {
    return {cos(plunge) * sin(trend), cos(plunge) * cos(trend), -sin(plunge)};
}

// Of a valid problem with Coulomb strength. Unit normals have level 0 at the origin, where the line comes out.
inline std::optional<WedgeAnswer> solve_wedge(const WedgeFailure& problem) {
    const Space face = compass_normal(problem.slope.face_dip, problem.slope.face_dip_direction);
    const Space upper = compass_normal(problem.slope.upper_surface_dip, problem.slope.upper_surface_dip_direction);
    const std::array<Space, 2> normals{compass_normal(problem.plane_1.dip, problem.plane_1.dip_direction),
                                       compass_normal(problem.plane_2.dip, problem.plane_2.dip_direction)};
    const Space crest =
        solved({normals[0], face, {Real(0), Real(0), Real(1)}}, {Real(0), Real(0), Real(problem.slope.height)});
    const Real ground = dot(upper, crest);
    const Space vertical{Real(0), Real(0), Real(1)};

    std::vector<HalfSpace> spaces{{face, Real(0)}, {upper, ground}};
    if (problem.tension_crack) {
        Space trace = cross(normals[0], upper);
        trace = (Real(dot(face, trace) < 0 ? 1 : -1) / norm(trace)) * trace;
        const Space on_crack = crest + Real(problem.tension_crack->distance) * trace;
        Space crack = compass_normal(problem.tension_crack->dip, problem.tension_crack->dip_direction);
        crack = Real(dot(crack, on_crack) < 0 ? -1 : 1) * crack;
        spaces.push_back({crack, dot(crack, on_crack)});
    }
    const std::size_t planes = spaces.size();
    spaces.resize(planes + 2);
    for (const int signs : {0, 1, 2, 3}) {
        const std::array<Space, 2> inner{Real((signs & 1) != 0 ? -1 : 1) * normals[0],
                                         Real((signs & 2) != 0 ? -1 : 1) * normals[1]};
        spaces[planes] = {Real(-1) * inner[0], Real(0)};
        spaces[planes + 1] = {Real(-1) * inner[1], Real(0)};
        // A crack may bound others of the four blocks: which it is, is decided without it.
        std::vector<HalfSpace> uncracked = spaces;
        uncracked.erase(uncracked.begin() + 2, uncracked.begin() + static_cast<std::ptrdiff_t>(planes));
        if (!body_of(uncracked)) {
            continue;
        }
        const auto body = body_of(spaces);
        if (!body) {
            return std::nullopt;
        }
        WedgeAnswer answer{body->volume, body->areas[planes], body->areas[planes + 1],
                           problem.tension_crack ? body->areas[2] : Real(0), Real(0)};
        const Real weight = Real(problem.rock.unit_weight) * answer.volume;
        Space line = cross(normals[0], normals[1]);
        line = (Real(line[2] < 0 ? 1 : -1) / norm(line)) * line;
        Space active = Real(-weight) * vertical;
        Space passive{Real(0), Real(0), Real(0)};
        if (const auto* water = std::get_if<FilledFissures>(&problem.water)) {
            Real depth;
            if (problem.tension_crack) {
                // From the foot of the crack up to the ground.
                const Space foot =
                    solved({normals[0], normals[1], spaces[2].normal}, {Real(0), Real(0), spaces[2].level});
                depth = (ground - dot(upper, foot)) / upper[2];
            } else {
                depth = solved({normals[0], normals[1], upper}, {Real(0), Real(0), ground})[2] / 2;
            }
            const Real mean = Real(water->unit_weight) * Real(water->filled_ratio) * depth / 3;
            active = active + (mean * answer.area_1) * inner[0] + (mean * answer.area_2) * inner[1];
            if (problem.tension_crack) {
                active = active - (mean * answer.crack_area) * spaces[2].normal;
            }
        }
        if (problem.seismic) {
            const Real trend = problem.seismic->trend ? Real(*problem.seismic->trend) : atan2(line[0], line[1]);
            active = active + (Real(problem.seismic->coefficient) * weight) *
                                  along(Real(problem.seismic->plunge.value_or(0.0)), trend);
        }
        for (const WedgeLoad& load : problem.load) {
            active = active + Real(load.force) * along(Real(load.plunge), Real(load.trend));
        }
        for (const WedgeBolt& bolt : problem.bolt) {
            Space& forces = bolt.action == BoltAction::active ? active : passive;
            forces = forces + Real(bolt.force) * along(Real(bolt.plunge), Real(bolt.trend));
        }
        // Reactions N1 a1 + N2 a2 + S i: the matrix has them as columns.
        const auto reactions = [&](const Space& force) {
            std::array<Space, 3> rows;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                rows[axis] = {inner[0][axis], inner[1][axis], line[axis]};
            }
            return solved(rows, Real(-1) * force);
        };
        const auto strength = [](const WedgePlane& plane, const Real& area, const Real& normal_force) {
            const auto& law = std::get<Coulomb<>>(plane.strength);
            const Real resisting = Real(law.cohesion) * area + normal_force * tan(Real(law.friction_angle));
            return resisting < 0 ? Real(0) : resisting;
        };
        const Space together = reactions(active);
        const Space both = reactions(active + passive);
        const auto factor = [](const Real& resisting, const Real& driving) {
            return driving > 0 ? Real((resisting < 0 ? Real(0) : resisting) / driving) : Real(1e300);
        };
        if (together[0] >= 0 && together[1] >= 0) {
            answer.factor_of_safety = factor(strength(problem.plane_1, answer.area_1, both[0]) +
                                                 strength(problem.plane_2, answer.area_2, both[1]) - dot(passive, line),
                                             dot(active, line));
            return answer;
        }
        for (const int plane : {0, 1}) {
            const auto own = static_cast<std::size_t>(plane);
            const Real pressing = -dot(active, inner[own]);
            const Space slide = active + pressing * inner[own];
            if (pressing > 0 && dot(slide, inner[1 - own]) > 0) {
                const Space direction = (Real(1) / norm(slide)) * slide;
                const Real normal_force = -dot(active + passive, inner[own]);
                answer.factor_of_safety = factor((plane == 0 ? strength(problem.plane_1, answer.area_1, normal_force)
                                                             : strength(problem.plane_2, answer.area_2, normal_force)) -
                                                     dot(passive, direction),
                                                 norm(slide));
                return answer;
            }
        }
        return answer;
    }
    return std::nullopt;
}

}  // namespace delabole::reference
