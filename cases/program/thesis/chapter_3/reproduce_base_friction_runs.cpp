// The base friction tests of Table 3.2 as runs of blocks on a belt.
#include "cases/program/terminal/interrupt.hpp"
#include "cases/program/thesis/chapter_3/base_friction.hpp"
#include "cases/program/thesis/chapter_3/chapter_3.hpp"
#include "cases/program/thesis/physical_models.hpp"
#include "dynamic_relaxation/study/cracks.hpp"
#include "fitting/work/words.hpp"
#include "plots/drawing/text.hpp"
#include "plots/figures/block_figures.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace delabole {

namespace {

using States = std::vector<BaseFrictionState>;
using Scenes = std::vector<BaseFrictionScene>;
using Needs = std::vector<SceneNeed>;

struct Prediction {
    const BaseFrictionState* state;
    const BaseFrictionScene* scene;
    const SceneNeed* need;
    const SceneNeed* run;  // at the fitted strength; null where the slope is predicted to stand
    bool fails;

    bool decided() const { return state->behaviour != SlopeBehaviour::limiting && need->known(); }
    bool hit() const { return fails == (state->behaviour == SlopeBehaviour::unstable); }
    std::optional<double> printed_angle() const {
        if (!state->crack_angle_from) {
            return std::nullopt;
        }
        return (*state->crack_angle_from + state->crack_angle_to.value_or(*state->crack_angle_from)) / 2;
    }
    std::optional<double> angle() const {
        if (run == nullptr || !run->failed() || run->path.broken < 2) {
            return std::nullopt;
        }
        return run->path.inclination;
    }
};

using Predictions = std::vector<Prediction>;

struct Score {
    long right = 0;
    long of = 0;
    std::string words() const { return std::to_string(right) + " of " + std::to_string(of); }
};

template <class Selected, class Right>
Score score(const Predictions& predictions, const Selected& selected, const Right& right) {
    Score result;
    for (const Prediction& prediction : predictions) {
        if (prediction.decided() && selected(prediction)) {
            ++result.of;
            result.right += right(prediction) ? 1 : 0;
        }
    }
    return result;
}

std::string strength_in_words(const SceneNeed& need) {
    switch (need.critical.status) {
    case StrengthStatus::found:
        return human_number(need.strength(), 3);
    case StrengthStatus::fails_however_strong:
        return "any: fails";
    case StrengthStatus::stands_however_weak:
        return "none: stands";
    default:
        return human_name(word_of(need.critical.status));
    }
}

std::string angle_in_words(std::optional<double> angle) {
    return angle ? human_number(*angle / degrees(1), 3) : "";
}

Table test_table(const Predictions& predictions) {
    Table table{"Test by test: strength needed, kPa, and crack path, deg",
                {"test", "slope, deg"_number, "toe, foundation", "half", "printed", "needs"_number, "predicted", "",
                 "path printed"_number, "computed"_number}};
    for (const Prediction& prediction : predictions) {
        const BaseFrictionState& state = *prediction.state;
        table.rows.push_back({state.test, human_number(state.slope_angle / degrees(1), 3),
                              human_name(word_of(state.toe)) + ", " + human_name(word_of(state.foundation)),
                              prediction.scene->fitted ? "fitted" : "predicted", std::string(word_of(state.behaviour)),
                              strength_in_words(*prediction.need), prediction.fails ? "U" : "S",
                              !prediction.decided() ? ""
                              : prediction.hit()    ? "hit"
                                                    : "MISS",
                              angle_in_words(prediction.printed_angle()), angle_in_words(prediction.angle())});
    }
    return table;
}

bool every_slope(const Prediction&) {
    return true;
}

Table score_table(const Predictions& predictions, Reproduction& result) {
    Table table{"Right out of the states that are stable or unstable",
                {"rule", "fitted half"_number, "predicted half"_number, "all"_number}};
    struct Scores {
        Score rest;  // of the half that nothing was fitted to
        Score all;
    };
    const auto add = [&](const std::string& rule, const std::string& key,
                         const std::function<bool(const Prediction&)>& fails) -> Scores {
        const auto right = [&](const Prediction& prediction) {
            return fails(prediction) == (prediction.state->behaviour == SlopeBehaviour::unstable);
        };
        const auto of_half = [&](bool fitted) {
            return score(
                predictions, [&](const Prediction& prediction) { return prediction.scene->fitted == fitted; }, right);
        };
        const Score all = score(predictions, every_slope, right);
        const Score fitted = of_half(true);
        const Score rest = of_half(false);
        table.rows.push_back({rule, fitted.words(), rest.words(), all.words()});
        result.json["scores"][key] = {
            {"fitted", fitted.right}, {"fitted_of", fitted.of}, {"predicted", rest.right}, {"predicted_of", rest.of}};
        return {rest, all};
    };
    const Scores guess = add("every slope fails", "every_slope", every_slope);
    add("70 deg and more, on the frame, or with a changed toe fails (seen after the tests)", "steep_or_weak_toe",
        [](const Prediction& prediction) { return steep_or_changed(*prediction.state); });
    const Scores runs =
        add("runs, one strength", "runs", [](const Prediction& prediction) { return prediction.fails; });
    result.rows.push_back({"behaviour of the half not fitted", "", runs.rest.words(), "", "right"});
    result.rows.push_back({"behaviour of all states", "", runs.all.words(), "",
                           "right; " + guess.all.words() + " where every slope is said to fail"});
    return table;
}

void add_angles(const Predictions& predictions, Reproduction& result) {
    double sum = 0;
    double squares = 0;
    double guess_squares = 0;
    double guess = 0;
    long count = 0;
    for (const Prediction& prediction : predictions) {
        if (prediction.printed_angle() && prediction.angle()) {
            guess += *prediction.printed_angle();
            ++count;
        }
    }
    guess /= static_cast<double>(std::max(count, 1L));
    for (const Prediction& prediction : predictions) {
        if (prediction.printed_angle() && prediction.angle()) {
            const double error = *prediction.angle() - *prediction.printed_angle();
            sum += error;
            squares += error * error;
            guess_squares += (guess - *prediction.printed_angle()) * (guess - *prediction.printed_angle());
        }
    }
    const auto share = static_cast<double>(std::max(count, 1L));
    const double mean = sum / share / degrees(1);
    const double spread = std::sqrt(squares / share) / degrees(1);
    const double guess_spread = std::sqrt(guess_squares / share) / degrees(1);
    result.rows.push_back({"crack path, error of the inclination", "", human_number(spread, 3) + " deg",
                           human_number(mean, 3) + " deg",
                           "root mean square and mean over " + std::to_string(count) +
                               " tests; their mean as a guess " + human_number(guess_spread, 3) + " deg"});
    result.json["crack_path"] = {
        {"tests", count}, {"rms_error_deg", spread}, {"mean_error_deg", mean}, {"rms_of_mean_deg", guess_spread}};
}

std::string csv_of(const Predictions& predictions, double strength) {
    CsvTable table({"test", "behaviour", "half", "status", "needed_strength_kPa", "fitted_strength_kPa",
                    "failure_probability", "predicted", "crack_angle_printed_deg", "crack_angle_deg", "broken_bonds",
                    "loose_blocks"});
    const auto angle = [](std::optional<double> value) { return value ? Cell(*value / degrees(1)) : Cell(""); };
    for (const Prediction& prediction : predictions) {
        const CriticalStrength& critical = prediction.need->critical;
        const auto broken = std::ranges::count_if(critical.end.state.bond,
                                                  [](const BondMemory& bond) { return is_broken(bond.state); });
        table.add_row({prediction.state->test, std::string(word_of(prediction.state->behaviour)),
                       prediction.scene->fitted ? "fitted" : "predicted", std::string(word_of(critical.status)),
                       prediction.need->strength(), strength,
                       failure_probability(prediction.need->strength(), strength), prediction.fails ? "U" : "S",
                       angle(prediction.printed_angle()), angle(prediction.angle()), static_cast<double>(broken),
                       static_cast<double>(critical.end.loose.size())});
    }
    return table.text();
}

// Strength needed over slope angle and height, by what the tests did.
Figure strength_figure(const Predictions& predictions, double strength) {
    constexpr double least = -2;  // powers of ten of kPa; what needs less or more is drawn at the edge
    constexpr double most = 2;
    Figure figure{
        .title = "Strength that the slopes of Table 3.2 need",
        .x = {.title = "row of the table"},
        .y = {.title = "log10 of the tensile strength", .unit = "kPa", .range = std::pair(least - 0.3, most + 0.3)}};
    std::array<Polyline, 3> points;
    for (std::size_t index = 0; index < predictions.size(); ++index) {
        const Prediction& prediction = predictions[index];
        if (prediction.need->known()) {
            const double height = std::clamp(std::log10(std::max(prediction.need->strength(), 1e-9)), least, most);
            points[static_cast<std::size_t>(prediction.state->behaviour)].emplace_back(index + 1, height);
        }
    }
    add_by_behaviour(points, figure);
    Line fitted;
    fitted.legend = "fitted strength";
    fitted.points = {{0, std::log10(strength)}, {static_cast<double>(predictions.size() + 1), std::log10(strength)}};
    figure.series.emplace_back(fitted);
    return figure;
}

// A slope where its run ended, with what has broken.
Figure slope_figure(const std::string& title, const ReducedSlope& slope, const StrengthReduction& reduction) {
    const Bodies bodies = make_bodies(slope.scene);
    BlockDrawing drawing{.title = title};
    for (std::size_t index = 0; index < bodies.size(); ++index) {
        if (slope.state.removed[index] != 0) {
            continue;
        }
        DrawnBlock block;
        for (std::size_t corner = bodies.range[index].begin; corner < bodies.range[index].end; ++corner) {
            block.outline.push_back(moved_corner(bodies, slope.state.motion, corner));
        }
        block.mode = bodies.fixed[index] != 0                                ? DrawnMode::fixed
                     : slope.displacement(index) > reduction.failed_distance ? DrawnMode::topples
                                                                             : DrawnMode::stays;
        drawing.blocks.push_back(std::move(block));
    }
    for (const BrokenBond& bond : broken_bonds(slope.scene, bodies, slope.state)) {
        drawing.broken.push_back({carried(bodies, slope.state.motion, bond.block, bond.from),
                                  carried(bodies, slope.state.motion, bond.block, bond.to)});
    }
    return block_figure(drawing);
}

void add_slope_figures(const Predictions& predictions, const ResultFolder& folder, Report& report) {
    constexpr std::array<std::string_view, 4> shown{"3(L)", "8(R)", "2(L)", "2'_1(L)"};
    for (const std::string_view test : shown) {
        const auto found =
            std::ranges::find_if(predictions, [&](const Prediction& p) { return p.state->test == test; });
        if (found != predictions.end() && found->run != nullptr) {
            const auto number = static_cast<int>(found - predictions.begin()) + 1;
            report.blocks.emplace_back(folder.draw(
                slope_figure("Model " + std::string(test) + " at the fitted strength", found->run->critical.end,
                             strength_reduction_of(found->scene->geometry)),
                "base_friction_" + std::to_string(number), "What has moved by 0.15 of a column's width is coloured."));
        }
    }
}

}  // namespace

Reproduction reproduce_base_friction_runs(const ResultFolder& folder, Report& report) {
    const States states = base_friction_states();
    const ModelMixture mixture = model_mixture();
    const Scenes scenes = base_friction_scenes(states, mixture);
    const auto goes_on = [] { return !interrupt_flag(); };
    Needs needs(scenes.size());
    run_part(folder, {"strength needed", 0, 0.5}, scenes.size(),
             [&](std::size_t scene) { needs[scene] = needed_strength(scenes[scene].geometry, mixture, goes_on); });
    const StrengthFit fit = fit_strength(states, scenes, needs);
    Needs runs(scenes.size());
    const auto fails = [&](std::size_t scene) { return needs[scene].strength() > fit.strength; };
    run_part(folder, {"runs at the fitted strength", 0.5, 1}, scenes.size(), [&](std::size_t scene) {
        const bool has_path = std::ranges::any_of(
            scenes[scene].state, [&](std::size_t state) { return states[state].crack_angle_from.has_value(); });
        if (fails(scene) && has_path) {
            runs[scene] = run_with_strength(scenes[scene].geometry, mixture, fit.strength, goes_on);
        }
    });
    Predictions predictions;
    for (std::size_t state = 0; state < states.size(); ++state) {
        const auto scene = std::ranges::find_if(
            scenes, [&](const BaseFrictionScene& one) { return std::ranges::count(one.state, state) > 0; });
        const auto index = static_cast<std::size_t>(scene - scenes.begin());
        predictions.push_back(
            {&states[state], &*scene, &needs[index], fails(index) ? &runs[index] : nullptr, fails(index)});
    }
    Reproduction result;
    result.rows.push_back({"tensile strength of the mixture", "not printed", human_number(fit.strength, 3) + " kPa", "",
                           human_number(fit.lower, 2) + " to " + human_number(fit.upper, 3) +
                               " kPa do as well (95 %); fitted to " + std::to_string((scenes.size() + 1) / 2) + " of " +
                               std::to_string(scenes.size()) + " scenes"});
    result.json["strength_range_kPa"] = {fit.lower, fit.upper};
    const auto ran = std::ranges::count_if(runs, [](const SceneNeed& run) { return run.critical.runs > 0; });
    const auto failed = std::ranges::count_if(runs, &SceneNeed::failed);
    result.rows.push_back({"scenes predicted to fail that do at the fitted strength itself", "",
                           std::to_string(failed) + " of " + std::to_string(ran), "",
                           "of those with a printed crack path. What needs hardly more may stand"});
    result.json["fail_at_fitted_strength"] = {{"failed", failed}, {"of", ran}};
    result.json["strength_kPa"] = fit.strength;
    result.json["misfit"] = fit.misfit;
    report.blocks.emplace_back(Heading{"Base friction tests as runs"});
    report.blocks.emplace_back(Paragraph{
        "Every state of Table 3.2 as a slope of columns that can break, on a belt. Its tensile strength is lowered "
        "until it fails: that is the strength it needs. One strength is fitted to every other scene, beginning with "
        "the first; a slope that needs more fails. Not printed and taken: friction on the steel frame, " +
        value_in_words(mixture.frame_friction, Dimension::angle) + "; cohesion, " + human_number(mixture.cohesion, 2) +
        " times the tensile strength; weight, as under gravity; modulus, " +
        human_number(mixture.young_modulus / 1e6, 2) +
        " MPa. The modulus was settled when runs had been seen: models of 15 MPa wedge and stand however weak."});
    report.blocks.emplace_back(score_table(predictions, result));
    add_angles(predictions, result);
    report.blocks.emplace_back(printed_table("Fit and prediction", result.rows));
    report.blocks.emplace_back(test_table(predictions));
    report.blocks.emplace_back(folder.draw(
        strength_figure(predictions, fit.strength), "base_friction_strength",
        "Slopes above the line fail. At the upper edge: fails however strong; at the lower: stands however weak."));
    add_slope_figures(predictions, folder, report);
    folder.write("base_friction.csv", csv_of(predictions, fit.strength));
    return result;
}

}  // namespace delabole
