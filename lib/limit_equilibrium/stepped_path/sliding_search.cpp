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

bool is_plane(const LatticePath& path) {
    return path.ends_on_step && path.level.size() == 1;
}

enum class LastPart { riser, riser_or_step };

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
        run_out_ = start_;
        plane_.resize(lattice.levels);
        for (std::size_t level = 0; level < lattice.levels; ++level) {
            bool has_riser = false;
            for (std::size_t riser = 0; riser < count; ++riser) {
                add_edges(riser, level);
                has_riser = has_riser || lattice.riser_node[riser][level];
            }
            if (lattice.step_outcrop[level] && !has_riser) {
                plane_[level] = on_step(*lattice.face_point(level), *lattice.step_outcrop[level]);
            }
        }
    }

    Ratio along(const LatticePath& path) const {
        if (is_plane(path)) {
            return *plane_[path.level.front()];
        }
        Ratio sum = *start_[path.first][path.level.front()];
        for (std::size_t index = 0; index + 1 < path.level.size(); ++index) {
            const std::size_t riser = path.first + index;
            const std::size_t above = path.level[index + 1];
            for (std::size_t level = path.level[index]; level < above; ++level) {
                sum = sum + *rise_[riser][level];
            }
            const bool comes_out = path.ends_on_step && index + 2 == path.level.size();
            sum = sum + (comes_out ? *run_out_[riser][above] : *step_[riser + 1][above]);
        }
        return path.ends_on_step ? sum : sum + *finish_[path.first + path.level.size() - 1][path.level.back()];
    }

    // The path with the least sum of resistance - factor times driving force, or of the negative driving force alone if
    // the factor is infinite.
    std::optional<LatticePath> least(double factor, LastPart last_part) const {
        const auto cost = [&](const Ratio& ratio) { return factor < infinity ? ratio.less(factor) : -ratio.driving; };
        enum class Came : unsigned char { nowhere, face, step, below };
        const std::size_t count = start_.size();
        std::vector<std::vector<Came>> came(count, std::vector<Came>(lattice_.levels, Came::nowhere));
        std::vector<double> before(lattice_.levels, infinity);  // at the riser before
        double best = infinity;
        std::size_t best_riser = 0;
        std::size_t best_level = 0;
        bool ends_on_step = false;
        const auto end = [&](double before_it, const std::optional<Ratio>& last, std::size_t riser, std::size_t level,
                             bool on_step) {
            if (last && before_it + cost(*last) < best) {
                best = before_it + cost(*last);
                best_riser = riser;
                best_level = level;
                ends_on_step = on_step;
            }
        };
        const bool on_steps = last_part == LastPart::riser_or_step;
        for (std::size_t level = 0; on_steps && level < lattice_.levels; ++level) {
            end(0, plane_[level], count, level, true);
        }
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
                end(here[level], finish_[riser][level], riser, level, false);
                if (on_steps) {
                    end(here[level], run_out_[riser][level], riser, level, true);
                }
            }
            before = std::move(here);
        }
        if (!(best < infinity)) {
            return std::nullopt;
        }
        LatticePath path;
        path.ends_on_step = ends_on_step;
        path.level.push_back(best_level);
        if (best_riser == count) {
            return path;
        }
        if (ends_on_step) {
            path.level.push_back(best_level);  // on the last riser
        }
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
        if (lattice_.is_far_enough(lattice_.riser_outcrop[riser])) {
            finish_[riser][level] = on_riser(*node[level], lattice_.riser_outcrop[riser]);
        }
        const bool is_last = riser + 1 == lattice_.riser_node.size() || !lattice_.riser_node[riser + 1][level];
        if (lattice_.step_outcrop[level] && is_last) {
            run_out_[riser][level] = on_step(*node[level], *lattice_.step_outcrop[level]);
        }
    }

    const PathLattice& lattice_;
    SurfaceStrength strength_;
    double unit_weight_;
    double dip_;
    double opening_;
    // Tables by riser and level: edges from the face, from the riser before, to the level above, to the ground along
    // the riser and along the step.
    std::vector<std::vector<std::optional<Ratio>>> start_, step_, rise_, finish_, run_out_;
    std::vector<std::optional<Ratio>> plane_;  // steps from the face to the ground that no riser cuts
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

Limit least_stable_on_riser(const SteppedPath& problem, const PathLattice& lattice) {
    const SurfaceStrength strength(problem);
    Limit least{LimitState::holds_at_any_strength, infinity, 0};
    for (std::size_t riser = 0; riser < lattice.riser_outcrop.size(); ++riser) {
        const Point& to = lattice.riser_outcrop[riser];
        const std::optional<Point> from = lattice.riser_in_face(riser);
        if (!from || !lattice.is_far_enough(to)) {
            continue;
        }
        const double dip = problem.risers->dip;
        const double weight = problem.rock.unit_weight * lattice.area_above(*from, to);
        const double normal = weight * std::cos(dip) - lattice.water_on(*from, to).force;
        const Limit limit = limit_of(
            {strength.riser_cohesion * (to - *from).norm() + strength.riser_friction * normal, weight * std::sin(dip)});
        if (limit.value < least.value) {
            least = limit;
        }
    }
    return least;
}

CriticalPath least_stable_sliding(const SteppedPath& problem, const PathLattice& lattice) {
    // A surface that ends on a step has to be weaker by more than rounding: without cohesion all parts of one plane
    // have the same factor, and cracks mark where it opens.
    constexpr double weaker = 1 - 1e-9;
    const SlidingGraph graph(problem, lattice);
    CriticalPath critical;
    critical.factor_of_safety = infinity;
    for (const LastPart last_part : {LastPart::riser, LastPart::riser_or_step}) {
        for (double factor = critical.factor_of_safety; critical.searches < most_searches && factor > 0;) {
            const auto path = graph.least(factor, last_part);
            ++critical.searches;
            if (!path) {
                break;
            }
            const Limit limit = limit_of(graph.along(*path));
            if (!(limit.value < (last_part == LastPart::riser ? factor : weaker * factor))) {
                break;
            }
            critical.path = *path;
            critical.limit = limit.state;
            critical.factor_of_safety = factor = limit.value;
        }
    }
    return critical;
}

Limit sliding_limit(const SteppedPath& problem, const PathLattice& lattice, const LatticePath& path) {
    return limit_of(SlidingGraph(problem, lattice).along(path));
}

}  // namespace delabole
