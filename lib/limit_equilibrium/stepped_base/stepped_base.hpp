// Toppling and sliding of columns on a stepped base: the model "stepped_base".
//
// Column geometry, water and loads: make_columns.hpp. Forces between columns: column_recursion.hpp. The wedge above
// them: slide_head.hpp.
#pragma once

#include "limit_equilibrium/columns/column_recursion.hpp"
#include "limit_equilibrium/columns/make_columns.hpp"
#include "parameters/lengths.hpp"
#include "parameters/model_interface.hpp"

#include <vector>

namespace delabole {

template <class T = double>
struct JointStrength {
    T friction_angle;
    static constexpr auto fields() {
        return FieldTable{number<&JointStrength::friction_angle>(Dimension::angle, within(0, degrees(89.9)),
                                                                 "friction angle of the joints between columns")};
    }
};

template <class T = double>
struct BaseStrength {
    T friction_angle;
    T cohesion;
    static constexpr auto fields() {
        return FieldTable{number<&BaseStrength::friction_angle>(Dimension::angle, within(0, degrees(89.9)),
                                                                "friction angle of the bases of the columns"),
                          number<&BaseStrength::cohesion>(Dimension::stress, at_least(0),
                                                          "cohesion of the bases, where a column slides on its base")};
    }
};

template <class T = double>
struct SteppedBase {
    ColumnScene<T> scene;
    JointStrength<T> joints;
    BaseStrength<T> bases;
    static constexpr std::string_view kind = "stepped_base";
    static constexpr auto fields() {
        return FieldTable{inlined(&SteppedBase::scene, "slope, columns, water and loads"),
                          section<&SteppedBase::joints>("strength of the joints between columns"),
                          section<&SteppedBase::bases>("strength of the bases")};
    }
};

// Whether a strength exists at which the toe column just begins to move. `abrupt`: the slope stands down to a strength
// and fails below it, but the toe column then still has a reserve and is not in limiting equilibrium. Either the
// tangents of the friction angles of joints and bases multiply to nearly 1 or more, and a column above begins to slide
// that no push can hold; or a column topples that has no neighbour to lean on.
enum class LimitState { found, holds_at_any_strength, fails_at_any_strength, abrupt };

// `value` is 0 if the slope fails at any strength and infinite if it holds at any; for `abrupt` it is the last strength
// at which the slope stands.
struct Limit {
    LimitState state = LimitState::fails_at_any_strength;
    double value = 0;
    int evaluations = 0;
};

ColumnStrength<> strength_of(const SteppedBase<>& problem);

// Force of the wedge above on the last column, with all strength divided by a factor; zero without a wedge.
JointForce<> head_force(const ColumnSlope<>& slope, const ColumnStrength<>& strength, double factor);

// Factor by which all friction (as tangents) and cohesion, including those of the wedge above, have to be divided for
// limiting equilibrium. The search goes outwards from the given strength to the nearest change from standing to
// failing, which is accurate to a few units in the last place of the factor as far as the margin resolves it. 15 to 60
// evaluations of the recursion.
//
// As strength is reduced, the margin changes sign once, except if the tangents of the joints' and the bases' friction
// at the limit have a product near 1. There the forces have a pole, a slope may stand and fail several times within a
// few per cent of strength, and the search may miss a narrow range. Measured: 4 in 1000 random wet slopes, none with a
// product under 0.7 at the limit. The limit is `abrupt` if the reserve of the toe column at it exceeds a millionth of
// the forces on it; this also happens if the force falls from many weights to zero within the rounding of the strength.
Limit factor_of_safety(const ColumnSlope<>& slope, const ColumnStrength<>& strength);

// The common friction angle (rad) of joints, bases and wedge for limiting equilibrium, with cohesion as given; the
// thesis's "mu required". 90 deg if the slope fails at any friction, 0 if it holds without friction.
Limit limiting_friction_angle(const ColumnSlope<>& slope, double base_cohesion);

// Force normal to the joints on the toe column, at the height of its middle line, that keeps it in limiting equilibrium
// with the given strength; negative if the column could be pulled. Infinite if no force holds it.
double toe_force(const ColumnSlope<>& slope, const ColumnStrength<>& strength, double factor = 1);

// A cable whose force is sought: from the toe side of a column to an anchor behind the columns.
template <class T = double>
struct RequiredCable {
    T block;
    T plunge;
    T height;
    T factor_of_safety;
    static constexpr auto fields() {
        return FieldTable{number<&RequiredCable::block>(at_least(1), "number of the column, 1 at the toe"),
                          number<&RequiredCable::plunge>(
                              Dimension::angle, within(degrees(-90), degrees(90)),
                              "direction below the horizontal, into the slope; negative: inclined upwards"),
                          number<&RequiredCable::height>(Dimension::length, distance_range(),
                                                         "height of its head above the base of that column"),
                          number<&RequiredCable::factor_of_safety>(more_than(0), "factor of safety to reach")};
    }
};

enum class CableState { found, not_needed, cannot_hold, no_such_place };

struct CableForce {
    CableState state;
    double force;  // N/m; 0 unless found
};

// Least tension for the required factor of safety. For column 1 it is in closed form (Goodman & Bray 1976), the larger
// of the tensions that prevent toppling and sliding; for others it is a bracketed root, as the margin decreases with
// the force.
CableForce required_cable(const SteppedBase<>& problem, const RequiredCable<>& cable);

// One column in limiting equilibrium at the given strength.
struct ColumnResult {
    int number;  // 1 at the toe
    ColumnMode mode;
    double width, height, weight;
    double upper_force, upper_force_height;  // P_n, above the column's own base
    double lower_force, lower_force_height;  // P_(n-1)
    double against_toppling, against_sliding;
    double normal_reaction;     // R, effective
    double shear_reaction;      // S, up-dip
    double friction_ratio;      // S / R; infinite if there is no normal force on the base
    double reaction_position;   // of R, share of the width from the toe corner; 0 for a toppling column
    bool reaction_inside_base;  // no: the column would rotate as well, which the recursion does not include
    bool base_friction_holds;   // S within the base's strength in either direction, and R not tensile

    static constexpr auto fields() {
        using C = ColumnResult;
        using D = Dimension;
        using delabole::number;  // names the function, not the member
        return FieldTable{section<&C::mode>("what it does with the strength as given"),
                          number<&C::width>(D::length, "width of its base"),
                          number<&C::height>(D::length, "height of its middle line"),
                          number<&C::weight>(D::force_per_length, "weight"),
                          number<&C::upper_force>(D::force_per_length, "normal force of the column above"),
                          number<&C::upper_force_height>(D::length, "height above the base at which that acts"),
                          number<&C::lower_force>(D::force_per_length, "normal force needed from the column below"),
                          number<&C::lower_force_height>(D::length, "height above the base at which that acts"),
                          number<&C::against_toppling>(D::force_per_length, "force from below that prevents toppling"),
                          number<&C::against_sliding>(D::force_per_length, "force from below that prevents sliding"),
                          number<&C::normal_reaction>(D::force_per_length, "effective normal force of the base"),
                          number<&C::shear_reaction>(D::force_per_length, "shear force of the base, up-dip"),
                          number<&C::friction_ratio>("shear force of the base over normal force"),
                          number<&C::reaction_position>("share of the width, from the toe corner, where they act")};
    }
};

// From the toe up, at the strength divided by a factor. If no push holds a column, the push on the toe column is
// infinite, and its ratio and position are those of the push alone; the columns between them are not evaluated: 0,
// stays.
std::vector<ColumnResult> column_results(const ColumnSlope<>& slope, const ColumnStrength<>& strength,
                                         double factor = 1);

struct SteppedBaseResult {
    ColumnCheck check = ColumnCheck::no_columns;
    LimitState limit = LimitState::fails_at_any_strength;
    double factor_of_safety = 0;
    LimitState friction_limit = LimitState::fails_at_any_strength;
    double limiting_friction_angle = 0;
    double toe_force = 0;
    double weight = 0;
    double column_count = 0;
    double toppling_count = 0;
    double sliding_count = 0;
    double uppermost_moving = 0;
    double moving_count = 0;
    double moving_area = 0;
    double inadmissible_count = 0;
    double crack_base_distance = 0;
    double crack_base_height = 0;
    double base_inclination = 0;
    double base_end_height = 0;
    SlideHeadState slide_head = SlideHeadState::stands;  // without a wedge this and the numbers below have no meaning
    double slide_head_thrust = 0;
    double slide_head_factor_of_safety = 0;
    double toppling_share = 0;
    double sliding_share = 0;
    double slide_head_share = 0;
    double crest_cracks = 0;

    static constexpr auto fields() {
        using Result = SteppedBaseResult;
        return FieldTable{
            section<&Result::limit>(
                "whether limiting equilibrium exists at any strength; abrupt: the slope stands down to the factor of "
                "safety and fails past it, but nothing is in equilibrium there"),
            number<&Result::factor_of_safety>("factor on all friction and cohesion for limiting equilibrium"),
            section<&Result::friction_limit>("the same for one friction angle of joints and bases"),
            number<&Result::limiting_friction_angle>(Dimension::angle,
                                                     "friction angle of joints and bases for limiting equilibrium"),
            number<&Result::toe_force>(
                Dimension::force_per_length,
                "push normal to the joints on the toe column for limiting equilibrium, as another column gives it, "
                "with the friction of a joint; a cable takes another force; negative: none is needed"),
            number<&Result::weight>(Dimension::force_per_length, "weight of the columns"),
            number<&Result::column_count>("columns"),
            number<&Result::toppling_count>("columns that topple in limiting equilibrium"),
            number<&Result::sliding_count>("columns that slide in limiting equilibrium"),
            number<&Result::uppermost_moving>(
                "number of the uppermost column that moves in limiting equilibrium, counted from the toe"),
            number<&Result::moving_count>("columns that topple or slide in limiting equilibrium"),
            number<&Result::moving_area>(Dimension::area,
                                         "area in section of these columns and of the wedge, where it pushes"),
            number<&Result::inadmissible_count>("columns whose base cannot give the reaction that limiting equilibrium "
                                                "asks of it: tension, friction exceeded, or outside the base"),
            number<&Result::crack_base_distance>(
                Dimension::length,
                "horizontal distance from the toe to the upper end of the base of the moving columns"),
            number<&Result::crack_base_height>(Dimension::length,
                                               "height above the toe of that end, where the crack behind them opens"),
            number<&Result::base_inclination>(Dimension::angle, "inclination of the line through the toe corners"),
            number<&Result::base_end_height>(Dimension::length, "height above the toe at which the stepped base ends"),
            section<&Result::slide_head>("what the wedge above the columns does"),
            number<&Result::slide_head_thrust>(Dimension::force_per_length, "force of the wedge on the last column"),
            number<&Result::slide_head_factor_of_safety>(
                "factor of safety of the wedge by itself; 0 where there is none"),
            number<&Result::toppling_share>(
                "share of the weight that moves in limiting equilibrium which is that of toppling columns"),
            number<&Result::sliding_share>("the same of sliding columns"),
            number<&Result::slide_head_share>("the same of the wedge"),
            number<&Result::crest_cracks>("joints that come out behind the crest and on whose sides the rock moves "
                                          "differently in limiting equilibrium; 0 where the ground is not given")};
    }
};

// If `check` is not valid the rest is unspecified.
SteppedBaseResult analyse(const SteppedBase<>& problem);

}  // namespace delabole
