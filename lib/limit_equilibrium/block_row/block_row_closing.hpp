// The tilt at which one mode of a row of blocks begins, in closed form. Equations: block_row_mode.hpp. A template over
// the scalar.
#pragma once

#include "limit_equilibrium/block_row/block_row_mode.hpp"

#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

namespace delabole {

// sine sin(tilt) + cosine cos(tilt)
template <class T>
struct TiltSwing {
    T sine{};
    T cosine{};
};

// Blocks that rotate as one unit.
template <class T>
struct TurningUnit {
    std::size_t begin;  // members
    std::size_t end;
    char role;
    T weight;
    T width;
    T height_moment;  // sum of W a / 2
    T width_moment;   // sum of W times distance from the unit's toe
    T base_friction;
    T interface_friction;  // with the unit above
    T contact;
    TiltSwing<T> thrust;  // from above
};

// A mode's blocks, from `first` on, by their roles: those that slide, those that rotate, and those that stand or
// retreat.
template <class T>
struct RowParts {
    std::size_t first = 0;
    std::size_t slides = 0;
    std::size_t turns = 0;
    std::size_t stands = 0;
    std::size_t retreats = 0;
    std::vector<TurningUnit<T>> units{};
    TiltSwing<T> pushed{};  // thrust on the highest sliding block
    T pushed_height{};      // height at which it acts

    // The uppermost heel: its toe moves backward by the sum of (1 / cos w - 1) b over the units from the pivot up to
    // the one below it, and the heel itself moves forward by (1 - cos w) b. To second order in w the sums of b decide.
    bool heel_pushes_back() const {
        if (units.empty()) {
            return false;
        }
        T pushed_back{};
        for (std::size_t index = units.size() - 1; index-- > 0;) {
            if (units[index].role == row_role::forward) {
                break;
            }
            pushed_back += units[index].width;
        }
        return pushed_back > units.back().width;
    }
};

// Keeps its working arrays between calls.
template <class T>
class RowClosing {
  public:
    explicit RowClosing(std::vector<RowMember<T>> members) : members_(std::move(members)) {}

    const std::vector<RowMember<T>>& members() const { return members_; }

    // Parts of the mode closed last.
    const RowParts<T>& parts() const { return parts_; }

    // `check` is no_tilt, locked, over_determined or admissible; forces are not set. Roles have the order S* (F* P? B*
    // with "=") (0* or R*), one for each block from `first` on, not all standing; R only with P.
    RowMode<T> close(std::string_view roles, std::size_t first) {
        divide(roles, first);
        return parts_.units.empty() ? close_sliding() : close_turning();
    }

  private:
    using Swing = TiltSwing<T>;
    using Unit = TurningUnit<T>;

    void divide(std::string_view roles, std::size_t first) {
        parts_.first = first;
        parts_.slides = 0;
        parts_.units.clear();
        std::size_t index = 0;
        for (; index < roles.size() && roles[index] == row_role::slides; ++index) {
            ++parts_.slides;
        }
        for (; index < roles.size() && roles[index] != row_role::stands && roles[index] != row_role::retreats;
             ++index) {
            const RowMember<T>& member = members_[first + index];
            if (roles[index] != row_role::adheres) {
                parts_.units.push_back({first + index, first + index, roles[index], T(0), T(0), T(0), T(0),
                                        member.base_friction, T(0), T(0), Swing{}});
            }
            Unit& unit = parts_.units.back();
            unit.height_moment += member.weight * member.height / 2;
            unit.width_moment += member.weight * (unit.width + member.width / 2);
            unit.weight += member.weight;
            unit.width += member.width;
            unit.interface_friction = member.interface_friction;
            unit.contact = member.contact;
            unit.end = first + index + 1;
        }
        parts_.turns = index - parts_.slides;
        const bool retreats = index < roles.size() && roles[index] == row_role::retreats;
        parts_.retreats = retreats ? roles.size() - index : 0;
        parts_.stands = retreats ? 0 : roles.size() - index;
    }

    RowMode<T> close_sliding() {
        parts_.pushed = Swing{};
        parts_.pushed_height = 0;
        T weight{};
        T resistance{};
        for (std::size_t index = parts_.first; index < parts_.first + parts_.slides; ++index) {
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
        std::size_t pivot = 0;  // unit whose shear is unknown; in an over-determined mode the lowest B; or `none`
        while (pivot < parts_.units.size() && parts_.units[pivot].role == row_role::forward) {
            ++pivot;
        }
        const bool pressed = pivot == parts_.units.size();
        const bool over_determined = !pressed && parts_.units[pivot].role != row_role::pivot;
        mode.pressed = pressed || (parts_.retreats > 0 && !parts_.heel_pushes_back());
        parts_.units.back().thrust = thrust_of_retreat();
        if (!thrusts_from_below(pivot)) {
            mode.check = RowModeCheck::locked;
            return mode;
        }
        if (!pressed) {
            thrusts_from_above(pivot);
        }
        const bool exists = set_tangent(restoring(), overturning(), mode.tangent);
        if (over_determined && pivot > 0) {
            const Swing below = parts_.units[pivot - 1].thrust;
            thrusts_from_above(pivot - 1);
            const Swing above = parts_.units[pivot - 1].thrust;
            set_tangent(T(below.cosine - above.cosine), T(above.sine - below.sine), mode.second_tangent);
            mode.check = RowModeCheck::over_determined;
        } else {
            mode.check = exists ? RowModeCheck::admissible : RowModeCheck::no_tilt;
        }
        return mode;
    }

    // Thrust of the blocks pushed back on the uppermost rotating block: T and c N of all of them, less the friction
    // that the rising heel takes off the lowest one.
    Swing thrust_of_retreat() const {
        Swing thrust;
        if (parts_.retreats > 0) {
            const std::size_t begin = parts_.units.back().end;
            for (std::size_t index = begin; index < begin + parts_.retreats; ++index) {
                thrust.sine += members_[index].weight;
                thrust.cosine += members_[index].weight * members_[index].base_friction;
            }
            const T mobility = 1 + members_[begin].base_friction * parts_.units.back().interface_friction;
            thrust = {T(thrust.sine / mobility), T(thrust.cosine / mobility)};
        }
        return thrust;
    }

    // Returns false if a block is locked.
    bool thrusts_from_below(std::size_t pivot) {
        parts_.pushed = Swing{};
        T friction_below{};
        parts_.pushed_height = 0;
        if (parts_.slides > 0) {
            for (std::size_t index = parts_.first; index < parts_.first + parts_.slides; ++index) {
                parts_.pushed.cosine += members_[index].weight * members_[index].base_friction;
                parts_.pushed.sine -= members_[index].weight;
            }
            const RowMember<T>& last = members_[parts_.first + parts_.slides - 1];
            const T mobility = 1 - last.base_friction * last.interface_friction;
            if (!(mobility > 0)) {
                return false;
            }
            parts_.pushed = {T(parts_.pushed.sine / mobility), T(parts_.pushed.cosine / mobility)};
            parts_.pushed_height = last.contact;
            friction_below = last.interface_friction;
        }
        Swing below = parts_.pushed;
        for (std::size_t index = 0; index < pivot; ++index) {
            Unit& unit = parts_.units[index];
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
        for (std::size_t index = parts_.units.size() - 1; index > pivot; --index) {
            const Unit& unit = parts_.units[index];
            Unit& below = parts_.units[index - 1];
            const T passed = 1 + unit.base_friction * unit.interface_friction;
            const T mobility = 1 + unit.base_friction * below.interface_friction;
            below.thrust.sine = (unit.thrust.sine * passed + unit.weight) / mobility;
            below.thrust.cosine = (unit.thrust.cosine * passed + unit.base_friction * unit.weight) / mobility;
        }
    }

    // sum X - h S' - sum b mu S = overturning sin - restoring cos
    T overturning() const {
        T sum = -parts_.pushed_height * parts_.pushed.sine;
        for (const Unit& unit : parts_.units) {
            sum += unit.height_moment - unit.width * unit.interface_friction * unit.thrust.sine;
        }
        return sum;
    }
    T restoring() const {
        T sum = parts_.pushed_height * parts_.pushed.cosine;
        for (const Unit& unit : parts_.units) {
            sum += unit.width_moment + unit.width * unit.interface_friction * unit.thrust.cosine;
        }
        return sum;
    }

    std::vector<RowMember<T>> members_;
    RowParts<T> parts_;
};

}  // namespace delabole
