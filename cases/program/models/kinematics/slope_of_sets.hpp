// A slope cut by the joint sets of a kinematic study, as the text of a case.
#pragma once

#include "kinematics/kinematics.hpp"

#include <string>

namespace delabole {

// Returns the starting case of a jointed slope with the face of the study, its friction, and a cut for each of its sets
// at the apparent dip of its mean in the section across the face. Sets that strike within 30 deg of the section are
// only named in a comment, since they could not be drawn as lines. Spacings do not follow from orientations: each cut
// has one to be replaced. The title includes that of the study. The result's check must be valid. Throws
// std::invalid_argument if no set is left.
std::string jointed_slope_of(const KinematicsStudy& study, const std::string& title, const KinematicsResult& result);

}  // namespace delabole
