#include "samples.hpp"

#include "plots/figures/study_figures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace delabole::samples {

namespace {

constexpr double foot = 0.3048;
constexpr double height = 225 * foot;
constexpr double base_height = 75 * foot;
constexpr double crack_depth = height - base_height;
constexpr double face_dip = degrees(70);
constexpr double crack_dip = degrees(72.5);
constexpr double unit_weight = 26.5e3;
constexpr double water_weight = 9.81e3;
constexpr double cohesion_30psi = 30 * 6894.757;

double hoek_bray(double cohesion, double friction_angle, double water_ratio, double plane_dip, double depth) {
    const double area = (height - depth) / std::sin(plane_dip);
    const double water = water_ratio * depth;
    const double uplift = 0.5 * water_weight * water * area;
    const double thrust = 0.5 * water_weight * water * water;
    const double squared = (1 - depth / height) * (1 - depth / height);
    const double weight =
        0.5 * unit_weight * height * height * ((1 - squared) / std::tan(plane_dip) - 1 / std::tan(face_dip));
    const double normal = weight * std::cos(plane_dip) - uplift - thrust * std::sin(plane_dip);
    const double driving = weight * std::sin(plane_dip) + thrust * std::cos(plane_dip);
    return (cohesion * area + normal * std::tan(friction_angle)) / driving;
}

Point crack_base() {
    return {base_height / std::tan(degrees(40)), base_height};
}

Point on_crack(double above_base) {
    return crack_base() + Point(above_base / std::tan(crack_dip), above_base);
}

double friction_for_failure(double cohesion, double water_ratio) {
    double low = 0;
    double high = degrees(89.9);
    for (int step = 0; step < 60; ++step) {
        const double middle = 0.5 * (low + high);
        (factor_of_safety(cohesion, middle, water_ratio) < 1 ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

}  // namespace

double factor_of_safety(double cohesion, double friction_angle, double water_ratio) {
    return hoek_bray(cohesion, friction_angle, water_ratio, degrees(40), crack_depth);
}

SectionDrawing section() {
    const Point crest{height / std::tan(face_dip), height};
    const Point top = on_crack(crack_depth);
    const double water = 50 * foot;  // level 475 ft in the crack
    const Point base = crack_base();
    return {.title = "Old Delabole, west face: section before and after 4 March 1967",
            .ground = {{-20, 0}, {0, 0}, crest, {62, height}},
            .failure_plane = {{0, 0}, base},
            .tension_crack = {base, top},
            .water_in_crack = {base, on_crack(water)},
            .water_pressure = {{{{0, 0}, base}, {0, water_weight * water}},
                               {{base, on_crack(water)}, {water_weight * water, 0}}},
            .observed_profile =
                {{0, 0}, {7.5, 7.6}, {10.5, 8.1}, {19, 15.9}, {22, 16.6}, {29, 22.9}, {35.5, 44}, {43, height}},
            .predicted_profile = {{0, 0}, base, top},
            .levels = {{height, "575 ft"}, {125 * foot, "475 ft"}, {base_height, "425 ft"}, {0, "350 ft"}},
            .toe_elevation = 350 * foot};
}

WaterDepthCurves water_depth_curves() {
    WaterDepthCurves data{.title = "Factor of safety against water in the tension crack (Fig 2.8(b))"};
    for (const auto& [legend, cohesion] :
         {std::pair{"c = 0", 0.0}, std::pair{"c = 15 lbf/in² (103 kPa)", 0.5 * cohesion_30psi},
          std::pair{"c = 30 lbf/in² (207 kPa)", cohesion_30psi}}) {
        NamedCurve curve{.legend = legend};
        for (int step = 0; step <= 100; ++step) {
            curve.points.emplace_back(0.01 * step, factor_of_safety(cohesion, degrees(66), 0.01 * step));
        }
        data.curves.push_back(curve);
    }
    data.statements = {{"printed: stable when half full, c = 0", {0.5, 1}},
                       {"printed: fails when two thirds full, c = 30 lbf/in²", {2.0 / 3, 1}}};
    return data;
}

FailureLoci failure_loci() {
    FailureLoci data{.title = "Strength at failure for several water levels"};
    for (const auto& [legend, ratio] : {std::pair{"dry", 0.0}, std::pair{"crack half full", 0.5},
                                        std::pair{"crack two thirds full", 2.0 / 3}, std::pair{"crack full", 1.0}}) {
        NamedCurve locus{.legend = legend};
        for (int step = 0; step <= 60; ++step) {
            const double cohesion = 5e3 * step;
            const double friction = friction_for_failure(cohesion, ratio);
            if (friction > 1e-6 && friction < degrees(89)) {
                locus.points.emplace_back(friction, cohesion);
            }
        }
        data.loci.push_back(locus);
    }
    data.laboratory = {{"laboratory: friction, wet to residual", within(degrees(20), degrees(33)), std::nullopt},
                       {"laboratory: apparent cohesion", std::nullopt, within(0.15e6, 0.25e6)}};
    return data;
}

MechanismFit mechanism_fit() {
    MechanismFit fit;
    fit.name = "structural_plane";
    fit.title = "Sliding on the structural plane";
    fit.parameters = {
        {.name = "strength.friction_angle", .lower = degrees(40), .upper = degrees(80), .prior = std::nullopt},
        {.name = "water.filled_ratio", .lower = 0, .upper = 1, .prior = std::nullopt}};
    fit.dimensions = {Dimension::angle, Dimension::ratio};
    const auto data_misfit = [](double friction, double ratio) {
        const double safety = factor_of_safety(0, friction, ratio);
        if (friction > degrees(76) && ratio < 0.12) {
            return std::numeric_limits<double>::infinity();
        }
        return std::pow((safety - 1) / 0.08, 2);
    };
    const auto prior_misfit = [](double friction, double ratio) {
        return std::pow((friction - degrees(60)) / degrees(6), 2) + std::pow((ratio - 0.4) / 0.3, 2);
    };
    constexpr int count = 61;
    MisfitMap map{};
    map.x = fit.parameters[0].name;
    map.y = fit.parameters[1].name;
    map.misfit.resize(count, count);
    for (int index = 0; index < count; ++index) {
        map.x_values.push_back(degrees(40 + 40.0 * index / (count - 1)));
        map.y_values.push_back(1.0 * index / (count - 1));
    }
    const double infinity = std::numeric_limits<double>::infinity();
    for (const bool priors : {true, false}) {
        Eigen::MatrixXd misfit(count, count);
        for (int row = 0; row < count; ++row) {
            for (int column = 0; column < count; ++column) {
                const double x = map.x_values[static_cast<std::size_t>(column)];
                const double y = map.y_values[static_cast<std::size_t>(row)];
                misfit(row, column) = data_misfit(x, y) + (priors ? prior_misfit(x, y) : 0.0);
            }
        }
        for (const int which : {0, 1}) {
            ProfileLikelihood profile{.parameter = fit.parameters[static_cast<std::size_t>(which)].name,
                                      .values = which == 0 ? map.x_values : map.y_values,
                                      .misfits = {},
                                      .least_misfit = 0,
                                      .interval_68 = {},
                                      .interval_95 = {},
                                      .determination = Determination::determined,
                                      .with_priors = priors};
            double least = infinity;
            for (int index = 0; index < count; ++index) {
                profile.misfits.push_back(which == 0 ? misfit.col(index).minCoeff() : misfit.row(index).minCoeff());
                least = std::min(least, profile.misfits.back());
            }
            profile.least_misfit = least;
            profile.interval_95 = within(profile.values.back(), profile.values.front());
            for (std::size_t index = 0; index < profile.values.size(); ++index) {
                if (profile.misfits[index] - least <= 3.841) {
                    profile.interval_95.lower = std::min(profile.interval_95.lower, profile.values[index]);
                    profile.interval_95.upper = std::max(profile.interval_95.upper, profile.values[index]);
                }
            }
            fit.profiles.push_back(profile);
        }
        if (priors) {
            map.misfit = misfit;
        }
    }
    Eigen::Index row = 0;
    Eigen::Index column = 0;
    const double least = map.misfit.minCoeff(&row, &column);
    map.level_68 = least + 2.279;
    map.level_95 = least + 5.991;
    fit.best = {map.x_values[static_cast<std::size_t>(column)], map.y_values[static_cast<std::size_t>(row)]};
    fit.minima = {{fit.best, least, 13}, {{degrees(70), 0.75}, least + 4, 3}};
    fit.map = map;
    FailureLocus locus{.x = map.x, .y = map.y, .points = {}, .branch = {}};
    for (int step = 0; step <= 50; ++step) {
        const double friction = friction_for_failure(0, 0.02 * step);
        if (friction < degrees(89)) {
            locus.points.emplace_back(friction, 0.02 * step);
            locus.branch.push_back(0);
        }
    }
    fit.loci = {locus};
    return fit;
}

std::vector<SensitivityBar> sensitivities() {
    return {{"strength.friction_angle", "+1 deg", 0.0612},
            {"water.filled_ratio", "+0.1", -0.184},
            {"strength.cohesion", "+10 kPa", 0.0227},
            {"failure_plane.dip", "+1 deg", -0.0415},
            {"slope.face_dip", "+1 deg", -0.0093},
            {"rock.unit_weight", "+1 kN/m³", 0.0112},
            {"tension_crack.base_below_crest", "+1 m", 0.0054}};
}

CriticalSearchDrawing critical_dip() {
    CriticalSearchDrawing drawing{.title = "Critical failure plane",
                                  .quantity = "failure_plane.dip",
                                  .dimension = Dimension::angle,
                                  .curves = {},
                                  .critical = {0, std::numeric_limits<double>::infinity()}};
    for (const auto& [legend, ratio] : {std::pair{"crack half full", 0.5}, std::pair{"dry", 0.0}}) {
        NamedCurve curve{.legend = legend};
        for (int step = 0; step <= 100; ++step) {
            const double dip = degrees(22 + 0.29 * step);
            const double depth = height * (1 - std::sqrt(std::tan(dip) / std::tan(face_dip)));
            curve.points.emplace_back(dip, hoek_bray(250e3, degrees(33), ratio, dip, depth));
            if (curve.points.back().y() < drawing.critical.y()) {
                drawing.critical = curve.points.back();
            }
        }
        drawing.curves.push_back(curve);
    }
    return drawing;
}

CriticalSearchDrawing critical_crack() {
    CriticalSearchDrawing drawing{.title = "Critical tension crack",
                                  .quantity = "tension_crack.depth",
                                  .dimension = Dimension::length,
                                  .curves = {{.legend = "dry", .points = {}}},
                                  .critical = {0, std::numeric_limits<double>::infinity()}};
    for (int step = 0; step <= 100; ++step) {
        const double depth = 14 + 0.3 * step;
        drawing.curves[0].points.emplace_back(depth, hoek_bray(200e3, degrees(33), 0, degrees(40), depth));
        if (drawing.curves[0].points.back().y() < drawing.critical.y()) {
            drawing.critical = drawing.curves[0].points.back();
        }
    }
    return drawing;
}

// The sets of the west face of Old Delabole (thesis 2.2.1, 2.2.3.1). Set B is the mirror image of set A, its scatter a
// guess.
StereonetDrawing stereonet() {
    const std::vector<JointSet> sets{
        {"joint_set_a", OrientationRange{degrees(70), degrees(90), degrees(100), degrees(105)}},
        {"joint_set_b", MeanOrientation{degrees(85), degrees(282.5), 200.0}},
        {"joint_set_c", OrientationRange{degrees(30), degrees(65), degrees(90), degrees(130)}},
        {"cleavage", OrientationRange{degrees(20), degrees(30), degrees(245), degrees(260)}},
        {"faults", OrientationRange{degrees(70), degrees(90), degrees(90), degrees(120)}}};
    StereonetDrawing drawing{.title = "Old Delabole, west face",
                             .slope = {degrees(70), degrees(102.5), {}},
                             .friction_angle = degrees(20),
                             .lateral_limit = {degrees(20), degrees(30), degrees(20)}};
    for (const JointSet& set : sets) {
        drawing.joint_set.push_back(
            {set.name, mean_orientation(set), sampled_planes(set, 300, 1967, drawing.joint_set.size())});
    }
    for (std::size_t first = 0; first < sets.size(); ++first) {
        for (std::size_t second = first + 1; second < sets.size(); ++second) {
            const auto line = intersection(mean_orientation(sets[first]), mean_orientation(sets[second]));
            drawing.intersection.push_back({std::to_string(drawing.intersection.size() + 1), line.value()});
        }
    }
    return drawing;
}

// The same with some planes of each set measured, and two that belong to none.
StereonetDrawing measured_stereonet() {
    StereonetDrawing drawing = stereonet();
    drawing.measured = true;
    for (DrawnJointSet& set : drawing.joint_set) {
        set.planes.resize(30);
    }
    drawing.without_set = {{degrees(50), degrees(10)}, {degrees(20), degrees(350)}};
    return drawing;
}

// Hoek & Bray's wedge of the complete solution, m.
WedgeDrawing wedge() {
    return {.title = "A wedge",
            .face_dip_direction = degrees(185),
            .face_normal = {-0.0790, -0.9029, 0.4226},
            .upper_normal = {-0.0538, -0.2008, 0.9781},
            .crest_1 = {-26.9, 14.9, 30.48},
            .crest_2 = {13.1, 17.6, 29.4},
            .crack_1 = {-22.6, 26.2, 33.0},
            .crack_2 = {4.0, 27.4, 34.7},
            .line_end = {-8.7, 21.2, 13.9},
            .cracked = true,
            .sliding = {0.324, -0.792, -0.518}};
}

std::vector<std::pair<std::string, Figure>> figures() {
    const MechanismFit fit = mechanism_fit();
    return {{"section", section_figure(section())},
            {"factor_of_safety_against_water", factor_of_safety_against_water(water_depth_curves())},
            {"failure_loci", failure_locus_figure(failure_loci())},
            {"misfit_map", misfit_map_figure(fit).value()},
            {"profile_friction_angle", profile_likelihood_figure(fit, "strength.friction_angle").value()},
            {"profile_filled_ratio", profile_likelihood_figure(fit, "water.filled_ratio").value()},
            {"sensitivities", tornado_figure("Change of the factor of safety", sensitivities())},
            {"critical_dip", critical_figure(critical_dip())},
            {"critical_crack", critical_figure(critical_crack())},
            {"stereonet_poles", pole_figure(stereonet())},
            {"stereonet_planes", plane_figure(stereonet())},
            {"stereonet_kamb", kamb_figure(measured_stereonet())},
            {"rosette", rosette_figure("Strikes", measured_stereonet().joint_set[0].planes, {})},
            {"wedge", wedge_figure(wedge())},
            {"slid_wedge", slid_wedge_figure(wedge())},
            {"goodman_bray_blocks", block_figure(goodman_bray_blocks())},
            {"goodman_bray_forces", force_along_slope_figure(goodman_bray_forces())},
            {"stepped_base", block_figure(stepped_base())},
            {"single_block", block_figure(single_block())},
            {"row_of_columns", block_figure(row_of_columns(40))},
            {"mode_chart", mode_chart_figure(mode_chart())}};
}

Report report(const std::vector<FigureFiles>& drawn) {
    Report report{
        .title = "Back-analysis of the 1967 failure", .subtitle = "Old Delabole slate quarry, west face", .blocks = {}};
    report.blocks = {
        HeadCard{.tone = AnswerTone::bad,
                 .sentences = {"FS 0.64: fails.", "FS 1.3 takes 4376 kN/m in bolts at 15 deg.",
                               "500 m2 of rock slide on a plane at 40 deg."},
                 .picture = FigureInReport{drawn.front(), "The section."}},
        Notice{
            .kind = NoticeKind::verdict,
            .title = "Not identifiable",
            .paragraphs =
                {"Friction and water level: only the combination that gives a factor of safety of 1 is determined."}},
        Notice{.kind = NoticeKind::warning,
               .title = "",
               .paragraphs = {"The tension crack is deeper than half the slope."}},
        Heading{.text = "Results"},
        Paragraph{"The slope is 68.58 m high; c < 0 & similar nonsense is refused."},
        BulletList{{"level 425 ft: seepage", "level 475 ft: seepage"}},
        Table{.caption = "Fitted parameters",
              .columns = {{"parameter"},
                          {"unit"},
                          {"best", true},
                          {"68 % from", true},
                          {"68 % to", true},
                          {"95 % from", true},
                          {"95 % to", true},
                          {"prior", true},
                          {"source"}},
              .rows = {{"strength.friction_angle", "deg", "62.4", "57.1", "67.0", "51.5", "71.3", "60.0",
                        "laboratory tests on wet joints"},
                       {"water.filled_ratio", "", "0.41", "0.18", "0.63", "0.00", "0.83", "0.40",
                        "seepage at 425 ft and 475 ft"}}},
        Heading{.text = "Figures"}};
    for (std::size_t index = 1; index + 3 < drawn.size(); ++index) {
        report.add(FigureInReport{drawn[index], "Sample figure " + drawn[index].svg.stem().string() + "."});
    }
    FigureRow row;
    for (std::size_t index = drawn.size() - 3; index < drawn.size(); ++index) {
        row.figures.push_back(FigureInReport{drawn[index], "Small figure."});
    }
    report.add(Heading{.text = "Small multiples"});
    report.add(std::move(row));
    Table blocks{.caption = "A table of several pages", .columns = {{"block", true}, {"movement"}}, .rows = {}};
    for (int block = 1; block <= 120; ++block) {
        blocks.rows.push_back({std::to_string(block), "slides forward"});
    }
    report.add(blocks);
    report.add(Folded{"Provenance",
                      {Provenance{{{"case", "cases/delabole_1967/delabole_1967.toml"},
                                   {"hash", "9f86d081884c7d659a2feaa0c55ad015a3bf4f1b2b0b822cd15d6c15b0f00a08"},
                                   {"seed", "1"}}}}});
    return report;
}

}  // namespace delabole::samples
