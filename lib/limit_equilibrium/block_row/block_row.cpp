#include "limit_equilibrium/block_row/block_row.hpp"

#include "limit_equilibrium/block_row/block_row_search.hpp"
#include "limit_equilibrium/bound/block_assembly.hpp"
#include "limit_equilibrium/bound/lp_bound.hpp"
#include "numerics/constants.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace delabole {

namespace {

BlockRowCheck check_input(const BlockRow& row) {
    if (row.block.empty()) {
        return BlockRowCheck::no_blocks;
    }
    if (row.block.size() > most_blocks) {
        return BlockRowCheck::too_many_blocks;
    }
    return in_range(row) ? BlockRowCheck::valid : BlockRowCheck::input_out_of_range;
}

double tilt_of(double tangent, bool exists) {
    return exists ? std::atan(tangent) : right_angle;
}

RowModeSummary summary_of(NamedRowMode<double>&& named) {
    const RowMode<double>& mode = named.mode;
    const bool has_tilt = mode.check != RowModeCheck::no_tilt && mode.check != RowModeCheck::locked;
    return {std::move(named.roles), mode.check,
            tilt_of(mode.tangent, has_tilt && (mode.check != RowModeCheck::over_determined || mode.tangent > 0)),
            tilt_of(mode.second_tangent, mode.second_tangent > 0)};
}

RowBlockForces forces_of(const MemberForces<double>& forces) {
    return {forces.thrust,     forces.thrust > 0 ? forces.thrust_moment / forces.thrust : 0.0,
            forces.shear,      forces.normal_force,
            forces.base_shear, forces.normal_force > 0 ? forces.base_moment / forces.normal_force : 0.0};
}

RowState failure_in(std::string_view roles) {
    if (roles.front() != row_role::slides) {
        return RowState::topples;
    }
    const bool turns = roles.find_first_not_of("S0") != std::string_view::npos;
    return turns ? RowState::slides_and_topples : RowState::slides;
}

RowState state_at(double inclination, const RowAnswer& answer) {
    if (inclination < answer.critical_tilt) {
        return RowState::stands;
    }
    if (inclination < answer.critical_tilt_in_contact && !answer.mode_in_contact.empty()) {
        return RowState::stands_if_pressed;
    }
    return failure_in(answer.mode_in_contact.empty() ? answer.mode : answer.mode_in_contact);
}

LpBound bound_of(const std::vector<RowMember<double>>& members) {
    std::vector<RectangularBlock> blocks;
    blocks.reserve(members.size());
    for (const RowMember<double>& member : members) {
        blocks.push_back({member.width, member.height, member.weight});
    }
    Assembly assembly = assemble_row(blocks, {0, 0});
    for (Contact& contact : assembly.contacts) {
        const double tangent = contact.other ? members[std::min(contact.body, *contact.other)].interface_friction
                                             : members[contact.body].base_friction;
        contact.friction_angle = std::atan(tangent);
    }
    return largest_tilt(assembly);
}

// Returns from the mechanism of the linear programme which blocks slide or rotate.
RowState failure_in(const std::vector<VirtualMotion>& mechanism) {
    constexpr double still = 1e-9;  // of motions scaled to about 1
    bool slides = false;
    bool turns = false;
    for (const VirtualMotion& motion : mechanism) {
        const bool rotates = std::abs(motion.rotation) > still;
        turns = turns || rotates;
        slides = slides || (!rotates && motion.displacement.norm() > still);
    }
    return !turns ? RowState::slides : slides ? RowState::slides_and_topples : RowState::topples;
}

// Returns nothing if the linear programme has no answer.
std::optional<RowAnswer> bounded_answer(const std::vector<RowMember<double>>& members, double inclination) {
    if (members.size() > most_bounded_row) {
        return std::nullopt;
    }
    const LpBound bound = bound_of(members);
    if (bound.status != LpStatus::optimal && bound.status != LpStatus::unbounded) {
        return std::nullopt;
    }
    RowAnswer answer;
    answer.search = RowSearchKind::upper_bound;
    answer.critical_tilt = bound.status == LpStatus::optimal ? std::atan(bound.value) : right_angle;
    answer.critical_tilt_in_contact = answer.critical_tilt;
    double alone = right_angle;
    for (const RowMember<double>& member : members) {
        alone = std::min(alone, std::atan(std::min(member.width / member.height, member.base_friction)));
    }
    answer.state = inclination < alone                  ? RowState::stands
                   : inclination < answer.critical_tilt ? RowState::stands_if_pressed
                                                        : failure_in(bound.mechanism);
    return answer;
}

}  // namespace

BlockRowResult analyse(const BlockRow& row) {
    BlockRowResult result;
    result.check = check_input(row);
    if (result.check != BlockRowCheck::valid) {
        return result;
    }
    const std::vector<RowMember<double>> members = row_members(row);
    RowSearchResult<double> found = RowSearch<double>(members).search();
    if (found.least) {
        const NamedRowMode<double>& least = found.modes[*found.least];
        RowAnswer& answer = result.answer;
        answer.search = found.exact ? RowSearchKind::exact : RowSearchKind::bounded;
        answer.mode = least.roles;
        answer.critical_tilt = std::atan(least.mode.tangent);
        answer.critical_tilt_in_contact = right_angle;
        if (found.least_in_contact) {
            const NamedRowMode<double>& contact = found.modes[*found.least_in_contact];
            answer.mode_in_contact = contact.roles;
            answer.critical_tilt_in_contact = std::atan(contact.mode.tangent);
        }
        answer.state = state_at(row.base.inclination, answer);
        result.block.reserve(least.mode.forces.size());
        for (const MemberForces<double>& forces : least.mode.forces) {
            result.block.push_back(forces_of(forces));
        }
    } else if (const std::optional<RowAnswer> bounded = bounded_answer(members, row.base.inclination)) {
        result.answer = *bounded;
    } else {
        result.check = BlockRowCheck::no_admissible_mode;
    }
    result.mode.reserve(found.modes.size());
    for (NamedRowMode<double>& mode : found.modes) {
        result.mode.push_back(summary_of(std::move(mode)));
    }
    return result;
}

ModelInterface model_interface(const BlockRow& row) {
    return interface_of_function(row, RowAnswer{}, [](const BlockRow& varied) -> Prediction {
        const BlockRowResult result = analyse(varied);
        return result.check == BlockRowCheck::valid ? Prediction{{}, output_values(result.answer), {}}
                                                    : Prediction{word_of(result.check), {}, {}};
    });
}

}  // namespace delabole
