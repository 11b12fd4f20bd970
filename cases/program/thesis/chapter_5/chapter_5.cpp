#include "cases/program/thesis/chapter_5/chapter_5.hpp"

#include "cases/program/terminal/interrupt.hpp"
#include "cases/program/thesis/chapter_5/relaxation_drawing.hpp"
#include "cases/program/thesis/thesis_tables.hpp"
#include "fitting/work/words.hpp"
#include "parameters/fields.hpp"
#include "plots/drawing/text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <sstream>

namespace delabole {

namespace {

struct EngineWords {
    std::string_view name;
    std::string_view start;  // of the clean engine
};

constexpr std::array<EngineWords, 3> engine_words{
    {{"re-created program", ""}, {"clean engine, dropped", "dropped"}, {"clean engine, preloaded", "preloaded"}}};

std::string in_words(HockingOutcome outcome) {
    return human_name(word_of(outcome));
}

std::string in_words(const SettledCycles& settled) {
    return std::to_string(settled.x) + " / " + std::to_string(settled.y);
}

std::string printed_in_words(const Chapter5Run& run) {
    return run.printed_settled ? in_words(*run.printed_settled)
           : run.printed_cycle ? in_words(run.printed) + ", momentum after " + std::to_string(*run.printed_cycle)
                               : in_words(run.printed);
}

// Outcome in words, with the cycle at which the first block has turned by a degree.
std::string outcome_with_rotation(const Chapter5Run& run, const HockingResult& result) {
    const auto turned = cycle_of_rotation(run, result, degrees(1));
    return outcome_in_words(result) + (turned ? ", 1 deg at " + std::to_string(*turned) : "");
}

std::string settled_or_turned(const Chapter5Run& run, const HockingResult& result) {
    return result.outcome == HockingOutcome::stands ? settled_in_words(result) : outcome_with_rotation(run, result);
}

// Adds every run's outcome beside the printed one, also to result.json; where they differ, those of shifted starts too.
void add_outcomes(const std::string& what, const std::vector<Chapter5Run>& runs, Reproduction& result) {
    constexpr int starts = 20;
    for (const Chapter5Run& run : runs) {
        PrintedRow row{what + ", " + run.name, in_words(run.printed), "", "", ""};
        for (const Engine engine : engines) {
            const HockingResult computed = compute(run, engine);
            const std::string words = outcome_in_words(computed);
            const bool agrees = computed.outcome == run.printed;
            const auto& [name, start] = engine_words[static_cast<std::size_t>(engine)];
            if (engine != Engine::recreated) {
                row.clean += (row.clean.empty() ? "" : "; ") + std::string(start) + " " + words;
            } else {
                row.computed = words;
                row.remark = statement(agrees);
                if (!agrees) {
                    const std::vector<HockingResult> shifted = compute_shifted(run, engine, typed_digit, starts);
                    row.remark += "; with the last typed digits shifted, " + in_words(shifted);
                    result.json["shifted"][what][run.name] = {
                        {"runs", starts}, {"agree", std::ranges::count(shifted, run.printed, &HockingResult::outcome)}};
                }
                result.json["outcomes"][what][run.name] = {
                    {"printed", in_words(run.printed)}, {"computed", words}, {"agrees", agrees}};
            }
            result.json["outcomes_by_scheme"][std::string(name)][what][run.name] = {{"computed", words},
                                                                                    {"agrees", agrees}};
        }
        result.add(row);
    }
}

// Counts the outcomes as printed if gravity turns instead of the base, of which the thesis says nothing.
void add_outcomes_with_gravity(const std::string& what, const std::vector<Chapter5Run>& runs, Reproduction& result) {
    const auto agree = std::ranges::count_if(
        runs, [](const Chapter5Run& run) { return compute(run, Engine::recreated).outcome == run.printed; });
    result.json["gravity_turned"][what] = {{"agree", agree}, {"of", runs.size()}};
    result.add(what + ", gravity turned instead: outcomes as printed", std::to_string(runs.size()),
               std::to_string(agree),
               statement(agree == std::ssize(runs)) +
                   ": so the base was turned: turned gravity pushes nothing, and no input that 'tilted_blocks' changes "
                   "gives all outcomes with it");
}

void add_settled(const std::string& what, const std::string& remark, const std::vector<Chapter5Run>& runs,
                 Reproduction& result) {
    int largest = 0;
    for (const Chapter5Run& run : runs) {
        if (run.printed_settled) {
            const HockingResult computed = compute(run, Engine::recreated);
            const SettledCycles settled = settled_cycles(computed);
            const SettledCycles difference{settled.x - run.printed_settled->x, settled.y - run.printed_settled->y};
            const bool stands = computed.outcome == HockingOutcome::stands;
            largest = std::max({largest, std::abs(difference.x), std::abs(difference.y)});
            result.add({what + ", " + run.name + ": cycles until CX / CY rest", in_words(*run.printed_settled),
                        settled_or_turned(run, computed), stands ? in_words(difference) : "", remark,
                        settled_or_turned(run, compute(run, Engine::dropped))});
        }
    }
    result.json["largest_difference_of_settled_cycles"][what] = largest;
}

void add_behaviour(const std::string& what, const std::string& printed, const Chapter5Run& run, Reproduction& result) {
    const HockingResult computed = compute(run, Engine::recreated);
    const HockingResult clean = compute(run, Engine::dropped);
    result.add(what, printed, behaviour_in_words(run, computed), statement(behaves_as_printed(run, computed)),
               behaviour_in_words(run, clean));
    result.json["behaves_as_printed"][run.name] = behaves_as_printed(run, computed);
    result.json["clean_behaves_as_printed"][run.name] = behaves_as_printed(run, clean);
}

// Makes a row for each run: what is printed, and what each engine gives: cycles, or outcomes with the behaviour of the
// columns.
Table table_of_group(const std::string& caption, const std::string& heading, const std::vector<Chapter5Run>& runs) {
    const bool settled = std::ranges::any_of(runs, [](const auto& run) { return run.printed_settled.has_value(); });
    Table table{caption, {{heading}, "printed"_number}};
    for (const EngineWords& words : engine_words) {
        table.columns.emplace_back(std::string(words.name), true);
    }
    for (const Chapter5Run& run : runs) {
        std::vector<std::string>& row = table.rows.emplace_back(std::vector{run.name, printed_in_words(run)});
        for (const Engine engine : engines) {
            const HockingResult result = compute(run, engine);
            row.push_back(settled ? settled_or_turned(run, result)
                          : run.printed_behaviour.empty()
                              ? outcome_with_rotation(run, result)
                              : outcome_in_words(result) + ": " + behaviour_in_words(run, result));
        }
    }
    return table;
}

enum class ReportPart {
    item,
    heading,
    subheading,
    paragraph,
    outcomes,
    outcomes_with_gravity,
    settled,
    table,
    behaviour,
    frames,
    swings,
    computation,
    rows
};

// A row of cases/thesis/chapter_5/report.csv, whose comments explain the columns.
struct ReportRow {
    std::string item;
    ReportPart part;
    std::string runs;
    std::string run;
    std::string with;
    std::string cycles;
    std::string name;
    std::string title;
    std::string text;
    static constexpr std::string_view file = "thesis/chapter_5/report.csv";
    static constexpr auto fields() {
        using R = ReportRow;
        return table_columns<&R::item, &R::part, &R::runs, &R::run, &R::with, &R::cycles, &R::name, &R::title,
                             &R::text>();
    }
};

const std::vector<ReportRow>& report_rows() {
    static const std::vector<ReportRow> rows = rows_of<ReportRow>();
    return rows;
}

std::vector<Chapter5Run> runs_of(const ReportRow& row) {
    std::vector<Chapter5Run> runs;
    std::istringstream groups(row.runs);
    for (std::string group; std::getline(groups >> std::ws, group, ';');) {
        std::ranges::move(chapter_5_runs(group, row.with == "base" ? TiltedPart::base : TiltedPart::gravity),
                          std::back_inserter(runs));
    }
    std::erase_if(runs, [&](const Chapter5Run& run) {
        return !row.run.empty() && ("; " + row.run + ";").find("; " + run.name + ";") == std::string::npos;
    });
    return runs;
}

// Returns the drawings of an item, in their order.
std::vector<Figure> frames_of(const std::string& item) {
    std::vector<Figure> figures;
    for (const ReportRow& row : report_rows()) {
        if (row.item == item && row.part == ReportPart::frames) {
            const Chapter5Run run = runs_of(row).front();
            std::istringstream text(row.cycles);
            const std::vector<int> cycles(std::istream_iterator<int>(text), {});
            const Engine engine = row.with == "clean" ? Engine::dropped : Engine::recreated;
            figures.push_back(frames_figure(row.title, run, compute(run, engine), cycles));
        }
    }
    set_one_scale(figures);
    return figures;
}

Computation& computation(const std::string& name) {
    static const std::map<std::string, Computation*> all{
        {"laws_of_contact", laws_of_contact},
        {"tilting_from_the_horizontal", tilting_from_the_horizontal},
        {"first_swings", first_swings},
        {"last_digits", last_digits},
        {"starts_of_two_blocks", starts_of_two_blocks},
        {"closed_gap", closed_gap},
        {"one_input_changed", one_input_changed},
        {"backward_sliding", backward_sliding},
        {"blow_out", blow_out},
        {"blow_outs_of_shifted_starts", blow_outs_of_shifted_starts},
        {"blow_outs_of_random_starts", blow_outs_of_random_starts},
        {"same_displacement", same_displacement},
        {"observations", observations},
        {"thresholds_by_stiffness", thresholds_by_stiffness},
        {"thresholds_by_step_and_damping", thresholds_by_step_and_damping},
        {"senses_of_three_blocks", senses_of_three_blocks},
        {"histories_of_four_blocks", histories_of_four_blocks},
        {"crack_of_the_tilting_frame", crack_of_the_tilting_frame},
        {"tension_cracks", tension_cracks},
        {"onset_of_the_stepped_base", onset_of_the_stepped_base}};
    return *all.at(name);
}

// "run | blow out #": # marks a column of numbers.
std::vector<TableColumn> columns_of(const std::string& titles) {
    std::vector<TableColumn> columns;
    std::istringstream text(titles);
    for (std::string title; std::getline(text >> std::ws, title, '|');) {
        const bool number = title.find(" #") != std::string::npos;
        title.erase(title.find_last_not_of(" #") + 1);
        columns.emplace_back(title, number);
    }
    return columns;
}

void compute_part(const ReportRow& row, Chapter5Item& item, Report& report) {
    item.table = {row.title, columns_of(row.text)};
    item.starts = row.cycles.empty() ? 0 : std::stoi(row.cycles);
    computation(row.name)(item);
    if (!item.table.rows.empty()) {
        report.add(item.table);
    }
    std::ranges::move(std::exchange(item.below, {}).blocks, std::back_inserter(report.blocks));
}

Reproduction reproduce_item(const std::string& name, const Sheet& sheet) {
    Chapter5Item item{sheet.folder};
    const std::vector<Figure> frames = frames_of(name);
    auto frame = frames.begin();
    for (const ReportRow& row : report_rows()) {
        if (row.item != name) {
            continue;
        }
        item.runs = runs_of(row);
        switch (row.part) {
        case ReportPart::item:
            break;
        case ReportPart::heading:
            sheet.add(Heading{row.text});
            break;
        case ReportPart::subheading:
            sheet.add(Heading{row.text, 3});
            break;
        case ReportPart::paragraph:
            sheet.add(Paragraph{row.text});
            break;
        case ReportPart::outcomes:
            add_outcomes(row.text, item.runs, item.result);
            break;
        case ReportPart::outcomes_with_gravity:
            add_outcomes_with_gravity(row.text, item.runs, item.result);
            break;
        case ReportPart::settled:
            add_settled(row.text, row.title, item.runs, item.result);
            break;
        case ReportPart::table:
            sheet.add(table_of_group(row.title, row.name, item.runs));
            break;
        case ReportPart::behaviour:
            add_behaviour(row.text, row.title, item.runs.front(), item.result);
            break;
        case ReportPart::frames:
            sheet.draw(*frame++, row.name, row.text);
            break;
        case ReportPart::swings:
            sheet.draw(swings_figure(row.title, item.runs, std::stoi(row.cycles)), row.name, row.text);
            break;
        case ReportPart::computation:
            compute_part(row, item, sheet.report);
            break;
        case ReportPart::rows:
            sheet.add(printed_table(row.title, item.result.rows));
            break;
        }
    }
    return item.result;
}

}  // namespace

void Chapter5Item::draw(const Figure& figure, const std::string& name, const std::string& caption) {
    below.add(folder.draw(figure, name, caption));
}

std::string outcome_in_words(const HockingResult& result) {
    return in_words(result.outcome) + (result.outcome == HockingOutcome::blows_out
                                           ? " at cycle " + std::to_string(result.blow_out_cycle.value_or(0))
                                           : "");
}

std::string in_words(const std::vector<HockingResult>& results) {
    std::vector<std::string> parts;
    for (const auto& [outcome, word] :
         {std::pair{HockingOutcome::stands, "stand"}, std::pair{HockingOutcome::fails, "fail"},
          std::pair{HockingOutcome::blows_out, "blow out"}, std::pair{HockingOutcome::undecided, "undecided"}}) {
        if (const auto count = std::ranges::count(results, outcome, &HockingResult::outcome); count > 0) {
            parts.push_back(std::to_string(count) + " " + word);
        }
    }
    return "of " + std::to_string(results.size()) + ": " + list_in_words(parts);
}

std::string in_words(const std::optional<int>& cycle) {
    return cycle ? std::to_string(*cycle) : "never";
}

std::string settled_in_words(const HockingResult& result) {
    return result.outcome == HockingOutcome::stands ? in_words(settled_cycles(result)) : outcome_in_words(result);
}

double rotation_at_end(const HockingResult& result, std::size_t column) {
    return result.prints.back().blocks[column].angle / degrees(1);
}

void CountRange::include(int value) {
    least = count == 0 ? value : std::min(least, value);
    greatest = count == 0 ? value : std::max(greatest, value);
    ++count;
}

std::string CountRange::words(const std::string& to) const {
    return std::to_string(least) + to + std::to_string(greatest);
}

namespace {

std::vector<HockingBlock> reversed(std::vector<HockingBlock> blocks) {
    const int last = static_cast<int>(blocks.size()) - 1;
    for (HockingBlock& block : blocks) {
        HockingNeighbours& near = block.neighbours;
        for (int* index : {&near.below, &near.below_uphill, &near.uphill, &near.above_uphill, &near.above,
                           &near.above_downhill, &near.downhill, &near.below_downhill}) {
            *index = *index == no_block ? no_block : last - *index;
        }
    }
    std::ranges::reverse(blocks);
    return blocks;
}

}  // namespace

std::vector<OtherListing> compute_otherwise(const Chapter5Run& run) {
    std::vector<OtherListing> results;
    for (const int bits : {48, 24}) {
        Chapter5Run words = run;
        words.settings.significand_bits = bits;
        results.push_back({std::to_string(bits) + " bits", compute(words, Engine::recreated)});
    }
    OtherListing& last =
        results.emplace_back("reversed", compute(run, Engine::recreated, reversed(make_blocks(run.columns))));
    for (HockingPrint& print : last.result.prints) {
        std::ranges::reverse(print.blocks);
    }
    return results;
}

std::pair<double, double> bisect(double low, double high, double accuracy, const std::function<bool(double)>& holds) {
    while (high - low > accuracy) {
        stop_if_interrupted();
        const double middle = (low + high) / 2;
        (holds(middle) ? low : high) = middle;
    }
    return {low, high};
}

ReproductionChapter chapter_5() {
    ReproductionChapter chapter{
        "chapter5", "dynamic relaxation, chapter 5", "Thesis, chapter 5: printed and computed", {}};
    for (const ReportRow& row : report_rows()) {
        if (row.part == ReportPart::item) {
            chapter.items.push_back({row.item, row.title, row.text,
                                     [name = row.item](const Sheet& sheet) { return reproduce_item(name, sheet); }});
        }
    }
    return chapter;
}

}  // namespace delabole
