// 5.3.4 of the thesis: columns of unequal height.
#include "cases/program/thesis/chapter_5/chapter_5.hpp"
#include "cases/program/thesis/chapter_5/relaxation_drawing.hpp"
#include "plots/drawing/text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace delabole {

namespace {

std::vector<std::string_view> behaviour_at_end(const Chapter5Run& run, const HockingResult& result) {
    std::vector<std::string_view> does;
    for (std::size_t column = 0; column < run.columns.heights.size(); ++column) {
        does.push_back(word_of(behaviour(run, result, result.prints.back(), column)));
    }
    return does;
}

std::string behaviour_in_words(const Chapter5Run& run, const HockingResult& result) {
    return columns_in_words(behaviour_at_end(run, result));
}

bool behaves_as_printed(const Chapter5Run& run, const HockingResult& result) {
    return std::ranges::equal(run.printed_behaviour, behaviour_at_end(run, result));
}

// Less is the give of the springs.
constexpr double open_joint = 1e-3;  // of a column's width

std::string opening_in_words(const Chapter5Run& run, const HockingPrint& print) {
    const JointOpening widest = widest_opening(run, print);
    if (widest.width < open_joint * run.columns.width) {
        return "none";
    }
    return "columns " + std::to_string(widest.column + 1) + " and " + std::to_string(widest.column + 2) + ", " +
           human_number(widest.width / inch, 2) + " in";
}

// First print with an open joint; the last one where none opens.
const HockingPrint& first_opening(const Chapter5Run& run, const HockingResult& result) {
    const auto found = std::ranges::find_if(result.prints, [&](const HockingPrint& print) {
        return widest_opening(run, print).width >= open_joint * run.columns.width;
    });
    return found == result.prints.end() ? result.prints.back() : *found;
}

// The tension crack: the first joint to open, and the widest at the end.
void add_crack(const Chapter5Run& run, const HockingResult& recreated, const HockingResult& clean,
               Reproduction& result) {
    constexpr std::size_t fifth = 4;
    const bool fails = run.printed == HockingOutcome::fails;
    const auto shown = [&](const HockingResult& history) {
        return "first " + opening_in_words(run, first_opening(run, history)) + ", at the end " +
               opening_in_words(run, history.prints.back());
    };
    const auto place = [&](const HockingPrint& print) { return widest_opening(run, print).column; };
    const auto as_printed = [&](const HockingResult& history) {
        const bool at_end = place(history.prints.back()) == fifth;
        return (!fails || at_end) && place(first_opening(run, history)) == fifth;
    };
    result.rows.push_back({"stepped base, " + run.name + ": widest joint, between",
                           fails ? "columns 5 and 6" : "columns 5 and 6, slight", shown(recreated), "",
                           statement(as_printed(recreated)), shown(clean)});
    result.json["crack"][run.name] = {{"as_printed", as_printed(recreated)},
                                      {"clean_as_printed", as_printed(clean)},
                                      {"width_in", widest_opening(run, recreated.prints.back()).width / inch},
                                      {"clean_width_in", widest_opening(run, clean.prints.back()).width / inch}};
}

}  // namespace

Reproduction reproduce_fig_5_16(const ResultFolder& folder, Report& report) {
    Reproduction result;
    const Chapter5Run run = chapter_5_runs("plane_base").front();
    const HockingResult computed = compute(run, Engine::recreated);
    const HockingResult clean_computed = compute(run, Engine::dropped);
    report.blocks.emplace_back(Heading{"Fig 5.16: nine columns on a plane base"});
    report.blocks.emplace_back(
        Paragraph{"Heights are read off the drawing, friction (30 deg) is chosen. The tilting frame's crack at 16 deg "
                  "lay between columns 6 and 7; at 25 deg column 7 topples too."});
    result.rows.push_back({"25 deg, cycle 2000", "1 slides, 2-7 topple, 8-9 stay", behaviour_in_words(run, computed),
                           "", statement(behaves_as_printed(run, computed)), behaviour_in_words(run, clean_computed)});
    Chapter5Run gentle = run;
    gentle.columns.dip = degrees(16);
    gentle.settings.bases = gentle.settings.joints = {degrees(26), degrees(26)};
    std::vector<std::string> cracks;
    bool all_crack = true;
    for (const Engine engine : {Engine::recreated, Engine::dropped}) {
        const HockingResult frame = compute(gentle, engine);
        const double sixth = rotation_at_end(frame, 5);
        const double seventh = rotation_at_end(frame, 6);
        const bool crack = sixth > 0.1 && std::abs(seventh) < 0.1;
        all_crack = all_crack && crack;
        cracks.push_back("6 turned " + human_number(sixth, 2) + " deg, 7 " + human_number(seventh, 2));
        result.json[engine == Engine::recreated ? "crack_at_16_deg" : "clean_crack_at_16_deg"] = crack;
    }
    result.rows.push_back({"16 deg, friction 26 deg: tension crack (tilting frame)", "between 6 and 7", cracks[0], "",
                           statement(all_crack), cracks[1]});
    result.json["as_printed"] = behaves_as_printed(run, computed);
    result.json["clean_as_printed"] = behaves_as_printed(run, clean_computed);
    result.json["behaviour"] = behaviour_in_words(run, computed);
    report.blocks.emplace_back(printed_table("Behaviour", result.rows));
    constexpr std::array cycles{0, 1000, 2000};
    std::vector<Figure> figures;
    for (const int cycle : cycles) {
        figures.push_back(frames_figure("Fig 5.16: nine columns, 25 deg", run, computed, {cycle}));
    }
    figures.push_back(frames_figure("Fig 5.16, clean engine: nine columns, 25 deg", run, clean_computed, {2000}));
    set_one_scale(figures);
    for (std::size_t index = 0; index < cycles.size(); ++index) {
        report.blocks.emplace_back(
            folder.draw(figures[index], "fig_5_16_" + std::to_string(cycles[index]), "Re-created program."));
    }
    report.blocks.emplace_back(folder.draw(figures.back(), "fig_5_16_clean", "The same by the clean engine."));
    return result;
}

Reproduction reproduce_fig_5_17(const ResultFolder& folder, Report& report) {
    Reproduction result;
    const std::vector<Chapter5Run> runs = chapter_5_runs("stepped_base");
    report.blocks.emplace_back(Heading{"Fig 5.17: eight columns on a stepped base"});
    report.blocks.emplace_back(
        Paragraph{"Columns that fail turn by some degrees and wedge again; so failure is here a rotation above 1 "
                  "degree. Equilibrium asks for 41.14 deg of friction. That 42 deg fails nevertheless, as printed, "
                  "comes of the start: dropped on springs as soft, it fails in the clean engine too; preloaded, it "
                  "stands. Columns that have failed wedge again there as well."});
    add_outcomes("stepped base, friction", runs, result);
    report.blocks.emplace_back(table_of(
        "Friction angle", "friction", runs, printed_outcome, [](const Chapter5Run& run, const HockingResult& computed) {
            return outcome_in_words(computed) + ": " + behaviour_in_words(run, computed);
        }));
    for (const Chapter5Run& run : runs) {
        const HockingResult computed = compute(run, Engine::recreated);
        const HockingResult other = compute(run, Engine::dropped);
        for (std::size_t column = 0; column < run.columns.heights.size(); ++column) {
            result.json["rotation_deg"][run.name].push_back(rotation_at_end(computed, column));
        }
        add_crack(run, computed, other, result);
        if (run.printed == HockingOutcome::fails) {
            result.rows.push_back({"stepped base, " + run.name + ": behaviour", "1 slides, 2-5 topple, 6-8 stay",
                                   behaviour_in_words(run, computed), "", statement(behaves_as_printed(run, computed)),
                                   behaviour_in_words(run, other)});
            result.json["behaves_as_printed"][run.name] = behaves_as_printed(run, computed);
            result.json["clean_behaves_as_printed"][run.name] = behaves_as_printed(run, other);
        }
    }
    const Chapter5Run& drawn = runs[1];
    const HockingResult computed = compute(drawn, Engine::recreated);
    const auto widest_joint = [&](const HockingResult& history, int cycle) {
        return "The widest open joint: " + opening_in_words(drawn, print_at(history, cycle)) + ".";
    };
    for (const int cycle : {0, 1000, 13000}) {
        report.blocks.emplace_back(
            folder.draw(frames_figure("Fig 5.17: stepped base, friction " + drawn.name, drawn, computed, {cycle}),
                        "fig_5_17_" + std::to_string(cycle), widest_joint(computed, cycle)));
    }
    const HockingResult drawn_clean = compute(drawn, Engine::dropped);
    report.blocks.emplace_back(
        folder.draw(frames_figure("Fig 5.17, clean engine: friction " + drawn.name, drawn, drawn_clean, {13000}),
                    "fig_5_17_clean", "The same by the clean engine, dropped. " + widest_joint(drawn_clean, 13000)));
    report.blocks.emplace_back(printed_table("Stepped base", result.rows));
    return result;
}

}  // namespace delabole
