// The least stable crack position and plane dip of a slope.
#pragma once

#include "plane_failure/check.hpp"
#include "plane_failure/study.hpp"

namespace delabole {

struct CriticalGeometry {
    PlaneFailureCheck check;  // valid where a minimum was found; otherwise the reason at the start of the search
    PlaneFailure<> problem;   // the input with the critical dip and crack position in place
    double factor_of_safety;  // under the condition of the search
    bool at_boundary;         // the minimum lies at an end of the searched range: a limit, not a balance
    int evaluations;
};

// Crack positions from the daylighting point to where the plane meets the ground (or to 20 slope heights behind the
// crest, where it does not), at the crack's given dip; plane dips from lower_dip to upper_dip, by default from 1 deg to
// the face. Searching for the crack of a problem without one adds none: the problem is returned with the plane searched
// only. Where a closed form gives the crack (critical.cpp says when: a dry slope level behind its crest) it is used;
// elsewhere both sides of every position at which the factor of safety has a kink or a jump (corners of the ground,
// line loads, ends of surcharges, the pond's level, points of a piezometric line), a scan of 12 points between any two
// of them, then the root of the exact slope: positions and factors of safety to rounding, if the scan separates the
// minima. Beside a jump the crack is placed 1e-12 of the range away from it.
CriticalGeometry find_critical_geometry(const PlaneFailure<>& problem, const CriticalSearch<>& request);

}  // namespace delabole
