// The blocks of a scene as the main loop needs them: their constant properties, and the motion of each.
#pragma once

#include "dynamic_relaxation/scene/scene.hpp"
#include "numerics/lanes.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace delabole {

struct CornerRange {
    std::size_t begin;
    std::size_t end;

    std::size_t size() const { return end - begin; }
    // The next and the previous corner around the block.
    std::size_t after(std::size_t corner) const { return corner + 1 < end ? corner + 1 : begin; }
    std::size_t before(std::size_t corner) const { return corner > begin ? corner - 1 : end - 1; }
};

// Struct of arrays. Corners and edges of all blocks are numbered through; edge n leads from corner n to the next one.
struct Bodies {
    std::vector<double> mass = {};             // kg per metre run; gravity and shaking act on it
    std::vector<double> inertial_mass = {};    // kg per metre run, against acceleration: equal to `mass` unless scaled
    std::vector<double> inertia = {};          // kg m2 per metre run, about the centroid; scaled in the same ratio
    std::vector<double> inverse_mass = {};     // 0 for fixed blocks
    std::vector<double> inverse_inertia = {};  // 0 for fixed blocks
    std::vector<double> radius = {};           // farthest corner from the centroid
    std::vector<double> shortest_edge = {};
    std::vector<char> fixed = {};
    std::vector<PlanePoint<>> centroid = {};  // in the initial geometry
    std::vector<CornerRange> range = {};
    std::vector<std::size_t> block_of = {};  // of a corner
    std::vector<PlanePoint<>> corner = {};   // about the centroid, in the initial geometry
    std::vector<PlanePoint<>> along = {};    // unit vector of an edge, in the initial geometry
    std::vector<double> length = {};         // of an edge
    std::vector<std::size_t> material = {};  // of an edge
    // A fixed block, if all fixed blocks move as one: the motion of the others is then measured relative to it.
    std::optional<std::size_t> moved_base = {};

    std::size_t size() const { return mass.size(); }
    PlanePoint<> normal(std::size_t edge) const { return {along[edge].y(), -along[edge].x()}; }  // outward
};

// Makes the bodies of a valid scene.
Bodies make_bodies(const RelaxationScene& scene);

// m2, of the initial geometry.
double area_of(const Bodies& bodies, std::size_t block);

// The upper median of the numbers of free blocks, without those in `removed`; unset: there are none.
std::optional<double> median_of_free(const Bodies& bodies, const std::vector<double>& numbers,
                                     const std::vector<char>& removed = {});

// Gives free blocks the inertia of the heaviest, but at most a hundred times their own. Equilibria do not change, as
// nothing accelerates in them, but the lightest block no longer sets the stable step. The motion is no longer that of
// the rock. Known as mass or density scaling (Cundall 1982).
void scale_masses(Bodies& bodies);

// Force and moment on a block, as a row of four numbers.
template <class Number>
struct alignas(4 * sizeof(double)) BlockForceOf {
    Number x{};       // N/m
    Number y{};       // N/m
    Number moment{};  // N, about the centroid
    Number unused{};

    DELABOLE_INLINED BlockForceOf& operator+=(const BlockForceOf& other) {
        x += other.x;
        y += other.y;
        moment += other.moment;
        return *this;
    }
};

using BlockForce = BlockForceOf<double>;

// Computes sine and versine of a rotation by an angle. Where the square of the angle is below 1e-4, the mask is true
// and the result is accurate to the last digits.
template <class Number>
DELABOLE_INLINED MaskOf<Number> small_turn(const Number& angle, Number& sine, Number& versine) {
    const Number square = angle * angle;
    // The series end where the next term is smaller than rounding.
    sine = angle * (1.0 - square * (1.0 / 6) * (1.0 - square * (1.0 / 20) * (1.0 - square * (1.0 / 42))));
    versine = square * 0.5 * (1.0 - square * (1.0 / 12) * (1.0 - square * (1.0 / 30) * (1.0 - square * (1.0 / 56))));
    return square < 1e-4;
}

// One block's motion since the initial geometry, and its velocity half a step ago. Displacements are stored instead of
// positions, because the overlap of stiff joints would be lost in the rounding of coordinates. The struct fills one
// cache line, because contacts visit blocks in random order.
template <class Number>
struct MotionOf {
    Number x{};        // m, of the centroid
    Number y{};        // m
    Number sine{};     // of the angle
    Number versine{};  // 1 - cosine, without cancellation
    Number vx{};
    Number vy{};
    Number spin{};   // rad/s
    Number angle{};  // rad, anticlockwise
};

// Upper bound, m/s, of the speed of any point of a block. `radius`: distance of its farthest corner.
template <class Number>
DELABOLE_INLINED Number fastest_point(const MotionOf<Number>& motion, const Number& radius) {
    return absolute(motion.vx) + absolute(motion.vy) + absolute(motion.spin) * radius;
}

struct alignas(64) Motion : MotionOf<double> {
    // Displacement of a point of the block by rotation alone.
    PlanePoint<> turned_by(const PlanePoint<>& point) const {
        return {-versine * point.x() - sine * point.y(), sine * point.x() - versine * point.y()};
    }
    PlanePoint<> turned(const PlanePoint<>& point) const { return point + turned_by(point); }
    void set_angle(double value) {
        angle = value;
        if (!small_turn(value, sine, versine)) {
            set_large_angle(value);
        }
    }

  private:
    void set_large_angle(double value);
};

// Corner of a moved block.
inline PlanePoint<> moved_corner(const Bodies& bodies, const std::vector<Motion>& motion, std::size_t corner) {
    const std::size_t block = bodies.block_of[corner];
    const Motion& moved = motion[block];
    return bodies.centroid[block] + PlanePoint<>(moved.x, moved.y) + moved.turned(bodies.corner[corner]);
}

// Rock with the lesser strengths and moduli of both; a spacing that is given counts before one of the blocks.
BondMaterial lesser_of(const BondMaterial& one, const BondMaterial& two);

// A joint that holds only what both hold: it has the lesser friction, cohesion and tensile strength, and is bonded
// where both are. Its stiffness is that of the one with less friction, or with less cohesion if both have the same.
JointMaterial lesser_of(const JointMaterial& one, const JointMaterial& two);

// Whether a joint and the rock that bonds it hold at least as much as another one in each of their strengths.
bool holds_at_least(const JointMaterial& one, const JointMaterial& other);

// The joint between two edges that lie on each other: the lesser of their joints.
JointMaterial joint_between(const RelaxationScene& scene, const Bodies& bodies, std::size_t edge,
                            std::size_t other_edge);

}  // namespace delabole
