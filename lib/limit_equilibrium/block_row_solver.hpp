// Solves one mode of a row of blocks: the tilt at which it begins, its forces, and whether it can happen. Equations:
// block_row_mode.hpp. A template over the scalar.
#pragma once

#include "limit_equilibrium/block_row_mode.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string_view>
#include <utility>
#include <vector>

namespace delabole {

// Evaluates modes of the blocks from `first` on; keeps its working space between calls.
template <class T>
class RowModeSolver {
  public:
    explicit RowModeSolver(std::vector<RowMember<T>> members) : members_(std::move(members)) {}

    const std::vector<RowMember<T>>& members() const { return members_; }

    // Tilt alone: `check` is no_tilt, locked, over_determined or admissible, there are no forces. Roles in the order
    // S* (F* P? B* with "=") (0* or R*), as many as there are blocks from `first` on, not all standing; R only with P.
    RowMode<T> close(std::string_view roles, std::size_t first) {
        divide(roles, first);
        return units_.empty() ? close_sliding() : close_turning();
    }

    // Tilt, forces and every check but that of the standing part.
    RowMode<T> solve(std::string_view roles, std::size_t first) {
        RowMode<T> mode = close(roles, first);
        if (mode.check == RowModeCheck::admissible) {
            complete(mode);
        }
        return mode;
    }

    // The checks of a mode that has been closed last.
    void complete(RowMode<T>& mode) {
        using std::sqrt;
        cosine_ = 1 / T(sqrt(T(1 + mode.tangent * mode.tangent)));
        sine_ = mode.tangent * cosine_;
        mode.forces.assign(slides_ + turns_ + stands_ + retreats_, MemberForces<T>{});
        turning_forces(mode);
        reactions_exist_ = true;
        sliding_forces(mode);
        standing_forces(mode);
        retreating_forces(mode);
        mode.check = statics(mode);
        if (mode.check == RowModeCheck::admissible && stands_ > 0 && heel_pushes_back()) {
            mode.check = RowModeCheck::blocked_by_standing_block;
        }
    }

  private:
    // sine sin(tilt) + cosine cos(tilt)
    struct Swing {
        T sine{};
        T cosine{};
    };

    // Blocks that turn as one.
    struct Unit {
        std::size_t begin;  // members
        std::size_t end;
        char role;
        T weight;
        T width;
        T height_moment;  // sum of W a / 2
        T width_moment;   // sum of W times distance from the unit's toe
        T base_friction;
        T interface_friction;  // above
        T contact;
        Swing thrust;  // above
    };

    static T at_least_zero(const T& value) { return value > 0 ? value : T(0); }
    T at(const Swing& swing) const { return T(swing.sine * sine_ + swing.cosine * cosine_); }

    void divide(std::string_view roles, std::size_t first) {
        first_ = first;
        slides_ = 0;
        units_.clear();
        std::size_t index = 0;
        for (; index < roles.size() && roles[index] == row_role::slides; ++index) {
            ++slides_;
        }
        for (; index < roles.size() && roles[index] != row_role::stands && roles[index] != row_role::retreats;
             ++index) {
            const RowMember<T>& member = members_[first + index];
            if (roles[index] != row_role::adheres) {
                units_.push_back({first + index, first + index, roles[index], T(0), T(0), T(0), T(0),
                                  member.base_friction, T(0), T(0), Swing{}});
            }
            Unit& unit = units_.back();
            unit.height_moment += member.weight * member.height / 2;
            unit.width_moment += member.weight * (unit.width + member.width / 2);
            unit.weight += member.weight;
            unit.width += member.width;
            unit.interface_friction = member.interface_friction;
            unit.contact = member.contact;
            unit.end = first + index + 1;
        }
        turns_ = index - slides_;
        const bool retreats = index < roles.size() && roles[index] == row_role::retreats;
        retreats_ = retreats ? roles.size() - index : 0;
        stands_ = retreats ? 0 : roles.size() - index;
    }

    RowMode<T> close_sliding() {
        pushed_ = Swing{};
        pushed_height_ = 0;
        T weight{};
        T resistance{};
        for (std::size_t index = first_; index < first_ + slides_; ++index) {
            weight += members_[index].weight;
            resistance += members_[index].weight * members_[index].base_friction;
        }
        return {RowModeCheck::admissible, false, T(resistance / weight), T(0), {}};
    }

    static bool set_tangent(const T& numerator, const T& denominator, T& tangent) {
        const bool exists = denominator > 0 && numerator >= 0;
        tangent = exists ? T(numerator / denominator) : T(0);
        return exists;
    }

    RowMode<T> close_turning() {
        RowMode<T> mode;
        std::size_t pivot = 0;  // the unit whose shear is free; in an over-determined mode the lowest B; or none
        while (pivot < units_.size() && units_[pivot].role == row_role::forward) {
            ++pivot;
        }
        const bool pressed = pivot == units_.size();
        const bool over_determined = !pressed && units_[pivot].role != row_role::pivot;
        mode.pressed = pressed || (retreats_ > 0 && !heel_pushes_back());
        units_.back().thrust = thrust_of_retreat();
        if (!thrusts_from_below(pivot)) {
            mode.check = RowModeCheck::locked;
            return mode;
        }
        if (!pressed) {
            thrusts_from_above(pivot);
        }
        const bool exists = set_tangent(restoring(), overturning(), mode.tangent);
        if (over_determined && pivot > 0) {
            const Swing below = units_[pivot - 1].thrust;
            thrusts_from_above(pivot - 1);
            const Swing above = units_[pivot - 1].thrust;
            set_tangent(T(below.cosine - above.cosine), T(above.sine - below.sine), mode.second_tangent);
            mode.check = RowModeCheck::over_determined;
        } else {
            mode.check = exists ? RowModeCheck::admissible : RowModeCheck::no_tilt;
        }
        return mode;
    }

    // Of the blocks pushed back, on the uppermost turning block: T and c N of all of them, less the friction that the
    // rising heel takes off the lowest one.
    Swing thrust_of_retreat() const {
        Swing thrust;
        if (retreats_ > 0) {
            const std::size_t begin = units_.back().end;
            for (std::size_t index = begin; index < begin + retreats_; ++index) {
                thrust.sine += members_[index].weight;
                thrust.cosine += members_[index].weight * members_[index].base_friction;
            }
            const T mobility = 1 + members_[begin].base_friction * units_.back().interface_friction;
            thrust = {T(thrust.sine / mobility), T(thrust.cosine / mobility)};
        }
        return thrust;
    }

    // False where a block is locked.
    bool thrusts_from_below(std::size_t pivot) {
        pushed_ = Swing{};
        T friction_below{};
        pushed_height_ = 0;
        if (slides_ > 0) {
            for (std::size_t index = first_; index < first_ + slides_; ++index) {
                pushed_.cosine += members_[index].weight * members_[index].base_friction;
                pushed_.sine -= members_[index].weight;
            }
            const RowMember<T>& last = members_[first_ + slides_ - 1];
            const T mobility = 1 - last.base_friction * last.interface_friction;
            if (!(mobility > 0)) {
                return false;
            }
            pushed_ = {T(pushed_.sine / mobility), T(pushed_.cosine / mobility)};
            pushed_height_ = last.contact;
            friction_below = last.interface_friction;
        }
        Swing below = pushed_;
        for (std::size_t index = 0; index < pivot; ++index) {
            Unit& unit = units_[index];
            const T mobility = 1 - unit.base_friction * unit.interface_friction;
            if (!(mobility > 0)) {
                return false;
            }
            const T passed = 1 - unit.base_friction * friction_below;
            unit.thrust.sine = (below.sine * passed - unit.weight) / mobility;
            unit.thrust.cosine = (below.cosine * passed + unit.base_friction * unit.weight) / mobility;
            below = unit.thrust;
            friction_below = unit.interface_friction;
        }
        return true;
    }

    void thrusts_from_above(std::size_t pivot) {
        for (std::size_t index = units_.size() - 1; index > pivot; --index) {
            const Unit& unit = units_[index];
            Unit& below = units_[index - 1];
            const T passed = 1 + unit.base_friction * unit.interface_friction;
            const T mobility = 1 + unit.base_friction * below.interface_friction;
            below.thrust.sine = (unit.thrust.sine * passed + unit.weight) / mobility;
            below.thrust.cosine = (unit.thrust.cosine * passed + unit.base_friction * unit.weight) / mobility;
        }
    }

    // sum X - h S' - sum b mu S = overturning sin - restoring cos
    T overturning() const {
        T sum = -pushed_height_ * pushed_.sine;
        for (const Unit& unit : units_) {
            sum += unit.height_moment - unit.width * unit.interface_friction * unit.thrust.sine;
        }
        return sum;
    }
    T restoring() const {
        T sum = pushed_height_ * pushed_.cosine;
        for (const Unit& unit : units_) {
            sum += unit.width_moment + unit.width * unit.interface_friction * unit.thrust.cosine;
        }
        return sum;
    }

    void turning_forces(RowMode<T>& mode) const {
        if (units_.empty()) {
            return;
        }
        const T pushed = at(pushed_);
        T thrust_below = pushed;
        T shear_below = slides_ > 0 ? T(members_[first_ + slides_ - 1].interface_friction * pushed) : T(0);
        T moment_below = pushed_height_ * pushed;
        for (const Unit& unit : units_) {
            const bool last = &unit == &units_.back();
            const T thrust = at(unit.thrust);
            const T shear = unit.interface_friction * thrust;
            const T overturning_moment = unit.height_moment * sine_ - unit.width_moment * cosine_;
            // The uppermost moment is zero by the closing, but for rounding: no thrust, or thrust at the heel.
            const T moment = last ? T(0) : T(moment_below - overturning_moment + unit.width * shear);
            MemberForces<T>& leader = mode.forces[unit.begin - first_];
            leader.normal_force = unit.weight * cosine_ + shear - shear_below;
            leader.base_shear = unit.weight * sine_ + thrust - thrust_below;
            MemberForces<T>& top = mode.forces[unit.end - 1 - first_];
            top.thrust = thrust;
            top.thrust_moment = moment;
            top.shear = shear;
            hang(mode, unit);
            thrust_below = thrust;
            shear_below = shear;
            moment_below = moment;
        }
    }

    // Within a unit the upper blocks have left the plane and hang on the lower ones.
    void hang(RowMode<T>& mode, const Unit& unit) const {
        for (std::size_t index = unit.end - 1; index > unit.begin; --index) {
            const RowMember<T>& member = members_[index];
            const MemberForces<T>& above = mode.forces[index - first_];
            MemberForces<T>& below = mode.forces[index - 1 - first_];
            below.thrust = above.thrust + member.weight * sine_;
            below.shear = above.shear + member.weight * cosine_;
            below.thrust_moment = above.thrust_moment - member.width * above.shear + own_moment(member);
        }
    }

    T own_moment(const RowMember<T>& member) const {
        return T(member.weight * (member.height * sine_ - member.width * cosine_) / 2);
    }

    void sliding_forces(RowMode<T>& mode) {
        const T pushed = units_.empty() ? T(0) : at(pushed_);
        T thrust{};
        for (std::size_t index = 0; index < slides_; ++index) {
            const RowMember<T>& member = members_[first_ + index];
            MemberForces<T>& forces = mode.forces[index];
            const T thrust_below = thrust;
            forces.thrust = thrust_below + member.weight * (member.base_friction * cosine_ - sine_);
            if (index + 1 == slides_) {
                forces.thrust = pushed;
                forces.shear = member.interface_friction * pushed;
            }
            thrust = forces.thrust;
            forces.normal_force = member.weight * cosine_ + forces.shear;
            forces.base_shear = member.weight * sine_ + forces.thrust - thrust_below;
        }
        place_reactions(mode, 0, slides_, T(pushed_height_ * pushed));
    }

    void retreating_forces(RowMode<T>& mode) {
        if (retreats_ == 0) {
            return;
        }
        const std::size_t begin = slides_ + turns_;
        T thrust{};
        for (std::size_t index = begin + retreats_; index-- > begin;) {
            const RowMember<T>& member = members_[first_ + index];
            MemberForces<T>& forces = mode.forces[index];
            forces.thrust = thrust;
            forces.normal_force = member.weight * cosine_;
            thrust += member.weight * (sine_ + member.base_friction * cosine_);
            forces.base_shear = -member.base_friction * forces.normal_force;
        }
        MemberForces<T>& lowest = mode.forces[begin];
        lowest.normal_force -= mode.forces[begin - 1].shear;
        lowest.base_shear = -members_[first_ + begin].base_friction * lowest.normal_force;
        place_reactions(mode, begin, begin + retreats_, T(0));
    }

    // Blocks from `begin` to `end` that move along the plane together. The moments of the thrusts between them are
    // free within limits; `handed_down` is that of the thrust on the uppermost, the thrust on the lowest from below
    // has none. Of the possible ones those nearest to a thrust at mid-height are taken.
    void place_reactions(RowMode<T>& mode, std::size_t begin, std::size_t end, const T& handed_down) {
        if (begin == end) {
            return;
        }
        lowest_.assign(end - begin + 1, T(0));
        highest_.assign(end - begin + 1, T(0));
        const T slack = tolerance(mode);
        const auto balance = [&](std::size_t index) {
            const RowMember<T>& member = members_[first_ + index];
            return T(member.width * mode.forces[index].shear - own_moment(member));
        };
        // The reaction's moment about the toe lies between 0 and R b.
        for (std::size_t index = begin; index < end; ++index) {
            const RowMember<T>& member = members_[first_ + index];
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
            const RowMember<T>& member = members_[first_ + index];
            MemberForces<T>& forces = mode.forces[index];
            forces.thrust_moment = moment;
            T below{};
            if (index > begin) {
                const T least = std::max(T(moment - balance(index)), lowest_[index - begin]);
                const T most =
                    std::min(T(moment - balance(index) + forces.normal_force * member.width), highest_[index - begin]);
                const T middle = mode.forces[index - 1].thrust * members_[first_ + index - 1].contact / 2;
                below = std::min(std::max(middle, least), most);
            }
            forces.base_moment = balance(index) - moment + below;
            moment = below;
        }
    }

    // As if each stood alone: what passes between standing blocks is not determined.
    void standing_forces(RowMode<T>& mode) const {
        for (std::size_t index = slides_ + turns_; index < slides_ + turns_ + stands_; ++index) {
            const RowMember<T>& member = members_[first_ + index];
            MemberForces<T>& forces = mode.forces[index];
            forces.normal_force = member.weight * cosine_;
            forces.base_shear = member.weight * sine_;
            forces.base_moment = -own_moment(member);
        }
    }

    // Forces below this count as zero: each is a chain of a few operations per block on sums up to the largest force.
    T tolerance(const RowMode<T>& mode) const {
        T largest{};
        for (const MemberForces<T>& forces : mode.forces) {
            largest = std::max({largest, T(forces.normal_force < 0 ? -forces.normal_force : forces.normal_force),
                                T(forces.thrust < 0 ? -forces.thrust : forces.thrust)});
        }
        return T(largest * static_cast<double>(16 * (16 + mode.forces.size())) * std::numeric_limits<T>::epsilon());
    }

    RowModeCheck statics(const RowMode<T>& mode) const {
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
        for (const Unit& unit : units_) {
            const RowModeCheck check = unit_statics(mode, unit, slack);
            if (check != RowModeCheck::admissible) {
                return check;
            }
        }
        if (mode.pressed && stands_ > 0 && !presses_in_equilibrium(mode, slack)) {
            return RowModeCheck::standing_blocks_fail;
        }
        return RowModeCheck::admissible;
    }

    // Whether the standing blocks that press on the heel of turning ones can do so: neither do they slide up the plane,
    // nor, supported by that thrust, does any upper group of them turn.
    bool presses_in_equilibrium(const RowMode<T>& mode, const T& slack) const {
        const std::size_t begin = slides_ + turns_;
        const std::size_t end = begin + stands_;
        std::vector<T> thrust(end, T(0));
        for (std::size_t index = end - 1; index >= begin; --index) {
            const RowMember<T>& member = members_[first_ + index];
            const T below = members_[first_ + index - 1].interface_friction;
            thrust[index - 1] = (member.weight * (sine_ + member.base_friction * cosine_) +
                                 thrust[index] * (1 + member.base_friction * member.interface_friction)) /
                                (1 + member.base_friction * below);
        }
        const T pressing = mode.forces[begin - 1].thrust;
        if (pressing > thrust[begin - 1] + slack) {
            return false;
        }
        T most = pressing;  // that the blocks below an interface bear before they slide forward
        bool locked = false;
        for (std::size_t index = begin; index + 1 < end; ++index) {
            const RowMember<T>& member = members_[first_ + index];
            const T mobility = 1 - member.base_friction * member.interface_friction;
            locked = locked || !(mobility > 0);
            if (!locked) {
                const T below = members_[first_ + index - 1].interface_friction;
                most = (member.weight * (member.base_friction * cosine_ - sine_) +
                        most * (1 - member.base_friction * below)) /
                       mobility;
                thrust[index] = std::min(thrust[index], most);
            }
        }
        T excess{};
        for (std::size_t index = end; index-- > begin;) {
            const RowMember<T>& member = members_[first_ + index];
            const T held = index + 1 < end ? T(member.width * member.interface_friction * thrust[index]) : T(0);
            excess += own_moment(member) - held;
            const T support = index > begin ? T(members_[first_ + index - 1].contact * thrust[index - 1]) : T(0);
            if (excess > support + slack * (member.width + member.height)) {
                return false;
            }
        }
        return true;
    }

    RowModeCheck unit_statics(const RowMode<T>& mode, const Unit& unit, const T& slack) const {
        const MemberForces<T>& leader = mode.forces[unit.begin - first_];
        if (unit.role == row_role::pivot) {
            const T friction = unit.base_friction * leader.normal_force;
            const T shear = leader.base_shear < 0 ? T(-leader.base_shear) : leader.base_shear;
            if (shear > friction + slack * (1 + unit.base_friction)) {
                return RowModeCheck::pivot_slips;
            }
        }
        for (std::size_t index = unit.begin; index < unit.end; ++index) {
            const RowMember<T>& member = members_[index];
            const MemberForces<T>& forces = mode.forces[index - first_];
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

    // The uppermost heel: its toe moves backward by the sum of (1 / cos w - 1) b over the units from the pivot up to
    // the one below it, the heel itself comes forward by (1 - cos w) b. To second order in w the sums of b decide.
    bool heel_pushes_back() const {
        if (units_.empty()) {
            return false;
        }
        T pushed_back{};
        for (std::size_t index = units_.size() - 1; index-- > 0;) {
            if (units_[index].role == row_role::forward) {
                break;
            }
            pushed_back += units_[index].width;
        }
        return pushed_back > units_.back().width;
    }

    std::vector<RowMember<T>> members_;
    std::size_t first_ = 0;
    std::size_t slides_ = 0;
    std::size_t turns_ = 0;
    std::size_t stands_ = 0;
    std::size_t retreats_ = 0;
    std::vector<Unit> units_;
    Swing pushed_;       // thrust on the highest sliding block
    T pushed_height_{};  // where it acts
    T sine_{};
    T cosine_{};
    bool reactions_exist_ = true;  // within the bases of the blocks that move along the plane
    std::vector<T> lowest_;
    std::vector<T> highest_;
};

}  // namespace delabole
