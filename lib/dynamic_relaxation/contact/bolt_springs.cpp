#include "dynamic_relaxation/contact/bolt_springs.hpp"

#include <algorithm>

namespace delabole {

BoltPosition locate(const BoltSegment& segment, const Bodies& bodies, const std::vector<Motion>& motion) {
    const Motion& one = motion[segment.block];
    const Motion& two = motion[segment.other];
    const PlanePoint<> arm = segment.at - bodies.centroid[segment.block];
    const PlanePoint<> other_arm = segment.other_at - bodies.centroid[segment.other];
    const PlanePoint<> drawn = segment.other_at - segment.at;
    // Computed from the displacement, because the difference of two lengths would lose the small extensions of a stiff
    // bolt.
    const PlanePoint<> moved =
        PlanePoint<>(two.x - one.x, two.y - one.y) + two.turned_by(other_arm) - one.turned_by(arm);
    const PlanePoint<> now = drawn + moved;
    const double length = now.norm();
    const PlanePoint<> arm_now = one.turned(arm);
    const PlanePoint<> other_arm_now = two.turned(other_arm);
    return {(2 * drawn + moved).dot(moved) / (length + drawn.norm()),
            length > 0 ? PlanePoint<>(now / length) : PlanePoint<>(0, 0),
            arm_now.x(),
            arm_now.y(),
            other_arm_now.x(),
            other_arm_now.y()};
}

double force_of(const BoltSegment& segment, const BoltMemory& memory, double extension) {
    const double elastic =
        segment.pretension + segment.stiffness * (extension - memory.extension_at_start - memory.yielded);
    return std::clamp(elastic, 0.0, segment.capacity);
}

bool holds(const BoltSegment& segment, const std::vector<char>& removed) {
    return removed[segment.block] == 0 && removed[segment.other] == 0;
}

}  // namespace delabole
