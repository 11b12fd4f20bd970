// Groundwater by tilting: answers for reports, which have no figures.
#include "cases/program/results/model_reports.hpp"
#include "fitting/work/words.hpp"

namespace delabole {

HeadCard head_card(const TiltedColumn<>&, const ColumnTilt& tilt) {
    return {AnswerTone::open,
            {"A tilt of " + value_in_words(tilt.tilt, Dimension::angle) + " stands for the water.",
             "Its force is " + number_in_words(tilt.water_force_over_weight) + " of the column's weight."},
            {}};
}

}  // namespace delabole
