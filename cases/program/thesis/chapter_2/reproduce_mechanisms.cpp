// The modes of failure that were tried on models of the Delabole face (2.3.3.2 of the thesis, Plates 2.I to 2.VI), with
// its verdicts by the three field criteria, and whether statics allows each mode at all.
#include "cases/program/thesis/chapter_2/chapter_2.hpp"
#include "cases/program/thesis/physical_models.hpp"
#include "fitting/work/words.hpp"
#include "plots/drawing/text.hpp"

#include <cmath>

namespace delabole {

namespace {

Table verdict_table(const std::vector<MechanismVerdict>& verdicts) {
    Table table{"Verdicts of the thesis",
                {"plate", "mode of failure", "profile", "crest cracks", "block movements", "what happened"}};
    for (const MechanismVerdict& verdict : verdicts) {
        table.rows.push_back({verdict.plate, human_name(verdict.mechanism), human_name(word_of(verdict.profile)),
                              human_name(word_of(verdict.cracks)), human_name(word_of(verdict.movements)),
                              verdict.remark});
    }
    return table;
}

void add_sliding(const MechanismVerdict& verdict, Reproduction& result) {
    const double factor = std::tan(mixture_friction) / std::tan(*verdict.joint_c_dip);
    result.add(verdict.plate + ": factor of safety on joint C, dry", "slides", number_in_words(factor),
               statement(factor < 1) + ": cot(psi_p) tan(phi), friction 40.5 deg");
    result.json["sliding"][verdict.plate] = factor;
}

// Columns that dip at b into the slope can slip past one another, and so bend or turn, where the face is steeper than
// 90 deg - b + phi (Goodman & Bray 1976): the stress in the face is parallel to it.
void add_toppling(const MechanismVerdict& verdict, Reproduction& result) {
    if (!verdict.slope_angle) {
        return;
    }
    const double least = degrees(90) - *verdict.joint_b_dip + mixture_friction;
    result.add(verdict.plate + ": least face for columns of joint B to slip",
               "toppled at " + value_in_words(*verdict.slope_angle, Dimension::angle),
               value_in_words(least, Dimension::angle), statement(*verdict.slope_angle > least));
    result.json["toppling_least_face_deg"][verdict.plate] = least / degrees(1);
}

}  // namespace

Reproduction reproduce_mechanisms(const Sheet& sheet) {
    const std::vector<MechanismVerdict> verdicts = rows_of<MechanismVerdict>();
    Reproduction result;
    for (const MechanismVerdict& verdict : verdicts) {
        if (verdict.mechanism == "simple_sliding") {
            add_sliding(verdict, result);
        } else if (verdict.joint_b_dip) {
            add_toppling(verdict, result);
        }
    }
    const double column = std::tan(mixture_friction) / std::tan(verdicts.front().joint_a_dip);
    result.add("2.II: factor of safety of an undermined column on joint A", "slides into the gap",
               number_in_words(column), statement(column < 1));
    sheet.add(Heading{"Modes of failure tried on models (2.3.3.2)"});
    sheet.add(printed_table("Whether each mode can happen, by statics", result.rows));
    sheet.add(verdict_table(verdicts));
    return result;
}

}  // namespace delabole
