// Closed forms of Hoek & Bray for a plane through the toe, a horizontal upper surface and a vertical crack, in forms
// that do not lose digits when plane and face are nearly parallel or the face nearly vertical. Templates over the
// scalar.
//
// z is the depth of the crack's bottom below crest level (for a crack in the face this is not the depth of the crack).
#pragma once

#include <cmath>

namespace delabole::closed_form {

// Printed as 1/2 gamma H^2 {[1 - (z/H)^2] cot p - cot f}. Here cot p times (1 - zeta^2 - k) with k = cot f tan p,
// where 1 - k = sin(f - p) / (sin f cos p); of the two orders of subtraction the one without cancellation is taken.
// Valid for 0 <= z <= (1 - k) H: crack between the plane's outcrop and the crest. Relative error below 1e-14.
template <class T>
T weight_crack_behind_crest(const T& unit_weight, const T& height, const T& z, const T& face_dip, const T& plane_dip) {
    using std::cos;
    using std::sin;
    const T zeta = z / height;
    const T one_minus_k = sin(T(face_dip - plane_dip)) / (sin(face_dip) * cos(plane_dip));
    const T k = cos(face_dip) * sin(plane_dip) / (sin(face_dip) * cos(plane_dip));
    const T factor = k < 0.5 ? T((height - z) / height * (1 + zeta) - k) : T(one_minus_k - zeta * zeta);
    return unit_weight * height * height / 2 * (cos(plane_dip) / sin(plane_dip)) * factor;
}

// Printed as 1/2 gamma H^2 (1 - z/H)^2 cot p (cot p tan f - 1). Here cot p tan f - 1 = sin(f - p) / (sin p cos f).
// Valid for (1 - k) H <= z < H: crack in the face. The printed form without a bracket ("[(1 - z/H)^2 cot p (...)]") is
// the same. Relative error below 1e-14 for faces up to 89.99 deg.
template <class T>
T weight_crack_in_face(const T& unit_weight, const T& height, const T& z, const T& face_dip, const T& plane_dip) {
    using std::cos;
    using std::sin;
    const T base_height = height - z;
    return unit_weight * base_height * base_height / 2 * (cos(plane_dip) / sin(plane_dip)) *
           (sin(T(face_dip - plane_dip)) / (sin(plane_dip) * cos(face_dip)));
}

// Dry slope: z_c / H = 1 - sqrt(cot f tan p), written as (1 - k) / (1 + sqrt k).
template <class T>
T critical_crack_depth_ratio(const T& face_dip, const T& plane_dip) {
    using std::cos;
    using std::sin;
    using std::sqrt;
    const T k = cos(face_dip) * sin(plane_dip) / (sin(face_dip) * cos(plane_dip));
    return T(sin(T(face_dip - plane_dip)) / (sin(face_dip) * cos(plane_dip))) / (1 + T(sqrt(k)));
}

// Dry slope: b_c / H = sqrt(cot f cot p) - cot f, written with cot p - cot f = sin(f - p) / (sin f sin p).
template <class T>
T critical_crack_distance_ratio(const T& face_dip, const T& plane_dip) {
    using std::cos;
    using std::sin;
    using std::sqrt;
    const T cot_face = cos(face_dip) / sin(face_dip);
    const T cot_plane = cos(plane_dip) / sin(plane_dip);
    return T(sqrt(cot_face)) * T(sin(T(face_dip - plane_dip)) / (sin(face_dip) * sin(plane_dip))) /
           (T(sqrt(cot_plane)) + T(sqrt(cot_face)));
}

// Dry slope without crack, Coulomb strength (Culmann): the plane that needs the most cohesion bisects the face and the
// friction angle *mobilised*, tan(phi_m) = tan(phi) / FS. With the full friction angle, as often printed, it is the
// plane of least factor of safety only where that factor is 1.
template <class T>
T critical_plane_dip(const T& face_dip, const T& mobilised_friction_angle) {
    return T((face_dip + mobilised_friction_angle) / 2);
}

// The same plane for given strength. With k = 2 c / (gamma H), t = tan(phi) and u = cot p the factor of safety is
//     FS = k (1 + u^2) / (u - cot f) + t u
// and least where (u - cot f)^2 sin^2 f = k / (k + t). k + t must not be 0; without cohesion the limit is the face.
template <class T>
T critical_plane_dip(const T& unit_weight, const T& height, const T& face_dip, const T& cohesion,
                     const T& friction_angle) {
    using std::atan2;
    using std::cos;
    using std::sin;
    using std::sqrt;
    using std::tan;
    const T k = 2 * cohesion / (unit_weight * height);
    const T root = sqrt(T(k / (k + T(tan(friction_angle)))));
    return T(atan2(T(sin(face_dip)), T(cos(face_dip) + root)));
}

// Its factor of safety: (2 k + t) cot f + 2 sqrt(k (k + t)) / sin f.
template <class T>
T critical_plane_factor_of_safety(const T& unit_weight, const T& height, const T& face_dip, const T& cohesion,
                                  const T& friction_angle) {
    using std::cos;
    using std::sin;
    using std::sqrt;
    using std::tan;
    const T k = 2 * cohesion / (unit_weight * height);
    const T t = tan(friction_angle);
    return T(((2 * k + t) * T(cos(face_dip)) + 2 * T(sqrt(T(k * (k + t))))) / T(sin(face_dip)));
}

}  // namespace delabole::closed_form
