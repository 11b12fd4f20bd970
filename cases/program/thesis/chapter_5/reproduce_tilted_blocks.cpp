// 5.3.1 B and 5.3.2 B of the thesis again: which values of inputs that it does not print give its outcomes.
#include "cases/program/reader/names.hpp"
#include "cases/program/terminal/interrupt.hpp"
#include "cases/program/thesis/chapter_5/chapter_5.hpp"
#include "parameters/fields.hpp"

#include <algorithm>

namespace delabole {

namespace {

// One input is changed, and the others are those of the runs.
struct Ingredient {
    std::string name;
    std::function<void(Chapter5Run&, double)> change;
    double value;
};

const std::vector<Ingredient>& ingredients() {
    using Run = Chapter5Run;
    const auto base = [](Run& run, double value) { run.columns.base_height = value * inch; };
    const auto damping = [](Run& run, double value) { run.settings.damping = value; };
    const auto step = [](Run& run, double value) { run.settings.time_step = value; };
    const auto stiffness = [](Run& run, double value) { run.settings.stiffness = value; };
    const auto friction = [](Run& run, double value) { run.settings.joints = run.settings.bases = {value, value}; };
    const auto typed = [](Run& run, double value) { run.columns.coordinate_unit = value; };
    const auto gap = [](Run& run, double value) { run.columns.gap = value; };
    const auto every = [](Run& run, double value) {
        HockingTilting& tilting = *run.settings.tilting;
        tilting.increment *= value / tilting.every;
        tilting.every = static_cast<int>(value);
    };
    const auto begin = [](Run& run, double value) { run.settings.tilting->begin = static_cast<int>(value); };
    static const std::vector<Ingredient> all = {
        {"as chosen", [](Run&, double) {}, 0},
        {"base 0.5 in thick", base, 0.5},
        {"base 1 in thick", base, 1},
        {"base 1.05 in thick", base, 1.05},
        {"base 1.15 in thick", base, 1.15},
        {"base 1.2 in thick", base, 1.2},
        {"base 2 in thick", base, 2},
        {"damping 0.3", damping, 0.3},
        {"damping 0.6", damping, 0.6},
        {"damping 1", damping, 1},
        {"step 0.5e-4 s", step, 0.5e-4},
        {"step 1.2e-4 s", step, 1.2e-4},
        {"stiffness 2e6 N/m", stiffness, 2e6},
        {"stiffness 4e6 N/m", stiffness, 4e6},
        {"stiffness 12e6 N/m", stiffness, 12e6},
        {"friction 30 deg", friction, degrees(30)},
        {"exact coordinates", typed, 0},
        {"typed to 10e-6 m", typed, 1e-5},
        {"gap 0.001 mm", gap, 1e-6},
        {"gap 0.01 mm", gap, 1e-5},
        {"same rate in increments every 1 cycles", every, 1},
        {"same rate in increments every 50 cycles", every, 50},
        {"consolidated for 500 cycles", begin, 500},
        {"consolidated for 5500 cycles", begin, 5500},
    };
    return all;
}

}  // namespace

// The item's runs are those of one block, followed by those of two.
void one_input_changed(Chapter5Item& item) {
    constexpr std::size_t one = 5;  // runs
    const TiltedPart part = item.runs.front().settings.tilting->part;
    const double begin = part == TiltedPart::base ? 0 : 0.5;
    std::vector<std::vector<HockingResult>> computed(ingredients().size());
    run_part(item.folder, {"one input changed", begin, begin + 0.5}, computed.size(), [&](std::size_t index) {
        for (Chapter5Run run : item.runs) {
            ingredients()[index].change(run, ingredients()[index].value);
            if (!interrupt_flag()) {
                computed[index].push_back(compute(run, Engine::recreated));
            }
        }
    });
    const std::string turned = std::string(word_of(part)) + " turned";
    std::vector<std::string> complete;  // what gives every printed outcome
    item.table.rows.push_back(
        {"printed", "", "", "6700 / 6000", "11000 / 9200", "12100 / 10600", "fails", "stands", "fails"});
    for (std::size_t index = 0; index < computed.size(); ++index) {
        const std::vector<HockingResult>& results = computed[index];
        const std::string& name = ingredients()[index].name;
        int of_one = 0;
        int of_two = 0;
        int behind = 0;  // CX comes to rest after CY by at most so many cycles
        for (std::size_t run = 0; run < results.size(); ++run) {
            const bool as_printed = results[run].outcome == item.runs[run].printed;
            (run < one ? of_one : of_two) += as_printed ? 1 : 0;
            if (item.runs[run].printed_settled && results[run].outcome == HockingOutcome::stands) {
                const SettledCycles settled = settled_cycles(results[run]);
                behind = std::max(behind, settled.x - settled.y);
            }
        }
        if (of_one + of_two == std::ssize(item.runs)) {
            complete.push_back(name);
        }
        item.table.rows.push_back({name, std::to_string(of_one), std::to_string(of_two), settled_in_words(results[0]),
                                   settled_in_words(results[1]), settled_in_words(results[3]),
                                   outcome_in_words(results[8]), outcome_in_words(results[9]),
                                   outcome_in_words(results[10])});
        item.result.json[turned][name] = {{"one", of_one},
                                          {"two", of_two},
                                          {"every_10", outcome_in_words(results[8])},
                                          {"every_20", outcome_in_words(results[9])},
                                          {"last_of_two", outcome_in_words(results[10])},
                                          {"x_behind_y", behind}};
    }
    item.result.json["complete"][turned] = complete;
    const std::string words = complete.empty() ? "none of those tried" : separated(complete, "; ");
    item.result.add(turned + ": with which all 11 printed outcomes come", "", words,
                    std::to_string(computed.size() - 1) + " inputs tried, one changed at a time");
}

}  // namespace delabole
