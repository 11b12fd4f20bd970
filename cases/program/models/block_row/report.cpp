// Rows of blocks on a plane: the governing mode, all modes and the forces for reports.
#include "cases/program/models/block_row/drawing.hpp"
#include "cases/program/reader/units.hpp"
#include "cases/program/results/model_reports.hpp"
#include "fitting/work/words.hpp"
#include "limit_equilibrium/block_row/block_row.hpp"
#include "plots/drawing/text.hpp"

#include <algorithm>
#include <string>
#include <variant>

namespace delabole {

namespace {

constexpr std::size_t most_named_modes = 200;
constexpr std::size_t most_named_blocks = 200;
constexpr std::size_t most_rows = 60;
constexpr std::size_t most_drawn_blocks = 1000;

std::string_view in_words(RowModeCheck check) {
    static constexpr auto words = std::to_array<std::string_view>(
        {"admissible", "moments balance at no tilt below 90°", "φ + ψ ≥ 90°: no thrust pushes a block forward",
         "one unknown too few: thrusts from below and from above disagree", "blocks would have to pull one another",
         "the plane would have to pull", "the pivot's toe would slip", "a thrust would act outside its interface",
         "a sliding block would overturn", "adhering blocks would slip on each other",
         "the standing block above is in the way", "the standing blocks fail first"});
    static_assert(words.size() == enum_names(RowModeCheck{}).size());
    return words[static_cast<std::size_t>(check)];
}

// A tilt of 90 deg means that there is none.
std::string tilt_shown(double tilt) {
    return tilt < degrees(90) ? human_number(tilt / degrees(1), 5) : "–";
}

Table mode_table(const std::vector<RowModeSummary>& modes) {
    std::vector<const RowModeSummary*> sorted;
    sorted.reserve(modes.size());
    for (const RowModeSummary& mode : modes) {
        sorted.push_back(&mode);
    }
    std::ranges::stable_sort(sorted, [](const RowModeSummary* first, const RowModeSummary* second) {
        const bool one = first->admissibility == RowModeCheck::admissible;
        const bool other = second->admissibility == RowModeCheck::admissible;
        return one != other ? one : first->critical_tilt < second->critical_tilt;
    });
    Table table{"Modes: the admissible ones first, by tilt.",
                {"mode", "begins at tilt, °"_number, "second solution, °"_number, "can it happen?"}};
    if (sorted.size() > most_rows) {
        table.caption +=
            " The first " + std::to_string(most_rows) + " of " + std::to_string(sorted.size()) + "; modes.csv has all.";
        sorted.resize(most_rows);
    }
    for (const RowModeSummary* mode : sorted) {
        table.rows.push_back({mode->roles, tilt_shown(mode->critical_tilt), tilt_shown(mode->second_critical_tilt),
                              std::string(in_words(mode->admissibility))});
    }
    return table;
}

// A tilt of 90 deg means that there is none.
Cell tilt_or_none(double tilt) {
    return tilt < degrees(90) ? Cell(tilt) : "none";
}

Cell tilt_in_csv(double tilt) {
    return tilt < degrees(90) ? Cell(tilt / degrees(1)) : "none";
}

std::string modes_csv(const std::vector<RowModeSummary>& modes) {
    CsvTable csv({"roles", "admissibility", "critical_tilt_deg", "second_critical_tilt_deg"});
    for (const RowModeSummary& mode : modes) {
        csv.add_row({mode.roles, std::string(word_of(mode.admissibility)), tilt_in_csv(mode.critical_tilt),
                     tilt_in_csv(mode.second_critical_tilt)});
    }
    return csv.text();
}

char role_of(const BlockRowResult& result, std::size_t index) {
    return result.answer.mode[index];
}

Table block_table(const BlockRowResult& result) {
    const std::string unit = human_unit(display_unit(Dimension::force_per_length).symbol);
    Table table{"Forces in the mode " + (result.block.size() > most_rows ? "" : result.answer.mode) + " at " +
                    value_in_words(result.answer.critical_tilt, Dimension::angle) + ".",
                {{"block", true},
                 {"role"},
                 {"thrust from above, " + unit, true},
                 {"at height, m", true},
                 {"shear, " + unit, true},
                 {"base normal, " + unit, true},
                 {"base shear, " + unit, true},
                 {"from toe, m", true}}};
    const auto force = [](double value) {
        return human_number(in_display_unit(value, Dimension::force_per_length), 5);
    };
    const auto length = [](double value) { return human_number(value, 4); };
    for (std::size_t index = 0; index < std::min(result.block.size(), most_rows); ++index) {
        const RowBlockForces& block = result.block[index];
        table.rows.push_back({std::to_string(index + 1), std::string(1, role_of(result, index)), force(block.thrust),
                              length(block.thrust_height), force(block.shear), force(block.normal_force),
                              force(block.base_shear), length(block.base_position)});
    }
    if (result.block.size() > most_rows) {
        table.caption += " The lowest " + std::to_string(most_rows) + " blocks; blocks.csv has all.";
    }
    return table;
}

std::string blocks_csv(const BlockRowResult& result) {
    std::vector<std::string> titles{"block", "role"};
    append_titles<RowBlockForces>(titles);
    CsvTable csv(titles);
    for (std::size_t index = 0; index < result.block.size(); ++index) {
        std::vector<Cell> row{static_cast<double>(index + 1), std::string(1, role_of(result, index))};
        append_cells(row, result.block[index]);
        csv.add_row(row);
    }
    return csv.text();
}

void append_modes(Analysis& analysis, const BlockRowResult& result) {
    if (result.mode.size() > most_named_modes) {
        return;
    }
    for (const RowModeSummary& mode : result.mode) {
        const std::string name = "mode." + mode.roles + ".";
        analysis.outputs.push_back({name + "admissibility", "admissible, or why not", Dimension::ratio,
                                    std::string(word_of(mode.admissibility)), true});
        for_each_named_number(mode, [&](const std::string& key, const FieldInfo& info, double value) {
            analysis.outputs.push_back(
                {name + key, std::string(info.meaning), info.dimension, tilt_or_none(value), true});
        });
    }
}

// The modes of a long row are abbreviated: "S x 12, P, B x 987".
std::string mode_in_words(const std::string& roles) {
    constexpr std::size_t most_letters = 24;
    if (roles.size() <= most_letters) {
        return roles;
    }
    std::vector<std::string> runs;
    for (std::size_t begin = 0; begin < roles.size();) {
        const std::size_t end = std::min(roles.find_first_not_of(roles[begin], begin), roles.size());
        runs.push_back(std::string(1, roles[begin]) + (end - begin > 1 ? " × " + std::to_string(end - begin) : ""));
        begin = end;
    }
    return list_in_words(runs);
}

}  // namespace

Analysis named_outputs(const BlockRow& row, const BlockRowResult& result) {
    Analysis analysis;
    append_outputs(analysis, result.answer);
    for (NamedOutput& output : analysis.outputs) {
        if (output.name.starts_with("mode")) {
            output.value = mode_in_words(std::get<std::string>(output.value));
        } else if (const auto* tilt = std::get_if<double>(&output.value);
                   output.name.starts_with("critical_tilt") && tilt != nullptr) {
            output.value = tilt_or_none(*tilt);
        }
    }
    append_modes(analysis, result);
    for (std::size_t index = 0; index < std::min(row.block.size(), most_named_blocks); ++index) {
        const RowBlockForces forces = result.block.empty() ? RowBlockForces{} : result.block[index];
        append_outputs(analysis, forces, "block[" + std::to_string(index + 1) + "]", true);
    }
    if (result.block.empty()) {
        mark_none(analysis, "block[");
    }
    if (result.answer.search == RowSearchKind::bounded) {
        analysis.warnings.emplace_back(
            "the row is too long for every mode to be examined: the answer is a mode that can happen, but where base "
            "friction varies or standing blocks need one another, one of a lesser tilt may exist");
    }
    if (result.answer.search == RowSearchKind::upper_bound) {
        analysis.warnings.emplace_back(
            "none of the modes examined satisfies statics and kinematics: unequal blocks may begin to move in ways "
            "that are not among them. The critical tilt is a bound by linear programming from the unsafe side: beyond "
            "it nothing keeps the row in equilibrium, below it a row that is not pressed together may fail");
    }
    return analysis;
}

HeadCard head_card(const BlockRow&, const BlockRowResult& result) {
    const RowAnswer& answer = result.answer;
    HeadCard head{AnswerTone::bad, {}, {}};
    std::string state = "The row fails: it " + human_name(word_of(answer.state)) + ".";
    if (answer.state == RowState::stands) {
        head.tone = AnswerTone::good;
        state = "The row stands.";
    } else if (answer.state == RowState::stands_if_pressed) {
        head.tone = AnswerTone::open;
        state = "The row stands only if its blocks are pressed together.";
    }
    head.sentences = {std::move(state),
                      "It begins to move at a tilt of " + value_in_words(answer.critical_tilt, Dimension::angle) +
                          (answer.mode.empty() ? "; no mode is admissible, and this is a bound from the unsafe side."
                                               : ", in mode " + mode_in_words(answer.mode) + ".")};
    return head;
}

void append_case_figures(const BlockRow& row, const BlockRowResult& result, const Sheet& sheet) {
    const std::string roles = mode_in_words(result.answer.mode);
    if (result.answer.search == RowSearchKind::upper_bound) {
        sheet.add(Paragraph{
            "No mode is admissible, and so there are no forces to show. The tilt is the bound by linear programming: "
            "the greatest at which contact forces within Coulomb's cones keep every block in equilibrium."});
    } else if (row.block.size() <= most_drawn_blocks) {
        sheet.draw(block_figure(row_drawing(
                       row, result.answer.mode, result.answer.critical_tilt, result.block,
                       "Mode " + roles + " at " + value_in_words(result.answer.critical_tilt, Dimension::angle))),
                   "mode",
                   "The blocks at the tilt at which the governing mode begins, with the forces at that moment.");
    } else {
        sheet.add(Paragraph{"There are " + std::to_string(row.block.size()) +
                            " blocks, too many to be told apart in a drawing."});
    }
    if (!result.block.empty()) {
        sheet.add(Heading{"The row in its governing mode"});
        sheet.add(block_table(result));
    }
    sheet.add(Heading{"Every mode"});
    sheet.add(
        Paragraph{"A mode gives every block a letter, from the lowest up: S slides; F, P and B turn forward about the "
                  "toe, which slides forward (F), does not slide (P) or slides backward (B); = adheres to the block "
                  "below and turns with it; 0 stands; R is pushed back up the plane. The governing mode is the "
                  "admissible one that begins at the least tilt: nothing presses the blocks together. Blocks that are "
                  "pressed together may stand up to the tilt given for contact, and no further."});
    sheet.add(mode_table(result.mode));
    sheet.write("modes.csv", modes_csv(result.mode));
    sheet.write("blocks.csv", blocks_csv(result));
}

void append_mechanism_figures(const BlockRow& at_best, const MechanismFit& fit, const FitProblem&, const Sheet& sheet) {
    const BlockRowResult result = analyse(at_best);
    if (result.check != BlockRowCheck::valid || result.block.empty() || at_best.block.size() > most_drawn_blocks) {
        return;
    }
    sheet.draw(block_figure(row_drawing(at_best, result.answer.mode, result.answer.critical_tilt, result.block,
                                        "Mode " + mode_in_words(result.answer.mode))),
               fit.name + "_mode", "The governing mode at the best point.");
}

Impossibility impossibility(const BlockRow& row, std::string_view failure) {
    const std::string count = std::to_string(row.block.size());
    Impossibility found = stated_impossibility(BlockRow::kind, failure);
    if (failure == word_of(BlockRowCheck::too_many_blocks)) {
        found.words += ": there are " + count;
    } else if (failure == word_of(BlockRowCheck::no_admissible_mode) && row.block.size() > most_bounded_row) {
        found.words = "none of the modes examined satisfies statics and kinematics, and " + count +
                      " blocks are too many for the bound by linear programming, at most " +
                      std::to_string(most_bounded_row) + ": there is no answer";
    }
    return found;
}

}  // namespace delabole
