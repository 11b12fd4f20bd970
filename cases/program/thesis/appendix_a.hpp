// The columns of Appendix A and 5.3.4.2, typed once: cases/stepped_base/appendix_a.toml.
#pragma once

#include "limit_equilibrium/stepped_base/stepped_base.hpp"

namespace delabole {

// The columns of Appendix A with one friction angle on joints and bases.
SteppedBase<> appendix_a(double friction_angle);

// Heights, width and steps in metres; a metre there is an inch of the blocks of chapter 5.
BlockColumns<> appendix_a_columns();

}  // namespace delabole
