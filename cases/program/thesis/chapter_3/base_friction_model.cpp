#include "cases/program/thesis/chapter_3/base_friction_model.hpp"

#include "cases/program/thesis/imperial.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace delabole {

namespace {

constexpr double mixture_density = 1330;  // kg/m3 (2.3.3.1)

SlopeCut line(const std::string& name, std::vector<SectionPoint> points) {
    LineCut cut{};
    cut.vertex = std::move(points);
    return {name, "joint", cut};
}

struct Corners {
    double toe_y;  // of the upright cut's foot, or of the slope
    double crest_x;
    double crest_y;
    double right;
    double bottom;
    double left;
};

// The origin is the foot of the inclined face.
Corners corners_of(const BaseFrictionGeometry& geometry) {
    Corners at{};
    at.toe_y = -geometry.vertical_cut;
    at.crest_y = geometry.slope_height - geometry.vertical_cut;
    at.crest_x = at.crest_y / std::tan(geometry.slope_angle);
    at.right = at.crest_x + geometry.slope_surface;
    at.bottom = at.toe_y - geometry.depth;
    at.left = -geometry.front;
    return at;
}

std::vector<SectionPoint> outline_of(const BaseFrictionGeometry& geometry) {
    const Corners at = corners_of(geometry);
    std::vector<SectionPoint> outline;
    if (geometry.depth > 0) {
        outline = {{at.left, at.bottom}, {at.right, at.bottom}};
    } else {
        outline = {{0, at.toe_y}, {at.right, at.toe_y}};
    }
    outline.push_back({at.right, at.crest_y});
    outline.push_back({at.crest_x, at.crest_y});
    outline.push_back({0, 0});
    if (geometry.depth > 0) {
        if (geometry.vertical_cut > 0) {
            outline.push_back({0, at.toe_y});
        }
        outline.push_back({at.left, at.toe_y});
    }
    return outline;
}

std::vector<SlopeCut> cuts_of(const BaseFrictionGeometry& geometry) {
    const Corners at = corners_of(geometry);
    std::vector<SlopeCut> cuts;
    if (geometry.horizontal_cut) {
        cuts.push_back(line("horizontal cut", {{0, at.toe_y}, {at.right, at.toe_y}}));
    }
    if (geometry.saw_tooth) {
        const double run = (at.crest_y - at.bottom) / std::tan(geometry.joint_dip);
        cuts.push_back(line("saw-tooth joint", {{at.crest_x, at.crest_y}, {at.crest_x + run, at.bottom}}));
    }
    JointSetCut columns{};
    columns.dip = -geometry.joint_dip;
    columns.spacing = geometry.joint_spacing;
    columns.through = geometry.saw_tooth ? SectionPoint{at.crest_x, at.crest_y} : SectionPoint{0, at.toe_y};
    cuts.push_back({"columns", "joint", columns});
    if (geometry.cross_joint_spacing) {
        JointSetCut across{};
        across.dip = degrees(90) - geometry.joint_dip;
        across.spacing = *geometry.cross_joint_spacing;
        across.staggered_by = "columns";
        across.stagger_share = 0.5;
        cuts.push_back({"cross joints", "joint", across});
    }
    return cuts;
}

}  // namespace

BaseFrictionGeometry geometry_of(const BaseFrictionState& state) {
    const double height = state.slope_height();
    const bool free = state.surroundings == ModelSurroundings::boundary_free;
    const bool repeated = state.test.find("_R") != std::string::npos;
    BaseFrictionGeometry geometry{};
    geometry.slope_angle = state.slope_angle;
    geometry.slope_height = height;
    geometry.joint_dip = state.joint_dip;
    geometry.joint_spacing = state.joint_spacing;
    geometry.cross_joint_spacing = state.cross_joint_spacing;
    // Three heights of ground avoid boundary effects (3.2.2, 2'); 12(R) has 22 columns; where nothing is printed, 10 in
    // is taken, as in models 6 to 11.
    const double near_surface = state.test == "12(R)" ? 15 * inch : 10 * inch;
    geometry.slope_surface = free ? 3 * height : state.slope_surface.value_or(near_surface);
    if (free) {
        geometry.depth = repeated ? height / 2 : height;
        geometry.front = height;
    } else if (state.foundation != SlopeFoundation::steel_frame) {
        // A toe cut of 3 in reached down to the frame (3.2.2, model 1). How far the ground went is not printed.
        geometry.depth = 3 * inch;
        geometry.front = 6 * inch;
    }
    geometry.vertical_cut = state.toe == ToeChange::vertical_cut ? 3 * inch : 0;
    // Slopes 3(R) and 4(L) stood on model material without the restraint of the toe, as on a cut of their own.
    const bool stands_on_cut = state.test == "3(R)" || state.test == "4(L)";
    geometry.horizontal_cut =
        state.foundation == SlopeFoundation::tin_strip || state.toe == ToeChange::horizontal_cut || stands_on_cut;
    geometry.saw_tooth = state.columns == ColumnKind::saw_tooth;
    return geometry;
}

RelaxationSlope model_as_cut(const BaseFrictionGeometry& geometry) {
    RelaxationSlope slope{};
    slope.geometry.outline = outline_of(geometry);
    slope.geometry.cut = cuts_of(geometry);
    slope.geometry.intact_joint = "joint";  // where rock is divided so that blocks are convex
    // The typical block is a piece of a column. A piece as wide as the columns does not count as a sliver.
    const double length =
        geometry.cross_joint_spacing.value_or((geometry.slope_height + geometry.depth) / std::sin(geometry.joint_dip));
    const double size = std::sqrt(geometry.joint_spacing * length);
    slope.geometry.sliver_share = std::min(0.15, 0.5 * geometry.joint_spacing / size);
    // A joint cut by hand is no more accurate than this.
    slope.geometry.snap_distance = 0.03 * geometry.joint_spacing;
    slope.rock = {{"mixture", mixture_density}};
    RelaxationJoint joint{};
    joint.friction_angle = mixture_friction;
    slope.joint = {{"joint", {}, joint}};
    SlopeFrame frame{};
    frame.sides = geometry.depth > 0 ? FrameSides::all_around : FrameSides::below_and_behind;
    frame.thickness = 2 * inch;
    if (geometry.depth == 0) {
        frame.reach = geometry.slope_height / 2;
    }
    frame.joint = "joint";
    slope.frame = frame;
    return slope;
}

}  // namespace delabole
