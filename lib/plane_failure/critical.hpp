// The least stable crack position and plane dip of a slope.
#pragma once

#include "plane_failure/check.hpp"
#include "plane_failure/study.hpp"

namespace delabole {

struct CriticalGeometry {
    PlaneFailureCheck check;  // valid if a minimum was found; otherwise the reason why the search could not begin
    PlaneFailure<> problem;   // the input with the critical dip and crack position in place
    double factor_of_safety;  // under the condition of the search
    bool at_boundary;         // the minimum lies at an end of the searched range, which limits it
    int evaluations;
};

// Crack positions range from the daylighting point to where the plane meets the ground (or, if it does not, to 20 slope
// heights behind the crest), at the crack's given dip; plane dips range from lower_dip to upper_dip, by default from 1
// deg to the face. If the problem has no crack, the search adds none: only the plane is searched. If a closed form
// gives the crack (a dry slope with level ground behind its crest, see critical.cpp), it is used. Otherwise both sides
// of every position at which the factor of safety has a kink or a jump are evaluated (corners of the ground, line
// loads, ends of surcharges, heads of bolts, the pond's level, points of a piezometric line), with a scan of 12 points
// between any two of them, followed by the root of the exact derivative: positions and factors of safety are accurate
// to rounding, if the scan separates the minima. Beside a jump the crack is placed 1e-12 of the range away from it.
// If no tensile strength is given, the search lets the strength law bear tension. Water that fills a crack near the
// face lifts the sliver in front of it, and the search would find no other crack. The geometry found is then analysed
// without tensile strength.
CriticalGeometry find_critical_geometry(const PlaneFailure<>& problem, const CriticalSearch<>& request);

}  // namespace delabole
