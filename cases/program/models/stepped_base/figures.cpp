// Figures and tables of columns on a stepped base.
#include "cases/program/models/stepped_base/bound.hpp"
#include "cases/program/models/stepped_base/drawing.hpp"
#include "cases/program/models/stepped_base/sweeps.hpp"
#include "cases/program/reports/sensitivity_step.hpp"
#include "cases/program/results/model_reports.hpp"
#include "fitting/work/words.hpp"

namespace delabole {

namespace {

void append_section(const SteppedBaseAnswer& answer, const std::vector<RequiredCable<>>& cables,
                    const Polyline& observed, const Polyline& predicted, const std::string& name, const Sheet& sheet) {
    const ColumnState& state = answer.limiting;
    if (state.columns.size() > most_drawn_columns) {
        sheet.add(Paragraph{"There are " + std::to_string(state.columns.size()) +
                            " columns, too many to be told apart in a section."});
        return;
    }
    const SteppedBase<>& problem = answer.resolved.problem;
    BlockDrawing drawing = column_drawing(problem, answer.slope, state.columns, state.factor, "Columns " + state.name);
    for (std::size_t index = 0; index < cables.size(); ++index) {
        if (answer.required_cable[index].state == CableState::found) {
            drawing.forces.push_back(
                required_force(problem.scene, answer.slope, cables[index], answer.required_cable[index].force));
        }
    }
    Figure figure = block_figure(drawing);
    if (const auto& slope = problem.scene.slope) {
        const double left = 0.75 * figure.x.range->first;
        const double toe = slope->toe_elevation.value_or(0);
        add_measure({{left, toe}, {left, toe + slope->height}, value_in_words(slope->height, Dimension::length)},
                    figure);
    }
    add_profiles(figure, observed, predicted, drawing.toe_elevation);
    std::string caption =
        "Columns by mode, with the forces between them and on their bases to scale, the smallest longer (effective "
        "forces; those of water are not drawn).";
    if (!predicted.empty()) {
        caption += " The ground left standing is drawn along the toe corners of the bases, without steps.";
    }
    sheet.draw(figure, name, caption);
}

void append_forces(const ColumnState& state, const std::string& name, const Sheet& sheet) {
    if (state.columns.size() > most_drawn_columns) {
        return;
    }
    sheet.draw(force_along_slope_figure(force_along_columns(state.columns, "Forces between columns " + state.name)),
               name,
               "Normal force that each column needs from the one below it; the larger of both demands acts, and "
               "none where both are zero.");
}

void append_sensitivity(const SteppedBaseAnswer& answer, const InputDeviations& known, const std::string& prefix,
                        const Sheet& sheet) {
    const SteppedBase<>& problem = answer.resolved.problem;
    if (answer.result.limit != LimitState::found) {
        sheet.add(
            Paragraph{"There is no limiting equilibrium whose dependence on geometry and inputs could be shown."});
        return;
    }
    if (!can_sweep(problem, answer.slope)) {
        sheet.add(Paragraph{"With so many columns the dependence on geometry and inputs is not computed."});
        return;
    }
    sheet.draw(
        tornado_figure("Change of the factor of safety",
                       sensitivity_bars(problem, answer.result.factor_of_safety, known)),
        prefix + "sensitivity",
        "By recalculation, one input at a time, the base held: the eight greatest." + deviations_in_words(known));
}

}  // namespace

void append_case_figures(const SteppedBaseStudy<>& study, const SteppedBaseAnswer& answer, const Sheet& sheet,
                         const InputDeviations& known) {
    const SteppedBase<>& problem = answer.resolved.problem;
    const SteppedBaseResult& result = answer.result;
    const bool found = result.limit == LimitState::found;

    append_section(answer, study.required_cable, {}, {}, "section", sheet);
    sheet.add(Heading{"Forces"});
    append_forces(answer.limiting, "forces", sheet);

    if (study.linear_programming_bound) {
        append_bound_figures(answer, *study.linear_programming_bound, sheet);
    }

    sheet.add(Heading{"Column by column"});
    sheet.add(
        Paragraph{"P acts normal to the joints, friction on them is fully mobilised by columns that move; R and S are "
                  "the normal and the up-dip force of the base. Heights are above each column's own base, the place of "
                  "R is a share of the width from the toe corner."});
    if (found) {
        sheet.add(column_table("Columns " + answer.limiting.name + ".", answer.limiting.columns));
    }
    sheet.add(column_table("Columns " + answer.as_given.name + ".", answer.as_given.columns));
    sheet.write("columns.csv",
                columns_csv(answer.as_given.columns, found ? answer.limiting.columns : std::vector<ColumnResult>{}));

    sheet.add(Heading{"Geometry and sensitivity"});
    if (found && can_sweep(problem, answer.slope)) {
        for (const GeometrySweep& sweep : geometry_sweeps(problem, result.factor_of_safety)) {
            sheet.draw(sweep.figure, sweep.file, sweep.caption);
        }
    }
    append_sensitivity(answer, known, "", sheet);
}

void append_mechanism_figures(const SteppedBaseStudy<>& at_best, const MechanismFit& fit, const FitProblem& problem,
                              const Sheet& sheet) {
    const SteppedBaseStudy<> best{resolve(at_best).problem, std::nullopt, {}, {}, std::nullopt};
    const SteppedBaseAnswer answer = analyse_case(best);
    if (answer.result.check != ColumnCheck::valid) {
        return;
    }
    const std::vector<std::string> warnings = named_outputs(best, answer).warnings;
    if (!warnings.empty()) {
        sheet.add(Notice{NoticeKind::warning, "The columns at the best point", warnings});
    }
    append_section(answer, {}, problem.profile ? problem.profile->profile : Polyline{},
                   profile_after_failure(best.model, answer.result), fit.name + "_section", sheet);
    append_forces(answer.limiting, fit.name + "_forces", sheet);
    append_sensitivity(answer, deviations_of(fit.parameters), fit.name + "_", sheet);
}

}  // namespace delabole
