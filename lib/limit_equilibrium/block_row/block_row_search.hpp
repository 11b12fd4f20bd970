// Search for the governing mode of a row of blocks: the admissible one that begins at the least tilt. A template over
// the scalar.
//
// There are two answers. Free: parts may move away from those above them, as the lowest block alone does; the rest then
// only has to stand without their support. In contact: the limit of blocks pressed together, by a mode of the whole
// row, as the thesis assumes, or by the greatest force that pressing on the heel of a lower part can provide.
//
// Does a third block add stability? In the free case not even a second one does: the lowest of equal blocks is at its
// limit at tan(tilt) = b / a whatever the number and the friction. In contact the second and the third add stability,
// (8) and FFP, and with tall blocks some more through modes with B, until the lowest block cannot be held (F0.., the
// tilt of FFP):
//     tan(tilt) = b (1 + mu c) / [a (1 - mu c) + 2 b mu]
// Further blocks add nothing.
//
// Up to `exact_row_limit` blocks every mode is examined: lower parts that slide, turning groups in every pattern,
// upper parts that stand, press or are pushed back, and blocks that adhere (any grouping up to `adhering_row_limit`
// blocks, beyond it the whole row as one); whether an upper part stands is decided by the same search. Time O(N^5), 16
// blocks take milliseconds.
//
// Not among the modes, so that sometimes none is admissible (block_row.hpp names the substitute): for unequal blocks,
// motions in which two groups turn by different angles or one part both slides and turns; a tall block that tips over
// the top of a locked one (phi + psi >= 90 deg) while its toe slides back. Measured on random rows with friction 10 to
// 44 deg and b/a 0.09 to 1: there is a mode for every row of two blocks, 98 % of three, 94 % of four, 88 % of six;
// there is a limit in contact for 100, 94, 87 and 79 %. Where it exists, it equals the bound by linear programming, to
// rounding, and free rows fail at or below that bound: no exception in ten thousand rows of one to six blocks, nor in
// long ones.
//
// Longer rows get a restricted search, linear in N: the lowest block alone and pressed, the sliding part of least
// resistance, the whole row sliding, and the turning group found by bisection on the tilt, with blocks above it that
// each stand by themselves. Its answer is a mode that has passed every check. If base friction varies, or if standing
// blocks need one another, the search may miss a mode of lower tilt. More than `pressing_limit` unequal blocks are not
// checked for pressing and count as unable to press.
#pragma once

#include "limit_equilibrium/block_row/block_row_solver.hpp"

#include <array>
#include <optional>
#include <string>

namespace delabole {

inline constexpr std::size_t exact_row_limit = 16;
inline constexpr std::size_t adhering_row_limit = 4;

// Calls visit(roles) for every mode of `count` blocks, at most exact_row_limit.
template <class Visitor>
void for_each_row_mode(std::size_t count, Visitor&& visit) {
    std::string roles(count, row_role::stands);
    // Bit i of `joined`: turning block i + 1 adheres to turning block i.
    const auto visit_patterns = [&](std::size_t slides, std::size_t turns, unsigned joined) {
        std::size_t leaders = 0;
        std::array<std::size_t, exact_row_limit> leader{};
        for (std::size_t index = 0; index < turns; ++index) {
            const bool adheres = index > 0 && (joined >> (index - 1) & 1U) != 0;
            roles[slides + index] = row_role::adheres;
            if (!adheres) {
                leader[leaders++] = slides + index;
            }
        }
        for (std::size_t forward = 0; forward < leaders; ++forward) {
            for (std::size_t index = 0; index < leaders; ++index) {
                roles[leader[index]] = index < forward    ? row_role::forward
                                       : index == forward ? row_role::pivot
                                                          : row_role::backward;
            }
            visit(std::string_view(roles));
            if (slides + turns < count) {
                const auto upper = roles.begin() + static_cast<std::ptrdiff_t>(slides + turns);
                std::fill(upper, roles.end(), row_role::retreats);
                visit(std::string_view(roles));
                std::fill(upper, roles.end(), row_role::stands);
            }
            if (forward > 0) {
                roles[leader[forward]] = row_role::backward;
                visit(std::string_view(roles));
            }
        }
        if (slides + turns < count) {
            for (std::size_t index = 0; index < leaders; ++index) {
                roles[leader[index]] = row_role::forward;
            }
            visit(std::string_view(roles));
        }
    };
    for (std::size_t slides = 0; slides <= count; ++slides) {
        for (std::size_t turns = 0; slides + turns <= count; ++turns) {
            std::fill(roles.begin(), roles.end(), row_role::stands);
            std::fill_n(roles.begin(), slides, row_role::slides);
            if (turns == 0) {
                if (slides > 0) {
                    visit(std::string_view(roles));
                }
                continue;
            }
            const unsigned all_joined = (1U << (turns - 1)) - 1;
            for (unsigned joined = 0; joined <= all_joined; ++joined) {
                if (count <= adhering_row_limit || joined == 0 || (joined == all_joined && turns == count)) {
                    visit_patterns(slides, turns, joined);
                } else if (turns == count) {
                    joined = all_joined - 1;
                } else {
                    break;
                }
            }
        }
    }
}

template <class T>
struct NamedRowMode {
    std::string roles;
    RowMode<T> mode;
};

template <class T>
struct RowSearchResult {
    bool exact = true;
    std::vector<NamedRowMode<T>> modes{};  // all modes examined
    // Index of the admissible motion of least tilt; if there is none, the limit in contact, beyond which there is no
    // equilibrium; absent if none is admissible.
    std::optional<std::size_t> least{};
    std::optional<std::size_t> least_in_contact{};
};

template <class T>
class RowSearch {
  public:
    explicit RowSearch(std::vector<RowMember<T>> members) : solver_(std::move(members)) {}

    RowSearchResult<T> search() {
        result_ = {};
        result_.exact = count() <= exact_row_limit;
        if (result_.exact) {
            examine_all();
        } else {
            examine_some();
        }
        if (!result_.least) {
            result_.least = result_.least_in_contact;
        }
        return std::move(result_);
    }

  private:
    // Relative rounding error of the closed forms.
    const T same_tilt = 64 * std::numeric_limits<T>::epsilon();

    std::size_t count() const { return solver_.members().size(); }
    const RowMember<T>& member(std::size_t index) const { return solver_.members()[index]; }

    // Tangents of the tilts at which a part fails: by a motion, and the greatest one if it is pressed together. Absent
    // if no such mode is admissible.
    struct Limits {
        std::optional<T> free{};
        std::optional<T> pressed{};
    };

    bool stands_above(std::string_view roles, std::size_t first, const RowMode<T>& mode) const {
        const std::size_t moving = roles.find(row_role::stands);
        if (moving == std::string_view::npos || mode.pressed) {
            return true;
        }
        const Limits& limits = limits_[first + moving];
        const std::optional<T>& limit = limits.free ? limits.free : limits.pressed;
        // Equal blocks reach their limits together.
        return limit && mode.tangent <= *limit * (1 + same_tilt);
    }

    static void improve(std::optional<T>& least, const T& tangent) {
        if (!least || tangent < *least) {
            least = tangent;
        }
    }

    void keep(std::string_view roles, RowMode<T> mode) {
        if (mode.check == RowModeCheck::admissible && !stands_above(roles, 0, mode)) {
            mode.check = RowModeCheck::standing_blocks_fail;
        }
        const std::size_t index = result_.modes.size();
        const auto standing = [](std::string_view text) {
            const std::size_t first = text.find(row_role::stands);
            return first == std::string_view::npos ? 0 : text.size() - first;
        };
        // Of modes that begin together, except for rounding, the one that moves more blocks is taken.
        const auto take = [&](std::optional<std::size_t>& least) {
            if (least) {
                const NamedRowMode<T>& best = result_.modes[*least];
                const T margin = best.mode.tangent * same_tilt;
                const bool lower = mode.tangent < best.mode.tangent - margin;
                const bool same = mode.tangent <= best.mode.tangent + margin;
                if (!lower && !(same && standing(roles) < standing(best.roles))) {
                    return;
                }
            }
            least = index;
        };
        if (mode.check == RowModeCheck::admissible) {
            if (!mode.pressed) {
                take(result_.least);
            }
            if (mode.pressed || roles.back() != row_role::stands) {
                take(result_.least_in_contact);
            }
        }
        result_.modes.push_back({std::string(roles), std::move(mode)});
    }

    // Limits of the blocks from `first` on, without blocks below them.
    Limits limits_of_upper_part(std::size_t first) {
        Limits limits;
        for_each_row_mode(count() - first, [&](std::string_view roles) {
            RowMode<T> mode = solver_.close(roles, first);
            const bool in_contact = mode.pressed || roles.back() != row_role::stands;
            const bool lower = (!mode.pressed && !(limits.free && mode.tangent >= *limits.free)) ||
                               (in_contact && !(limits.pressed && mode.tangent >= *limits.pressed));
            if (mode.check != RowModeCheck::admissible || !lower || !stands_above(roles, first, mode)) {
                return;
            }
            solver_.complete(mode);
            if (mode.check != RowModeCheck::admissible) {
                return;
            }
            if (!mode.pressed) {
                improve(limits.free, mode.tangent);
            }
            if (in_contact) {
                improve(limits.pressed, mode.tangent);
            }
        });
        return limits;
    }

    void examine_all() {
        limits_.assign(count() + 1, Limits{});
        for (std::size_t first = count(); first-- > 1;) {
            limits_[first] = limits_of_upper_part(first);
        }
        for_each_row_mode(count(), [&](std::string_view roles) { keep(roles, solver_.solve(roles, 0)); });
    }

    static T limit_alone(const RowMember<T>& block) {
        return std::min(T(block.width / block.height), block.base_friction);
    }

    void examine_some() {
        limits_.assign(count() + 1, Limits{});
        for (std::size_t first = count(); first-- > 0;) {
            limits_[first] = limits_[first + 1];
            improve(limits_[first].free, limit_alone(member(first)));
            limits_[first].pressed = limits_[first].free;
        }
        std::string roles(count(), row_role::stands);
        roles[0] = row_role::pivot;
        keep(roles, solver_.solve(roles, 0));
        roles[0] = row_role::forward;
        keep(roles, solver_.solve(roles, 0));
        examine_sliding();
        examine_turning(false);
        examine_turning(true);
    }

    void examine_sliding() {
        std::size_t best = 1;
        T least{};
        T weight{};
        T resistance{};
        for (std::size_t index = 0; index < count(); ++index) {
            weight += member(index).weight;
            resistance += member(index).weight * member(index).base_friction;
            if (index == 0 || resistance / weight < least) {
                least = resistance / weight;
                best = index + 1;
            }
        }
        std::string roles(count(), row_role::stands);
        std::fill_n(roles.begin(), best, row_role::slides);
        keep(roles, solver_.solve(roles, 0));
        if (best < count()) {
            roles.assign(count(), row_role::slides);
            keep(roles, solver_.solve(roles, 0));
        }
    }

    // The turning group that governs at a given tilt.
    struct Group {
        T excess{};             // of overturning over resisting moment; positive: the group fails
        std::size_t first = 0;  // lowest turning block
        std::size_t pivot = 0;
        std::size_t end = 0;  // past the highest turning block; 0: none turns
    };

    Group group_at(const T& tilt, bool whole) {
        using std::cos;
        using std::sin;
        const T sine = sin(tilt);
        const T cosine = cos(tilt);
        Group group;
        group.end = count();
        while (!whole && group.end > 0 && sine <= cosine * limit_alone(member(group.end - 1))) {
            --group.end;
        }
        if (group.end == 0) {
            return group;
        }
        const std::size_t changeover = thrusts_at(sine, cosine, group.end);
        // The loop goes downwards and adds one turning block at a time.
        T turning{};
        bool any = false;
        for (std::size_t first = group.end; first-- > 0;) {
            const RowMember<T>& block = member(first);
            turning += block.weight * (block.height * sine - block.width * cosine) / 2;
            if (first + 1 < group.end) {
                turning -= block.width * block.interface_friction * thrust_[first];
            }
            // From the changeover on, blocks slide backward, because the thrust is too small to push them forward.
            if (first > changeover) {
                continue;
            }
            const T excess = first == 0 ? turning : T(turning - member(first - 1).contact * thrust_[first - 1]);
            if (!any || excess > group.excess) {
                any = true;
                group.excess = excess;
                group.first = first;
                group.pivot = changeover;
            }
        }
        return group;
    }

    // Computes the lesser of the thrusts from below and from above at every interface; returns the block where they
    // change over.
    std::size_t thrusts_at(const T& sine, const T& cosine, std::size_t end) {
        thrust_.assign(end, T(0));
        T above{};
        T friction_above{};
        for (std::size_t index = end - 1; index > 0; --index) {
            const RowMember<T>& block = member(index);
            above = (block.weight * (sine + block.base_friction * cosine) +
                     above * (1 + block.base_friction * friction_above)) /
                    (1 + block.base_friction * member(index - 1).interface_friction);
            friction_above = member(index - 1).interface_friction;
            thrust_[index - 1] = above;
        }
        T below{};
        T friction_below{};
        for (std::size_t index = 0; index + 1 < end; ++index) {
            const RowMember<T>& block = member(index);
            const T mobility = 1 - block.base_friction * block.interface_friction;
            if (!(mobility > 0)) {
                return index;  // locked
            }
            below = (block.weight * (block.base_friction * cosine - sine) +
                     below * (1 - block.base_friction * friction_below)) /
                    mobility;
            friction_below = block.interface_friction;
            if (below >= thrust_[index]) {
                return index;
            }
            thrust_[index] = below;
        }
        return end - 1;
    }

    void examine_turning(bool whole) {
        using std::atan;
        T low{};
        T high = 2 * T(atan(T(1)));
        if (!(group_at(high, whole).excess > 0)) {
            return;
        }
        // The bisection ends at half of the last digit; the closed form gives the tilt itself.
        for (int digit = 0; digit < std::numeric_limits<T>::digits; ++digit) {
            const T middle = (low + high) / 2;
            (group_at(middle, whole).excess > 0 ? high : low) = middle;
        }
        const Group group = group_at(high, whole);
        std::string roles(count(), row_role::stands);
        for (std::size_t index = 0; index < group.end; ++index) {
            roles[index] = index < group.first    ? row_role::slides
                           : index < group.pivot  ? row_role::forward
                           : index == group.pivot ? row_role::pivot
                                                  : row_role::backward;
        }
        keep(roles, solver_.solve(roles, 0));
    }

    RowModeSolver<T> solver_;
    RowSearchResult<T> result_;
    std::vector<Limits> limits_;  // of the blocks from each index on
    std::vector<T> thrust_;
};

}  // namespace delabole
