// 5.3.2 of the thesis: two blocks of equal height, but for the blow-out.
#include "cases/program/thesis/chapter_5/chapter_5.hpp"
#include "cases/program/thesis/chapter_5/relaxation_drawing.hpp"
#include "plots/drawing/text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace delabole {

namespace {

// Distance of the upper column's downhill top corner from the lower column's uphill side, in.
double opening(const std::vector<HockingBlock>& blocks, const HockingPrint& print) {
    const auto lower = corners_of(blocks[0], print.blocks[0]);
    const auto upper = corners_of(blocks[1], print.blocks[1]);
    const Point side = (lower[1] - lower[2]).normalized();
    return (upper[0] - lower[1]).dot(Point(side.y(), -side.x())) / inch;
}

// The thesis's way to close the crack: consolidate, hold the lower block, let the upper one slide down to it on a base
// without friction, consolidate, tilt. From which inclination is not printed: as in Fig 5.10.
struct ClosedGap {
    double opening_before = 0;  // in
    double opening_after = 0;   // in
    Chapter5Run run = {};       // the last stage
    HockingResult result = {};
};

ClosedGap close_gap() {
    ClosedGap closed;
    closed.run = chapter_5_runs("double_tilting", TiltedPart::base).front();
    // Starts with the crack: a gap of a hundredth of a millimetre.
    Chapter5Run stage = closed.run;
    stage.columns.gap = 1e-5;
    stage.settings.tilting.reset();
    stage.settings.cycles = 2500;
    // The place at which two blocks with a gap stand.
    stage.columns.dip = degrees(18);
    const std::vector<HockingBlock> start = make_blocks(stage.columns);
    const HockingResult consolidated = run_hocking(start, stage.settings);
    closed.opening_before = opening(start, consolidated.prints.back());
    std::vector<HockingBlock> blocks = blocks_at(start, consolidated.prints.back());
    blocks[0].fixed = true;
    HockingSettings slippery = stage.settings;
    slippery.joints = {};
    slippery.bases = {};
    const HockingResult slid = run_hocking(blocks, slippery);
    blocks = blocks_at(blocks, slid.prints.back());
    blocks[0].fixed = false;
    closed.run.columns.dip = stage.columns.dip;
    closed.run.settings.tilting->total = degrees(18.5) - stage.columns.dip;
    closed.result = run_hocking(blocks, closed.run.settings);
    closed.opening_after = opening(blocks, closed.result.prints.front());
    return closed;
}

}  // namespace

Reproduction reproduce_double_blocks(const ResultFolder& folder, Report& report) {
    Reproduction result;
    report.blocks.emplace_back(Heading{"Two blocks, a/b = 3 (5.3.2)"});
    const std::vector<Chapter5Run> fixed = chapter_5_runs("double_fixed");
    add_outcomes("two blocks", fixed, result);
    report.blocks.emplace_back(
        table_of("Fixed inclination", "inclination", fixed, printed_outcome, outcome_with_rotation));
    Table spread{"The same with coordinates shifted at random, 50 starts each",
                 {{"inclination"},
                  {"by 1e-9 m"},
                  {"by 1e-7 m"},
                  {"by 1e-6 m, a typed digit"},
                  {"clean engine, dropped, by 1e-6 m"},
                  {"preloaded"}}};
    for (const Chapter5Run& run : fixed) {
        std::vector<std::string> row = {run.name};
        for (const double unit : {1e-9, 1e-7, typed_digit}) {
            row.push_back(in_words(compute_shifted(run, Engine::recreated, unit, 50)));
        }
        result.json["starts"][run.name] = row.back();
        for (const Engine engine : {Engine::dropped, Engine::preloaded}) {
            row.push_back(in_words(compute_shifted(run, engine, typed_digit, 50)));
        }
        spread.rows.push_back(row);
    }
    report.blocks.emplace_back(Paragraph{
        "Two blocks help each other only after turning far enough to jam, so that a gap of a thousandth of a "
        "millimetre decides. At 18.3 deg the last typed digit makes half of the starts fail. In the clean engine two "
        "blocks of this stiffness stand up to 18.22 deg dropped and 18.43 deg preloaded, and none blows out."});
    report.blocks.emplace_back(spread);
    for (const TiltedPart part : {TiltedPart::base, TiltedPart::gravity}) {
        const std::vector<Chapter5Run> runs = chapter_5_runs("double_tilting", part);
        if (part == TiltedPart::base) {
            add_outcomes("two blocks, " + in_words(part), runs, result);
        } else {
            add_other_part("two blocks", runs, result);
        }
        report.blocks.emplace_back(table_of("Tilted from a stable inclination, " + in_words(part), "tilted from, to",
                                            runs, printed_outcome, outcome_with_rotation));
    }
    const Chapter5Run shown = chapter_5_runs("double_tilting", TiltedPart::base).front();
    const HockingResult tilted = compute(shown, Engine::recreated);
    report.blocks.emplace_back(folder.draw(
        frames_figure("Fig 5.10: tilted from 18.3 to 18.5 deg", shown, tilted,
                      {2500, 4500, tilted.prints.back().cycle}),
        "fig_5_10", "Base turned. The lower block goes ahead of the upper one, each by itself, as printed."));
    const ClosedGap closed = close_gap();
    result.json["closed_gap"] = {{"opening_before_in", closed.opening_before},
                                 {"opening_after_in", closed.opening_after},
                                 {"outcome", outcome_in_words(closed.result)}};
    result.rows.push_back(
        {"Fig 5.11: opening before and after the lower block is held and the upper slides", "closed",
         human_number(closed.opening_before, 2) + " and " + human_number(closed.opening_after, 2) + " in", "",
         statement(closed.opening_after < closed.opening_before)});
    const int early = cycle_of_rotation(closed.run, closed.result, degrees(0.1)).value_or(0);
    const double parted = opening(make_blocks(closed.run.columns), print_at(closed.result, early));
    result.json["closed_gap"]["parted_in"] = parted;
    result.rows.push_back({"Fig 5.11: then tilted from 18 to 18.5 deg", "fails as before, each block by itself",
                           outcome_in_words(closed.result) + "; parted by " + human_number(parted, 2) +
                               " in when the lower has turned by 0.1 deg",
                           "",
                           statement(parted > 0 && closed.result.outcome == HockingOutcome::fails) +
                               "; the inclinations are not printed"});
    report.blocks.emplace_back(Heading{"Fig 5.11: the gap closed", 3});
    report.blocks.emplace_back(folder.draw(
        frames_figure("Fig 5.11: gap closed, tilted from 18 to 18.5 deg", closed.run, closed.result,
                      {0, 2500, closed.result.prints.back().cycle}),
        "fig_5_11", "Slots of contact memory start empty at each stage; the listing's restart keeps them."));
    report.blocks.emplace_back(printed_table("Statements", result.rows));
    return result;
}

Reproduction reproduce_fig_5_12(const ResultFolder& folder, Report& report) {
    Reproduction result;
    Table table{
        "First backward sliding of block 2",
        {"blocks", "printed: about cycle"_number, "cycle"_number, "rotation, deg"_number, "rotation / atan(b/a)"_number,
         "clean engine: cycle"_number, "rotation, deg"_number, "rotation / atan(b/a)"_number}};
    report.blocks.emplace_back(Heading{"Fig 5.12: backward sliding and a/b"});
    // For each engine the last share of atan(b/a), and whether it has fallen from run to run.
    std::array<double, 2> last = {INFINITY, INFINITY};
    std::array<bool, 2> earlier = {true, true};
    constexpr std::array keys{"rotation_over_slenderness_angle", "clean_rotation_over_slenderness_angle"};
    constexpr int drawn_cycle = 4500;
    constexpr int plot_interval = 500;  // not printed
    const std::vector<Chapter5Run> runs = chapter_5_runs("slenderness");
    std::vector<int> begins;
    for (const Chapter5Run& run : runs) {
        std::vector<std::string>& row = table.rows.emplace_back(std::vector<std::string>{run.name, "4500"});
        for (const Engine engine : {Engine::recreated, Engine::dropped}) {
            const auto which = static_cast<std::size_t>(engine);
            const HockingResult computed = compute(run, engine);
            const auto cycle = first_sliding(computed, 1, BaseSliding::backward);
            const double rotation = cycle ? print_at(computed, *cycle).blocks[1].angle : INFINITY;
            const double share = rotation / std::atan(run.columns.width / run.columns.heights[0]);
            earlier[which] = earlier[which] && share < last[which];
            last[which] = share;
            if (engine == Engine::recreated) {
                begins.push_back(cycle.value_or(0));
            }
            result.json[keys[which]].push_back(share);
            row.insert(row.end(),
                       {cycle ? std::to_string(*cycle) : "never", cycle ? human_number(rotation / degrees(1), 3) : "",
                        cycle ? human_number(share, 3) : ""});
            if (cycle && engine == Engine::recreated) {
                const std::string name = "fig_5_12_" + std::to_string(std::lround(run.columns.heights[0] / inch));
                Figure figure = frames_figure("Fig 5.12: " + run.name, run, computed, {drawn_cycle});
                // The three are compared: one scale.
                figure.x.range = std::pair(-0.5, 5.5);
                figure.y.range = std::pair(-1.5, 11.5);
                figure.height = 760;
                report.blocks.emplace_back(
                    folder.draw(figure, name, "Block 2 slides backwards since cycle " + std::to_string(*cycle) + "."));
            }
        }
    }
    for (std::size_t index = 0; index < begins.size(); ++index) {
        const bool within = begins[index] > drawn_cycle - plot_interval && begins[index] <= drawn_cycle;
        result.rows.push_back({runs[index].name + ": cycle at which backward sliding begins", "drawn at 4500",
                               std::to_string(begins[index]), "",
                               statement(within) + ": with a plot every 500 cycles; the inclination is not printed"});
    }
    result.rows.push_back({"backward sliding begins at earlier stages as a/b grows", "earlier",
                           earlier[0] ? "earlier" : "not earlier", "", statement(earlier[0]),
                           earlier[1] ? "earlier" : "not earlier"});
    report.blocks.emplace_back(table);
    report.blocks.emplace_back(printed_table("Statements", result.rows));
    return result;
}

namespace {

// The runs of observations 2 to 4 with another friction than the printed 20 deg, in all joints. The displacement is
// that of the first run at its printed cycle.
Table observations_by_friction(const std::vector<Chapter5Run>& runs, Reproduction& result) {
    Table table{"Cycle of the same displacement with another friction", {"friction, deg"_number}};
    for (const Chapter5Run& run : runs) {
        table.columns.emplace_back(run.name, true);
    }
    int slowest = 0;  // cycles of the softer pair, where the stiffer one moves that far
    double slowest_at = 0;
    for (int tenth = 200; tenth <= 250; ++tenth) {
        const double friction = degrees(tenth / 10.0);
        std::vector<std::string> row{human_number(tenth / 10.0, 3)};
        double reference = 0;
        for (std::size_t index = 0; index < runs.size(); ++index) {
            Chapter5Run run = runs[index];
            run.settings.joints = run.settings.bases = {friction, friction};
            run.settings.cycles = 12000;
            const HockingResult computed = compute(run, Engine::recreated);
            const Point start = computed.prints.front().blocks[0].centroid;
            const auto moved = [&](const HockingPrint& print) { return (print.blocks[0].centroid - start).norm(); };
            reference = index == 0 ? moved(print_at(computed, runs[0].printed_cycle.value_or(0))) : reference;
            const auto cycle =
                first_cycle(computed, [&](const HockingPrint& print) { return moved(print) >= reference; });
            row.push_back(cycle ? std::to_string(*cycle) : in_words(computed.outcome));
            if (index == 1 && cycle && *cycle > slowest) {
                slowest = *cycle;
                slowest_at = tenth / 10.0;
            }
        }
        if (tenth % 5 == 0 || (tenth > 235 && tenth < 240)) {
            table.rows.push_back(row);
        }
    }
    result.rows.push_back(
        {"6e6 N/m: slowest with a friction of 20 to 25 deg", "7000, 20 deg",
         std::to_string(slowest) + ", " + human_number(slowest_at, 3) + " deg", "",
         "other frictions reach thousands of cycles, but where they do the pair of half the step stands"});
    return table;
}

}  // namespace

Reproduction reproduce_observations(const ResultFolder& folder, Report& report) {
    Reproduction result;
    report.blocks.emplace_back(Heading{"Observations on two blocks (5.3.2)"});
    add_outcomes("stiffness at 18.3 deg", chapter_5_runs("stiffness"), result);
    const std::vector<Chapter5Run> runs = chapter_5_runs("displacement");
    const int printed_cycle = runs[0].printed_cycle.value_or(0);
    const auto moved = [](const HockingResult& computed, const HockingPrint& print) {
        return (print.blocks[0].centroid - computed.prints.front().blocks[0].centroid).norm();
    };
    const HockingResult first = compute(runs[0], Engine::recreated);
    const double reference = moved(first, print_at(first, printed_cycle));
    // The cycle of the displacement that the first run has at its printed cycle.
    const auto cycle_of = [&](const HockingResult& computed) {
        return first_cycle(computed, [&](const HockingPrint& print) { return moved(computed, print) >= reference; });
    };
    const auto cycle_in_words = [&](const Chapter5Run&, const HockingResult& computed) {
        const auto cycle = cycle_of(computed);
        return cycle ? std::to_string(*cycle) : "never";
    };
    const auto printed = [](const Chapter5Run& run) {
        return run.printed_cycle ? std::to_string(*run.printed_cycle) : std::string();
    };
    report.blocks.emplace_back(
        table_of("Cycle of the same displacement at 18.4 deg", "run", runs, printed, cycle_in_words));
    std::vector<Chapter5Run> all = runs;
    for (const Chapter5Run& damped : chapter_5_runs("damping")) {
        all.push_back(damped);
    }
    // Histories of the runs, cycles by each engine, and by start; nothing where a run blows out.
    constexpr int starts = 30;
    std::vector<HockingResult> histories;
    std::vector<HockingResult> clean_histories;
    std::vector<int> cycle;
    std::vector<std::string> clean_cycle;
    std::vector<std::vector<std::optional<int>>> shifted(starts);
    for (const Chapter5Run& one : all) {
        histories.push_back(compute(one, Engine::recreated));
        clean_histories.push_back(compute(one, Engine::dropped));
        cycle.push_back(cycle_of(histories.back()).value_or(one.settings.cycles));
        clean_cycle.push_back(cycle_in_words(one, clean_histories.back()));
        const std::vector<HockingResult> others = compute_shifted(one, Engine::recreated, typed_digit, starts);
        for (std::size_t start = 0; start < others.size(); ++start) {
            const int found = cycle_of(others[start]).value_or(one.settings.cycles);
            shifted[start].push_back(others[start].outcome == HockingOutcome::blows_out ? std::nullopt
                                                                                        : std::optional(found));
        }
    }
    Table spread{"Least and greatest cycle of that displacement, coordinates shifted by one digit, 30 starts each",
                 {"run", "blow out"_number, "least"_number, "greatest"_number}};
    for (std::size_t number = 0; number < all.size(); ++number) {
        CountRange range;
        for (const std::vector<std::optional<int>>& start : shifted) {
            if (start[number]) {
                range.include(*start[number]);
            }
        }
        const bool any = range.count > 0;
        spread.rows.push_back({all[number].name, std::to_string(starts - range.count),
                               any ? std::to_string(range.least) : "", any ? std::to_string(range.greatest) : ""});
        if (any) {
            result.json["spread"][all[number].name] = {range.least, range.greatest};
        }
    }
    // Counts the shifted starts in which an observation holds that compares some of the runs.
    const auto how_often = [&](const std::string& name, const std::vector<std::size_t>& compared, const auto& holds) {
        int usable = 0;
        int held = 0;
        for (const std::vector<std::optional<int>>& start : shifted) {
            if (std::ranges::all_of(compared, [&](std::size_t number) { return start[number].has_value(); })) {
                ++usable;
                held += holds(start) ? 1 : 0;
            }
        }
        result.json["shifted"][name] = {{"held", held}, {"usable", usable}};
        return "; in " + std::to_string(held) + " of " + std::to_string(usable) +
               " starts with the last typed digits shifted";
    };
    const auto softer_is_slower = [](const auto& at) { return *at[1] > *at[0]; };
    const auto half_is_slower = [](const auto& at) { return *at[2] > 2 * *at[0]; };
    const auto damping_is_irregular = [](const auto& at) { return *at[3] > *at[5] && *at[5] > *at[4]; };
    const std::string stiff = std::to_string(cycle[0]);
    result.rows.push_back({"18.4 deg: stiffness 6e6 against 12e6 N/m, cycles", "7000 / 2500",
                           std::to_string(cycle[1]) + " / " + stiff, "",
                           statement(cycle[1] > cycle[0]) + how_often("stiffness", {0, 1}, softer_is_slower),
                           clean_cycle[1] + " / " + clean_cycle[0]});
    result.rows.push_back({"half the time step, cycles", "6000 / 2500, more than twice",
                           std::to_string(cycle[2]) + " / " + stiff, "",
                           statement(cycle[2] > 2 * cycle[0]) + how_often("half_step", {0, 2}, half_is_slower),
                           clean_cycle[2] + " / " + clean_cycle[0]});
    result.rows.push_back(
        {"damping 0.5, 0.6, 0.7: cycle of that displacement", "slowest, fastest, between",
         std::to_string(cycle[3]) + ", " + std::to_string(cycle[4]) + ", " + std::to_string(cycle[5]), "",
         statement(cycle[3] > cycle[5] && cycle[5] > cycle[4]) + how_often("damping", {3, 4, 5}, damping_is_irregular),
         clean_cycle[3] + ", " + clean_cycle[4] + ", " + clean_cycle[5]});
    report.blocks.emplace_back(spread);
    const auto rotation = [](const HockingPrint& print) { return print.blocks[0].angle / degrees(1); };
    std::vector<HistoryOf> drawn;
    for (std::size_t index = 0; index < all.size(); ++index) {
        if (index != 3) {  // damping 0.5 is the run of 6e6 N/m
            drawn.push_back({all[index].name, &histories[index], rotation});
        }
        if (index < runs.size()) {
            drawn.push_back({all[index].name + ", clean", &clean_histories[index], rotation, true});
        }
    }
    Figure figure = history_figure("5.3.2: two blocks at 18.4 deg", "rotation of block 1", "deg", drawn);
    Points marks{.legend = "printed: cycles of one displacement", .marker = Marker::filled_diamond};
    for (const Chapter5Run& one : runs) {
        marks.points.emplace_back(one.printed_cycle.value_or(0), rotation(print_at(histories[0], printed_cycle)));
    }
    figure.series.emplace_back(marks);
    figure.x.range = std::pair(0, 9000);
    figure.y.range = std::pair(0, 20);
    report.blocks.emplace_back(
        folder.draw(figure, "observations", "Stiffness, time step and damping; dashed: clean engine, dropped."));
    report.blocks.emplace_back(Paragraph{
        "In the clean engine, dropped, stiffer blocks fail later, not faster; half the step takes twice the cycles, "
        "which is the same time; and more damping delays the failure, in order. The opposite or irregular answers of "
        "the thesis come with a scatter of its program's cycles that the table of shifted starts shows. Preloaded, the "
        "blocks stand at 18.4 deg, whatever their stiffness from 2e6 N/m on, step and damping."});
    report.blocks.emplace_back(Paragraph{
        "Why 7000 cycles are not met: a block of this size leaves its balance e-fold in 739 cycles, 1 / sqrt(3 g / 4 "
        "r) with r half its diagonal. To take 7000 cycles instead of some 2400, a pair has to start five hundred times "
        "nearer to balance: within 0.0002 deg of its own limit instead of within 0.1 deg. That limit depends on digits "
        "that are not printed: 18.30 deg with centroids typed to 1e-6 m, 18.43 deg with exact ones, where many starts "
        "blow out. Dampings of 0.5 to 0.7 change the count by a print or two, in no order."});
    report.blocks.emplace_back(observations_by_friction(all, result));
    report.blocks.emplace_back(printed_table("Observations 1 to 4", result.rows));
    return result;
}

}  // namespace delabole
