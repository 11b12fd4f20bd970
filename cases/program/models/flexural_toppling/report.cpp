// Flexural toppling by limit equilibrium: answers, warnings and figures for reports.
#include "cases/program/results/model_reports.hpp"
#include "fitting/work/words.hpp"
#include "limit_equilibrium/columns/flexural_toppling.hpp"
#include "plots/drawing/text.hpp"
#include "plots/figures/block_figures.hpp"

#include <cmath>

namespace delabole {

namespace {

DrawnMode drawn(FlexuralMode mode) {
    return mode == FlexuralMode::stands   ? DrawnMode::stays
           : mode == FlexuralMode::shears ? DrawnMode::slides
                                          : DrawnMode::topples;
}

// The columns on their base plane, with the force that each needs from below.
Figure columns_figure(const FlexuralSlope& slope, const FlexuralStability& result) {
    const Point along(std::cos(slope.base_dip), std::sin(slope.base_dip));
    const Point up(-along.y(), along.x());
    BlockDrawing drawing{.title =
                             result.toe_push > 0 ? "The columns: the slope fails" : "The columns: the slope stands"};
    double foot = 0;
    double height_before = slope.column.front().height;
    for (std::size_t index = 0; index < slope.column.size(); ++index) {
        const FlexuralColumn& column = slope.column[index];
        const FlexuralColumnState& state = result.column[index];
        const Point left = foot * along;
        const Point right = (foot + column.width) * along;
        drawing.blocks.push_back({.outline = {left, right, right + column.height * up, left + column.height * up},
                                  .label = std::to_string(index + 1),
                                  .mode = drawn(state.mode)});
        const double contact = slope.contact_height * std::min(column.height, height_before);
        drawing.forces.push_back({left + contact * up, state.push * along});
        foot += column.width;
        height_before = column.height;
    }
    drawing.base = {Point(0, 0), foot * along};
    return block_figure(drawing);
}

Table column_table(const FlexuralStability& result) {
    Table table{"The columns from the toe up, and the push that each needs from the one below.",
                {"column"_number, "without it", "push, kN/m"_number, "moment at the foot, kN"_number}};
    constexpr double kilo = 1e3;
    for (std::size_t index = 0; index < result.column.size(); ++index) {
        const FlexuralColumnState& state = result.column[index];
        table.rows.push_back({std::to_string(index + 1), human_name(word_of(state.mode)),
                              human_number(state.push / kilo, 4), human_number(state.moment / kilo, 4)});
    }
    return table;
}

}  // namespace

HeadCard head_card(const FlexuralSlope&, const FlexuralStability& result) {
    const bool stands = result.toe_push == 0;
    HeadCard head{stands ? AnswerTone::good : AnswerTone::bad, {}, {}};
    const std::string factor = std::isinf(result.factor_of_safety)
                                   ? std::string("No tensile strength is needed")
                                   : factor_in_words(result.factor_of_safety) + " on tensile strength";
    head.sentences = {factor + (stands ? ": stands." : ": fails by flexural toppling."),
                      std::isinf(result.required_tensile_strength)
                          ? std::string("No tensile strength holds it: the columns are sheared off their feet.")
                          : "It takes a tensile strength of " +
                                value_in_words(result.required_tensile_strength, Dimension::stress) + "."};
    if (!stands) {
        head.sentences.push_back("The column at the toe lacks a push of " +
                                 value_in_words(result.toe_push, Dimension::force_per_length) + ".");
    }
    return head;
}

void append_case_figures(const FlexuralSlope& slope, const FlexuralStability& result, const Sheet& sheet) {
    sheet.add(Heading{"The columns"});
    sheet.add(column_table(result));
    sheet.draw(columns_figure(slope, result), "columns",
               "Arrows: the push that a column needs from the one below it, which in turn "
               "bears it; the lowest is what the slope lacks.");
}

void append_mechanism_figures(const FlexuralSlope& at_best, const MechanismFit& fit, const FitProblem&,
                              const Sheet& sheet) {
    const FlexuralStability result = analyse(at_best);
    if (result.check == FlexuralCheck::valid) {
        sheet.draw(columns_figure(at_best, result), fit.name + "_columns", "The columns at the best point.");
    }
}

}  // namespace delabole
