// The stepped surface of least factor of safety among all that the joints of a lattice allow.
//
// Sliding. The mass slides on the steps, out of the slope along their dip b; risers (dip a) open. The surface ends on a
// riser, or on a step that comes out behind the crest. With W the rock above the surface, U and V the water on steps
// and risers, c and m the cohesion and the tangent of the friction of the steps (of joint and rock bridges together,
// Jennings 1970: k c_joint + (1 - k) c_rock, and m in the same way), t = (1 - k) times the tensile strength on risers,
// and lengths l,
//   resisting  R = sum over steps of c l + m (W cos b - U), less the sum over risers of m V cos(a - b), plus that of
//                  t l sin(a - b);
//   driving    D = W sin b + sum over risers of V sin(a - b);
// every term belongs to one edge of the surface (W to the edge below it), so that R and D are lengths of a path in a
// graph and F = R / D is a ratio of two lengths. Dinkelbach's (1967) argument applies: if F is too high, the path with
// the least R - F D < 0 has a ratio below F, which is the next F. The iteration ends at the least ratio after a few
// steps, each a shortest path without cycles. The additional compression of the steps by the tension of bridges is
// neglected, which is on the safe side.
//
// Columns. Column n receives from above the push P and its drag m P, m being the tangent of the friction of the joints,
// in the direction k = (out of the slope, normal to the joints) - m (up along them), and needs from below
//   against rotation about its toe corner  P' L = O + P (A + m B - d)
//   against sliding on its base            P' e = P e + D - c N - C
// with L the height of contact below, O the moment of its loads, A and B the moments of unit push and drag at the
// ground end of the upper joint, d the depth of contact under it, D and N the loads along and into the base. The share
// e of a push along k that counts in the balance of sliding is e = -(b . k - c n . k) with b up the base and n normal
// to it. With s the sum of the dips of joints (into the slope) and steps (out of it)
//   e = sin s - (m + c) cos s - m c sin s,
// which for bases normal to the joints, s = 90 deg, is the 1 - c m of Goodman & Bray (1976). Columns touch at the
// ground, d = 0; a wedge behind the last one touches it at the height given in slide_head.hpp. At a given strength more
// push on a column requires more push below it, so that of all surfaces above a column the one with the greatest need
// governs: dynamic programming over columns and levels finds the surface whose toe lacks most. This does not hold if
// e < 0, nor for a column whose loads rotate it rather than slide it and that is so squat that drag holds it, O > 0 and
// A + m B < 0. Above such columns the needs of all surfaces are passed down, from the 65th on those of evenly spaced
// ranks. Such a column is also the more stable the more the weak ones above it push, so that a slope may stand at one
// strength and fail at a greater one. F is searched from the weak side: strengths above the first at which all surfaces
// stand are not tried. A wedge that is lifted off its riser drags by less than m (slide_head.hpp). The factor of safety
// of the surface found is at most F; it becomes the next F, and the search is repeated until no surface fails. It ends
// because surfaces are finite in number and each F is less than the one before.
//
// A surface counts as a failure if every column between toe and crack moves: a column that needs no push cuts off those
// above it. The mass has to be at least one whole block wide behind the crest, and in front of each riser of a sliding
// mass: joints leave whole blocks, and the thesis counts the failed mass in whole columns of joint set A (2.3.4).
// Without such a rule the least stable surface is a sliver of the face. Columns at the toe or in the face may fail by
// themselves before, without a push from above: the search of the same joints for a mass that comes out in front of
// where a surface counts, at least one whole column wide, gives their factor.
//
// Jennings, J.E. (1970) A mathematical theory for the calculation of the stability of slopes in open cast mines. In:
// Planning Open Pit Mines, 87-102. Dinkelbach, W. (1967) On nonlinear fractional programming. Management Science 13,
// 492-498. Search of stepped paths by the weakest: Call, R.D. & Nicholas, D.E. (1978) Prediction of step path failure
// geometry for slope stability analysis. 19th US Symp. Rock Mech.
#pragma once

#include "limit_equilibrium/columns/column_recursion.hpp"
#include "limit_equilibrium/stepped_base/stepped_base.hpp"
#include "limit_equilibrium/stepped_path/path_lattice.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace delabole {

// A surface through a lattice. For sliding, `level` is that of the step that ends at each riser from `first` on; after
// the last riser that of a step which comes out behind the crest, if there is one. For columns it is that of each
// column from `first` (counted from 1) on, and `wedge` is the place of the wedge behind the last one.
struct LatticePath {
    std::size_t first = 0;
    std::vector<std::size_t> level = {};
    bool ends_on_step = false;
    std::optional<std::size_t> wedge = {};
};

struct CriticalPath {
    LimitState limit = LimitState::holds_at_any_strength;
    double factor_of_safety = 0;  // 0 if it fails at any strength, infinite if it holds at any
    LatticePath path = {};        // empty if no surface is driven
    int searches = 0;             // of the whole lattice, at most `most_searches`
};
inline constexpr int most_searches = 200;

CriticalPath least_stable_path(const SteppedPath& problem, const PathLattice& lattice);

// The least factor of safety of columns at the toe or in the face that move by themselves: of what is at least one
// whole column wide and comes out in front of where a surface counts. Infinite if nothing does, and for sliding. Its
// limit may be abrupt where only a narrower sliver fails before.
Limit least_stable_toe(const SteppedPath& problem, const PathLattice& lattice);

// Factor of safety of one given surface.
Limit factor_of_safety(const SteppedPath& problem, const PathLattice& lattice, const LatticePath& path);

// Motion of each column of a surface at the strength divided by `factor`, from the toe up, and the push on it from
// above; `moves` if every column does.
struct MovingColumn {
    ColumnMode mode = ColumnMode::stays;
    double push = 0;
    double depth = 0;  // of the contact above, below the ground, along the joint
};
std::vector<MovingColumn> moving_columns(const SteppedPath& problem, const PathLattice& lattice,
                                         const LatticePath& path, double factor);

// The surface of least factor of safety among those that slide on steps.
CriticalPath least_stable_sliding(const SteppedPath& problem, const PathLattice& lattice);

// The least factor of safety of what slides on a single riser that comes out in the face and, as far behind the crest
// as a surface may, on the ground. Infinite if there is none: risers are steeper than the face.
Limit least_stable_on_riser(const SteppedPath& problem, const PathLattice& lattice);

// Factor of safety of one given surface.
Limit sliding_limit(const SteppedPath& problem, const PathLattice& lattice, const LatticePath& path);

}  // namespace delabole
