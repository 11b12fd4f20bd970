#include "cases/program/models/plane_failure/figures.hpp"

#include "cases/program/reports/sensitivity_step.hpp"
#include "fitting/work/words.hpp"
#include "geometry/polygon.hpp"
#include "plane_failure/critical.hpp"
#include "plane_failure/water_diagram.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace delabole {

namespace {

constexpr int curve_points = 101;

// The level of the water, if its form has one.
WaterLevel<>* level_of(Water<>& water) {
    return std::visit(
        [](auto& form) -> WaterLevel<>* {
            if constexpr (requires { form.level; }) {
                return &form.level;
            } else {
                return nullptr;
            }
        },
        water);
}

double* cohesion_of(StrengthLaw<>& strength) {
    return std::visit(
        [](auto& law) -> double* {
            if constexpr (requires { law.cohesion; }) {
                return &law.cohesion;
            } else {
                return nullptr;
            }
        },
        strength);
}

double cohesion_at_failure(const PlaneFailureResult& result, double friction_angle) {
    return (result.driving_force - result.normal_force * std::tan(friction_angle)) / result.sliding_area;
}

Polyline failure_locus(const PlaneFailureResult& result) {
    Polyline locus;
    constexpr double steepest = degrees(80);
    for (int index = 0; index < curve_points; ++index) {
        const double friction_angle = steepest * index / (curve_points - 1);
        const double cohesion = cohesion_at_failure(result, friction_angle);
        if (cohesion < 0) {
            locus.emplace_back(std::atan2(result.driving_force, result.normal_force), 0.0);
            break;
        }
        locus.emplace_back(friction_angle, cohesion);
    }
    return locus;
}

double least_factor(PlaneFailure<> problem, const CriticalSearch<>& this_plane, CriticalFeature find) {
    if (find == CriticalFeature::both) {
        const CriticalGeometry critical = find_critical_geometry(problem, this_plane);
        return critical.check == PlaneFailureCheck::valid ? critical.factor_of_safety
                                                          : std::numeric_limits<double>::infinity();
    }
    if (this_plane.under == SearchCondition::dry_slope) {
        problem.water = Dry{};
        problem.pond.reset();
    }
    const FactorOfSafety result = factor_of_safety(problem);
    return result.check == PlaneFailureCheck::valid ? result.value : std::numeric_limits<double>::infinity();
}

}  // namespace

SectionDrawing section_drawing(const PlaneFailure<>& problem, const std::string& title) {
    SectionDrawing drawing;
    drawing.title = title;
    drawing.ground = ground_profile(problem);
    drawing.ground.insert(drawing.ground.begin(), Point(-problem.slope.height / 4, 0));
    drawing.toe_elevation = problem.slope.toe_elevation.value_or(0.0);
    const WaterDiagram water = water_diagram(problem);
    if (water.base.surface.empty()) {
        return drawing;
    }
    drawing.failure_plane = {water.base.surface.front(), water.base.surface.back()};
    if (!water.crack.surface.empty()) {
        drawing.tension_crack = {water.crack.surface.front(), water.crack.surface.back()};
        drawing.water_in_crack = water.water_in_crack;
    }
    for (const SurfacePressure* surface : {&water.base, &water.crack}) {
        if (std::any_of(surface->pressure.begin(), surface->pressure.end(), [](double p) { return p > 0; })) {
            drawing.water_pressure.push_back({surface->surface, surface->pressure});
        }
    }
    return drawing;
}

void annotate(const PlaneFailure<>& problem, const PlaneFailureResult& result, SectionDrawing& drawing) {
    const double height = problem.slope.height;
    const double left = -0.15 * height;
    drawing.measures.push_back({{left, 0}, {left, height}, value_in_words(height, Dimension::length)});
    const auto face_at = [&](double level) { return Point(level / std::tan(problem.slope.face_dip), level); };
    // The note stands beside the face or below the plane, at any place along it with enough room.
    const auto note = [&](const Polyline& line, const Point& beside, Label::Align align, double angle) {
        SectionNote dip{{}, value_in_words(angle, Dimension::angle)};
        for (const double share : {0.5, 0.75, 0.25, 0.9, 0.1}) {
            dip.places.push_back({line.front() + share * (line.back() - line.front()) + height * beside, align});
        }
        drawing.notes.push_back(std::move(dip));
    };
    note({face_at(height), face_at(0.6 * height)}, {-0.06, 0}, Label::Align::right, problem.slope.face_dip);
    if (drawing.failure_plane.empty()) {
        return;
    }
    const Point foot = drawing.failure_plane.front();
    const Point end = drawing.failure_plane.back();
    note({foot, end}, {0.03, -0.03}, Label::Align::left, result.plane_dip);
    const Point top = drawing.tension_crack.empty() ? end : drawing.tension_crack.back();
    Polyline mass{foot, end, top};
    for (std::size_t index = drawing.ground.size(); index-- > 0;) {
        const Point& corner = drawing.ground[index];
        if (corner.x() > foot.x() && corner.x() < top.x() && corner.y() > foot.y()) {
            mass.push_back(corner);
        }
    }
    const auto text = [](const std::string& name, double force) {
        return name + " " + number_in_words(force / shown_unit(Dimension::force_per_length).si_per_unit);
    };
    const Point along = (end - foot).normalized();
    drawing.forces = {
        {area_properties(mass).centroid, {0, -1}, result.weight, text("W", result.weight)},
        {foot + 0.5 * (end - foot),
         {-along.y(), along.x()},
         result.base_water_force,
         text("U", result.base_water_force)},
        {end + 0.2 * (top - end), {-1, 0}, result.crack_water_force, text("V", result.crack_water_force)}};
    const std::vector<std::vector<BoltRow>> support = support_rows(problem);
    for (std::size_t index = 0; index < support.size(); ++index) {
        const BoltPattern<>& pattern = problem.support[index].pattern;
        const Point of_bolts(std::cos(pattern.plunge), -std::sin(pattern.plunge));
        double force = 0;
        SectionNote bolts;
        for (const BoltRow& row : support[index]) {
            const Point tip = row.head + pattern.length * of_bolts;
            drawing.bolts.push_back({row.head, tip});
            bolts.places.push_back({tip + Point(0.02 * height, 0), Label::Align::left});
            bolts.places.push_back({tip - Point(0, 0.06 * height), Label::Align::centre});
            bolts.places.push_back({row.head - Point(0.03 * height, 0), Label::Align::right});
            force += row.force;
        }
        bolts.text = "bolts " + value_in_words(force, Dimension::force_per_length);
        drawing.notes.push_back(std::move(bolts));
    }
    for (const Bolt<>& bolt : problem.bolt) {
        drawing.forces.push_back({face_at(bolt.head_height),
                                  {std::cos(bolt.plunge), -std::sin(bolt.plunge)},
                                  bolt.force,
                                  text("bolt", bolt.force)});
    }
}

std::optional<WaterDepthCurves> water_depth_curves(const PlaneFailure<>& problem) {
    PlaneFailure<> varied = problem;
    WaterLevel<>* level = level_of(varied.water);
    double* cohesion = cohesion_of(varied.strength);
    if (level == nullptr || cohesion == nullptr) {
        return std::nullopt;
    }
    WaterDepthCurves curves;
    curves.title = "Factor of safety against depth of water";
    const double given = *cohesion;
    const double unit = given > 0 ? given : 50e3;
    for (const double value : {0.0, unit, 2 * unit}) {
        NamedCurve curve{.legend =
                             "c = " + value_in_words(value, Dimension::stress) + (value == given ? " (as given)" : "")};
        *cohesion = value;
        for (int index = 0; index < curve_points; ++index) {
            const double ratio = static_cast<double>(index) / (curve_points - 1);
            *level = FilledRatio<>{ratio};
            const FactorOfSafety result = factor_of_safety(varied);
            if (result.check == PlaneFailureCheck::valid && std::isfinite(result.value)) {
                curve.points.emplace_back(ratio, result.value);
            }
        }
        curves.curves.push_back(std::move(curve));
    }
    return curves;
}

FailureLoci failure_loci(const PlaneFailure<>& problem) {
    FailureLoci loci;
    loci.title = "Friction and cohesion at failure";
    if (const auto* law = std::get_if<Coulomb<>>(&problem.strength)) {
        loci.given = Point(law->friction_angle, law->cohesion);
    }
    PlaneFailure<> varied = problem;
    WaterLevel<>* level = level_of(varied.water);
    const auto add = [&](const std::string& legend) {
        const PlaneFailureResult result = analyse(varied);
        if (result.check == PlaneFailureCheck::valid) {
            loci.loci.push_back({legend, failure_locus(result)});
        }
    };
    if (level == nullptr) {
        add("");  // one curve needs no name
        return loci;
    }
    for (const double ratio : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        *level = FilledRatio<>{ratio};
        add("water level " + number_in_words(100 * ratio) + " %");
    }
    return loci;
}

std::vector<SensitivityBar> sensitivity_bars(const PlaneFailure<>& problem, const SensitivityResult& sensitivities,
                                             const InputDeviations& known) {
    const double height = problem.slope.height;
    const double overburden = problem.rock.unit_weight * height;
    std::vector<SensitivityBar> bars;
    for (const Sensitivity& input : sensitivities.derivatives) {
        const SensitivityStep step =
            sensitivity_step(input.parameter, known, input.dimension, input.value, height, overburden);
        const double effect = input.derivative * step.size;
        if (effect != 0) {
            bars.push_back({input.parameter, step.words, effect, step.by_rule && !known.empty()});
        }
    }
    return bars;
}

std::optional<CriticalSearchDrawing> critical_plane_drawing(const PlaneFailureStudy<>& study,
                                                            const ResolvedStudy& best) {
    if (!study.critical || study.critical->find == CriticalFeature::tension_crack) {
        return std::nullopt;
    }
    CriticalSearchDrawing drawing;
    drawing.title = "Search for the critical plane";
    drawing.quantity = "failure_plane.dip";
    drawing.dimension = Dimension::angle;
    drawing.critical = Point(best.problem.failure_plane.dip, best.least_factor_of_safety);
    NamedCurve curve;
    curve.legend =
        study.critical->find == CriticalFeature::both ? "crack at its critical place" : "least factor of safety";
    const double lower = study.critical->lower_dip.value_or(degrees(1));
    const double upper = study.critical->upper_dip.value_or(study.model.slope.face_dip);
    // A search whose range is this plane alone.
    CriticalSearch<> this_plane = *study.critical;
    this_plane.find = CriticalFeature::tension_crack;
    for (int index = 1; index + 1 < curve_points; ++index) {
        PlaneFailure<> problem = study.model;
        problem.failure_plane.dip = lower + (upper - lower) * index / (curve_points - 1);
        const double factor = least_factor(problem, this_plane, study.critical->find);
        // Near both ends the factor of safety increases without limit, but the figure is to show the minimum.
        if (factor < 4 * best.least_factor_of_safety) {
            curve.points.emplace_back(problem.failure_plane.dip, factor);
        }
    }
    drawing.curves.push_back(std::move(curve));
    return drawing;
}

}  // namespace delabole
