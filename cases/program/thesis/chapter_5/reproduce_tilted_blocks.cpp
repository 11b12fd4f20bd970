// 5.3.1 B and 5.3.2 B of the thesis once more: which of the inputs that it does not print gives its outcomes.
#include "cases/program/terminal/interrupt.hpp"
#include "cases/program/thesis/chapter_5/chapter_5.hpp"
#include "plots/drawing/text.hpp"

#include <algorithm>
#include <array>

namespace delabole {

namespace {

// One input changed, the others as in the runs.
struct Ingredient {
    std::string name;
    std::function<void(Chapter5Run&)> change;
};

const std::vector<Ingredient>& ingredients() {
    const auto damping = [](double value) {
        return Ingredient{"damping " + human_number(value, 2), [=](Chapter5Run& run) { run.settings.damping = value; }};
    };
    const auto step = [](double value) {
        return Ingredient{"step " + human_number(value * 1e4, 2) + "e-4 s",
                          [=](Chapter5Run& run) { run.settings.time_step = value; }};
    };
    const auto stiffness = [](double value) {
        return Ingredient{"stiffness " + human_number(value / 1e6, 2) + "e6 N/m",
                          [=](Chapter5Run& run) { run.settings.stiffness = value; }};
    };
    const auto friction = [](double value) {
        return Ingredient{"friction " + human_number(value, 2) + " deg", [=](Chapter5Run& run) {
                              run.settings.joints = run.settings.bases = {degrees(value), degrees(value)};
                          }};
    };
    const auto base = [](double value) {
        return Ingredient{"base " + human_number(value, 3) + " in thick",
                          [=](Chapter5Run& run) { run.columns.base_height = value * inch; }};
    };
    const auto typed = [](double value) {
        return Ingredient{value > 0 ? "typed to " + human_number(value * 1e6, 2) + "e-6 m" : "exact coordinates",
                          [=](Chapter5Run& run) { run.columns.coordinate_unit = value; }};
    };
    const auto gap = [](double value) {
        return Ingredient{"gap " + human_number(value * 1e3, 2) + " mm",
                          [=](Chapter5Run& run) { run.columns.gap = value; }};
    };
    const auto every = [](int value) {
        return Ingredient{"same rate in increments every " + std::to_string(value) + " cycles", [=](Chapter5Run& run) {
                              HockingTilting& tilting = *run.settings.tilting;
                              tilting.increment *= static_cast<double>(value) / tilting.every;
                              tilting.every = value;
                          }};
    };
    const auto consolidation = [](int value) {
        return Ingredient{"consolidated for " + std::to_string(value) + " cycles",
                          [=](Chapter5Run& run) { run.settings.tilting->begin = value; }};
    };
    static const std::vector<Ingredient> all = {
        {"as chosen", [](Chapter5Run&) {}},
        base(0.5),
        base(1),
        base(1.05),
        base(1.15),
        base(1.2),
        base(2),
        damping(0.3),
        damping(0.6),
        damping(1),
        step(0.5e-4),
        step(1.2e-4),
        stiffness(2e6),
        stiffness(4e6),
        stiffness(12e6),
        friction(30),
        typed(0),
        typed(1e-5),
        gap(1e-6),
        gap(1e-5),
        every(1),
        every(50),
        consolidation(500),
        consolidation(5500),
    };
    return all;
}

// The runs of one part turned.
struct Tilted {
    std::vector<HockingResult> one;
    std::vector<HockingResult> two;
};

// Results by the part turned, gravity first.
using OfIngredient = std::array<Tilted, 2>;

constexpr std::array parts{TiltedPart::gravity, TiltedPart::base};

OfIngredient compute(const Ingredient& ingredient) {
    OfIngredient computed;
    const auto run_all = [&](std::vector<Chapter5Run> runs, std::vector<HockingResult>& results) {
        for (Chapter5Run& one : runs) {
            ingredient.change(one);
            if (!interrupt_flag()) {
                results.push_back(compute(one, Engine::recreated));
            }
        }
    };
    for (std::size_t part = 0; part < parts.size(); ++part) {
        run_all(chapter_5_runs("single_tilting", parts[part]), computed[part].one);
        run_all(chapter_5_runs("double_tilting", parts[part]), computed[part].two);
    }
    return computed;
}

long as_printed(const std::vector<Chapter5Run>& runs, const std::vector<HockingResult>& results) {
    long count = 0;
    for (std::size_t index = 0; index < runs.size(); ++index) {
        count += results[index].outcome == runs[index].printed ? 1 : 0;
    }
    return count;
}

Table table_of_part(std::size_t part, const std::vector<OfIngredient>& computed, Reproduction& result) {
    const std::string turned = in_words(parts[part]);
    const std::vector<Chapter5Run> one = chapter_5_runs("single_tilting", parts[part]);
    const std::vector<Chapter5Run> two = chapter_5_runs("double_tilting", parts[part]);
    Table table{
        "One input changed, " + turned + ": outcomes as printed, and cycles after which CX / CY of one block rest",
        {"changed",
         {"one block, of " + std::to_string(one.size()), true},
         {"two, of " + std::to_string(two.size()), true},
         {"one, 18 to 18.2", true},
         {"18 to 18.3", true},
         {"18.15 to 18.3", true},
         {"two, 18.2 to 18.3, every 10", true},
         {"every 20", true},
         {"18 to 18.3", true}}};
    table.rows.push_back(
        {"printed", "", "", "6700 / 6000", "11000 / 9200", "12100 / 10600", "fails", "stands", "fails"});
    for (std::size_t index = 0; index < ingredients().size(); ++index) {
        const Tilted& tilted = computed[index][part];
        const long of_one = as_printed(one, tilted.one);
        const long of_two = as_printed(two, tilted.two);
        table.rows.push_back({ingredients()[index].name, std::to_string(of_one), std::to_string(of_two),
                              settled_in_words(tilted.one[0]), settled_in_words(tilted.one[1]),
                              settled_in_words(tilted.one[3]), outcome_in_words(tilted.two[3]),
                              outcome_in_words(tilted.two[4]), outcome_in_words(tilted.two[5])});
        result.json[turned][ingredients()[index].name] = {{"one", of_one},
                                                          {"two", of_two},
                                                          {"every_10", outcome_in_words(tilted.two[3])},
                                                          {"every_20", outcome_in_words(tilted.two[4])},
                                                          {"last_of_two", outcome_in_words(tilted.two[5])}};
        // CX comes to rest after CY by at most this many cycles.
        int behind = 0;
        for (const std::size_t run : {0U, 1U, 3U}) {
            if (tilted.one[run].outcome == HockingOutcome::stands) {
                const SettledCycles settled = settled_cycles(tilted.one[run]);
                behind = std::max(behind, settled.x - settled.y);
            }
        }
        result.json[turned][ingredients()[index].name]["x_behind_y"] = behind;
    }
    return table;
}

// The names of what gives every printed outcome.
std::vector<std::string> complete(const Json& by_ingredient) {
    std::vector<std::string> names;
    for (const auto& [name, counts] : by_ingredient.items()) {
        if (counts["one"] == 5 && counts["two"] == 6) {
            names.push_back(name);
        }
    }
    return names;
}

}  // namespace

Reproduction reproduce_tilted_blocks(const ResultFolder& folder, Report& report) {
    std::vector<OfIngredient> computed(ingredients().size());
    run_part(folder, {"one input changed", 0, 1}, computed.size(),
             [&](std::size_t index) { computed[index] = compute(ingredients()[index]); });
    Reproduction result;
    report.blocks.emplace_back(Heading{"Tilted blocks: which input decides"});
    std::vector<Table> tables;
    for (std::size_t part = 0; part < parts.size(); ++part) {
        tables.push_back(table_of_part(part, computed, result));
    }
    for (const std::string turned : {"base turned", "gravity turned"}) {
        const std::vector<std::string> names = complete(result.json[turned]);
        result.json["complete"][turned] = names;
        std::string words = names.empty() ? "none of those tried" : "";
        for (const std::string& name : names) {
            words += (words.empty() ? "" : "; ") + name;
        }
        result.rows.push_back({turned + ": with which all 11 printed outcomes come", "", words, "",
                               std::to_string(ingredients().size() - 1) + " inputs tried, one changed at a time"});
    }
    report.blocks.emplace_back(Paragraph{
        "Turning the base about its centroid pushes what stands on it, the more the thicker it is: a block that stood "
        "rocks on after the tilt has ended, and a tenth of the thickness, which is not printed, decides whether it "
        "stands. With 1.1 in, as chosen, and with 1.15 in all outcomes are the printed ones; with one inch all but "
        "one, and the counts are farther from the printed. That CX comes to rest 1500 to 1800 cycles after CY, no "
        "input gives: 900 at most. Turned gravity pushes nothing: unless the step is halved, the block is at rest when "
        "the tilt ends, so that the printed counts cannot come, and it stands up to 18.43 deg. Two blocks tilted from "
        "18.2 to 18.3 deg are decided by the last digits of their coordinates: exact ones give the printed outcomes, "
        "typed ones do not, and a gap, as the thesis found with a magnifier, makes both runs fail. From 18 to 18.3 deg "
        "they fail on springs of 2e6 N/m alone, on which a single block fails as well."});
    for (std::size_t part = parts.size(); part-- > 0;) {
        report.blocks.emplace_back(tables[part]);
    }
    report.blocks.emplace_back(printed_table("Outcomes", result.rows));
    return result;
}

}  // namespace delabole
