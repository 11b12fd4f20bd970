#include "limit_equilibrium/stepped_path/path_search.hpp"

#include "limit_equilibrium/stepped_path/surface_strength.hpp"
#include "numerics/constants.hpp"
#include "numerics/edge_of_sign.hpp"

#include <algorithm>
#include <cmath>

namespace delabole {

namespace {

// Greatest factor by which strength is divided or multiplied.
constexpr double widest_factor = 1e8;

// Push on a column from above: its normal part, the tangent of its friction drag, and the depth of its point of
// application below the ground, along the joint.
struct Push {
    double force = 0;
    double drag = 0;
    double depth = 0;
};

// The limits of columns and joints at a given strength.
struct ColumnLaw {
    double joint, base, cohesion;  // tangents; Pa
    double sine, cosine;           // of the sum of the dips of joints and steps
    double push_effect;

    ColumnLaw(const SteppedPath& problem, const SurfaceStrength& strength, double factor)
        : joint(std::tan(problem.columns->friction_angle) / factor),
          base(strength.step_friction / factor),
          cohesion(strength.step_cohesion / factor),
          sine(std::sin(problem.steps.dip - problem.columns->dip)),
          cosine(std::cos(problem.steps.dip - problem.columns->dip)),
          push_effect(effect(joint)) {}

    // The share of a push with this drag that counts in the balance of sliding.
    double effect(double drag) const { return sine - (drag + base) * cosine - drag * base * sine; }
    Push from(double needed) const { return {needed, joint, 0}; }
    double overturning(const PathCell& cell, const Push& push) const {
        return cell.overturning + push.force * (cell.push_arm + push.drag * cell.drag_arm - push.depth);
    }
    double unresisted(const PathCell& cell, const Push& push) const {
        return cell.down_dip - base * cell.normal - cohesion * cell.base_length + push.force * effect(push.drag);
    }
    // The push from below that the column needs against rotation and against sliding; at the face, the push that it
    // lacks, which may be negative.
    double against_turning(const PathCell& cell, const Push& push) const {
        const double moment = overturning(cell, push);
        if (cell.at_face) {
            return moment / std::max(cell.upper_reach, cell.base_length);
        }
        return !(moment > 0) ? 0 : cell.lower_contact > 0 ? moment / cell.lower_contact : infinity;
    }
    double against_sliding(const PathCell& cell, const Push& push) const {
        const double lacking = unresisted(cell, push);
        if (cell.at_face) {
            return lacking;
        }
        return !(lacking > 0) ? 0 : push_effect > 0 ? lacking / push_effect : infinity;
    }
    double needed(const PathCell& cell, const Push& push) const {
        return push.force < infinity ? std::max(against_turning(cell, push), against_sliding(cell, push)) : infinity;
    }
    // Whether more push from above may reduce the push needed below. More push always increases the push needed against
    // sliding; it has to be allowed for if it reduces the push needed against rotation and that governs without a push.
    bool may_be_steadied(const PathCell& cell) const {
        return !(push_effect > 0) || (cell.overturning > 0 && cell.push_arm + joint * cell.drag_arm < 0 &&
                                      against_turning(cell, {}) > against_sliding(cell, {}));
    }
};

// Surfaces that come out far enough behind the crest, or those of a toe, which come out in front of that.
enum class ComesOut { behind_crest, at_toe };

class ColumnSearch {
  public:
    ColumnSearch(const SteppedPath& problem, const PathLattice& lattice, ComesOut comes_out = ComesOut::behind_crest)
        : problem_(problem),
          lattice_(lattice),
          comes_out_(comes_out),
          strength_(problem),
          joint_friction_(std::tan(problem.columns->friction_angle)) {
        for (const std::vector<PathWedge>& behind : lattice.wedges) {
            if (!wedge_joint_ && !behind.empty()) {
                const double normal_to_joints = degrees(90) + problem.columns->dip;
                wedge_joint_.emplace(behind.front().loads, normal_to_joints);
            }
        }
    }

    static constexpr std::size_t no_wedge = static_cast<std::size_t>(-1);
    // The neighbour above a column: the next column on a level, with the place of its need in the list of its needs;
    // or, if the level is one past the last, a wedge, or a crack without one.
    struct Choice {
        std::size_t level, place;
    };
    struct Need {
        double need;
        Choice where;
    };
    static constexpr std::size_t most_needs = 64;
    // A range of a list of needs, which are sorted in decreasing order.
    struct Span {
        std::size_t first = 0, end = 0;
    };

    // Reduces the needs from `first` on, which are sorted except for a few: of equal ones the first stays, and of more
    // than `most_needs` those whose ranks are evenly spaced.
    static void thin(std::vector<Need>& list, std::size_t first) {
        const auto begin = list.begin() + static_cast<std::ptrdiff_t>(first);
        for (auto next = begin; next != list.end(); ++next) {
            if (next != begin && std::prev(next)->need < next->need) {
                std::rotate(std::ranges::upper_bound(begin, next, next->need, std::ranges::greater{}, &Need::need),
                            next, next + 1);
            }
        }
        const auto equal = [](const Need& one, const Need& next) { return one.need == next.need; };
        list.erase(std::unique(begin, list.end(), equal), list.end());
        const std::size_t count = list.size() - first;
        if (count > most_needs) {
            constexpr std::size_t steps = most_needs - 1;
            for (std::size_t place = 1; place <= steps; ++place) {
                list[first + place] = list[first + (2 * place * (count - 1) + steps) / (2 * steps)];
            }
            list.resize(first + most_needs);
        }
    }
    // Adds a need to those from `first` on: keeps all of them, or the greatest alone.
    static void add(std::vector<Need>& list, std::size_t first, const Need& need, bool all) {
        if (all || list.size() == first) {
            list.push_back(need);
        } else if (need.need > list[first].need) {
            list[first] = need;
        }
    }

    // Returns nothing if the wedge does not push.
    std::optional<Push> wedge_push(const PathWedge& wedge, double factor) const {
        const SlideHeadThrust<> thrust = slide_head_thrust(wedge.loads, *wedge_joint_, joint_friction_, factor);
        return thrust.force > 0 ? std::optional(Push{thrust.force, thrust.shear / thrust.force,
                                                     std::max(0.0, wedge.depth - thrust.height)})
                                : std::nullopt;
    }

    // The push that the surface's toe lacks, negative if the toe stands or one of the columns stays. From the top down,
    // `visit` gets the place of each column in the path, the push on it and the push that it needs.
    template <class Visitor>
    double lacking(const LatticePath& path, double factor, const Visitor& visit) const {
        const ColumnLaw law(problem_, strength_, factor);
        Push push;
        if (path.wedge) {
            const auto found = wedge_push(lattice_.wedges[path.first + path.level.size() - 2][*path.wedge], factor);
            if (!found) {
                return -infinity;
            }
            push = *found;
        }
        for (std::size_t index = path.level.size(); index-- > 0;) {
            const PathCell& cell = lattice_.cells[path.first + index - 1][path.level[index]];
            const double needed = law.needed(cell, push);
            visit(index, law, cell, push);
            if (index == 0) {
                return needed;
            }
            if (!(needed > 0)) {
                return -infinity;
            }
            push = law.from(needed);
        }
        return -infinity;
    }
    double lacking(const LatticePath& path, double factor) const {
        return lacking(path, factor, [](auto&&...) {});
    }

    // For each column, the lowest level from which on the needs of all surfaces are passed down: from there on a column
    // below may be more stable under a smaller push.
    std::vector<std::size_t> levels_with_all_needs(const ColumnLaw& law) const {
        std::vector<std::size_t> lowest(lattice_.cells.size() + 1, lattice_.levels);
        for (std::size_t column = 0; column < lattice_.cells.size(); ++column) {
            for (std::size_t level = lattice_.levels; level-- > 0;) {
                const PathCell& cell = lattice_.cells[column][level];
                if (cell.exists && (law.may_be_steadied(cell) || (!cell.at_face && level >= lowest[column]))) {
                    lowest[column + 1] = level;
                }
            }
        }
        return lowest;
    }

    // Whether the face leaves the base of a column its full width. By itself what is narrower is a sliver of the face.
    bool is_whole(const ColumnLaw& law, const PathCell& cell) const {
        constexpr double rounding = 1e-9;
        return cell.base_length * law.sine >= (1 - rounding) * problem_.columns->spacing;
    }

    // Joins the needs of a column on a level, from `needs_`, with those on higher levels, from `here_`.
    Span join(const Span& higher, const Span& own, std::size_t level, bool all) {
        const std::size_t first = here_.size();
        std::size_t place = own.first;
        const auto take = [&] {
            here_.push_back({needs_[place].need, {level, place - own.first}});
            ++place;
        };
        for (std::size_t other = higher.first; other < higher.end; ++other) {
            while (place < own.end && needs_[place].need > here_[other].need) {
                take();
            }
            const Need copy = here_[other];
            here_.push_back(copy);
        }
        while (place < own.end) {
            take();
        }
        if (all) {
            thin(here_, first);
        } else if (here_.size() > first) {
            here_.resize(first + 1);
        }
        return {first, here_.size()};
    }

    // Finds the surface whose toe lacks most at a given strength.
    double most_lacking(double factor, LatticePath& path) {
        const ColumnLaw law(problem_, strength_, factor);
        const std::size_t count = lattice_.cells.size();
        const std::size_t levels = lattice_.levels;
        const bool of_toe = comes_out_ == ComesOut::at_toe;
        const std::vector<std::size_t> all_from = levels_with_all_needs(law);
        std::vector<Span> chosen(count * levels);  // ranges of `needs_`
        needs_.clear();
        // Needs of the next column on each level or a higher one, as ranges of `above_`.
        std::vector<Span> above(levels);
        above_.clear();
        double most = -infinity;
        Choice toe{};
        std::size_t first = 0;
        std::vector<std::optional<Push>> pushes;
        for (std::size_t column = count; column-- > 0;) {
            const bool far_enough = lattice_.retreat(lattice_.column_outcrop[column]) >= lattice_.least_width;
            if (of_toe && far_enough) {
                continue;
            }
            pushes.clear();
            for (const PathWedge& wedge : lattice_.wedges[column]) {
                pushes.push_back(of_toe ? std::nullopt : wedge_push(wedge, factor));
            }
            std::vector<Span> here(levels);
            here_.clear();
            for (std::size_t level = levels; level-- > 0;) {
                const Span higher = level + 1 < levels ? here[level + 1] : Span{};
                here[level] = higher;
                const PathCell& cell = lattice_.cells[column][level];
                if (!cell.exists) {
                    continue;
                }
                const bool all = !cell.at_face && level >= all_from[column];
                const std::size_t begin = needs_.size();
                // A column that needs no push does not move; at the face any surface counts.
                const auto offer = [&](const Push& push, const Choice& above_it) {
                    const double need = law.needed(cell, push);
                    if (cell.at_face || need > 0) {
                        add(needs_, begin, {need, above_it}, all);
                    }
                };
                Span from = above[level];
                if (!all && !law.may_be_steadied(cell)) {
                    from.end = std::min(from.end, from.first + 1);
                }
                for (; from.first < from.end; ++from.first) {
                    offer(law.from(above_[from.first].need), above_[from.first].where);
                }
                if (of_toe ? !cell.at_face || is_whole(law, cell) : far_enough) {
                    offer({}, {levels, no_wedge});
                }
                for (std::size_t index = 0; index < pushes.size(); ++index) {
                    if (pushes[index] && lattice_.wedges[column][index].depth <= cell.upper_reach) {
                        offer(*pushes[index], {levels, index});
                    }
                }
                thin(needs_, begin);
                chosen[column * levels + level] = {begin, needs_.size()};
                if (cell.at_face) {
                    if (needs_.size() > begin && needs_[begin].need > most) {
                        most = needs_[begin].need;
                        first = column;
                        toe = {level, 0};
                    }
                    continue;
                }
                here[level] = join(higher, {begin, needs_.size()}, level, all);
            }
            above.swap(here);
            above_.swap(here_);
        }
        path = {first + 1, {}, {}};
        if (!(most > -infinity)) {
            return most;
        }
        for (std::size_t column = first;; ++column) {
            path.level.push_back(toe.level);
            toe = needs_[chosen[column * levels + toe.level].first + toe.place].where;
            if (toe.level == levels) {
                if (toe.place != no_wedge) {
                    path.wedge = toe.place;
                }
                return most;
            }
        }
    }

    // Searches for the limit below `failing`, at which the surface lacks a push.
    Limit limit_of(const LatticePath& path, double failing) const {
        int evaluations = 0;
        const auto lacks = [&](double logarithm) {
            ++evaluations;
            return lacking(path, std::exp(logarithm));
        };
        SignBracket bracket{std::log(failing), std::log(failing), 0, 0};
        bracket.at_upper = lacks(bracket.upper);
        for (;;) {
            bracket.lower = bracket.upper - 0.25;
            if (bracket.lower < -std::log(widest_factor)) {
                return {LimitState::fails_at_any_strength, 0, evaluations};
            }
            bracket.at_lower = lacks(bracket.lower);
            if (!(bracket.at_lower > 0)) {
                break;
            }
            bracket.upper = bracket.lower;
            bracket.at_upper = bracket.at_lower;
        }
        // Just past the limit the surface moves.
        const double factor = std::exp(edge_in(lacks, bracket)) * (1 + 1e-12);
        // The toe is in equilibrium there unless its lacking push jumps, for instance where a column above begins to
        // move.
        double scale = 0;
        for (std::size_t index = 0; index < path.level.size(); ++index) {
            const PathCell& cell = lattice_.cells[path.first + index - 1][path.level[index]];
            scale += std::abs(cell.normal) + std::abs(cell.down_dip);
        }
        constexpr double share = 1e-6;
        return {lacking(path, factor) <= share * scale ? LimitState::found : LimitState::abrupt, factor, evaluations};
    }

    CriticalPath search() {
        CriticalPath critical;
        critical.factor_of_safety = infinity;
        LatticePath path;
        double factor = 1;
        while (!(++critical.searches, most_lacking(factor, path) > 0)) {
            factor *= 4;
            if (factor > widest_factor) {
                return critical;
            }
        }
        while (critical.searches < most_searches) {
            const Limit limit = limit_of(path, factor);
            critical.limit = limit.state;
            critical.factor_of_safety = limit.value;
            critical.path = path;
            if (!(limit.value > 0)) {
                break;
            }
            // At a factor just below the limit that surface itself stands.
            factor = limit.value * (1 - 4e-12);
            ++critical.searches;
            if (!(most_lacking(factor, path) > 0)) {
                break;
            }
        }
        return critical;
    }

  private:
    const SteppedPath& problem_;
    const PathLattice& lattice_;
    ComesOut comes_out_;
    SurfaceStrength strength_;
    double joint_friction_;  // tangent, between columns
    std::optional<SlideHeadJoint<>> wedge_joint_;
    std::vector<Need> needs_, above_, here_;  // used during a search
};

}  // namespace

CriticalPath least_stable_path(const SteppedPath& problem, const PathLattice& lattice) {
    return problem.search.mechanism == SteppedPathMechanism::sliding ? least_stable_sliding(problem, lattice)
                                                                     : ColumnSearch(problem, lattice).search();
}

Limit least_stable_toe(const SteppedPath& problem, const PathLattice& lattice) {
    if (problem.search.mechanism == SteppedPathMechanism::sliding) {
        return {LimitState::holds_at_any_strength, infinity, 0};
    }
    const CriticalPath critical = ColumnSearch(problem, lattice, ComesOut::at_toe).search();
    return {critical.limit, critical.factor_of_safety, critical.searches};
}

Limit factor_of_safety(const SteppedPath& problem, const PathLattice& lattice, const LatticePath& path) {
    if (problem.search.mechanism == SteppedPathMechanism::sliding) {
        return sliding_limit(problem, lattice, path);
    }
    const ColumnSearch search(problem, lattice);
    double factor = 1;
    while (!(search.lacking(path, factor) > 0)) {
        factor *= 4;
        if (factor > widest_factor) {
            return {LimitState::holds_at_any_strength, infinity, 0};
        }
    }
    return search.limit_of(path, factor);
}

std::vector<MovingColumn> moving_columns(const SteppedPath& problem, const PathLattice& lattice,
                                         const LatticePath& path, double factor) {
    std::vector<MovingColumn> columns(path.level.size());
    ColumnSearch(problem, lattice)
        .lacking(path, factor, [&](std::size_t index, const ColumnLaw& law, const PathCell& cell, const auto& push) {
            MovingColumn& column = columns[index];
            column.push = push.force;
            column.depth = push.depth;
            column.mode = law.against_turning(cell, push) >= law.against_sliding(cell, push) ? ColumnMode::topples
                                                                                             : ColumnMode::slides;
        });
    return columns;
}

}  // namespace delabole
