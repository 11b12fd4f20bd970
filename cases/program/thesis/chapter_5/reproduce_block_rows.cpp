// 5.3.4 of the thesis: columns of unequal height.
#include "cases/program/thesis/chapter_5/chapter_5.hpp"
#include "cases/program/thesis/chapter_5/relaxation_drawing.hpp"
#include "plots/drawing/text.hpp"

#include <algorithm>
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

// A smaller opening is the deformation of the springs.
constexpr double open_joint = 1e-3;  // of a column's width

std::string opening_in_words(const Chapter5Run& run, const HockingPrint& print) {
    const JointOpening widest = widest_opening(run, print);
    if (widest.width < open_joint * run.columns.width) {
        return "none";
    }
    return "columns " + std::to_string(widest.column + 1) + " and " + std::to_string(widest.column + 2) + ", " +
           human_number(widest.width / inch, 2) + " in";
}

// Returns the first print with an open joint, or the last print if none opens.
const HockingPrint& first_opening(const Chapter5Run& run, const HockingResult& result) {
    const auto found = std::ranges::find_if(result.prints, [&](const HockingPrint& print) {
        return widest_opening(run, print).width >= open_joint * run.columns.width;
    });
    return found == result.prints.end() ? result.prints.back() : *found;
}

}  // namespace

std::string behaviour_in_words(const Chapter5Run& run, const HockingResult& result) {
    return columns_in_words(behaviour_at_end(run, result));
}

bool behaves_as_printed(const Chapter5Run& run, const HockingResult& result) {
    return std::ranges::equal(run.printed_behaviour, behaviour_at_end(run, result));
}

// Puts the columns of Fig 5.16 on the tilting frame.
void crack_of_the_tilting_frame(Chapter5Item& item) {
    Chapter5Run gentle = item.runs.front();
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
        item.result.json[engine == Engine::recreated ? "crack_at_16_deg" : "clean_crack_at_16_deg"] = crack;
    }
    item.result.add("16 deg, friction 26 deg: tension crack (tilting frame)", "between 6 and 7", cracks[0],
                    statement(all_crack), cracks[1]);
}

// Tells which joint of the stepped base opens first, and which is the widest at the end.
void tension_cracks(Chapter5Item& item) {
    constexpr std::size_t fifth = 4;
    for (const Chapter5Run& run : item.runs) {
        const bool fails = run.printed == HockingOutcome::fails;
        const auto shown = [&](const HockingResult& history) {
            return "first " + opening_in_words(run, first_opening(run, history)) + ", at the end " +
                   opening_in_words(run, history.prints.back());
        };
        const auto place = [&](const HockingPrint& print) { return widest_opening(run, print).column; };
        const auto as_printed = [&](const HockingResult& history) {
            return (!fails || place(history.prints.back()) == fifth) && place(first_opening(run, history)) == fifth;
        };
        const HockingResult recreated = compute(run, Engine::recreated);
        const HockingResult clean = compute(run, Engine::dropped);
        item.result.add("stepped base, " + run.name + ": widest joint, between",
                        fails ? "columns 5 and 6" : "columns 5 and 6, slight", shown(recreated),
                        statement(as_printed(recreated)), shown(clean));
        item.result.json["crack"][run.name] = {
            {"as_printed", as_printed(recreated)},
            {"clean_as_printed", as_printed(clean)},
            {"width_in", widest_opening(run, recreated.prints.back()).width / inch},
            {"clean_width_in", widest_opening(run, clean.prints.back()).width / inch}};
        for (std::size_t column = 0; column < run.columns.heights.size(); ++column) {
            item.result.json["rotation_deg"][run.name].push_back(rotation_at_end(recreated, column));
        }
    }
}

}  // namespace delabole
