// Slopes that are to be cut by joints, for tests and benchmarks.
#pragma once

#include "dynamic_relaxation/scene/relaxation_parameters.hpp"
#include "jointed_slope/jointed_section.hpp"

#include <string>
#include <utility>
#include <vector>

namespace delabole::testing {

// The friction angle is in degrees.
inline RelaxationJoint joint_of_friction(double friction) {
    RelaxationJoint joint{};
    joint.friction_angle = degrees(friction);
    return joint;
}

inline JointSetCut joint_set(double dip, double spacing, double offset = 0) {
    JointSetCut set{};
    set.dip = dip;
    set.spacing = spacing;
    set.offset = offset;
    return set;
}

// A set of which one joint, through that point, crosses a section of up to 200 m, limited to a region.
inline JointSetCut one_joint(double dip, const SectionPoint& through, std::vector<SectionPoint> region) {
    JointSetCut set = joint_set(dip, 200);
    set.through = through;
    set.region = std::move(region);
    return set;
}

inline SlopeCut cut(std::string name, std::variant<JointSetCut, LineCut> trace) {
    return {std::move(name), "joint", std::move(trace)};
}

inline LineCut line(std::vector<SectionPoint> vertex) {
    LineCut made{};
    made.vertex = std::move(vertex);
    return made;
}

inline SlopeGeometry section(std::vector<SectionPoint> outline, std::vector<SlopeCut> cuts = {}) {
    SlopeGeometry geometry{};
    geometry.outline = std::move(outline);
    geometry.cut = std::move(cuts);
    return geometry;
}

inline std::vector<SectionPoint> square(double size) {
    return {{0, 0}, {size, 0}, {size, size}, {0, size}};
}

// Two faces at 60 and 45 deg with a bench between them.
inline std::vector<SectionPoint> benched_slope() {
    return {{-10, -8}, {60, -8}, {60, 30}, {30, 30}, {16, 16}, {11, 16}, {2, 0}, {-10, 0}};
}

inline std::vector<SlopeCut> three_sets() {
    return {cut("a", joint_set(degrees(70), 5, 0.3)), cut("b", joint_set(degrees(-85), 3, 1.1)),
            cut("cleavage", joint_set(degrees(-10), 2, 0.7))};
}

inline JointedSection cut_in_one_rock(const SlopeGeometry& geometry) {
    return cut_slope(geometry, {"slate", "gouge", "other"}, {"joint"});
}

}  // namespace delabole::testing
