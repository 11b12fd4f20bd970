// Solves one mode of a row of blocks: the tilt at which it begins, its forces, and whether it can happen. Equations:
// block_row_mode.hpp. A template over the scalar.
#pragma once

#include "limit_equilibrium/block_row/block_row_closing.hpp"
#include "numerics/infeasibility.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string_view>
#include <utility>
#include <vector>

namespace delabole {

// Greatest number of unequal blocks that are checked for pressing on others. The time of the search for the forces
// grows with the third power of their number, to 10 ms for this many; more blocks are checked only if all are equal.
inline constexpr std::size_t pressing_limit = 48;

// Evaluates modes of the blocks from `first` on; keeps its working arrays between calls.
template <class T>
class RowModeSolver {
  public:
    explicit RowModeSolver(std::vector<RowMember<T>> members) : closing_(std::move(members)) {}

    const std::vector<RowMember<T>>& members() const { return closing_.members(); }

    // Computes the tilt alone.
    RowMode<T> close(std::string_view roles, std::size_t first) { return closing_.close(roles, first); }

    // Computes tilt and forces, and makes every check except that of the standing part.
    RowMode<T> solve(std::string_view roles, std::size_t first) {
        RowMode<T> mode = close(roles, first);
        if (mode.check == RowModeCheck::admissible) {
            complete(mode);
        }
        return mode;
    }

    // Makes the checks of the mode that was closed last.
    void complete(RowMode<T>& mode) {
        using std::sqrt;
        cosine_ = 1 / T(sqrt(T(1 + mode.tangent * mode.tangent)));
        sine_ = mode.tangent * cosine_;
        mode.forces.assign(parts().slides + parts().turns + parts().stands + parts().retreats, MemberForces<T>{});
        turning_forces(mode);
        reactions_exist_ = true;
        sliding_forces(mode);
        standing_forces(mode);
        retreating_forces(mode);
        mode.check = statics(mode);
        if (mode.check == RowModeCheck::admissible && parts().stands > 0 && parts().heel_pushes_back()) {
            mode.check = RowModeCheck::blocked_by_standing_block;
        }
    }

  private:
    const RowParts<T>& parts() const { return closing_.parts(); }
    // `index` counts within the mode.
    const RowMember<T>& block(std::size_t index) const { return members()[parts().first + index]; }
    static T at_least_zero(const T& value) { return value > 0 ? value : T(0); }
    T at(const TiltSwing<T>& swing) const { return T(swing.sine * sine_ + swing.cosine * cosine_); }

    void turning_forces(RowMode<T>& mode) const {
        if (parts().units.empty()) {
            return;
        }
        const T pushed = at(parts().pushed);
        T thrust_below = pushed;
        T shear_below = parts().slides > 0 ? T(block(parts().slides - 1).interface_friction * pushed) : T(0);
        T moment_below = parts().pushed_height * pushed;
        for (const TurningUnit<T>& unit : parts().units) {
            const bool last = &unit == &parts().units.back();
            const T thrust = at(unit.thrust);
            const T shear = unit.interface_friction * thrust;
            const T overturning_moment = unit.height_moment * sine_ - unit.width_moment * cosine_;
            // By the closing equation the uppermost moment is zero, except for rounding: there is no thrust, or it acts
            // at the heel.
            const T moment = last ? T(0) : T(moment_below - overturning_moment + unit.width * shear);
            MemberForces<T>& leader = mode.forces[unit.begin - parts().first];
            leader.normal_force = unit.weight * cosine_ + shear - shear_below;
            leader.base_shear = unit.weight * sine_ + thrust - thrust_below;
            MemberForces<T>& top = mode.forces[unit.end - 1 - parts().first];
            top.thrust = thrust;
            top.thrust_moment = moment;
            top.shear = shear;
            hang(mode, unit);
            thrust_below = thrust;
            shear_below = shear;
            moment_below = moment;
        }
    }

    // Within a unit the upper blocks have left the plane and are carried by the lower ones.
    void hang(RowMode<T>& mode, const TurningUnit<T>& unit) const {
        for (std::size_t index = unit.end - 1; index > unit.begin; --index) {
            const RowMember<T>& member = members()[index];
            const MemberForces<T>& above = mode.forces[index - parts().first];
            MemberForces<T>& below = mode.forces[index - 1 - parts().first];
            below.thrust = above.thrust + member.weight * sine_;
            below.shear = above.shear + member.weight * cosine_;
            below.thrust_moment = above.thrust_moment - member.width * above.shear + own_moment(member);
        }
    }

    T own_moment(const RowMember<T>& member) const {
        return T(member.weight * (member.height * sine_ - member.width * cosine_) / 2);
    }

    void sliding_forces(RowMode<T>& mode) {
        const T pushed = parts().units.empty() ? T(0) : at(parts().pushed);
        T thrust{};
        for (std::size_t index = 0; index < parts().slides; ++index) {
            const RowMember<T>& member = block(index);
            MemberForces<T>& forces = mode.forces[index];
            const T thrust_below = thrust;
            forces.thrust = thrust_below + member.weight * (member.base_friction * cosine_ - sine_);
            if (index + 1 == parts().slides) {
                forces.thrust = pushed;
                forces.shear = member.interface_friction * pushed;
            }
            thrust = forces.thrust;
            forces.normal_force = member.weight * cosine_ + forces.shear;
            forces.base_shear = member.weight * sine_ + forces.thrust - thrust_below;
        }
        place_reactions(mode, 0, parts().slides, T(parts().pushed_height * pushed));
    }

    void retreating_forces(RowMode<T>& mode) {
        if (parts().retreats == 0) {
            return;
        }
        const std::size_t begin = parts().slides + parts().turns;
        T thrust{};
        for (std::size_t index = begin + parts().retreats; index-- > begin;) {
            const RowMember<T>& member = block(index);
            MemberForces<T>& forces = mode.forces[index];
            forces.thrust = thrust;
            forces.normal_force = member.weight * cosine_;
            thrust += member.weight * (sine_ + member.base_friction * cosine_);
            forces.base_shear = -member.base_friction * forces.normal_force;
        }
        MemberForces<T>& lowest = mode.forces[begin];
        lowest.normal_force -= mode.forces[begin - 1].shear;
        lowest.base_shear = -block(begin).base_friction * lowest.normal_force;
        place_reactions(mode, begin, begin + parts().retreats, T(0));
    }

    // Places the reactions of blocks from `begin` to `end` that move along the plane together. The moments of the
    // thrusts between them are free within limits; `handed_down` is the moment of the thrust on the uppermost block,
    // and the thrust on the lowest from below has none. Of the possible moments those nearest to a thrust at mid-height
    // are taken.
    void place_reactions(RowMode<T>& mode, std::size_t begin, std::size_t end, const T& handed_down) {
        if (begin == end) {
            return;
        }
        lowest_.assign(end - begin + 1, T(0));
        highest_.assign(end - begin + 1, T(0));
        const T slack = tolerance(mode);
        const auto balance = [&](std::size_t index) {
            const RowMember<T>& member = block(index);
            return T(member.width * mode.forces[index].shear - own_moment(member));
        };
        // The reaction's moment about the toe lies between 0 and R b.
        for (std::size_t index = begin; index < end; ++index) {
            const RowMember<T>& member = block(index);
            const MemberForces<T>& forces = mode.forces[index];
            T& lowest = lowest_[index - begin + 1];
            T& highest = highest_[index - begin + 1];
            lowest = lowest_[index - begin] + balance(index) - forces.normal_force * member.width;
            highest = highest_[index - begin] + balance(index);
            const bool last = index + 1 == end;
            lowest = std::max(lowest, last ? handed_down : T(0));
            highest = std::min(highest, last ? handed_down : at_least_zero(T(forces.thrust * member.contact)));
            if (lowest > highest + slack * (member.width + member.height)) {
                reactions_exist_ = false;
                return;
            }
        }
        T moment = handed_down;
        for (std::size_t index = end; index-- > begin;) {
            const RowMember<T>& member = block(index);
            MemberForces<T>& forces = mode.forces[index];
            forces.thrust_moment = moment;
            T below{};
            if (index > begin) {
                const T least = std::max(T(moment - balance(index)), lowest_[index - begin]);
                const T most =
                    std::min(T(moment - balance(index) + forces.normal_force * member.width), highest_[index - begin]);
                const T middle = mode.forces[index - 1].thrust * block(index - 1).contact / 2;
                below = std::min(std::max(middle, least), most);
            }
            forces.base_moment = balance(index) - moment + below;
            moment = below;
        }
    }

    // Each block is taken as if it stood alone, because forces between standing blocks are not determined.
    void standing_forces(RowMode<T>& mode) const {
        for (std::size_t index = parts().slides + parts().turns;
             index < parts().slides + parts().turns + parts().stands; ++index) {
            const RowMember<T>& member = block(index);
            MemberForces<T>& forces = mode.forces[index];
            forces.normal_force = member.weight * cosine_;
            forces.base_shear = member.weight * sine_;
            forces.base_moment = -own_moment(member);
        }
    }

    // Forces below this count as zero. Each results from a chain of a few operations per block on sums up to the
    // largest force.
    T tolerance(const RowMode<T>& mode) const {
        T largest{};
        for (const MemberForces<T>& forces : mode.forces) {
            largest = std::max({largest, T(forces.normal_force < 0 ? -forces.normal_force : forces.normal_force),
                                T(forces.thrust < 0 ? -forces.thrust : forces.thrust)});
        }
        return T(largest * static_cast<double>(16 * (16 + mode.forces.size())) * std::numeric_limits<T>::epsilon());
    }

    RowModeCheck statics(const RowMode<T>& mode) {
        const T slack = tolerance(mode);
        for (std::size_t index = 0; index < mode.forces.size(); ++index) {
            if (mode.forces[index].thrust < -slack) {
                return RowModeCheck::tension;
            }
            if (mode.forces[index].normal_force < -slack) {
                return RowModeCheck::base_lifts;
            }
        }
        if (!reactions_exist_) {
            return RowModeCheck::sliding_block_overturns;
        }
        for (const TurningUnit<T>& unit : parts().units) {
            const RowModeCheck check = unit_statics(mode, unit, slack);
            if (check != RowModeCheck::admissible) {
                return check;
            }
        }
        const bool presses = mode.pressed && parts().stands > 0;
        if (presses && !(parts().stands <= pressing_limit ? pressing_forces_exist(mode, slack)
                                                          : equal_blocks_press(mode, slack))) {
            return RowModeCheck::standing_blocks_fail;
        }
        return RowModeCheck::admissible;
    }

    // Whether forces within all faces and their friction exist by which the standing blocks can press on the heel of
    // the turning ones: three equations for each block, with the two edges of Coulomb's cone at both ends of every face
    // as unknowns, those of the base first.
    bool pressing_forces_exist(const RowMode<T>& mode, const T& slack) {
        const std::size_t begin = parts().slides + parts().turns;
        const std::size_t columns = 8 * parts().stands - 4;
        coefficients_.assign(3 * parts().stands * columns, T(0));
        right_sides_.assign(3 * parts().stands, T(0));
        const MemberForces<T>& heel = mode.forces[begin - 1];
        T largest = heel.thrust;
        for (std::size_t index = 0; index < parts().stands; ++index) {
            largest = std::max(largest, block(begin + index).weight);
        }
        for (std::size_t index = 0; index < parts().stands; ++index) {
            const RowMember<T>& member = block(begin + index);
            const std::size_t row = 3 * index;
            const T size = member.width + member.height;
            // Moments are about the toe of `receiver`, divided by its size, positive against overturning.
            const auto add = [&](std::size_t receiver, std::size_t column, const T& up_dip, const T& outward,
                                 const T& restoring) {
                coefficients_[receiver * columns + column] = up_dip;
                coefficients_[(receiver + 1) * columns + column] = outward;
                coefficients_[(receiver + 2) * columns + column] = restoring;
            };
            std::size_t column = 8 * index;
            const T base = 1 / T(1 + member.base_friction);
            for (const T& arm : {T(0), T(member.width / size)}) {
                for (const T& shear : {T(member.base_friction), T(-member.base_friction)}) {
                    add(row, column++, base * shear, base, -base * arm);
                }
            }
            if (index + 1 < parts().stands) {
                // Forces from the block above: down the slope, and shear down on this block.
                const RowMember<T>& above = block(begin + index + 1);
                const T above_size = above.width + above.height;
                const T face = 1 / T(1 + member.interface_friction);
                for (const T& height : {T(0), member.contact}) {
                    for (const T& shear : {T(member.interface_friction), T(-member.interface_friction)}) {
                        add(row, column, -face, -face * shear, face * (shear * member.width - height) / size);
                        add(row + 3, column++, face, face * shear, face * height / above_size);
                    }
                }
            }
            right_sides_[row] = member.weight * sine_ / largest;
            right_sides_[row + 1] = member.weight * cosine_ / largest;
            right_sides_[row + 2] = own_moment(member) / (size * largest);
        }
        // The forces of the turning block are subtracted for its lowest neighbour.
        right_sides_[0] -= heel.thrust / largest;
        right_sides_[1] -= heel.shear / largest;
        return infeasibility_(coefficients_, right_sides_) <= slack / largest;
    }

    // The same check for many equal blocks, by sums: the blocks neither slide up the plane, nor does any upper group of
    // them, supported by that thrust, turn. Rows of unequal blocks may satisfy the sums although no such forces exist.
    bool equal_blocks_press(const RowMode<T>& mode, const T& slack) const {
        const std::size_t begin = parts().slides + parts().turns;
        const std::size_t end = begin + parts().stands;
        for (std::size_t index = begin + 1; index < end; ++index) {
            const RowMember<T>& lower = block(index - 1);
            const RowMember<T>& upper = block(index);
            const bool last = index + 1 == end;
            if (lower.height != upper.height || lower.width != upper.width || lower.weight != upper.weight ||
                lower.base_friction != upper.base_friction ||
                (!last && lower.interface_friction != upper.interface_friction)) {
                return false;
            }
        }
        std::vector<T> thrust(end, T(0));
        for (std::size_t index = end - 1; index >= begin; --index) {
            const RowMember<T>& member = block(index);
            const T below = block(index - 1).interface_friction;
            thrust[index - 1] = (member.weight * (sine_ + member.base_friction * cosine_) +
                                 thrust[index] * (1 + member.base_friction * member.interface_friction)) /
                                (1 + member.base_friction * below);
        }
        const T pressing = mode.forces[begin - 1].thrust;
        if (pressing > thrust[begin - 1] + slack) {
            return false;
        }
        T most = pressing;  // greatest force that the blocks below an interface bear before they slide forward
        bool locked = false;
        for (std::size_t index = begin; index + 1 < end; ++index) {
            const RowMember<T>& member = block(index);
            const T mobility = 1 - member.base_friction * member.interface_friction;
            locked = locked || !(mobility > 0);
            if (!locked) {
                const T below = block(index - 1).interface_friction;
                most = (member.weight * (member.base_friction * cosine_ - sine_) +
                        most * (1 - member.base_friction * below)) /
                       mobility;
                thrust[index] = std::min(thrust[index], most);
            }
        }
        T excess{};
        for (std::size_t index = end; index-- > begin;) {
            const RowMember<T>& member = block(index);
            const T held = index + 1 < end ? T(member.width * member.interface_friction * thrust[index]) : T(0);
            excess += own_moment(member) - held;
            const T support = index > begin ? T(block(index - 1).contact * thrust[index - 1]) : T(0);
            if (excess > support + slack * (member.width + member.height)) {
                return false;
            }
        }
        return true;
    }

    RowModeCheck unit_statics(const RowMode<T>& mode, const TurningUnit<T>& unit, const T& slack) const {
        const MemberForces<T>& leader = mode.forces[unit.begin - parts().first];
        if (unit.role == row_role::pivot) {
            const T friction = unit.base_friction * leader.normal_force;
            const T shear = leader.base_shear < 0 ? T(-leader.base_shear) : leader.base_shear;
            if (shear > friction + slack * (1 + unit.base_friction)) {
                return RowModeCheck::pivot_slips;
            }
        }
        for (std::size_t index = unit.begin; index < unit.end; ++index) {
            const RowMember<T>& member = members()[index];
            const MemberForces<T>& forces = mode.forces[index - parts().first];
            if (index + 1 < unit.end &&
                forces.shear > member.interface_friction * forces.thrust + slack * (1 + member.interface_friction)) {
                return RowModeCheck::adhering_blocks_slip;
            }
            const T margin = slack * (member.height + (1 + member.interface_friction) * unit.width);
            if (forces.thrust_moment < -margin || forces.thrust_moment > forces.thrust * member.contact + margin) {
                return RowModeCheck::thrust_outside_interface;
            }
        }
        return RowModeCheck::admissible;
    }

    RowClosing<T> closing_;
    T sine_{};
    T cosine_{};
    bool reactions_exist_ = true;  // within the bases of the blocks that move along the plane
    std::vector<T> lowest_;
    std::vector<T> highest_;
    Infeasibility<T> infeasibility_;
    std::vector<T> coefficients_;
    std::vector<T> right_sides_;
};

}  // namespace delabole
