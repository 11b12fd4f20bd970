// The part of a slope that has failed and the ground left standing, from the initial and the present positions of its
// blocks.
//
// A block's movement is m = sqrt(displacement^2 + (rotation times radius)^2) since the start. The share of it that
// counts as failed is m^4 / (m^4 + limit^4): half at the limit, a ten-thousandth at a tenth of it. Areas and elevations
// add such shares, so that they change smoothly with the motion and a fit can use them. Blocks removed in a stage of
// excavation count as absent, not as failed; blocks removed because they have failed count as wholly failed
// (retrogression.hpp).
//
// The elevation left standing at x is that of the ground at the start, less the share-weighted height of the blocks on
// the vertical line there; for an overhang only this sum is correct. The failure's foot and top are where more than a
// hundredth of the slope's height is lost. Its knee is the point of the ground left standing that is farthest below the
// straight line between them, e.g. the level of 425 ft at Delabole, where the stepped lower surface meets the upper
// one. For a slope that has not failed, its own foot and top are used.
//
// Section axes: x into the slope, y up, metres and radians, without a correction for a tilt of gravity.
#pragma once

#include "dynamic_relaxation/blocks/bodies.hpp"
#include "geometry/polyline.hpp"
#include "parameters/fields.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace delabole {

struct PostFailureRequest {
    std::optional<double> moved_share;
    std::optional<double> crack_share;
    static constexpr double standard_moved_share = 0.25;
    static constexpr double standard_crack_share = 0.01;
    static constexpr auto fields() {
        using R = PostFailureRequest;
        return FieldTable{
            absent_is(
                standard_moved_share,
                number<&R::moved_share>(
                    more_than(0), "movement at which half of a block counts as failed, in sizes of the median block")),
            absent_is(standard_crack_share,
                      number<&R::crack_share>(
                          more_than(0), "opening at which a joint at the crest counts as an open crack, likewise"))};
    }
};

// Open joints of one kind that daylight at the ground behind the crest.
struct CrestJoint {
    std::string joint;
    double open;
    double opening;
    double farthest;
    static constexpr auto fields() {
        return FieldTable{
            section<&CrestJoint::joint>("name of the properties along it"),
            number<&CrestJoint::open>("cracks, each by the share of its opening as a block by that of its movement"),
            number<&CrestJoint::opening>(Dimension::length, "of all together, none more than the median block's size"),
            number<&CrestJoint::farthest>(Dimension::length, "of an open crack behind the crest; 0: none is open")};
    }
};

// Mean over blocks at the ground behind the crest, weighted by their width there; zero if there are none.
struct CrestMovement {
    double horizontal;
    double vertical;
    double rotation;
    static constexpr auto fields() {
        return FieldTable{number<&CrestMovement::horizontal>(Dimension::length, "displacement, into the slope"),
                          number<&CrestMovement::vertical>(Dimension::length, "displacement, upwards"),
                          number<&CrestMovement::rotation>(Dimension::angle, "out of the slope")};
    }
};

struct PostFailureAnswer {
    double failed_area;
    double failed_width;
    double foot_level;
    double knee_level;
    double top_level;
    double lower_angle;
    double upper_angle;
    double lower_roughness;
    double upper_roughness;
    CrestMovement near_face;
    CrestMovement between_cracks;
    double backward_rotation;
    double rotation_share;
    std::vector<CrestJoint> joint;
    static constexpr auto fields() {
        using P = PostFailureAnswer;
        return FieldTable{
            number<&P::failed_area>(Dimension::area, "of the section that has failed"),
            number<&P::failed_width>(Dimension::length, "of the ground behind the crest, failed"),
            number<&P::foot_level>(Dimension::length, "y of the foot of the failure: its height above a toe at (0, 0)"),
            number<&P::knee_level>(Dimension::length, "likewise, where lower and upper surface meet"),
            number<&P::top_level>(Dimension::length, "likewise, of its top"),
            number<&P::lower_angle>(Dimension::angle, "mean inclination of the surface left standing, foot to knee"),
            number<&P::upper_angle>(Dimension::angle, "likewise, knee to top"),
            number<&P::lower_roughness>(
                Dimension::length,
                "root mean square distance of the surface left standing from the line from foot to knee"),
            number<&P::upper_roughness>(Dimension::length, "likewise, from knee to top"),
            section<&P::near_face>("blocks between the crest and the first open crack behind it"),
            section<&P::between_cracks>("blocks between the first and the last open crack"),
            number<&P::backward_rotation>(Dimension::angle,
                                          "into the slope, the greatest of a block at the ground behind the crest"),
            number<&P::rotation_share>(
                "share of rotation in the kinetic energy of all blocks that are there, with displacements since the "
                "start in place of velocities; 0: they slide, 0.25: rectangles turn about a corner"),
            section<&P::joint>("cracks at the crest by their joint, as the scene lists joints")};
    }
};

struct CrestCrack {
    double position;    // m behind the crest
    double opening;     // m, normal to the joint, at the ground
    double dip;         // rad, positive out of the slope
    std::size_t joint;  // index among the scene's joints
};

// A block that forms a part of the ground behind the crest.
struct CrestBlock {
    std::size_t block;
    double position;  // m behind the crest, of the middle of that part
    double width;     // m
    CrestMovement movement;
};

struct PostFailure {
    PostFailureAnswer answer = {};
    Polyline ground = {};                // at the start, without the blocks removed by stages
    Polyline left_standing = {};         // from the front end of the section into the slope
    Point crest = {0, 0};                // of the slope at the start
    std::vector<Point> surface = {};     // foot, knee and top of the failure
    std::vector<double> share = {};      // of each block that has failed, 0 to 1
    std::vector<CrestCrack> crack = {};  // open joints, from the crest into the slope
    std::vector<CrestBlock> block = {};  // from the crest into the slope
};

struct MovedSlope {
    const Bodies& bodies;
    const std::vector<Motion>& start;
    const std::vector<Motion>& now;
    const std::vector<char>& removed;        // by stages
    const std::vector<std::string>& joints;  // names, one for each material
    std::vector<char> failed = {};           // and removed for that reason; empty: none
};

// At least one block must be free. If stages have removed all blocks, everything is empty and zero.
PostFailure post_failure(const MovedSlope& slope, const PostFailureRequest& request);

}  // namespace delabole
