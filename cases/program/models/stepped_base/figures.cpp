// Figures and tables of columns on a stepped base.
#include "cases/program/models/stepped_base/bound.hpp"
#include "cases/program/models/stepped_base/columns.hpp"
#include "cases/program/models/stepped_base/drawing.hpp"
#include "cases/program/models/stepped_base/sweeps.hpp"
#include "cases/program/results/model_reports.hpp"
#include "fitting/work/words.hpp"
#include "limit_equilibrium/stepped_base/stepped_base_study.hpp"

namespace delabole {

namespace {

// Columns in one state, and by what the strength was divided for it.
struct ColumnState {
    std::vector<ColumnResult> columns;
    double factor = 1;
    std::string name;  // of the state, in words
};

ColumnState as_given(const SteppedBase<>& problem, const ColumnSlope<>& slope) {
    return {column_results(slope, strength_of(problem)), 1, "with the strength as given"};
}

// As given where there is no limiting equilibrium.
ColumnState limiting(const SteppedBase<>& problem, const ColumnSlope<>& slope, const SteppedBaseResult& result) {
    if (result.limit != LimitState::found) {
        return as_given(problem, slope);
    }
    const double factor = result.factor_of_safety;
    return {column_results(slope, strength_of(problem), factor), factor,
            "in limiting equilibrium, strength divided by " + number_in_words(factor)};
}

void append_section(const SteppedBase<>& problem, const ColumnState& state, const Polyline& observed,
                    const Polyline& predicted, const std::string& name, const ResultFolder& folder, Report& report) {
    if (state.columns.size() > most_drawn_columns) {
        report.blocks.emplace_back(Paragraph{"There are " + std::to_string(state.columns.size()) +
                                             " columns, too many to be told apart in a section."});
        return;
    }
    const BlockDrawing drawing = column_drawing(problem, state.columns, state.factor, "Columns " + state.name);
    Figure figure = block_figure(drawing);
    add_profiles(figure, observed, predicted, drawing.toe_elevation);
    std::string caption =
        "Columns by mode, with the forces between them and on their bases to scale (effective forces; those of water "
        "are not drawn).";
    if (!predicted.empty()) {
        caption += " The ground left standing is drawn along the toe corners of the bases, without steps.";
    }
    report.blocks.emplace_back(folder.draw(figure, name, caption));
}

void append_forces(const ColumnState& state, const std::string& name, const ResultFolder& folder, Report& report) {
    if (state.columns.size() > most_drawn_columns) {
        return;
    }
    report.blocks.emplace_back(folder.draw(
        force_along_slope_figure(force_along_columns(state.columns, "Forces between columns " + state.name)), name,
        "Normal force that each column needs from the one below it; the larger of both demands acts, and "
        "none where both are zero."));
}

void append_sensitivity(const SteppedBase<>& problem, const SteppedBaseResult& result, const std::string& prefix,
                        const ResultFolder& folder, Report& report) {
    if (result.limit != LimitState::found) {
        report.blocks.emplace_back(
            Paragraph{"There is no limiting equilibrium whose dependence on geometry and inputs could be shown."});
        return;
    }
    if (!can_sweep(problem)) {
        report.blocks.emplace_back(
            Paragraph{"With so many columns the dependence on geometry and inputs is not computed."});
        return;
    }
    report.blocks.emplace_back(folder.draw(
        tornado_figure("Change of the factor of safety", sensitivity_bars(problem, result.factor_of_safety)),
        prefix + "sensitivity", "By recalculation, one input at a time; the base is held."));
}

}  // namespace

void append_case_figures(const SteppedBaseStudy<>& study, const ResultFolder& folder, Report& report) {
    const SteppedBase<> problem = resolve(study).problem;
    const SteppedBaseResult result = analyse(problem);
    const ColumnSlope<> slope = make_columns(problem.scene);
    const ColumnState given = as_given(problem, slope);
    const ColumnState limit = limiting(problem, slope, result);
    const bool found = result.limit == LimitState::found;

    report.blocks.emplace_back(Heading{"Section"});
    append_section(problem, limit, {}, found ? profile_after_failure(problem, result) : Polyline{}, "section", folder,
                   report);
    append_forces(limit, "forces", folder, report);

    if (study.linear_programming_bound) {
        append_bound_figures(problem, result, *study.linear_programming_bound, folder, report);
    }

    report.blocks.emplace_back(Heading{"Column by column"});
    report.blocks.emplace_back(
        Paragraph{"P acts normal to the joints, friction on them is fully mobilised by columns that move; R and S are "
                  "the normal and the up-dip force of the base. Heights are above each column's own base, the place of "
                  "R is a share of the width from the toe corner."});
    if (found) {
        report.blocks.emplace_back(column_table("Columns " + limit.name + ".", limit.columns));
    }
    report.blocks.emplace_back(column_table("Columns " + given.name + ".", given.columns));
    folder.write("columns.csv", columns_csv(given.columns, found ? limit.columns : std::vector<ColumnResult>{}));

    report.blocks.emplace_back(Heading{"Geometry and sensitivity"});
    if (found && can_sweep(problem)) {
        for (const GeometrySweep& sweep : geometry_sweeps(problem, result.factor_of_safety)) {
            report.blocks.emplace_back(folder.draw(sweep.figure, sweep.file, sweep.caption));
        }
    }
    append_sensitivity(problem, result, "", folder, report);
}

void append_mechanism_figures(const SteppedBaseStudy<>& at_best, const MechanismFit& fit, const FitProblem& problem,
                              const ResultFolder& folder, Report& report) {
    const SteppedBase<> best = resolve(at_best).problem;
    const SteppedBaseResult result = analyse(best);
    if (result.check != ColumnCheck::valid) {
        return;
    }
    const std::vector<std::string> warnings =
        analyse_case(SteppedBaseStudy<>{best, std::nullopt, {}, {}, std::nullopt}).warnings;
    if (!warnings.empty()) {
        report.blocks.emplace_back(Notice{NoticeKind::warning, "The columns at the best point", warnings});
    }
    const ColumnState limit = limiting(best, make_columns(best.scene), result);
    append_section(best, limit, problem.profile ? problem.profile->profile : Polyline{},
                   profile_after_failure(best, result), fit.name + "_section", folder, report);
    append_forces(limit, fit.name + "_forces", folder, report);
    append_sensitivity(best, result, fit.name + "_", folder, report);
}

}  // namespace delabole
