// Groundwater by tilting as the program reports it: numbers only.
#include "cases/program/results/model_reports.hpp"
#include "fitting/work/words.hpp"

namespace delabole {

ColumnTilt analyse_case(const TiltedColumn<>& column, const AnalysisWork&) {
    return column_tilt(column);
}

Analysis named_outputs(const TiltedColumn<>&, const ColumnTilt& tilt) {
    Analysis analysis;
    append_outputs(analysis, tilt);
    return analysis;
}

HeadCard head_card(const TiltedColumn<>&, const ColumnTilt& tilt) {
    return {AnswerTone::open,
            {"A tilt of " + value_in_words(tilt.tilt, Dimension::angle) + " stands for the water.",
             "Its force is " + number_in_words(tilt.water_force_over_weight) + " of the column's weight."},
            {}};
}

void append_case_figures(const TiltedColumn<>&, const ColumnTilt&, const ResultFolder&, Report&) {}

void append_mechanism_figures(const TiltedColumn<>&, const MechanismFit&, const FitProblem&, const ResultFolder&,
                              Report&) {}

Impossibility impossibility(const TiltedColumn<>&, std::string_view failure) {
    return {{}, std::string(failure)};
}

}  // namespace delabole
