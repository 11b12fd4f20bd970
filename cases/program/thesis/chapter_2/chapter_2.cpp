// The calculations of the thesis's chapter 2.
#include "cases/program/thesis/chapter_2/chapter_2.hpp"

#include "cases/program/models/plane_failure/figures.hpp"
#include "cases/program/reader/units.hpp"
#include "cases/program/thesis/imperial.hpp"
#include "cases/program/thesis/reproduction.hpp"
#include "cases/program/thesis/thesis_tables.hpp"
#include "fitting/work/words.hpp"
#include "plots/drawing/text.hpp"
#include "plots/figures/figures.hpp"

#include <cmath>
#include <stdexcept>

namespace delabole {

namespace {

Table solutions_table(CsvTable& csv) {
    Table table{
        "Crack depth z that makes the slope just fail, for plausible unit weights",
        {"reading of \"full\"", "unit weight"_number, "z"_number, "depth of the crack"_number,
         "level of its bottom"_number, "it opens in", "FS half full, c = 0"_number, "restoring / overturning"_number}};
    for (const FilledFraction reading : {FilledFraction::of_z_below_crest, FilledFraction::of_the_crack_itself}) {
        const std::string words(word_of(reading));
        for (const double unit_weight : {24e3, 25e3, 26e3, 27e3, 28e3, 29e3}) {
            const Fig28Solution solution = solve_fig_2_8(reading, unit_weight);
            const std::string weight = value_in_words(unit_weight, Dimension::unit_weight);
            if (!solution.z) {
                table.rows.push_back({words, weight, "no solution"});
                csv.add_row({words, unit_weight / 1e3, std::string("none")});
                continue;
            }
            const double base_level = 350 + solution.state.crack_base_height / foot;
            const std::string place(word_of(solution.state.crack_location));
            table.rows.push_back({words, weight, value_in_words(std::round(*solution.z * 10) / 10, Dimension::length),
                                  value_in_words(solution.state.crack_depth, Dimension::length),
                                  number_in_words(base_level) + " ft", place,
                                  number_in_words(solution.factor_half_full),
                                  number_in_words(solution.state.overturning_factor)});
            csv.add_row({words, unit_weight / 1e3, *solution.z, solution.state.crack_depth, base_level, place,
                         solution.factor_half_full, solution.state.overturning_factor});
        }
    }
    return table;
}

WaterDepthCurves fig_2_8_curves(const Fig28Solution& solution) {
    WaterDepthCurves curves;
    curves.title = "Fig 2.8 (b): factor of safety against water in the crack";
    curves.ratio = "depth of water / z";
    for (const double share : {0.0, 0.5, 1.0}) {
        NamedCurve curve{
            .legend = "c = " + number_in_words(30 * share) + " lbf/in2",
            .points = fig_2_8_curve(solution.reading, solution.unit_weight, *solution.z, share * fig_2_8_cohesion)};
        curves.curves.push_back(std::move(curve));
    }
    curves.statements = {{"stable, half full, c = 0 (printed)", Point(0.5, solution.factor_half_full)},
                         {"fails, two thirds full, c = 30 lbf/in2 (printed)", Point(2.0 / 3, 1)}};
    return curves;
}

Reproduction reproduce_fig_2_8(const Sheet& sheet) {
    const Fig28Solution solution = solve_fig_2_8(FilledFraction::of_z_below_crest, 27e3);
    if (!solution.z) {
        throw std::logic_error("fig2.8: no depth of crack meets the printed statement");
    }
    Reproduction result;
    result.add({"FS, crack two thirds full, c = 30 lbf/in2", "1 (unstable beyond)",
                readable_quantity(solution.state.factor_of_safety, Dimension::ratio),
                difference_in_words(solution.state.factor_of_safety - 1), "z is solved for this statement"});
    result.add("FS, crack half full, c = 0", "more than 1 (stable)", number_in_words(solution.factor_half_full),
               statement(solution.factor_half_full > 1));
    constexpr double intact = 20;  // MN/m2, the least of Richards's strengths
    const double stress = 27e3 * 225 * foot / 1e6;
    result.add({"(a) stress below 225 ft of slate of 27 kN/m3", "2 MN/m2, several times below 20",
                human_number(stress, 3) + " MN/m2", human_number(stress - 2, 2) + " MN/m2",
                statement(intact > 3 * stress) + ": strength over stress " + human_number(intact / stress, 3)});
    sheet.add(Heading{"Fig 2.8: plane failure with a crack in the face"});
    sheet.add(
        Paragraph{"H, z and the unit weight are not printed. H is taken between the printed levels 575 and 350 ft; z "
                  "follows from the printed statement that two thirds of the crack must be full for the slope to fail "
                  "with 30 lbf/in2; the other statement, stable when half full without cohesion, is then a check."});
    sheet.add(printed_table("Printed statements", result.rows));
    CsvTable csv({"full_means", "unit_weight_kN_per_m3", "z_m", "crack_depth_m", "crack_base_level_ft",
                  "crack_location", "factor_half_full", "overturning_factor"});
    sheet.add(solutions_table(csv));
    sheet.add(
        Paragraph{"z is measured from crest level in the printed formulas (A = (H - z) cosec psi_p), so a crack in the "
                  "face is shallower than z. Read as a fraction of z, every unit weight from 25 kN/m3 on gives a crack "
                  "in the face whose bottom lies within 11 ft of the level, 425 ft, at which the observed surfaces "
                  "meet. Read as a fraction of the crack's own depth there is no crack in the face that meets the "
                  "statement. Restoring over overturning moment about the toe is below 1: the mass would overturn "
                  "before it slides, which the printed force balance does not see."});
    const auto drawn = std::get<PlaneFailureStudy<>>(built_in_case("plane_failure", "fig_2_8").model);
    sheet.draw(
        section_figure(section_drawing(drawn.model, "Fig 2.8 (a): the slope and its crack")), "fig_2_8a",
        "The lower surface, drawn as one plane at 40 deg, is stepped: joints and cleavage add 46 deg of friction.");
    sheet.draw(factor_of_safety_against_water(fig_2_8_curves(solution)), "fig_2_8b",
               "Factor of safety against the filled fraction of z, at 27 kN/m3.");
    sheet.write("fig_2_8.csv", csv.text());
    return result;
}

}  // namespace

ReproductionChapter chapter_2() {
    return {
        "chapter2",
        "the calculations of chapter 2",
        "Thesis, chapter 2: printed and computed",
        {
            {"fig2.8", "2.3.2, Fig 2.8", "plane failure of the west face; its unprinted crack depth and curves",
             reproduce_fig_2_8},
            data_item("tilting", "2.3.5, Fig 2.15", "groundwater by tilting the model, section 2.3.5", "plane_failure",
                      {"groundwater_by_tilting"}),
            {"mechanisms", "2.3.3.2", "modes of failure tried on models of the west face, verdicts of section 2.3.3.2",
             reproduce_mechanisms},
            {"drawings", "Figs 2.1 to 2.15",
             "Figs 2.1, 2.4 to 2.7, 2.10 and 2.15: the joint sets, the failure and the models",
             reproduce_slope_drawings},
            {"plates", "Plates 2.I to 2.VI", "Plates 2.I to 2.VI as runs in motion, scored by the field criteria",
             reproduce_plates, ReproductionCost::minutes},
            data_item("plate2.iii", "Plate 2.III", "which friction lets the model of Plate 2.III fail",
                      "thesis/chapter_2", {"plate_2_iii_friction"}, ReproductionCost::minutes),
            {"groundwater", "2.3.5", "one column with groundwater: tests and observations of section 2.3.5",
             reproduce_groundwater},
            {"trends", "2.3.4", "Figs 2.11 to 2.14 as trends of runs, conclusions (i) to (iv) of section 2.3.4",
             reproduce_trends, ReproductionCost::minutes},
            {"column_motion", "2.3.5, Plates 2.VII to IX",
             "one column with groundwater in motion: observations 1 to 4 of section 2.3.5", reproduce_column_motion,
             ReproductionCost::minutes},
            data_item("dry_friction", "2.3.3.2 A", "dry factor of safety of section 2.3.3.2 A", "plane_failure",
                      {"dry_cohesionless"}),
        }};
}

}  // namespace delabole
