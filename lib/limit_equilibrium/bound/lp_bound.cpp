#include "limit_equilibrium/bound/lp_bound.hpp"

#include "limit_equilibrium/bound/lp_residuals.hpp"

#include <glpk.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace delabole {

namespace {

using detail::friction_of;
using detail::horizontal_weights;
using detail::refused_bound;
using detail::Scales;
using detail::scales_of;
using detail::Sense;
using detail::solve;
using detail::Sought;

// GLPK keeps one environment for each thread, with its own switch for printing; both are left as they were.
class SolverEnvironment {
  public:
    SolverEnvironment() : created_(glp_init_env() == 0), terminal_(glp_term_out(GLP_OFF)) {}
    ~SolverEnvironment() {
        if (created_) {
            glp_free_env();
        } else {
            glp_term_out(terminal_);
        }
    }
    SolverEnvironment(const SolverEnvironment&) = delete;
    SolverEnvironment& operator=(const SolverEnvironment&) = delete;

  private:
    bool created_;
    int terminal_;
};

struct DeleteProblem {
    void operator()(glp_prob* problem) const { glp_delete_prob(problem); }
};
using Problem = std::unique_ptr<glp_prob, DeleteProblem>;

// Columns: the sought factor; then for every contact the edges of the cone at its start and at its end, with cohesion
// its shear, and with tensile strength the tension at either end. Rows: forces along x and y and moment of each body.
class Programme {
  public:
    Programme(const Assembly& assembly, const Scales& scales, const Sought& sought, double strength)
        : assembly_(assembly), scales_(scales), sought_(sought), strength_(strength), problem_(glp_create_prob()) {
        set_rows();
        set_columns();
        glp_load_matrix(problem_.get(), static_cast<int>(values_.size()) - 1, rows_.data(), columns_.data(),
                        values_.data());
    }

    // A failure is nearly always a basis that lost its accuracy; another start is tried then, and after it another
    // method. A lost basis may also wrongly report that there is no solution: two starts have to agree on that.
    LpStatus solve() {
        LpStatus last = LpStatus::not_converged;
        for (const int method : {GLP_PRIMAL, GLP_DUALP}) {
            for (const bool advanced : {true, false}) {
                if (advanced) {
                    glp_adv_basis(problem_.get(), 0);
                } else {
                    glp_std_basis(problem_.get());
                }
                const LpStatus status = solve_from_basis(method);
                if (status == LpStatus::optimal || (status != LpStatus::not_converged && status == last)) {
                    return status;
                }
                last = status;
            }
        }
        return LpStatus::not_converged;
    }

    int iterations() const { return glp_get_it_cnt(problem_.get()); }
    double factor() const { return glp_get_col_prim(problem_.get(), 1); }

    std::vector<BoundContactForce> forces() const {
        std::vector<BoundContactForce> forces;
        int column = 2;
        const auto next = [&] { return scales_.force * glp_get_col_prim(problem_.get(), column++); };
        for (const Contact& contact : assembly_.contacts) {
            const double friction = friction_of(contact, strength_);
            BoundContactForce force{};
            for (EndForce* end : {&force.at_start, &force.at_end}) {
                const double forward = next();
                const double backward = next();
                end->normal = (forward + backward) * std::cos(friction);
                end->shear = (forward - backward) * std::sin(friction);
            }
            if (contact.cohesion > 0) {
                const double half = next() / 2;
                force.at_start.shear += half;
                force.at_end.shear += half;
            }
            if (contact.tensile_strength > 0) {
                force.at_start.normal -= next();
                force.at_end.normal -= next();
            }
            const double normal = force.normal();
            force.position = contact.length() * (normal > 0 ? force.at_end.normal / normal : 0.5);
            forces.push_back(force);
        }
        return forces;
    }

    // The shadow prices of the rows: the decrease of the factor per unit of load on a body. The sign is that of the
    // motion in which the sought load does positive work when its factor is made as large as possible.
    std::vector<VirtualMotion> mechanism() const {
        const double sign = sought_.sense == Sense::largest ? 1 : -1;
        return mechanism_of([&](int row) { return sign * glp_get_row_dual(problem_.get(), row); });
    }

    // Adds a force in both directions to every row and minimises their sum; the factor has to be fixed at 0. The
    // interior-point method is used, and the simplex method if that fails.
    LeastImbalance least_imbalance() {
        if (may_overflow()) {
            return {LpStatus::not_converged, AssemblyCheck::valid, 0, {}};
        }
        glp_set_obj_coef(problem_.get(), 1, 0);
        const int rows = glp_get_num_rows(problem_.get());
        for (int row = 1; row <= rows; ++row) {
            for (const double sign : {1.0, -1.0}) {
                const int column = glp_add_cols(problem_.get(), 1);
                glp_set_col_bnds(problem_.get(), column, GLP_LO, 0, 0);
                glp_set_obj_coef(problem_.get(), column, 1);
                const std::array<int, 2> of_row{0, row};
                const std::array<double, 2> entry{0, sign};
                glp_set_mat_col(problem_.get(), column, 1, of_row.data(), entry.data());
            }
        }
        glp_iptcp control;
        glp_init_iptcp(&control);
        control.msg_lev = GLP_MSG_OFF;
        control.ord_alg = GLP_ORD_AMD;
        if (glp_interior(problem_.get(), &control) == 0 && glp_ipt_status(problem_.get()) == GLP_OPT) {
            return {LpStatus::optimal, AssemblyCheck::valid, std::max(glp_ipt_obj_val(problem_.get()), 0.0),
                    mechanism_of([&](int row) { return -glp_ipt_row_dual(problem_.get(), row); })};
        }
        const LpStatus status = solve();
        if (status != LpStatus::optimal) {
            return {status, AssemblyCheck::valid, 0, {}};
        }
        return {status, AssemblyCheck::valid, std::max(glp_get_obj_val(problem_.get()), 0.0), mechanism()};
    }

  private:
    // Whether loads or strengths are so far beyond the weights that GLPK's interior-point method would end the process.
    bool may_overflow() const {
        constexpr double most = 1e100;
        for (int row = 1; row <= glp_get_num_rows(problem_.get()); ++row) {
            if (!(std::abs(glp_get_row_ub(problem_.get(), row)) <= most)) {
                return true;
            }
        }
        for (int column = 1; column <= glp_get_num_cols(problem_.get()); ++column) {
            if (glp_get_col_type(problem_.get(), column) == GLP_DB &&
                !(glp_get_col_ub(problem_.get(), column) <= most)) {
                return true;
            }
        }
        return false;
    }

    template <class PriceOf>
    std::vector<VirtualMotion> mechanism_of(const PriceOf& price_of) const {
        std::vector<VirtualMotion> motions;
        double largest = 0;
        for (std::size_t body = 0; body < assembly_.bodies.size(); ++body) {
            const int row = first_row(body);
            const double turned = price_of(row + 2);
            motions.push_back({{price_of(row), price_of(row + 1)}, turned / scales_.arm[body]});
            largest = std::max({largest, motions.back().displacement.norm(), std::abs(turned)});
        }
        if (!(largest > 0)) {
            return {};  // the factor is at its own limit, and no load on a body changes it
        }
        for (VirtualMotion& motion : motions) {
            motion.displacement /= largest;
            motion.rotation /= largest;
        }
        return motions;
    }

    LpStatus solve_from_basis(int method) {
        glp_bfcp factors;
        glp_get_bfcp(problem_.get(), &factors);
        // With GLPK's defaults, 0.1 and 100, rows of a few hundred blocks lose all digits and the phase-one test is
        // wrong.
        factors.piv_tol = 0.9;
        factors.nfs_max = 20;
        glp_set_bfcp(problem_.get(), &factors);
        glp_smcp control;
        glp_init_smcp(&control);
        control.msg_lev = GLP_MSG_OFF;
        control.meth = method;
        control.tol_bnd = 1e-10;
        control.tol_dj = 1e-10;
        control.it_lim = 1000 + 100 * glp_get_num_rows(problem_.get());
        if (glp_simplex(problem_.get(), &control) != 0) {
            return LpStatus::not_converged;
        }
        if (glp_get_status(problem_.get()) == GLP_OPT) {
            // Rounding errors accumulate in the updates of the factors: the answer is taken from a new factorization.
            if (glp_factorize(problem_.get()) != 0 || glp_warm_up(problem_.get()) != 0) {
                return LpStatus::not_converged;
            }
        }
        switch (glp_get_status(problem_.get())) {
        case GLP_OPT:
            return LpStatus::optimal;
        case GLP_UNBND:
            return LpStatus::unbounded;
        case GLP_NOFEAS:
            return LpStatus::infeasible;
        default:
            return LpStatus::not_converged;
        }
    }

    static int first_row(std::size_t body) { return static_cast<int>(3 * body) + 1; }

    void set_rows() {
        glp_set_obj_dir(problem_.get(), sought_.sense == Sense::largest ? GLP_MAX : GLP_MIN);
        glp_add_rows(problem_.get(), static_cast<int>(3 * assembly_.bodies.size()));
        for (std::size_t index = 0; index < assembly_.bodies.size(); ++index) {
            const Body& body = assembly_.bodies[index];
            const int row = first_row(index);
            const auto fix = [&](int offset, double value) {
                glp_set_row_bnds(problem_.get(), row + offset, GLP_FX, value, value);
            };
            fix(0, -body.load.force.x() / scales_.force);
            fix(1, (body.weight - body.load.force.y()) / scales_.force);
            fix(2, -body.load.moment / (scales_.force * scales_.arm[index]));
        }
    }

    void set_columns() {
        const int factor = glp_add_cols(problem_.get(), 1);
        const bool fixed = sought_.lower == sought_.upper;
        const int least = fixed ? GLP_FX : GLP_LO;
        glp_set_col_bnds(problem_.get(), factor, std::isfinite(sought_.lower) ? least : GLP_FR, sought_.lower,
                         sought_.upper);
        glp_set_obj_coef(problem_.get(), factor, 1);
        for (std::size_t index = 0; index < assembly_.bodies.size(); ++index) {
            const BodyLoad& load = sought_.load[index];
            add(index, factor, load.force / scales_.force, load.moment / scales_.force);
        }
        for (const Contact& contact : assembly_.contacts) {
            const double friction = friction_of(contact, strength_);
            const Point along = contact.along();
            const Point normal = contact.normal();
            for (const Point& point : {contact.start, contact.end}) {
                for (const double sign : {1.0, -1.0}) {
                    const int column = glp_add_cols(problem_.get(), 1);
                    glp_set_col_bnds(problem_.get(), column, contact.bears_compression ? GLP_LO : GLP_FX, 0, 0);
                    add_contact(contact, column, point,
                                Point(std::cos(friction) * normal + sign * std::sin(friction) * along));
                }
            }
            if (contact.cohesion > 0) {
                const int column = glp_add_cols(problem_.get(), 1);
                const double most = strength_ * contact.cohesion * contact.length() / scales_.force;
                glp_set_col_bnds(problem_.get(), column, most > 0 ? GLP_DB : GLP_FX, -most, most);
                add_contact(contact, column, contact.start, along);
            }
            if (contact.tensile_strength > 0) {
                const double most = strength_ * contact.tensile_strength * contact.length() / 2 / scales_.force;
                for (const Point& point : {contact.start, contact.end}) {
                    const int column = glp_add_cols(problem_.get(), 1);
                    glp_set_col_bnds(problem_.get(), column, most > 0 ? GLP_DB : GLP_FX, 0, most);
                    add_contact(contact, column, point, -normal);
                }
            }
        }
    }

    void add_contact(const Contact& contact, int column, const Point& point, const Point& force) {
        add(contact.body, column, force, cross(point - assembly_.bodies[contact.body].centroid, force));
        if (contact.other) {
            add(*contact.other, column, -force, -cross(point - assembly_.bodies[*contact.other].centroid, force));
        }
    }

    void add(std::size_t body, int column, const Point& force, double moment) {
        const std::array<double, 3> entries = {force.x(), force.y(), moment / scales_.arm[body]};
        for (int offset = 0; offset < 3; ++offset) {
            const double entry = entries[static_cast<std::size_t>(offset)];
            if (entry != 0) {
                rows_.push_back(first_row(body) + offset);
                columns_.push_back(column);
                values_.push_back(entry);
            }
        }
    }

    const Assembly& assembly_;
    const Scales& scales_;
    const Sought& sought_;
    double strength_;
    Problem problem_;
    // These arrays count from 1, as in GLPK.
    std::vector<int> rows_{0};
    std::vector<int> columns_{0};
    std::vector<double> values_{0};
};

}  // namespace

LpBound detail::solve(const Assembly& assembly, const Scales& scales, const Sought& sought, double strength) {
    const SolverEnvironment environment;
    LpBound bound;
    Programme programme(assembly, scales, sought, strength);
    bound.status = programme.solve();
    bound.iterations = programme.iterations();
    if (bound.status != LpStatus::optimal) {
        return bound;
    }
    bound.value = programme.factor();
    bound.forces = programme.forces();
    bound.mechanism = programme.mechanism();
    set_static_residuals(assembly, scales, sought, strength, bound);
    set_mechanism_residuals(assembly, sought, strength, bound);
    double largest_normal = 0;
    for (const BoundContactForce& force : bound.forces) {
        largest_normal = std::max(largest_normal, force.normal() / scales.force);
    }
    // Work of the force on a face that the mechanism closes by mistake would make the values differ.
    if (!(bound.residuals.imbalance <= 1e-7 && bound.residuals.cone_violation <= 1e-7 &&
          bound.residuals.mechanism_overlap * largest_normal <= 1e-6)) {
        LpBound failed;
        failed.iterations = bound.iterations;
        return failed;
    }
    return bound;
}

LpBound largest_tilt(const Assembly& assembly) {
    return largest_load_factor(assembly, horizontal_weights(assembly));
}

LpBound largest_load_factor(const Assembly& assembly, const std::vector<BodyLoad>& loads) {
    if (const AssemblyCheck check = check_assembly(assembly); check != AssemblyCheck::valid) {
        return refused_bound(check);
    }
    if (loads.size() != assembly.bodies.size() || !std::all_of(loads.begin(), loads.end(), [](const BodyLoad& load) {
            return load.force.allFinite() && std::isfinite(load.moment);
        })) {
        return refused_bound(AssemblyCheck::input_out_of_range);
    }
    return solve(assembly, scales_of(assembly), {loads}, 1);
}

LeastImbalance least_imbalance(const Assembly& assembly) {
    if (const AssemblyCheck check = check_assembly(assembly); check != AssemblyCheck::valid) {
        return {LpStatus::invalid_assembly, check, 0, {}};
    }
    const SolverEnvironment environment;
    const Scales scales = scales_of(assembly);
    const Sought nothing{std::vector<BodyLoad>(assembly.bodies.size()), Sense::least, 0, 0};
    return Programme(assembly, scales, nothing, 1).least_imbalance();
}

}  // namespace delabole
