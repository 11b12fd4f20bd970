// Brings blocks that are far out of balance nearer to it one by one, while all others stay.
//
// Where contacts of a few blocks close or open, Newton's method for all blocks together overshoots, and its line search
// shortens the step for all. Solving for these few first is nonlinear elimination (Lanzkron, Rose and Wilkes 1996, SIAM
// J. Sci. Comput. 17, 538-559; Cai and Li 2011, SIAM J. Sci. Comput. 33, 746-762). The equations are the same; only the
// order in which they are solved differs.
#pragma once

#include "dynamic_relaxation/statics/static_equations.hpp"

namespace delabole {

// Only for blocks without bonds: where rock breaks, it leads to other equilibria (RJ-8 stands with strengths divided by
// 1.13 instead of 1.01).
//
// The function sweeps over the free blocks in their order, so that the result is the same on any machine: first over
// the blocks that are far out of balance, then over those affected around them. `lacking`: unbalanced forces including
// pseudo-viscosity. `moved` and `motion` are updated; contacts must be evaluated again afterwards.
void balance_one_by_one(const PseudoViscosity& resisting, const Eigen::VectorXd& lacking, const MemoryArray& before,
                        StaticEquations& equations, Eigen::VectorXd& moved, std::vector<Motion>& motion,
                        ContactList& list);

}  // namespace delabole
