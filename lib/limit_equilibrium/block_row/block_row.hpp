// A row of blocks on an inclined plane: all modes of sliding and toppling, those that can happen and their tilts, and
// the governing one. Equations and checks: block_row_mode.hpp; choice of the mode: block_row_search.hpp; the thesis's
// formulas for equal blocks: closed_forms.hpp.
//
// Some rows of unequal blocks begin to move in ways that are not among the modes (block_row_search.hpp). If no mode is
// admissible, the bound by linear programming (lp_bound.hpp) is used for the tilts: beyond it no forces keep the row in
// equilibrium. It equals the limit in contact if there is one; a row that is not pressed together may fail at a smaller
// tilt, though not before a block that stands alone would.
//
// Limits: rectangular blocks, dry, no cohesion, statics only; the answer is the tilt at which a motion can begin. There
// are no bolts: every term of the modes' equations is a weight and so linear in the sine and cosine of the tilt, which
// gives its tangent in closed form; a bolt's force does not turn with the tilt. For bolts and a factor of safety see
// stepped_base.
#pragma once

#include "limit_equilibrium/block_row/block_row_mode.hpp"
#include "limit_equilibrium/block_row/block_row_parameters.hpp"
#include "parameters/model_interface.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace delabole {

enum class BlockRowCheck {
    valid,
    no_blocks,
    too_many_blocks,     // more than 100 000
    no_admissible_mode,  // every mode examined violates statics or kinematics, and there is no bound either: more than
                         // most_bounded_row blocks, or the linear programme has no answer
    input_out_of_range,  // a number outside the range of its field, or not finite
};

enum class RowState {
    stands,
    stands_if_pressed,  // between both critical tilts: stands only if the blocks are pressed together. If the tilts are
                        // bounds: from the tilt at which a block that stands alone would fail, up to the bound
    slides,
    topples,
    slides_and_topples,
};

enum class RowSearchKind { exact, bounded, upper_bound };

struct RowAnswer {
    RowState state{};
    RowSearchKind search{};
    std::string mode{};
    double critical_tilt{};
    std::string mode_in_contact{};
    double critical_tilt_in_contact{};
    static constexpr auto fields() {
        using A = RowAnswer;
        return FieldTable{
            section<&A::state>("at the given inclination"),
            section<&A::search>(
                "exact: every mode was examined; bounded: a long row's likely ones; upper_bound: none of those is "
                "admissible, and both tilts are the one beyond which linear programming finds no equilibrium"),
            section<&A::mode>("least stable mode, one letter per block from the lowest up: S slides; F, P, B turns "
                              "with its toe sliding forward, not at all, backward; = adheres to the block below; 0 "
                              "stands; R is pushed back; empty: none is admissible"),
            number<&A::critical_tilt>(Dimension::angle, "inclination at which the governing mode begins"),
            section<&A::mode_in_contact>("limiting mode of blocks pressed together; empty: none is admissible"),
            number<&A::critical_tilt_in_contact>(
                Dimension::angle,
                "inclination at which that mode begins: limit of blocks pressed together; 90 deg: none")};
    }
};

struct RowModeSummary {
    std::string roles;
    RowModeCheck admissibility;
    double critical_tilt;
    double second_critical_tilt;
    static constexpr auto fields() {
        using M = RowModeSummary;
        return FieldTable{
            section<&M::roles>("one letter per block, see mode"), section<&M::admissibility>("admissible, or why not"),
            number<&M::critical_tilt>(Dimension::angle, "inclination at which moments balance; 90 deg: none"),
            number<&M::second_critical_tilt>(
                Dimension::angle,
                "over-determined modes: inclination at which thrusts from both sides agree; else 90 deg")};
    }
};

// Forces on a block in the governing mode at its critical tilt. Forces between standing blocks are not determined:
// these blocks have the forces of blocks that stand alone.
struct RowBlockForces {
    double thrust;         // on the block from the one above, along the plane; 0 for the uppermost
    double thrust_height;  // above the base; 0 without thrust
    double shear;          // in the same interface, positive down on this block
    double normal_force;   // of the plane
    double base_shear;     // of the plane, positive up-dip
    double base_position;  // distance of the normal force from the toe
    static constexpr auto fields() {
        using F = RowBlockForces;
        using D = Dimension;
        return FieldTable{
            number<&F::thrust>(D::force_per_length, "force from the block above"),
            number<&F::thrust_height>(D::length, "where it acts, above the base"),
            number<&F::shear>(D::force_per_length, "shear in that interface, positive down on this block"),
            number<&F::normal_force>(D::force_per_length, "base reaction"),
            number<&F::base_shear>(D::force_per_length, "shear on the base, positive up-dip on the block"),
            number<&F::base_position>(D::length, "where the base reaction acts, from the toe")};
    }
};

struct BlockRowResult {
    BlockRowCheck check = BlockRowCheck::input_out_of_range;
    RowAnswer answer{};                   // valid only if `check` is valid
    std::vector<RowModeSummary> mode{};   // filled also if no mode is admissible
    std::vector<RowBlockForces> block{};  // in the governing mode; empty if there is none
    static constexpr auto fields() {
        using R = BlockRowResult;
        return FieldTable{inlined(&R::answer, "what governs"), section<&R::mode>("the modes examined"),
                          section<&R::block>("forces in the governing mode")};
    }
};

// The linear programme of this many blocks takes a second.
inline constexpr std::size_t most_bounded_row = 500;

// Exact up to 16 blocks; for longer rows a restricted search of linear time (block_row_search.hpp).
BlockRowResult analyse(const BlockRow& row);

// Inputs: every number of the row. Outputs: the numbers of RowAnswer.
ModelInterface model_interface(const BlockRow& row);

// The blocks in the form that the solver needs: tangents, contacts, weights.
inline std::vector<RowMember<double>> row_members(const BlockRow& row) {
    std::vector<RowMember<double>> members;
    members.reserve(row.block.size());
    const double base = std::tan(row.base.friction_angle);
    const double interface = std::tan(row.interface.friction_angle);
    for (std::size_t index = 0; index < row.block.size(); ++index) {
        const RowBlock& block = row.block[index];
        RowMember<double> member{};
        member.height = block.height;
        member.width = block.width;
        const auto* weight = std::get_if<WeightOfBlock>(&block.mass);
        member.weight = weight != nullptr
                            ? weight->weight
                            : std::get<UnitWeightOfBlock>(block.mass).unit_weight * block.height * block.width;
        member.base_friction = block.base_friction_angle ? std::tan(*block.base_friction_angle) : base;
        member.interface_friction =
            block.interface_friction_angle ? std::tan(*block.interface_friction_angle) : interface;
        if (index + 1 < row.block.size()) {
            member.contact = std::min(block.height, row.block[index + 1].height);
        } else {
            member.interface_friction = 0;
        }
        members.push_back(member);
    }
    return members;
}

}  // namespace delabole
