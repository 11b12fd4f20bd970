// The stepped surface of least factor of safety among all that the joints of a lattice allow.
//
// Sliding. The mass slides on the steps, out of the slope along their dip b; risers (dip a) open. With W the rock above
// the surface, U and V the water on steps and risers, c and m the cohesion and the tangent of the friction of the steps
// (of joint and rock bridges together, Jennings 1970: k c_joint + (1 - k) c_rock, likewise m), t = (1 - k) times the
// tensile strength on risers, and lengths l,
//   resisting  R = sum over steps of c l + m (W cos b - U), over risers of m V cos(a - b) taken off, and t l sin(a - b)
//                  added;
//   driving    D = W sin b + sum over risers of V sin(a - b);
// every term belongs to one edge of the surface (W to the edge below it), so that R and D are lengths of a path in a
// graph and F = R / D is a ratio of two lengths. Where F is too high by Dinkelbach's (1967) argument: the path with the
// least R - F D < 0 has a ratio below F, which is the next F. It ends at the least ratio, in a few steps, each a
// shortest path without cycles. Left out, on the safe side: the tension of bridges also presses on the steps.
//
// Columns. Column n takes from above the push P and its drag m P, m being the tangent of the friction of the joints, in
// the direction k = (out of the slope, normal to the joints) - m (up along them), and needs from below
//   against turning about its toe corner   P' L = O + P (A + m B - d)
//   against sliding on its base            P' e = P e + D - c N - C
// with L the height of contact below, O the moment of its loads, A and B the moments of unit push and drag at the
// ground end of the upper joint, d the depth of contact under it, D and N the loads along and into the base. What a
// push along k takes from sliding is e = -(b . k - c n . k) with b up the base and n normal to it: with s the sum of
// the dips of joints (into the slope) and steps (out of it)
//   e = sin s - (m + c) cos s - m c sin s,
// which for bases normal to the joints, s = 90 deg, is the 1 - c m of Goodman & Bray (1976). Contact is at the ground,
// d = 0, where columns touch; a wedge behind the last one (slide_head.hpp) touches it where that says.
// At given strength more push on a column asks more of what is below, so that of all surfaces above it the one with the
// greatest need asks most: dynamic programming over columns and levels finds the surface whose toe lacks most. It does
// not where e < 0, and for a column that its loads turn rather than slide and that is squatter than its own drag, O > 0
// and A + m B < 0: what stands above such a one hands down the needs of all surfaces, from the 65th on those of evenly
// spaced ranks. Such a column also stands the better the more the weak ones above it push, so that a slope may stand at
// one strength and fail at a greater one. F is found from the weak side: strengths above the first at which all
// surfaces stand are not tried. A wedge that is lifted off its riser drags by less than m (slide_head.hpp). The factor
// of safety of that surface alone is at most F; taken for F, the search is repeated until no surface fails. It ends
// because surfaces are finite in number and each F is less than the one before.
//
// A surface counts as a failure where every column between toe and crack moves: a column that needs no push cuts off
// what stands above it. The mass has to be one whole block wide at least behind the crest, and in front of each riser
// of a sliding mass: joints leave whole blocks, and the thesis counts what fails in whole columns of joint set A
// (2.3.4). Without such a rule the least stable surface is a sliver of the face.
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

// A surface through a lattice. Sliding: `level` is that of the step that ends at each riser from `first` on. Columns:
// that of each column from `first` (counted from 1) on; `wedge` is the place of the wedge behind the last one.
struct LatticePath {
    std::size_t first = 0;
    std::vector<std::size_t> level = {};
    std::optional<std::size_t> wedge = {};
};

struct CriticalPath {
    LimitState limit = LimitState::holds_at_any_strength;
    double factor_of_safety = 0;  // 0 where it fails at any strength, infinite where it holds at any
    LatticePath path = {};        // empty where nothing drives
    int searches = 0;             // of the whole lattice
};

CriticalPath least_stable_path(const SteppedPath& problem, const PathLattice& lattice);

// The same for one surface alone.
Limit factor_of_safety(const SteppedPath& problem, const PathLattice& lattice, const LatticePath& path);

// How each column of a surface moves at the strength divided by `factor`, from the toe up, and the push on it from
// above; `moves` where every one does.
struct MovingColumn {
    ColumnMode mode = ColumnMode::stays;
    double push = 0;
    double depth = 0;  // of the contact above, under the ground, along the joint
};
std::vector<MovingColumn> moving_columns(const SteppedPath& problem, const PathLattice& lattice,
                                         const LatticePath& path, double factor);

// The surface of least factor of safety among those that slide on steps.
CriticalPath least_stable_sliding(const SteppedPath& problem, const PathLattice& lattice);

// The same for one surface alone.
Limit sliding_limit(const SteppedPath& problem, const PathLattice& lattice, const LatticePath& path);

}  // namespace delabole
