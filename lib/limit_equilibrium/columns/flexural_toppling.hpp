// Flexural toppling: columns that grow out of intact rock, bend out of the slope and break at their feet (Aydan &
// Kawamoto 1992; Adhikary et al. 1997), column by column from the uppermost down.
//
// Axes along the plane of the feet, which dips out of the slope by `base_dip`: u up-dip, v normal to it, the columns'
// own direction. A column of width t and height h weighs W = gamma t h. P_r is the push of the column above at height
// y_r over the feet, P_l what the column below holds at y_l. Bending columns slip past each other: the right face of
// each moves up along the left face of the next one, so that friction m = tan(phi) at full strength pulls the right
// face down and the left face up. About the middle of the foot, and along the column,
//   M = W h sin(d) / 2 + P_r (y_r - m t / 2) - P_l (y_l + m t / 2),     N = W cos(d) + m P_r - m P_l.
// The foot cracks where its outer fibre reaches the tensile strength s, 6 M / t^2 - N / t = s, which needs
//   P_l (y_l + m t / 3) = W (h sin(d) / 2 - t cos(d) / 6) + P_r (y_r - 2 m t / 3) - s t^2 / 6.          (bending)
// A cracked column still stands as a block until it turns about its lower edge, M = N t / 2, which gives Goodman &
// Bray's toppling:
//   P_l y_l = W (h sin(d) - t cos(d)) / 2 + P_r (y_r - m t).                                              (toppling)
// A column fails only beyond both limits, so the smaller of these two pushes is needed; without tensile strength it is
// the second, and the model is Goodman & Bray's.
//   Friction does not pull a foot out of the rock: it holds the left face up by T_l <= m P_l, and by no more than
// leaves N = 0 under a block, and N = -s t under a foot that has not cracked. About the lower edge the left face's
// friction has no moment: (toppling) holds with any T_l. In all equations T_r, which the column above passes on, takes
// the place of m P_r.
// Where (bending) would need N < -s t, the foot is torn evenly, M = 0, under
//   P_l y_l = W (h sin(d) - t cos(d)) / 2 + P_r y_r - T_r t - s t^2 / 2,     T_l = W cos(d) + T_r + s t.
// (With full friction tall columns above short ones stood by the tension of feet without tensile strength.)
//   In addition the column must not shear off its foot of cohesion c and friction mb, which needs
//   P_l (1 - m mb) = P_r - mb T_r + W (sin(d) - mb cos(d)) - c t,                                         (shearing)
// or, where that would need N < -s t or m mb >= 1,
//   P_l = P_r + W sin(d) - c t + mb s t.
// The greatest of the push for shearing, the smaller push above and zero acts on the next column. The slope fails if
// the toe column needs a push. Printed forms in the literature take h y_r and y_l as shares of the height, as here, and
// have the bending case alone.
//
// Limits: the feet lie in one plane, columns do not break above them, the rock does not crush; water and steps are not
// modelled.
// Aydan, O. & Kawamoto, T. (1992) The stability of slopes and underground openings against flexural toppling and their
// stabilisation. Rock Mech. Rock Eng. 25, 143-165. Adhikary, D.P. et al. (1997) A study of the mechanism of flexural
// toppling failure of rock slopes. Rock Mech. Rock Eng. 30, 75-93.
#pragma once

#include "parameters/lengths.hpp"
#include "parameters/model_interface.hpp"

#include <string_view>
#include <vector>

namespace delabole {

struct FlexuralColumn {
    double width;
    double height;
    static constexpr auto fields() {
        using C = FlexuralColumn;
        return FieldTable{number<&C::width>(Dimension::length, extent_range(), "along the plane of the feet"),
                          number<&C::height>(Dimension::length, extent_range(), "normal to that plane")};
    }
};

struct FlexuralSlope {
    double base_dip;
    double unit_weight;
    double joint_friction_angle;
    double tensile_strength;
    double cohesion;
    double friction_angle;
    double contact_height;
    std::vector<FlexuralColumn> column;

    static constexpr std::string_view kind = "flexural_toppling";
    static constexpr auto fields() {
        using S = FlexuralSlope;
        return FieldTable{
            number<&S::base_dip>(Dimension::angle, right_open(0, degrees(90)),
                                 "of the plane of the feet, out of the slope"),
            number<&S::unit_weight>(Dimension::unit_weight, more_than(0), "of the rock"),
            number<&S::joint_friction_angle>(Dimension::angle, right_open(0, degrees(90)), "between columns"),
            number<&S::tensile_strength>(Dimension::stress, at_least(0), "of the rock"),
            number<&S::cohesion>(Dimension::stress, at_least(0), "of the rock at the feet"),
            number<&S::friction_angle>(Dimension::angle, right_open(0, degrees(90)), "of the rock at the feet"),
            number<&S::contact_height>(left_open(0, 1),
                                       "of the force between two columns, over the height they share: 1 at the top, "
                                       "about 0.6 to 0.8 before cracking"),
            section<&S::column>("columns from the toe up")};
    }
};

enum class FlexuralCheck { valid, no_columns, input_out_of_range };

enum class FlexuralMode { stands, bends, topples, shears };

struct FlexuralColumnState {
    FlexuralMode mode = FlexuralMode::stands;
    double push = 0;    // N/m, required from the column below
    double moment = 0;  // N, at its foot, under that push
    double normal = 0;  // N/m, compression at its foot, under that push
    static constexpr auto fields() {
        using C = FlexuralColumnState;
        return FieldTable{
            section<&C::mode>("how it fails unless it is pushed"),
            number<&C::push>(Dimension::force_per_length, "that it needs from the column below"),
            number<&C::normal>(Dimension::force_per_length, "compression at its foot, where it gets that push")};
    }
};

struct FlexuralStability {
    FlexuralCheck check = FlexuralCheck::no_columns;
    double toe_push = 0;  // N/m, that the toe column needs; 0: the slope stands
    // Least tensile strength with which the slope stands, all else as given; infinite if the columns shear off their
    // feet.
    double required_tensile_strength = 0;
    double factor_of_safety = 0;  // tensile strength over the required one; infinite if none is required
    std::vector<FlexuralColumnState> column = {};
    static constexpr auto fields() {
        using S = FlexuralStability;
        return FieldTable{
            number<&S::toe_push>(Dimension::force_per_length, "that the toe column would need; 0: the slope stands"),
            number<&S::required_tensile_strength>(
                Dimension::stress, "least with which the slope stands; infinite: it is sheared off its feet"),
            number<&S::factor_of_safety>("tensile strength over the required one; infinite: none is required"),
            section<&S::column>("the columns from the toe up")};
    }
};

// Inputs: every number of the slope. Outputs: every number of FlexuralStability.
ModelInterface model_interface(const FlexuralSlope& slope);

FlexuralStability analyse(const FlexuralSlope& slope);

}  // namespace delabole
