// Faces of two blocks that lie on each other in the initial geometry, and how they have moved apart since.
#pragma once

#include "dynamic_relaxation/blocks/bodies.hpp"
#include "dynamic_relaxation/blocks/neighbours.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

namespace delabole {

struct SharedFace {
    std::uint32_t block;
    std::uint32_t other;
    std::uint32_t edge;  // of the block; edges of all blocks are numbered through
    std::uint32_t other_edge;
    PlanePoint<> arm;        // of the middle of the shared length, about the block's centroid, in the initial geometry
    PlanePoint<> other_arm;  // of the same point, about the other block's centroid
    PlanePoint<> along;      // of the other's edge, in the initial geometry
    double length;           // m
};

// A joint of two blocks counts as closed if it is open by no more than this in the initial geometry: in shortest edges
// of the two, and in m. Its blocks touch there from the beginning, so that rounded coordinates make no difference. Nor
// does rounding where a joint is drawn open by just a thousandth.
inline constexpr double closed_joint = (1 + 1e-9) * 1e-3;
inline double opening_of_closed_joint(const Bodies& bodies, std::size_t block, std::size_t other,
                                      double opening = closed_joint) {
    return opening * std::min(bodies.shortest_edge[block], bodies.shortest_edge[other]);
}

// The face that two edges share if they face each other, the ends of one of them lie on the line of the other within
// the opening of a closed joint, and they share a length greater than that; empty otherwise. Here and below another
// `opening` may be allowed, in shortest edges.
std::optional<SharedFace> shared_face(const Bodies& bodies, std::size_t edge, std::size_t other_edge,
                                      double opening = closed_joint);

// The faces that two blocks share, in the order of the edges of the one and, for each, of the other.
std::vector<SharedFace> faces_between(const Bodies& bodies, std::size_t block, std::size_t other,
                                      double opening = closed_joint);

// By how much a face of find_shared_faces is open in the initial geometry where its length starts and ends along the
// other's edge, m; negative where the blocks overlap.
std::array<double, 2> opening_in_drawing(const Bodies& bodies, const SharedFace& face);

// Pairs of blocks, not both fixed, that may touch in the initial geometry, in increasing order.
std::vector<BlockPair> touching_blocks(const Bodies& bodies, double opening = closed_joint);

// Finds third blocks between two blocks, such as the filling of a seam that is thinner than the opening of a closed
// joint: the two do not touch there.
class BlocksBetween {
  public:
    // `near`: of touching_blocks. `gone`: of each block, not 0 if it is not there; empty if all are.
    BlocksBetween(const Bodies& bodies, const std::vector<BlockPair>& near, const std::vector<char>& gone = {});

    // Whether a third block lies between the two along more than a tenth of their face or, if it is no thicker than
    // twice the joint's opening, along more than half of its own shortest edge.
    bool part(const SharedFace& face) const;
    // Whether a third block lies between a corner of a block and the edge of another that is `gap` below it, m.
    bool part(std::size_t corner, std::size_t other_edge, double gap) const;

  private:
    template <class Matches>
    bool any_near(std::size_t block, std::size_t other, const Matches& matches) const;
    double share_inside(std::size_t third, const PlanePoint<>& from, const PlanePoint<>& to) const;

    const Bodies& bodies_;
    std::vector<std::vector<std::uint32_t>> near_;  // of each block, the blocks near it
};

// The shared faces of all touching_blocks between which no third block lies, in the order of the pairs. `gone`: of each
// block, not 0 if it is not there and so lies between none; empty if all are.
std::vector<SharedFace> find_shared_faces(const Bodies& bodies, double opening = closed_joint,
                                          const std::vector<char>& gone = {});

// Position of the block's face relative to the other block, whose face carries the axes.
struct FacePosition {
    double normal_x;  // outward from the other
    double normal_y;
    double opening;  // m, of the middle, along the normal; negative in compression
    double slide;    // m, of the middle along the other's edge
    double turn;     // rad, of the block against the other
    double arm_x;    // from the block's centroid to the middle of its face
    double arm_y;
    double other_arm_x;  // from the other's centroid to the same point
    double other_arm_y;

    double along_x() const { return -normal_y; }
    double along_y() const { return normal_x; }
    // Opening at the end where it is larger.
    double widest(double length) const { return opening + std::abs(turn) * length / 2; }
};

inline FacePosition locate(const SharedFace& face, const Motion& block, const Motion& other) {
    const PlanePoint<> turned = block.turned_by(face.arm);
    const PlanePoint<> other_turned = other.turned_by(face.other_arm);
    // Only changes are added up, as for contacts, so that no digits are lost to large coordinates.
    const double change_x = (block.x - other.x) + (turned.x() - other_turned.x());
    const double change_y = (block.y - other.y) + (turned.y() - other_turned.y());
    const PlanePoint<> normal = other.turned(PlanePoint<>(face.along.y(), -face.along.x()));
    FacePosition at;
    at.normal_x = normal.x();
    at.normal_y = normal.y();
    at.opening = normal.x() * change_x + normal.y() * change_y;
    at.slide = at.along_x() * change_x + at.along_y() * change_y;
    at.turn = block.angle - other.angle;
    at.arm_x = face.arm.x() + turned.x();
    at.arm_y = face.arm.y() + turned.y();
    at.other_arm_x = face.other_arm.x() + other_turned.x() + change_x;
    at.other_arm_y = face.other_arm.y() + other_turned.y() + change_y;
    return at;
}

}  // namespace delabole
