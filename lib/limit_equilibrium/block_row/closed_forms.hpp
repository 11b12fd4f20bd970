// The thesis's formulas for rows of two, three and four blocks of the same height a and width b (4.2, 4.3), as printed
// and as derived. Each returns tan(tilt). mu is the friction of the interfaces, c that of the base, m = mu c.
//
// Derivation: block_row_mode.hpp, with equal blocks sum X = sum b mu S and t = tan(tilt), per weight and cos(tilt):
//     from below  S_i = i (c - t) / (1 - m),    from above  S_i = (N - i) (c + t) / (1 + m)
// so that F^k P B^(N-1-k) begins at
//     N (a t - b) / 2 = b mu { k (k + 1) / 2 (c - t) / (1 - m) + q (q + 1) / 2 (c + t) / (1 + m) },   q = N - 1 - k
//
// Comparison of the printed with the derived formulas:
//     (7) (8) (9) (10) (11)  correct
//     (12) (13)  correct: the thrusts above, per block weight, of one block in the forward and backward mode
//     (14)  printed equal to (8). FFP gives b (1 + m) / [a (1 - m) + 2 b mu], which exceeds (8) wherever c > b / a,
//           since their difference has the sign of mu (1 - m)(c a - b). Equal to (8) is F P with the third block
//           standing apart, but on a plane steeper than b / a it does not stand: a row in contact gains from a third.
//     (15)  correct for FPB
//     (16)  its text is lost; PBB gives b (1 + 3 m) / [a (1 + m) - 2 b mu]
//     (17)  correct for FBB: both terms of the fraction carry the factor 1 + m, and c (3 m - 1) / (3 - m) is the same
//     (18)  multiplied out, its denominator is 2 (1 - m) {a (1 - m)(2 + m) + b mu (2 + 4 m)}; FFPB has
//           2 (1 - m) {2 a (1 - m)(1 + m) + b mu (2 + 4 m)}: so it is meant for FFPB, with (2 + m) for 2 (1 + m).
//           Its numerator contains mu by itself, which friction can bring in only together with c or b / a.
//     (19)  has the numerator of (18) at c = mu, but + 4 b mu (1 - mu^2)^2 in the denominator where (18) has a
//           minus: an error of sign, because b mu (2 + 4 m) requires the minus. Correct for FFPB is
//           b (1 + 2 m) / [a (1 - m^2) + b mu (1 + 2 m)].
//
// A formula whose denominator is not positive has no tilt below 90 deg; the caller checks this. Accuracy: a few units
// in the last place, except where the denominator cancels.
#pragma once

#include <cmath>

namespace delabole::closed_form {

// (7): the lower block's toe slides forward, the upper one pivots (FP).
inline double two_blocks_forward(double a, double b, double w1, double w2, double mu, double c) {
    const double m = mu * c;
    return b * ((w1 + w2) * (1 - m) + 2 * w1 * m) / (a * (w1 + w2) * (1 - m) + 2 * w1 * b * mu);
}

// (8): (7) with equal weights; (9) is this with c = mu.
inline double two_equal_blocks_forward(double a, double b, double mu, double c) {
    return b / (a * (1 - mu * c) + b * mu);
}

// (10): the upper block's toe slides backward, the lower one pivots (PB).
inline double two_blocks_backward(double a, double b, double w1, double w2, double mu, double c) {
    const double m = mu * c;
    return b * ((w1 + w2) * (1 + m) + 2 * w2 * m) / (a * (w1 + w2) * (1 + m) - 2 * w2 * b * mu);
}

// Derived formula for N equal blocks: `forward` toes slide forward, one pivots, `backward` ones slide backward. It
// contains (8), (15) and the corrected (14), (16) and (18).
inline double equal_blocks(int forward, int backward, double a, double b, double mu, double c) {
    const int count = forward + 1 + backward;
    const double m = mu * c;
    const double below = forward * (forward + 1) * (1 + m);
    const double above = backward * (backward + 1) * (1 - m);
    return b * (count * (1 - m) * (1 + m) + m * (below + above)) /
           (a * count * (1 - m) * (1 + m) + b * mu * (below - above));
}

// (14) as derived: FFP.
inline double three_blocks_two_forward(double a, double b, double mu, double c) {
    const double m = mu * c;
    return b * (1 + m) / (a * (1 - m) + 2 * b * mu);
}

// (15): FPB.
inline double three_blocks_forward_backward(double a, double b, double mu, double c) {
    const double m = mu * c;
    return (3 * b * (1 - m * m) + 4 * b * m) / (3 * a * (1 - m * m) + 4 * b * mu * m);
}

// (16) as derived: PBB.
inline double three_blocks_two_backward(double a, double b, double mu, double c) {
    const double m = mu * c;
    return b * (1 + 3 * m) / (a * (1 + m) - 2 * b * mu);
}

// (17) as printed: FBB, from the equality of the thrusts.
inline double three_blocks_equal_thrusts(double mu, double c) {
    const double m = mu * c;
    return (m * c * (2 + 3 * m) - c) / (m * (2 - m) + 3);
}

// (18) as printed.
inline double four_blocks_printed(double a, double b, double mu, double c) {
    const double m = mu * c;
    return b * (c * c * (2 * c - 1) * mu * mu * mu - 7 * m * m + (3 * c + 1) * mu + 4) /
           (2 * (a * (1 - 2 * m + m * m) + 2 * b * mu * (1 - m)) * (2 + m) - 4 * b * mu * (1 - m) * (1 - m));
}

// (19) as printed.
inline double four_blocks_one_friction_printed(double a, double b, double mu) {
    const double squared = mu * mu;
    const double product = (mu + 1) * (mu - 1);
    return b * (squared * squared * ((2 * mu - 3) * (mu + 1) - 4) + ((3 * mu + 4) * (mu - 1) + 8)) /
           (product * (2 * (a * product - 2 * b * mu) * (squared + 2) + 4 * b * mu * product));
}

// (18) as derived: FFPB.
inline double four_blocks_two_forward_one_backward(double a, double b, double mu, double c) {
    const double m = mu * c;
    return b * (1 + 2 * m) / (a * (1 - m * m) + b * mu * (1 + 2 * m));
}

// Base friction at which two blocks change over from FP to PB (Figs 4.7, 4.8). With w = W_1 / (W_1 + W_2),
// (7) = (10) is
//     w (1 + m)(c a - b) - (1 - w)(1 - m)(c a + b) - 4 w (1 - w) m b = 0
// linear in w^2 and quadratic in c, mu a c^2 + {(2 w - 1) a - [(2 w - 1)^2 + ...]} ...: collected by powers of c below.
inline double boundary_base_friction(double a, double b, double w, double mu) {
    const double v = 1 - w;
    // c^2 mu a (w + v) + c [a (w - v) + mu b (v - w) - 4 w v mu b] - b (w + v)
    const double quadratic = mu * a;
    const double half_linear = ((w - v) * (a - mu * b) - 4 * w * v * mu * b) / 2;
    const double root = std::sqrt(half_linear * half_linear + quadratic * b);
    // This form avoids cancellation; mu = 0 leaves the linear equation.
    return half_linear > 0 ? b / (half_linear + root) : (root - half_linear) / quadratic;
}

// Share w = W_1 / (W_1 + W_2) of the lower block's weight that puts the changeover at base friction c: the root in
// [0, 1] of the same equation; both ends of the interval have opposite signs where c a > b and m < 1.
inline double weight_share_at_boundary(double a, double b, double mu, double c) {
    const double m = mu * c;
    // 4 m b w^2 + w [(1 + m)(c a - b) + (1 - m)(c a + b) - 4 m b] - (1 - m)(c a + b) = 0
    const double quadratic = 4 * m * b;
    const double constant = (1 - m) * (c * a + b);
    const double half_linear = ((1 + m) * (c * a - b) + constant - quadratic) / 2;
    const double root = std::sqrt(half_linear * half_linear + quadratic * constant);
    return half_linear > 0 ? constant / (half_linear + root) : (root - half_linear) / quadratic;
}

}  // namespace delabole::closed_form
