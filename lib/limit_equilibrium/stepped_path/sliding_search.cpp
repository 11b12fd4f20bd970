#include "limit_equilibrium/stepped_path/path_search.hpp"

#include "limit_equilibrium/stepped_path/surface_strength.hpp"
#include "numerics/constants.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace delabole {

namespace {

struct Ratio {
    double resisting = 0;
    double driving = 0;

    Ratio operator+(const Ratio& other) const { return {resisting + other.resisting, driving + other.driving}; }
    double less(double factor) const { return resisting - factor * driving; }
};

class SlidingGraph {
  public:
    SlidingGraph(const SteppedPath& problem, const PathLattice& lattice)
        : lattice_(lattice),
          strength_(problem),
          unit_weight_(problem.rock.unit_weight),
          dip_(problem.steps.dip),
          opening_(problem.risers->dip - problem.steps.dip) {
        const std::size_t count = lattice.riser_node.size();
        start_.assign(count, std::vector<std::optional<Ratio>>(lattice.levels));
        step_ = start_;
        rise_ = start_;
        finish_ = start_;
        for (std::size_t riser = 0; riser < count; ++riser) {
            for (std::size_t level = 0; level < lattice.levels; ++level) {
                add_edges(riser, level);
            }
        }
    }

    Ratio along(const LatticePath& path) const {
        Ratio sum = *start_[path.first][path.level.front()];
        for (std::size_t index = 0; index < path.level.size(); ++index) {
            const std::size_t riser = path.first + index;
            const bool last = index + 1 == path.level.size();
            if (last) {
                return sum + *finish_[riser][path.level[index]];
            }
            for (std::size_t level = path.level[index]; level < path.level[index + 1]; ++level) {
                sum = sum + *rise_[riser][level];
            }
            sum = sum + *step_[riser + 1][path.level[index + 1]];
        }
        return sum;
    }

    // The path with the least sum of resistance - factor times driving force, or of the negative driving force alone if
    // the factor is infinite.
    std::optional<LatticePath> least(double factor) const {
        const auto cost = [&](const Ratio& ratio) { return factor < infinity ? ratio.less(factor) : -ratio.driving; };
        enum class Came : unsigned char { nowhere, face, step, below };
        const std::size_t count = start_.size();
        std::vector<std::vector<Came>> came(count, std::vector<Came>(lattice_.levels, Came::nowhere));
        std::vector<double> before(lattice_.levels, infinity);  // at the riser before
        double best = infinity;
        std::size_t best_riser = 0;
        std::size_t best_level = 0;
        for (std::size_t riser = 0; riser < count; ++riser) {
            std::vector<double> here(lattice_.levels, infinity);
            for (std::size_t level = 0; level < lattice_.levels; ++level) {
                const auto offer = [&](double value, Came from) {
                    if (value < here[level]) {
                        here[level] = value;
                        came[riser][level] = from;
                    }
                };
                if (start_[riser][level]) {
                    offer(cost(*start_[riser][level]), Came::face);
                }
                if (step_[riser][level]) {
                    offer(before[level] + cost(*step_[riser][level]), Came::step);
                }
                if (level > 0 && rise_[riser][level - 1]) {
                    offer(here[level - 1] + cost(*rise_[riser][level - 1]), Came::below);
                }
                if (finish_[riser][level] && here[level] + cost(*finish_[riser][level]) < best) {
                    best = here[level] + cost(*finish_[riser][level]);
                    best_riser = riser;
                    best_level = level;
                }
            }
            before = std::move(here);
        }
        if (!(best < infinity)) {
            return std::nullopt;
        }
        LatticePath path;
        path.level.push_back(best_level);
        std::size_t riser = best_riser;
        for (std::size_t level = best_level; came[riser][level] != Came::face;) {
            if (came[riser][level] == Came::below) {
                --level;
                path.level.back() = level;
            } else {
                --riser;
                path.level.push_back(level);
            }
        }
        path.first = riser;
        std::ranges::reverse(path.level);
        return path;
    }

  private:
    Ratio on_step(const Point& from, const Point& to) const {
        const double weight = unit_weight_ * lattice_.area_above(from, to);
        const double uplift = lattice_.water_on(from, to).force;
        return {
            strength_.step_cohesion * (to - from).norm() + strength_.step_friction * (weight * std::cos(dip_) - uplift),
            weight * std::sin(dip_)};
    }
    Ratio on_riser(const Point& from, const Point& to) const {
        const double weight = unit_weight_ * lattice_.area_above(from, to);
        const double water = lattice_.water_on(from, to).force;
        return {strength_.step_friction * (weight * std::cos(dip_) - water * std::cos(opening_)) +
                    strength_.riser_tension * (to - from).norm() * std::sin(opening_),
                weight * std::sin(dip_) + water * std::sin(opening_)};
    }
    void add_edges(std::size_t riser, std::size_t level) {
        const auto& node = lattice_.riser_node[riser];
        if (!node[level]) {
            return;
        }
        const bool inner = riser > 0 && lattice_.riser_node[riser - 1][level];
        if (inner) {
            step_[riser][level] = on_step(*lattice_.riser_node[riser - 1][level], *node[level]);
        } else if (const auto face = lattice_.face_point(level)) {
            start_[riser][level] = on_step(*face, *node[level]);
        }
        if (level + 1 < lattice_.levels && node[level + 1]) {
            rise_[riser][level] = on_riser(*node[level], *node[level + 1]);
        }
        if (lattice_.retreat(lattice_.riser_outcrop[riser]) >= lattice_.least_width) {
            finish_[riser][level] = on_riser(*node[level], lattice_.riser_outcrop[riser]);
        }
    }

    const PathLattice& lattice_;
    SurfaceStrength strength_;
    double unit_weight_;
    double dip_;
    double opening_;
    // Tables by riser and level: edges from the face, from the riser before, to the level above, to the ground.
    std::vector<std::vector<std::optional<Ratio>>> start_, step_, rise_, finish_;
};

Limit limit_of(const Ratio& ratio) {
    if (!(ratio.driving > 0)) {
        return {LimitState::holds_at_any_strength, infinity, 1};
    }
    if (!(ratio.resisting > 0)) {
        return {LimitState::fails_at_any_strength, 0, 1};
    }
    return {LimitState::found, ratio.resisting / ratio.driving, 1};
}

}  // namespace

CriticalPath least_stable_sliding(const SteppedPath& problem, const PathLattice& lattice) {
    const SlidingGraph graph(problem, lattice);
    CriticalPath critical;
    critical.factor_of_safety = infinity;
    for (double factor = infinity; critical.searches < most_searches;) {
        const auto path = graph.least(factor);
        ++critical.searches;
        if (!path) {
            return critical;
        }
        const Limit limit = limit_of(graph.along(*path));
        if (!(limit.value < factor)) {
            break;
        }
        critical.path = *path;
        critical.limit = limit.state;
        critical.factor_of_safety = limit.value;
        factor = limit.value;
        if (limit.state != LimitState::found) {
            break;
        }
    }
    return critical;
}

Limit sliding_limit(const SteppedPath& problem, const PathLattice& lattice, const LatticePath& path) {
    return limit_of(SlidingGraph(problem, lattice).along(path));
}

}  // namespace delabole
