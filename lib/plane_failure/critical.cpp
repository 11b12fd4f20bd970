#include "plane_failure/critical.hpp"

#include "numerics/scalar_search.hpp"
#include "plane_failure/dual.hpp"
#include "plane_failure/plane_failure.hpp"
#include "plane_failure/stability.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace delabole {

namespace {

constexpr int scan_points = 12;  // on every stretch without kink or jump
// Relative distance at which both sides of a kink or jump are evaluated: far above the rounding of a crack placed by
// its bottom, far below any visible effect on the factor of safety.
constexpr double beside_kink = 1e-12;

// Minimises a function on each stretch between the kinks or jumps of a range, and returns the least of these minima.
ScalarMinimum minimise_between(std::vector<double> kinks, double lower, double upper,
                               const std::function<ScalarMinimum(double, double)>& minimise) {
    const double beside = beside_kink * std::max(std::abs(lower), std::abs(upper));
    std::erase_if(kinks, [&](double kink) { return !(kink > lower + 4 * beside && kink < upper - 4 * beside); });
    std::ranges::sort(kinks);
    kinks.push_back(upper);
    ScalarMinimum least{lower, std::numeric_limits<double>::infinity(), true};
    double from = lower;
    for (const double kink : kinks) {
        const bool last = kink == upper;
        const double to = last ? upper : kink - beside;
        if (to > from) {
            ScalarMinimum minimum = minimise(from, to);
            const bool at_kink =
                (minimum.position <= from + beside && from > lower) || (minimum.position >= to - beside && !last);
            minimum.at_boundary = minimum.at_boundary && !at_kink;
            if (minimum.value < least.value) {
                least = minimum;
            }
            from = kink + beside;
        }
    }
    return least;
}

// The problem with varying geometry, in plain and in dual numbers; the dual one serves for derivatives.
class Search {
  public:
    Search(const PlaneFailure<>& problem, bool with_crack)
        : problem_(problem), dual_(with_scalar<PlaneFailure<Dual>>(problem)), with_crack_(with_crack) {
        for_each_number(dual_, [](Dual& number, const FieldInfo&) { number = constant(number.value()); });
    }

    const PlaneFailure<>& problem() const { return problem_; }
    int evaluations() const { return evaluations_; }
    PlaneFailureCheck first_failure() const { return first_failure_; }

    ScalarMinimum over_crack() {
        if (put_closed_form_crack()) {
            return {0, value(), false};
        }
        const double highest = highest_crack_base();
        // The scan is over the root of the height, because the factor of safety varies fastest where the mass is small.
        // A crack through the daylighting point leaves no mass; one at the highest base has no depth.
        const double root = std::sqrt(highest);
        std::vector<double> kinks = crack_kinks();
        std::ranges::transform(kinks, kinks.begin(), [](double height) { return std::sqrt(std::max(0.0, height)); });
        const auto value_at = [&](double u) { return put_crack(u * u), value(); };
        const auto slope_at = [&](double u) {
            put_crack(u * u);
            crack_position().base_below_crest = variable(crack_position().base_below_crest.value());
            return -slope();
        };
        ScalarMinimum minimum = minimise_between(std::move(kinks), root * 1e-3, root, [&](double from, double to) {
            return minimise_scalar(value_at, slope_at, from, to, scan_points);
        });
        minimum.position *= minimum.position;
        put_crack(minimum.position);
        return minimum;
    }

    ScalarMinimum over_plane(double lower, double upper) {
        bool crack_at_boundary = false;
        const auto least_over_crack = [&](double dip) {
            put_plane(dip);
            if (!with_crack_) {
                return value();
            }
            const ScalarMinimum crack = over_crack();
            crack_at_boundary = crack.at_boundary;
            return crack.value;
        };
        // The derivative of a minimum over the crack equals the derivative at the fixed critical crack (envelope
        // theorem). The crack is fixed by its top, because if the minimum is a kink, the crack opens at a corner of the
        // ground or at a load, which do not move. At an end of the range no fixed point is known, and at the pond's
        // level the bottom of the crack is fixed: a difference quotient has to do there.
        const auto slope_over_crack = [&](double dip) {
            if (!std::isfinite(least_over_crack(dip))) {
                return std::numeric_limits<double>::infinity();
            }
            if (crack_at_boundary || crack_ends_at_pond_level()) {
                constexpr double step = 1e-6;
                const double rise = least_over_crack(dip + step) - least_over_crack(dip - step);
                return rise / (2 * step);
            }
            if (with_crack_) {
                hold_crack_top();
            }
            dual_.failure_plane.dip = variable(dip);
            return slope();
        };
        ScalarMinimum minimum = minimise_between(plane_kinks(lower, upper), lower, upper, [&](double from, double to) {
            return minimise_scalar(least_over_crack, slope_over_crack, from, to, scan_points);
        });
        least_over_crack(minimum.position);
        minimum.at_boundary = minimum.at_boundary || crack_at_boundary;
        return minimum;
    }

    double value() {
        ++evaluations_;
        const FactorOfSafety result = factor_of_safety(problem_);
        if (result.check == PlaneFailureCheck::valid) {
            return result.value;
        }
        if (first_failure_ == PlaneFailureCheck::valid) {
            first_failure_ = result.check;
        }
        return std::numeric_limits<double>::infinity();
    }

  private:
    CrackBaseBelowCrest<Dual>& crack_position() {
        return std::get<CrackBaseBelowCrest<Dual>>(dual_.tension_crack->position);
    }

    void put_crack(double base_height) {
        const double below = problem_.slope.height - problem_.failure_plane.daylight_height.value_or(0.0) - base_height;
        problem_.tension_crack->position = CrackBaseBelowCrest<>{below};
        dual_.tension_crack->position = CrackBaseBelowCrest<Dual>{constant(below)};
    }

    // With dry, level ground behind the crest, a linear strength law with cohesion, and no force that does not grow
    // with the weight, the factor of safety depends on the crack through base length over weight alone, which is least
    // for
    //     h = H sqrt((cot f - cot t) / (cot p - cot t)),
    // h the height of the crack's bottom, H that of the crest, above the daylighting point; f, t, p the dips of face,
    // crack and plane. For a vertical crack that is Hoek & Bray's z_c = H (1 - sqrt(cot f tan p)). For cracks in the
    // face the factor decreases all the way up, so the minimum is there only if the crack opens behind the crest.
    bool put_closed_form_crack() {
        if (!closed_form_applies_) {
            return false;
        }
        const double crack_dip = problem_.tension_crack->dip;
        const double plane_dip = problem_.failure_plane.dip;
        const double face_dip = problem_.slope.face_dip;
        const double crest_height = problem_.slope.height - problem_.failure_plane.daylight_height.value_or(0.0);
        // cot a - cot b = sin(b - a) / (sin a sin b)
        const double share = std::sin(crack_dip - face_dip) * std::sin(plane_dip) /
                             (std::sin(crack_dip - plane_dip) * std::sin(face_dip));
        if (!(share > 0 && share < 1)) {
            return false;
        }
        put_crack(crest_height * std::sqrt(share));
        Wedge<double> wedge;
        return make_wedge(problem_, wedge) == PlaneFailureCheck::valid && wedge.crack_top_x > wedge.crest_x;
    }

    bool closed_form_applies() const {
        const auto linear_with_cohesion = [](const auto& law) {
            if constexpr (requires { law.cohesion + law.friction_angle; }) {
                return law.cohesion > 0;
            } else {
                return false;
            }
        };
        return problem_.tension_crack && std::holds_alternative<Dry>(problem_.water) && !problem_.pond &&
               !problem_.slope.bench && problem_.slope.upper_surface_dip == 0 && problem_.surcharge.empty() &&
               problem_.line_load.empty() && problem_.bolt.empty() &&
               std::visit(linear_with_cohesion, problem_.strength);
    }

    bool crack_ends_at_pond_level() const {
        if (!with_crack_ || !problem_.pond) {
            return false;
        }
        const auto* position = std::get_if<CrackBaseBelowCrest<>>(&problem_.tension_crack->position);
        const double height = problem_.slope.height;
        return position != nullptr &&
               std::abs(height - position->base_below_crest - problem_.pond->depth) < 1e-9 * height;
    }

    // Distances behind the crest at which the factor of safety has a kink or a jump if the mass ends there: corners of
    // the ground, line loads, the ends of surcharges, and heads of bolts.
    std::vector<double> kinks_of_mass_end() const {
        std::vector<double> distances = {0};
        if (problem_.slope.bench) {
            distances.push_back(problem_.slope.bench->width);
        }
        for (const LineLoad<>& load : problem_.line_load) {
            distances.push_back(load.distance_behind_crest);
        }
        for (const Surcharge<>& surcharge : problem_.surcharge) {
            distances.push_back(surcharge.from_distance);
            distances.push_back(surcharge.to_distance);
        }
        // A crack in the face in front of a bolt's head leaves the bolt out of the mass.
        const auto add_head = [&](double height) {
            distances.push_back((height - problem_.slope.height) / std::tan(problem_.slope.face_dip));
        };
        for (const Bolt<>& bolt : problem_.bolt) {
            add_head(bolt.head_height);
        }
        for (const PlaneSupport<>& support : problem_.support) {
            for (int row = 0; row < static_cast<int>(support.pattern.rows); ++row) {
                add_head(support.pattern.head_height(row));
            }
        }
        return distances;
    }

    // Heights, above the daylighting point, of the bottom of a crack at which the factor of safety has a kink or a
    // jump: those of cracks that open at one of these distances, and those at which water pressure on the base has a
    // corner.
    std::vector<double> crack_kinks() const {
        std::vector<double> heights;
        PlaneFailure<> moved = problem_;
        for (const double distance : kinks_of_mass_end()) {
            moved.tension_crack->position = CrackAtDistance<>{distance};
            Wedge<double> wedge;
            if (make_wedge(moved, wedge) == PlaneFailureCheck::valid) {
                heights.push_back(wedge.base_top_height());
            }
        }
        const double daylight = problem_.failure_plane.daylight_height.value_or(0.0);
        if (problem_.pond) {
            heights.push_back(problem_.pond->depth - daylight);
        }
        if (const auto* line = std::get_if<PiezometricLineWater<>>(&problem_.water)) {
            const double daylight_x = daylight / std::tan(problem_.slope.face_dip);
            for (const PiezometricPoint<>& point : line->point) {
                heights.push_back((point.x - daylight_x) * std::tan(problem_.failure_plane.dip));
            }
        }
        return heights;
    }

    // Dips of the plane at which its mass ends at one of these distances, if the crack is absent or fixed. A searched
    // crack passes them at every dip.
    std::vector<double> plane_kinks(double lower, double upper) const {
        std::vector<double> dips;
        if (with_crack_) {
            return dips;
        }
        PlaneFailure<> turned = problem_;
        const auto mass_end = [&](double dip) {
            turned.failure_plane.dip = dip;
            Wedge<double> wedge;
            return make_wedge(turned, wedge) == PlaneFailureCheck::valid ? wedge.crack_top_x - wedge.crest_x
                                                                         : std::numeric_limits<double>::quiet_NaN();
        };
        constexpr int intervals = 48;
        const std::vector<double> distances = kinks_of_mass_end();
        double left = lower;
        double left_end = mass_end(left);
        for (int index = 1; index <= intervals; ++index) {
            const double right = lower + (upper - lower) * index / intervals;
            const double right_end = mass_end(right);
            for (const double distance : distances) {
                const bool beyond = left_end > distance;
                if (std::isnan(left_end) || std::isnan(right_end) || beyond == (right_end > distance)) {
                    continue;
                }
                double from = left;
                double to = right;
                for (int halving = 0; halving < 60; ++halving) {
                    const double middle = from + (to - from) / 2;
                    ((mass_end(middle) > distance) == beyond ? from : to) = middle;
                }
                dips.push_back(from);
            }
            left = right;
            left_end = right_end;
        }
        return dips;
    }

    void hold_crack_top() {
        Wedge<double> wedge;
        make_wedge(problem_, wedge);
        dual_.tension_crack->position = CrackAtDistance<Dual>{constant(wedge.crack_top_x - wedge.crest_x)};
    }

    void put_plane(double dip) {
        problem_.failure_plane.dip = dip;
        dual_.failure_plane.dip = constant(dip);
    }

    // Derivative of the factor of safety with respect to the one dual variable that is set.
    double slope() {
        ++evaluations_;
        const Equilibrium<Dual> forces = evaluate(dual_);
        return forces.check == PlaneFailureCheck::valid ? forces.stability.factor_of_safety.derivatives()(0)
                                                        : std::numeric_limits<double>::infinity();
    }

    // The height above the daylighting point at which the plane would meet the ground without a crack.
    double highest_crack_base() const {
        PlaneFailure<> uncracked = problem_;
        uncracked.tension_crack.reset();
        Wedge<double> wedge;
        const PlaneFailureCheck check = make_wedge(uncracked, wedge);
        if (check == PlaneFailureCheck::valid) {
            return wedge.base_top_height();
        }
        const double far = wedge.crest_x + 20 * problem_.slope.height;
        return check == PlaneFailureCheck::plane_never_surfaces ? far * std::tan(problem_.failure_plane.dip) : 0;
    }

    PlaneFailure<> problem_;
    PlaneFailure<Dual> dual_;
    bool with_crack_;
    bool closed_form_applies_ = closed_form_applies();
    int evaluations_ = 0;
    PlaneFailureCheck first_failure_ = PlaneFailureCheck::valid;
};

ScalarMinimum minimise(Search& search, const CriticalSearch<>& request, bool with_crack) {
    if (request.find == CriticalFeature::tension_crack) {
        return with_crack ? search.over_crack() : ScalarMinimum{0, search.value(), false};
    }
    const double face_dip = search.problem().slope.face_dip;
    // The mass vanishes as the plane approaches the face.
    const double lower = std::max(request.lower_dip.value_or(degrees(1)), degrees(0.01));
    const double upper = std::min(request.upper_dip.value_or(face_dip), face_dip - degrees(0.01));
    return lower < upper ? search.over_plane(lower, upper)
                         : ScalarMinimum{lower, std::numeric_limits<double>::infinity(), true};
}

}  // namespace

CriticalGeometry find_critical_geometry(const PlaneFailure<>& problem, const CriticalSearch<>& request) {
    const PlaneFailureCheck ranges = check_ranges(problem);
    if (ranges != PlaneFailureCheck::valid) {
        return {ranges, problem, 0, false, 0};
    }
    const bool with_crack = request.find != CriticalFeature::failure_plane && problem.tension_crack;
    PlaneFailure<> searched = problem;
    if (request.under == SearchCondition::dry_slope) {
        searched.water = Dry{};
        searched.pond.reset();
    }
    if (!searched.tension_cutoff || searched.tension_cutoff->tensile_strength == 0) {
        searched.tension_cutoff = TensionCutoff<>{std::numeric_limits<double>::max()};
    }
    Search search(searched, with_crack);
    const ScalarMinimum minimum = minimise(search, request, with_crack);
    if (!std::isfinite(minimum.value)) {
        const PlaneFailureCheck reason = search.first_failure() == PlaneFailureCheck::valid
                                             ? PlaneFailureCheck::mass_vanishes
                                             : search.first_failure();
        return {reason, problem, 0, false, search.evaluations()};
    }
    PlaneFailure<> found = problem;
    found.failure_plane = search.problem().failure_plane;
    found.tension_crack = search.problem().tension_crack;
    return {PlaneFailureCheck::valid, found, minimum.value, minimum.at_boundary, search.evaluations()};
}

}  // namespace delabole
