#include "limit_equilibrium/stepped_path/path_search.hpp"

#include "limit_equilibrium/stepped_path/surface_strength.hpp"
#include "numerics/edge_of_sign.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace delabole {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr int most_searches = 200;
// Strength is divided by at most this, and multiplied.
constexpr double widest_factor = 1e8;

// On a column from above: its normal part, how much friction drags with it, as a tangent, and how deep below the
// ground, along the joint, it acts.
struct Push {
    double force = 0;
    double drag = 0;
    double depth = 0;
};

// The limits of columns and joints at one strength.
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

    // The share of a push with this drag that works against sliding.
    double effect(double drag) const { return sine - (drag + base) * cosine - drag * base * sine; }
    Push from(double needed) const { return {needed, joint, 0}; }
    double overturning(const PathCell& cell, const Push& push) const {
        return cell.overturning + push.force * (cell.push_arm + push.drag * cell.drag_arm - push.depth);
    }
    double unresisted(const PathCell& cell, const Push& push) const {
        return cell.down_dip - base * cell.normal - cohesion * cell.base_length + push.force * effect(push.drag);
    }
    double against_turning(const PathCell& cell, const Push& push) const {
        const double moment = overturning(cell, push);
        return !(moment > 0) ? 0 : cell.lower_contact > 0 ? moment / cell.lower_contact : infinity;
    }
    double against_sliding(const PathCell& cell, const Push& push) const {
        const double lacking = unresisted(cell, push);
        return !(lacking > 0) ? 0 : push_effect > 0 ? lacking / push_effect : infinity;
    }
    // The push that the column needs from below; at the face, the push that it lacks, which may be negative.
    double needed(const PathCell& cell, const Push& push) const {
        if (!(push.force < infinity)) {
            return infinity;
        }
        if (cell.at_face) {
            return std::max(overturning(cell, push) / std::max(cell.upper_reach, cell.base_length),
                            unresisted(cell, push));
        }
        return std::max(against_turning(cell, push), against_sliding(cell, push));
    }
    // Whether more push from above may ask less of what is below.
    bool may_be_steadied(const PathCell& cell) const {
        return !(push_effect > 0) || (cell.overturning > 0 && cell.push_arm + joint * cell.drag_arm < 0);
    }
};

class ColumnSearch {
  public:
    ColumnSearch(const SteppedPath& problem, const PathLattice& lattice)
        : problem_(problem), lattice_(lattice), strength_(problem), base_dip_(degrees(90) + problem.columns->dip) {}

    static constexpr std::size_t no_wedge = static_cast<std::size_t>(-1);
    // The neighbour above a column: the next one on a level, with the need that has a place in the list of its needs;
    // or, the level being one past the last, a wedge or a crack.
    struct Choice {
        std::size_t level, wedge, place;
    };
    struct Need {
        double need;
        Choice where;
    };
    // Needs of one column, or of one of several, over surfaces that move, and where they come from: the greatest alone,
    // or all of them. Of more than `most_needs` those are left whose ranks are evenly spaced.
    class Needs {
      public:
        static constexpr std::size_t most_needs = 64;

        void add(double need, const Choice& where, bool all) {
            if (all || list_.empty()) {
                list_.push_back({need, where});
            } else if (need > list_.front().need) {
                list_.front() = {need, where};
            }
        }
        void thin() {
            if (list_.size() < 2) {
                return;
            }
            std::ranges::stable_sort(list_, std::ranges::greater{}, &Need::need);
            const auto equal = [](const Need& one, const Need& next) { return one.need == next.need; };
            list_.erase(std::unique(list_.begin(), list_.end(), equal), list_.end());
            if (list_.size() > most_needs) {
                const double step = static_cast<double>(list_.size() - 1) / (most_needs - 1);
                for (std::size_t place = 1; place < most_needs; ++place) {
                    list_[place] = list_[static_cast<std::size_t>(std::lround(static_cast<double>(place) * step))];
                }
                list_.resize(most_needs);
            }
        }
        const std::vector<Need>& list() const { return list_; }

      private:
        std::vector<Need> list_;  // once thin: from the greatest down
    };

    // There is none where the wedge does not push.
    std::optional<Push> wedge_push(const PathWedge& wedge, double factor) const {
        const SlideHeadThrust<> thrust =
            slide_head_thrust(wedge.loads, base_dip_, std::tan(problem_.columns->friction_angle), factor);
        return thrust.force > 0 ? std::optional(Push{thrust.force, thrust.shear / thrust.force,
                                                     std::max(0.0, wedge.depth - thrust.height)})
                                : std::nullopt;
    }

    // The push that the surface's toe lacks, negative where it stands or where a column of it stays; from the top down,
    // `visit` gets the place of each column in the path, the push on it and what it needs.
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

    // The surface whose toe lacks most at a strength.
    double most_lacking(double factor, LatticePath& path) const {
        const ColumnLaw law(problem_, strength_, factor);
        const std::size_t count = lattice_.cells.size();
        const std::size_t levels = lattice_.levels;
        const bool all = std::ranges::any_of(lattice_.cells, [&](const std::vector<PathCell>& column) {
            return std::ranges::any_of(column,
                                       [&](const PathCell& cell) { return cell.exists && law.may_be_steadied(cell); });
        });
        std::vector<Needs> chosen(count * levels);
        // Needs of the next column on each level or a higher one.
        std::vector<Needs> above(levels);
        double most = -infinity;
        Choice toe{};
        std::size_t first = 0;
        std::vector<std::optional<Push>> pushes;
        for (std::size_t column = count; column-- > 0;) {
            const bool crack_allowed = lattice_.retreat(lattice_.column_outcrop[column]) >= lattice_.least_width;
            pushes.clear();
            for (const PathWedge& wedge : lattice_.wedges[column]) {
                pushes.push_back(wedge_push(wedge, factor));
            }
            std::vector<Needs> here(levels);
            for (std::size_t level = levels; level-- > 0;) {
                if (level + 1 < levels) {
                    here[level] = here[level + 1];
                }
                const PathCell& cell = lattice_.cells[column][level];
                if (!cell.exists) {
                    continue;
                }
                Needs& own = chosen[column * levels + level];
                // A column that needs nothing does not move; at the face any surface counts.
                const auto offer = [&](const Push& push, const Choice& above_it) {
                    const double need = law.needed(cell, push);
                    if (cell.at_face || need > 0) {
                        own.add(need, above_it, all);
                    }
                };
                for (const Need& need : above[level].list()) {
                    offer(law.from(need.need), need.where);
                }
                if (crack_allowed) {
                    offer({}, {levels, no_wedge, 0});
                }
                for (std::size_t index = 0; index < pushes.size(); ++index) {
                    if (pushes[index] && lattice_.wedges[column][index].depth <= cell.upper_reach) {
                        offer(*pushes[index], {levels, index, 0});
                    }
                }
                own.thin();
                if (!cell.at_face) {
                    for (std::size_t place = 0; place < own.list().size(); ++place) {
                        here[level].add(own.list()[place].need, {level, no_wedge, place}, all);
                    }
                    here[level].thin();
                } else if (!own.list().empty() && own.list().front().need > most) {
                    most = own.list().front().need;
                    first = column;
                    toe = {level, no_wedge, 0};
                }
            }
            above = std::move(here);
        }
        path = {first + 1, {}, {}};
        if (!(most > -infinity)) {
            return most;
        }
        for (std::size_t column = first;; ++column) {
            path.level.push_back(toe.level);
            toe = chosen[column * levels + toe.level].list()[toe.place].where;
            if (toe.level == levels) {
                if (toe.wedge != no_wedge) {
                    path.wedge = toe.wedge;
                }
                return most;
            }
        }
    }

    // Below `failing`, at which the surface lacks something.
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
        // Past the edge, where it moves.
        const double factor = std::exp(edge_in(lacks, bracket)) * (1 + 1e-12);
        // In equilibrium there unless what the toe lacks jumps, as where a column above begins to move.
        double scale = 0;
        for (std::size_t index = 0; index < path.level.size(); ++index) {
            const PathCell& cell = lattice_.cells[path.first + index - 1][path.level[index]];
            scale += std::abs(cell.normal) + std::abs(cell.down_dip);
        }
        constexpr double share = 1e-6;
        return {lacking(path, factor) <= share * scale ? LimitState::found : LimitState::abrupt, factor, evaluations};
    }

    CriticalPath search() const {
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
            // Just before the edge: that surface itself stands there.
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
    SurfaceStrength strength_;
    double base_dip_;  // of normals to the joints between columns
};

}  // namespace

CriticalPath least_stable_path(const SteppedPath& problem, const PathLattice& lattice) {
    return problem.search.mechanism == SteppedPathMechanism::sliding ? least_stable_sliding(problem, lattice)
                                                                     : ColumnSearch(problem, lattice).search();
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
            const double turning = cell.at_face
                                       ? law.overturning(cell, push) / std::max(cell.upper_reach, cell.base_length)
                                       : law.against_turning(cell, push);
            const double sliding = cell.at_face ? law.unresisted(cell, push) : law.against_sliding(cell, push);
            column.mode = turning >= sliding ? ColumnMode::topples : ColumnMode::slides;
        });
    return columns;
}

}  // namespace delabole
