// How far a bolt runs through the ground of a slope.
#pragma once

#include "plane_failure/parameters.hpp"
#include "plane_failure/wedge.hpp"

#include <limits>

namespace delabole {

// Length along a bolt from its head, at a height on the face, to where it comes out of the ground behind the crest, m;
// infinite if it does not, 0 if it rises more steeply than the face.
template <class T>
T length_in_ground(const SlopeSection<T>& slope, const T& head_height, const T& plunge) {
    const auto slope_of = [](const T& angle) {
        const SineCosine<T> direction = sine_cosine(angle);
        return T(direction.sine / direction.cosine);
    };
    const SineCosine<T> bolt = sine_cosine(plunge);
    const SineCosine<T> face = sine_cosine(slope.face_dip);
    if (-bolt.sine * face.cosine > bolt.cosine * face.sine) {
        return T(0);
    }
    const T head_x = head_height * face.cosine / face.sine;
    T x = slope.height * face.cosine / face.sine;
    T y = slope.height;
    const auto length_below = [&](const T& rise) {
        const T leaving = -bolt.sine - bolt.cosine * rise;
        return leaving > 0 ? T((y - head_height + (head_x - x) * rise) / leaving)
                           : T(std::numeric_limits<double>::infinity());
    };
    if (slope.bench) {
        const T rise = slope_of(slope.bench->dip);
        const T length = length_below(rise);
        x += slope.bench->width;
        y += slope.bench->width * rise;
        if (head_x + length * bolt.cosine <= x) {
            return length;
        }
    }
    return length_below(slope_of(slope.upper_surface_dip));
}

}  // namespace delabole
