// A slope cut by the joint sets of a kinematic study, as the text of a case.
#pragma once

#include "kinematics/kinematics.hpp"

#include <string>

namespace delabole {

// The starting case of a jointed slope with the face of the study, its friction, and a cut for each of its sets by the
// apparent dip of its mean in the section across the face. Sets that strike within 30 deg of that section cross it in
// no line that could be drawn: they are named in a comment. Orientations do not tell spacings, so each cut has one to
// be replaced. Its title tells that of the study. The result's check is valid. Throws std::invalid_argument if no set
// is left.
std::string jointed_slope_of(const KinematicsStudy& study, const std::string& title, const KinematicsResult& result);

}  // namespace delabole
