// The thesis's chapter 3: its tables, its models as runs of blocks in motion, and limit equilibrium beside its graphs.
#include "cases/program/thesis/chapter_3/chapter_3.hpp"
#include "cases/program/thesis/reproduction.hpp"

namespace delabole {

ReproductionChapter chapter_3() {
    return {"chapter3",
            "physical model tests, chapter 3",
            "Thesis, chapter 3: printed and computed",
            {
                {"table3.2", "3.4.1, Table 3.2", "base friction tests: what the tables say of the text",
                 reproduce_table_3_2},
                {"plates3", "Plates 3.I to 3.XIII", "the base friction models drawn, with their printed crack paths",
                 reproduce_base_friction_plates},
                {"base_friction", "3.2, Table 3.2",
                 "a base friction model of Table 3.2 in motion: the path along which its columns break",
                 reproduce_base_friction_run},
                {"tilting_frame", "3.3",
                 "rows of columns tilted until they fail, with the scatter of plaster: Figs 3.4, 3.6, 3.7",
                 reproduce_tilting_runs, ReproductionCost::minutes},
                {"fig3.2", "Fig 3.2, Table 3.3",
                 "base friction: crack path and its time against slope height (Table 3.3)", reproduce_fig_3_2},
                data_item("fig3.4", "Fig 3.4", "single column on the tilting frame, theoretical curve",
                          "thesis/chapter_4", {"fig_3_4"}),
                data_item("fig3.5", "Fig 3.5", "what an adjacent column adds: its friction, its toe, its height",
                          "thesis/chapter_3", {"fig_3_5"}),
                {"fig3.6", "Fig 3.6", "rows of one to four equal columns on the tilting frame", reproduce_fig_3_6},
                {"fig3.7", "Fig 3.7, Plate 3.XIV",
                 "columns of growing and falling height on the tilting frame, Plate 3.XIV", reproduce_fig_3_7},
            }};
}

}  // namespace delabole
