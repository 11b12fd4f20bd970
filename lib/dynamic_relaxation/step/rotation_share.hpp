// Share of rotation in the kinetic energy of blocks, with their displacements and rotations over an interval in place
// of velocities: at the onset of failure both are proportional, and velocities are zero wherever kinetic damping has
// just acted.
//
// It tells toppling from sliding by energy: 0 where blocks slide; 1/4 where rectangles of any slenderness turn about a
// corner, since their inertia about the centroid is a quarter of that about the corner; 1 where blocks turn in place.
#pragma once

#include "dynamic_relaxation/blocks/bodies.hpp"

#include <cstddef>

namespace delabole {

class RotationShare {
  public:
    void add(const Bodies& bodies, std::size_t block, const Motion& from, const Motion& to) {
        const double x = to.x - from.x;
        const double y = to.y - from.y;
        const double angle = to.angle - from.angle;
        translation_ += bodies.mass[block] * (x * x + y * y);
        rotation_ += bodies.inertia[block] * angle * angle;
    }
    // 0 if nothing has moved.
    double value() const {
        const double all = translation_ + rotation_;
        return all > 0 ? rotation_ / all : 0;
    }

  private:
    double translation_ = 0;  // twice the energies
    double rotation_ = 0;
};

}  // namespace delabole
