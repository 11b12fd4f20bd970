// A single block on a plane: the block with its forces and its place in the chart of modes, for reports.
#include "cases/program/models/single_block/chart.hpp"
#include "cases/program/reader/units.hpp"
#include "cases/program/results/model_reports.hpp"
#include "fitting/work/words.hpp"
#include "limit_equilibrium/block_row/single_block.hpp"
#include "plots/drawing/text.hpp"

#include <algorithm>
#include <cmath>

namespace delabole {

namespace {

DrawnMode drawn(BlockMotion motion) {
    switch (motion) {
    case BlockMotion::stable:
        return DrawnMode::stays;
    case BlockMotion::slides:
        return DrawnMode::slides;
    case BlockMotion::topples:
        return DrawnMode::topples;
    case BlockMotion::slides_and_topples:
        return DrawnMode::slides_and_topples;
    case BlockMotion::lifts_off:
        break;
    }
    return DrawnMode::plain;
}

BlockDrawing block_drawing(const SingleBlock& problem, const SingleBlockResult& result) {
    const double inclination = problem.base.inclination;
    const Point along(std::cos(inclination), std::sin(inclination));
    const Point up(-along.y(), along.x());
    const double width = problem.block.width;
    const double height = problem.block.height;
    BlockDrawing drawing{.title = "The block: " + human_name(word_of(result.onset_mode)),
                         .blocks = {{Polyline{Point(0, 0), width * along, width * along + height * up, height * up}, "",
                                     drawn(result.onset_mode)}}};
    // The base extends so far that the figure of a slender block is wide enough.
    const double reach = 0.6 * std::max(width, height);
    drawing.base = {-reach * along, (width + reach) * along};
    const Point centre = width / 2 * along + height / 2 * up;
    const double horizontal = problem.seismic ? problem.seismic->horizontal_coefficient : 0;
    const double vertical = problem.seismic ? problem.seismic->vertical_coefficient : 0;
    drawing.forces.push_back({centre, result.weight * Point(-horizontal, -1 - vertical), ForceKind::weight});
    if (result.onset_mode == BlockMotion::stable) {
        drawing.forces.push_back({result.reaction_position * width * along,
                                  result.normal_force * up + result.driving_force * along, ForceKind::base_reaction});
    }
    return drawing;
}

bool dry_and_at_rest(const SingleBlock& problem) {
    return !problem.water && !problem.seismic && problem.base.cohesion == 0 && problem.base.friction_angle > degrees(1);
}

}  // namespace

Analysis named_outputs(const SingleBlock&, const SingleBlockResult& result) {
    Analysis analysis;
    append_outputs(analysis, result);
    if (result.static_mode != result.onset_mode) {
        analysis.warnings.push_back("the static criteria say " + human_name(word_of(result.static_mode)) +
                                    ", the equations of motion " + human_name(word_of(result.onset_mode)) +
                                    ": the latter holds");
    }
    return analysis;
}

HeadCard head_card(const SingleBlock&, const SingleBlockResult& result) {
    const bool stands = result.onset_mode == BlockMotion::stable;
    HeadCard head{stands ? AnswerTone::good : AnswerTone::bad, {}, {}};
    head.sentences = {stands ? "The block stands." : "The block " + human_name(word_of(result.onset_mode)) + ".",
                      "Factor of safety against sliding " + number_in_words(result.factor_of_safety) +
                          ", of restoring over overturning moment " + number_in_words(result.overturning_factor) + "."};
    return head;
}

void append_case_figures(const SingleBlock& problem, const SingleBlockResult& result, const Sheet& sheet) {
    sheet.draw(block_figure(block_drawing(problem, result)), "block",
               "Weight with the earthquake's inertia and, where the block stands, the "
               "effective force of the base; those of water are not drawn.");
    if (!dry_and_at_rest(problem)) {
        return;
    }
    ModeChart chart =
        single_block_chart(problem.base.friction_angle, BlockCriteria::onset_of_motion,
                           "Dry block, friction " + value_in_words(problem.base.friction_angle, Dimension::angle));
    chart.printed = {
        {"this block", Point(problem.base.inclination, std::atan(problem.block.width / problem.block.height))}};
    sheet.add(Heading{"Chart of modes"});
    sheet.draw(
        mode_chart_figure(chart), "mode_chart",
        "What a dry block released from rest does, over inclination and slenderness angle atan(width / height).");
}

void append_mechanism_figures(const SingleBlock& at_best, const MechanismFit& fit, const FitProblem&,
                              const Sheet& sheet) {
    const SingleBlockResult result = analyse(at_best);
    if (result.check == SingleBlockCheck::valid) {
        sheet.draw(block_figure(block_drawing(at_best, result)), fit.name + "_block", "The block at the best point.");
    }
}

Impossibility impossibility(const SingleBlock& problem, std::string_view failure) {
    if (value_of<SingleBlockCheck>(failure) != SingleBlockCheck::water_above_block) {
        return stated_impossibility(SingleBlock::kind, failure);
    }
    const bool behind = problem.water && problem.water->depth_behind > problem.block.height;
    return {{behind ? "water.depth_behind" : "water.depth_in_front", "block.height"},
            "a depth of water exceeds the height of the block, " +
                readable_quantity(problem.block.height, Dimension::length)};
}

}  // namespace delabole
