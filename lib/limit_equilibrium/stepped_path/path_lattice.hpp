// The crossings of steps, risers and columns in a slope, and the loads on every part that a stepped surface can cut
// off.
//
// Rock lies below the face and below the ground behind the crest: it is convex. Water is at rest below a surface that
// is the lowest of a few straight lines, the ground among them, so that the height of water over a straight edge is
// concave and linear between a few points.
//
// Levels are counted upwards from the plane of the steps that daylights at the toe, 0; risers into the slope, for
// sliding from the first one behind the toe, otherwise from the joint through the crest, 0; joints of columns into the
// slope from the one through the toe, 0. Column n stands between joints n - 1 and n.
#pragma once

#include "geometry/polyline.hpp"
#include "limit_equilibrium/columns/column.hpp"
#include "limit_equilibrium/stepped_path/stepped_path_parameters.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace delabole {

// Points `point` with normal . point = offset.
struct SectionLine {
    Point normal;
    double offset;
};

// Loads of rock and water on a part, and their moment about a point, positive anticlockwise: toppling out of the slope.
struct PathLoad {
    Point force = Point(0, 0);
    double moment = 0;
};

// A column on one level. It `exists` if its base lies in the rock; at the toe its base begins at the face.
struct PathCell {
    bool exists = false;
    bool at_face = false;
    Point base_from = Point(0, 0);  // the corner about which it rotates
    Point base_to = Point(0, 0);
    double area = 0;
    double down_dip = 0;     // of the load, along the base out of the slope
    double normal = 0;       // of the load, into the base
    double overturning = 0;  // moment of the load about base_from
    double base_length = 0;
    double lower_contact = 0;  // height of the ground at the lower joint over base_from, along that; 0 at the face
    double upper_reach = 0;    // length of the upper joint from base_to to the ground
    // Moment about base_from of a unit push at the ground end of the upper joint, and of a unit drag down along it.
    double push_arm = 0;
    double drag_arm = 0;
};

// A wedge between joint n of the columns and a riser, from their crossing up to the ground.
struct PathWedge {
    std::size_t riser;
    double depth;  // of the crossing below the ground, along the joint of the columns
    Point corner;
    Point outcrop;
    double area;
    SlideHeadWedge<> loads;
};

class PathLattice {
  public:
    // `check` is valid if there is a lattice; otherwise the other members have no meaning.
    explicit PathLattice(const SteppedPath& path);

    SteppedPathCheck check = SteppedPathCheck::no_path;
    Point crest;
    double least_width = 0;
    double greatest_retreat = 0;
    std::size_t levels = 0;

    // For sliding; a node is absent outside the rock, and if the mass in front of it would be too narrow.
    std::vector<std::vector<std::optional<Point>>> riser_node;  // by riser, then level
    std::vector<std::optional<Point>> step_outcrop;  // by level, where the step comes out far enough behind the crest
    // Each riser comes out here: behind the crest on the ground, in front of it in the face.
    std::vector<Point> riser_outcrop;

    // For toppling.
    std::vector<std::vector<PathCell>> cells;    // by column - 1, then level
    std::vector<Point> column_outcrop;           // of joint n, by n - 1
    std::vector<std::vector<PathWedge>> wedges;  // behind joint n, by n - 1

    std::optional<Point> face_point(std::size_t level) const;
    // A flat riser comes out of the face here; empty if it does so below the toe, in massive rock or not at all.
    std::optional<Point> riser_in_face(std::size_t riser) const;
    double retreat(const Point& outcrop) const { return outcrop.x() - crest.x(); }
    bool is_far_enough(const Point& outcrop) const {
        return retreat(outcrop) >= least_width && retreat(outcrop) <= greatest_retreat;
    }
    // Whether the ground from one of its points to another turns at the crest.
    bool crest_between(const Point& one, const Point& other) const;
    // Rock between an edge and the ground above it, m2.
    double area_above(const Point& from, const Point& to) const;
    // Force of the water on an edge (N/m, at least 0) and the distance of its resultant from `from` along the edge.
    struct EdgeWater {
        double force = 0;
        double position = 0;
    };
    EdgeWater water_on(const Point& from, const Point& to) const;
    // Vertices in order of x; the last two define its continuation. Empty if the slope is dry.
    const std::vector<Point>& water_surface() const { return water_surface_; }

  private:
    double ground(double x) const;
    double ground_integral(double x) const;
    bool inside(const Point& point) const;
    bool in_massive_rock(const Point& point) const {
        return massive_ && massive_->normal.dot(point) < massive_->offset - tolerance_;
    }
    Point exit(const Point& from, const Point& along) const;
    void set_water(const SteppedPath& path);
    bool has_surface() const;
    void set_riser_outcrops();
    void set_risers();
    void set_columns(const SteppedPath& path);
    PathCell make_cell(std::size_t column, std::size_t level) const;
    std::optional<PathWedge> make_wedge(const SteppedPath& path, std::size_t column, std::size_t riser) const;
    SectionLine level_line(std::size_t level) const;
    SectionLine riser_line(std::size_t riser) const;
    SectionLine column_line(std::size_t joint) const;
    void add_part(PathLoad& load, double& area, const Point* corners, std::size_t count, const Point& about) const;
    void add_push(PathLoad& load, const EdgeWater& water, const Point& from, const Point& along, const Point& normal,
                  const Point& about) const;

    SectionLine face_;
    SectionLine upper_;
    std::optional<SectionLine> massive_;  // the rock with open joints lies to its left
    double slope_upper_ = 0;
    double cot_face_ = 0;
    double unit_weight_ = 0;
    double water_weight_ = 0;  // 0: dry
    std::vector<Point> water_surface_;
    Point step_along_;
    Point riser_along_;
    Point column_up_;
    double step_spacing_ = 0;
    double riser_spacing_ = 0;
    double risers_in_front_ = 0;  // of the joint through the crest
    double column_spacing_ = 0;
    double tolerance_ = 0;
};

}  // namespace delabole
