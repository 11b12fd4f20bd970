#include "cases/program/models/wedge/figures.hpp"

#include "cases/program/reports/sensitivity_step.hpp"

#include <cmath>

namespace delabole {

namespace {

// NaN if there is no wedge.
double factor_of(const WedgeFailure& problem) {
    const WedgeFailureResult result = analyse(problem);
    return result.check == WedgeFailureCheck::valid ? result.factor_of_safety : std::nan("");
}

}  // namespace

WedgeDrawing wedge_drawing(const WedgeFailure& problem, const std::string& title) {
    const WedgeEquilibrium forces = evaluate(problem);
    const WedgeGeometry& wedge = forces.wedge;
    const WedgeSlope& slope = problem.slope;
    return {.title = title,
            .face_dip_direction = slope.face_dip_direction,
            .face_normal = upward_normal({slope.face_dip, slope.face_dip_direction}),
            .upper_normal = upward_normal({slope.upper_surface_dip, slope.upper_surface_dip_direction}),
            .crest_1 = wedge.crest_1,
            .crest_2 = wedge.crest_2,
            .crack_1 = wedge.crack_1,
            .crack_2 = wedge.crack_2,
            .line_end = wedge.line_end,
            .cracked = problem.tension_crack.has_value(),
            .sliding = forces.stability.sliding};
}

WedgeNet wedge_net(const WedgeFailure& problem, const WedgeFailureResult& result) {
    const WedgeSlope& slope = problem.slope;
    WedgeNet net{.title = "Stereonet",
                 .face = {slope.face_dip, slope.face_dip_direction},
                 .upper_surface = {slope.upper_surface_dip, slope.upper_surface_dip_direction},
                 .planes = {{"plane_1", {problem.plane_1.dip, problem.plane_1.dip_direction}},
                            {"plane_2", {problem.plane_2.dip, problem.plane_2.dip_direction}}},
                 .line = {result.line_plunge, result.line_trend}};
    if (problem.tension_crack) {
        net.planes.push_back({"tension_crack", {problem.tension_crack->dip, problem.tension_crack->dip_direction}});
    }
    if (result.contact != SlidingContact::none) {
        net.sliding = {result.sliding_plunge, result.sliding_trend};
    }
    return net;
}

std::optional<WaterDepthCurves> filled_ratio_curve(const WedgeFailure& problem) {
    WedgeFailure varied = problem;
    auto* fissures = std::get_if<FilledFissures>(&varied.water);
    if (fissures == nullptr) {
        return std::nullopt;
    }
    WaterDepthCurves curves{.title = "Factor of safety against water in the fissures",
                            .ratio = "filled ratio of the fissures",
                            .curves = {{"as given", {}}}};
    constexpr int points = 101;
    for (int index = 0; index < points; ++index) {
        fissures->filled_ratio = static_cast<double>(index) / (points - 1);
        const double factor = factor_of(varied);
        if (std::isfinite(factor)) {
            curves.curves.front().points.emplace_back(fissures->filled_ratio, factor);
        }
    }
    return curves;
}

std::vector<SensitivityBar> sensitivity_bars(const WedgeFailure& problem, const InputDeviations& known) {
    const double height = problem.slope.height;
    const double overburden = problem.rock.unit_weight * height;
    const double given = factor_of(problem);
    std::vector<SensitivityBar> bars;
    for_each_named_number(problem, [&](const std::string& path, const FieldInfo& info, double value) {
        const SensitivityStep step = sensitivity_step(path, known, info.dimension, value, height, overburden);
        WedgeFailure varied = problem;
        const auto changed_by = [&](double change) {
            for_each_named_number(varied, [&](const std::string& other, const FieldInfo&, double& number) {
                number = other == path ? value + change : number;
            });
            return factor_of(varied) - given;
        };
        const double upwards = changed_by(step.size);
        const double effect = std::isfinite(upwards) ? upwards : -changed_by(-step.size);
        if (effect != 0) {
            bars.push_back({path, step.words, effect, step.by_rule && !known.empty()});
        }
    });
    return bars;
}

}  // namespace delabole
