// Limit equilibrium that predicts its own failure surface: the stepped surface along joint sets, and the crack, that
// fail first. The model "stepped_path".
//
// Case: stepped_path_parameters.hpp. Search, equations and the definition of a failure: path_search.hpp.
//
// The motion follows from the mechanism at its limit, which has one degree of freedom: columns rotate about their toe
// corners or slide on their bases, touch where they push each other, and a wedge slides on its riser. With the greatest
// displacement at the ground set to 1, each joint that daylights behind the crest opens and slips by the difference of
// displacements across it. These are first displacements; later motion requires dynamic relaxation.
//
// Limits: rigid parts, surfaces within the three sets, water at rest, no loads but weight and water. A wedge does not
// rotate; nor does a sliding mass, whose moments are not checked. Surfaces combine steps with risers that open: what
// slides on a single riser has a factor of its own, and no surface slides on steps and risers. So have columns at the
// toe that fail before what is behind them. The least factor of safety is exact on the lattice (path_search.hpp); finer
// steps lower it, by amounts measured in stepped_path_test.cpp of the tests.
#pragma once

#include "limit_equilibrium/stepped_path/path_search.hpp"
#include "parameters/model_interface.hpp"

#include <vector>

namespace delabole {

// Whether the least stable surface is as small or as large as the search allows.
enum class PathExtent { within, least, greatest };

struct SteppedPathResult {
    SteppedPathCheck check = SteppedPathCheck::no_path;
    LimitState limit = LimitState::fails_at_any_strength;
    double factor_of_safety = 0;
    PathExtent extent = PathExtent::within;
    double factor_on_riser = 0;
    double factor_of_toe = 0;
    double toe_fails_before = 0;
    double failed_area = 0;
    double retreat = 0;
    double foot_height = 0;
    double knee_distance = 0;
    double knee_height = 0;
    double lower_angle = 0;
    double upper_angle = 0;
    double upper_height = 0;
    double lower_steps = 0;
    double lower_roughness = 0;
    double column_count = 0;
    double toppling_count = 0;
    double toppling_share = 0;
    double sliding_share = 0;
    double slide_head_share = 0;
    double toppling_work_share = 0;
    double sliding_work_share = 0;
    double slide_head_work_share = 0;
    double crest_cracks = 0;
    double crest_opening = 0;
    double crest_sinking = 0;
    double crest_turning = 0;
    double searches = 0;

    // These members have no output names: they serve figures and the profile.
    struct Part {
        Polyline outline;
        ColumnMode mode;
        bool wedge;
    };
    Polyline surface = {};         // from where it daylights at the toe to where it daylights behind the crest
    std::vector<Part> parts = {};  // moving parts, from the toe up

    static constexpr auto fields() {
        using R = SteppedPathResult;
        return FieldTable{
            section<&R::limit>("whether limiting equilibrium exists at any strength; abrupt: past the factor of safety "
                               "the mass fails, but its toe is not in equilibrium there"),
            number<&R::factor_of_safety>("factor on all strength for limiting equilibrium, of the surface for which it "
                                         "is least; what slides on a single riser and columns at the toe alone have "
                                         "their own, factor_on_riser and factor_of_toe, and may fail before"),
            number<&R::factor_on_riser>("factor of safety of what slides on a single riser from the face to the ground "
                                        "behind the crest, a mechanism of its own; infinite if none comes out so, or "
                                        "if the mechanism has no risers"),
            number<&R::factor_of_toe>("factor of safety of columns at the toe or in the face that move by themselves, "
                                      "at least one column wide, without a surface that comes out far enough behind "
                                      "the crest; infinite if none do, or if the mechanism has no columns"),
            number<&R::toe_fails_before>(
                "1 if the limit is abrupt: at the factor of safety the toe has failed before, so "
                "that the slope's own factor is at most that; else 0"),
            section<&R::extent>("whether the surface is the smallest or the largest that may fail: then it is the "
                                "limit of its size that decides, not strength"),
            number<&R::failed_area>(Dimension::area, "area in section of what fails"),
            number<&R::retreat>(Dimension::length,
                                "horizontal distance behind the crest at which the surface comes out"),
            number<&R::foot_height>(Dimension::length, "height above the toe at which the surface daylights"),
            number<&R::knee_distance>(Dimension::length,
                                      "horizontal distance from the toe to where the upper surface begins"),
            number<&R::knee_height>(Dimension::length, "height of that point"),
            number<&R::lower_angle>(Dimension::angle, "inclination of the line from the foot to that point"),
            number<&R::upper_angle>(
                Dimension::angle,
                "inclination of the upper surface, one joint from there to the ground; above 90 deg it overhangs"),
            number<&R::upper_height>(Dimension::length, "height of the upper surface"),
            number<&R::lower_steps>("risers in the lower surface"),
            number<&R::lower_roughness>(Dimension::length,
                                        "root mean square distance of the lower surface from its line"),
            number<&R::column_count>("columns that move"),
            number<&R::toppling_count>("columns that turn"),
            number<&R::toppling_share>("share of the moving area that turns"),
            number<&R::sliding_share>("share of the moving area that slides on steps"),
            number<&R::slide_head_share>("share of the moving area in the wedge"),
            number<&R::toppling_work_share>("share of the work that weight does at the first displacements on columns "
                                            "that turn; parts that rise count for nothing"),
            number<&R::sliding_work_share>("likewise, on what slides on steps"),
            number<&R::slide_head_work_share>("likewise, on the wedge; all three are 0 if every part rises"),
            number<&R::crest_cracks>("joints behind the crest that open or slip at the ground by a twentieth of the "
                                     "greatest displacement or more"),
            number<&R::crest_opening>("greatest opening there, over the greatest displacement"),
            number<&R::crest_sinking>("displacement downwards of the uppermost part at its outcrop, over the greatest "
                                      "displacement; negative: it rises"),
            number<&R::crest_turning>("rotation of the uppermost part times its height, over the greatest "
                                      "displacement; positive: backwards, into the slope"),
            number<&R::searches>("searches of all surfaces")};
    }
};

// If `check` is not valid the rest is unspecified. Time: proportional to columns or risers times levels, some ten
// microseconds for a hundred crossings.
SteppedPathResult analyse(const SteppedPath& problem);

// Ground left standing: the surface, from the toe on, and the ground behind it. Empty if there is no surface.
Polyline profile_after_failure(const SteppedPath& problem, const SteppedPathResult& result);

// Vertices of the water surface, from the toe into the slope; the last two define its continuation. Empty if the slope
// is dry or the case is not valid.
Polyline water_surface(const SteppedPath& problem);

// Inputs: every number of the case. Outputs: every number of SteppedPathResult. A slope that fails or holds at any
// strength is a failed prediction, under the name of that state. Where the limit is abrupt the factor of safety is
// known as a bound alone.
ModelInterface model_interface(const SteppedPath& problem);

}  // namespace delabole
