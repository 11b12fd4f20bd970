// 5.3.2 of the thesis: two blocks of equal height, but for the blow-out.
#include "cases/program/thesis/chapter_5/chapter_5.hpp"
#include "cases/program/thesis/chapter_5/relaxation_drawing.hpp"
#include "parameters/fields.hpp"
#include "plots/drawing/text.hpp"

#include <array>
#include <cmath>
#include <iterator>
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

// The thesis closes the crack in stages: consolidate, hold the lower block, let the upper one slide down to it on a
// base without friction, consolidate, tilt. The first inclination is not printed: that of Fig 5.10 is taken.
struct ClosedGap {
    double opening_before = 0;  // in
    double opening_after = 0;   // in
    Chapter5Run run = {};       // the last stage
    HockingResult result = {};
};

ClosedGap close_gap() {
    ClosedGap closed;
    closed.run = chapter_5_runs("double_tilting", TiltedPart::base).front();
    // The run starts with the crack: a gap of a hundredth of a millimetre.
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

void starts_of_two_blocks(Chapter5Item& item) {
    for (const Chapter5Run& run : item.runs) {
        std::vector<std::string>& row = item.table.rows.emplace_back(std::vector{run.name});
        for (const double unit : {1e-9, 1e-7, typed_digit}) {
            row.push_back(in_words(compute_shifted(run, Engine::recreated, unit, item.starts)));
        }
        item.result.json["starts"][run.name] = row.back();
        for (const Engine engine : {Engine::dropped, Engine::preloaded}) {
            row.push_back(in_words(compute_shifted(run, engine, typed_digit, item.starts)));
        }
    }
}

void closed_gap(Chapter5Item& item) {
    Reproduction& result = item.result;
    const ClosedGap closed = close_gap();
    const int early = cycle_of_rotation(closed.run, closed.result, degrees(0.1)).value_or(0);
    const double parted = opening(make_blocks(closed.run.columns), print_at(closed.result, early));
    result.json["closed_gap"] = {{"opening_before_in", closed.opening_before},
                                 {"opening_after_in", closed.opening_after},
                                 {"parted_in", parted},
                                 {"outcome", outcome_in_words(closed.result)}};
    result.add("Fig 5.11: opening before and after the lower block is held and the upper slides", "closed",
               human_number(closed.opening_before, 2) + " and " + human_number(closed.opening_after, 2) + " in",
               statement(closed.opening_after < closed.opening_before));
    result.add(
        "Fig 5.11: then tilted from 18 to 18.5 deg", "fails as before, each block by itself",
        outcome_in_words(closed.result) + "; parted by " + human_number(parted, 2) +
            " in when the lower has turned by 0.1 deg",
        statement(parted > 0 && closed.result.outcome == HockingOutcome::fails) + "; the inclinations are not printed");
    item.draw(frames_figure("Fig 5.11: gap closed, tilted from 18 to 18.5 deg", closed.run, closed.result,
                            {0, 2500, closed.result.prints.back().cycle}),
              "fig_5_11", "Slots of contact memory start empty at each stage; the listing's restart keeps them.");
}

// Fig 5.12.
void backward_sliding(Chapter5Item& item) {
    Reproduction& result = item.result;
    constexpr int drawn_cycle = 4500;
    constexpr int plot_interval = 500;  // not printed
    // For each engine: the last share of atan(b/a), and whether it has decreased from run to run.
    std::array<double, 2> last = {INFINITY, INFINITY};
    std::array<bool, 2> earlier = {true, true};
    constexpr std::array keys{"rotation_over_slenderness_angle", "clean_rotation_over_slenderness_angle"};
    for (const Chapter5Run& run : item.runs) {
        std::vector<std::string>& row =
            item.table.rows.emplace_back(std::vector{run.name, std::to_string(drawn_cycle)});
        for (const Engine engine : {Engine::recreated, Engine::dropped}) {
            const HockingResult computed = compute(run, engine);
            const auto cycle = first_sliding(computed, 1, BaseSliding::backward);
            const double rotation = cycle ? print_at(computed, *cycle).blocks[1].angle : INFINITY;
            const double share = rotation / std::atan(run.columns.width / run.columns.heights[0]);
            const auto which = static_cast<std::size_t>(engine);
            earlier[which] = earlier[which] && share < last[which];
            last[which] = share;
            result.json[keys[which]].push_back(share);
            if (engine == Engine::recreated) {
                const int begin = cycle.value_or(0);
                result.add(run.name + ": cycle at which backward sliding begins", "drawn at 4500",
                           std::to_string(begin),
                           statement(begin > drawn_cycle - plot_interval && begin <= drawn_cycle) +
                               ": with a plot every 500 cycles; the inclination is not printed");
            }
            row.insert(row.end(), {in_words(cycle), cycle ? human_number(rotation / degrees(1), 3) : "",
                                   cycle ? human_number(share, 3) : ""});
        }
    }
    const auto words = [](bool is) { return is ? "earlier" : "not earlier"; };
    result.add("backward sliding begins at earlier stages as a/b grows", "earlier", words(earlier[0]),
               statement(earlier[0]), words(earlier[1]));
}

namespace {

// The displacement of block 1 since the start.
double displacement(const HockingResult& result, const HockingPrint& print) {
    return (print.blocks[0].centroid - result.prints.front().blocks[0].centroid).norm();
}

std::optional<int> cycle_of(double reached, const HockingResult& result) {
    return first_cycle(result, [&](const HockingPrint& print) { return displacement(result, print) >= reached; });
}

// Returns the displacement of the first run at its printed cycle.
double reference_of(const std::vector<Chapter5Run>& runs) {
    const HockingResult first = compute(runs.front(), Engine::recreated);
    return displacement(first, print_at(first, runs.front().printed_cycle.value_or(0)));
}

// A statement on the cycles at which some of the runs have the same displacement.
struct Observation {
    std::string name;
    std::string what;
    std::string printed;
    std::vector<std::size_t> compared;  // runs
    std::string separator;
    bool (*holds)(const std::vector<int>&);
};

const std::vector<Observation>& printed_observations() {
    static const std::vector<Observation> all{
        {"stiffness",
         "18.4 deg: stiffness 6e6 against 12e6 N/m, cycles",
         "7000 / 2500",
         {1, 0},
         " / ",
         [](const std::vector<int>& at) { return at[0] > at[1]; }},
        {"half_step",
         "half the time step, cycles",
         "6000 / 2500, more than twice",
         {2, 0},
         " / ",
         [](const std::vector<int>& at) { return at[0] > 2 * at[1]; }},
        {"damping",
         "damping 0.5, 0.6, 0.7: cycle of that displacement",
         "slowest, fastest, between",
         {3, 4, 5},
         ", ",
         [](const std::vector<int>& at) { return at[0] > at[2] && at[2] > at[1]; }}};
    return all;
}

Figure figure_of_rotations(const std::vector<Chapter5Run>& runs, const std::vector<HockingResult>& histories,
                           const std::vector<HockingResult>& clean) {
    const auto rotation = [](const HockingPrint& print) { return print.blocks[0].angle / degrees(1); };
    Points marks{.legend = "printed: cycles of one displacement", .marker = Marker::filled_diamond};
    std::vector<HistoryOf> drawn;
    for (std::size_t index = 0; index < runs.size(); ++index) {
        if (index != 3) {  // damping 0.5 is the run of 6e6 N/m
            drawn.push_back({runs[index].name, &histories[index], rotation});
        }
        if (runs[index].printed_cycle) {
            drawn.push_back({index == 0 ? "dashed: clean engine" : "", &clean[index], rotation, true});
            marks.points.emplace_back(*runs[index].printed_cycle,
                                      rotation(print_at(histories[0], *runs[0].printed_cycle)));
        }
    }
    Figure figure = history_figure("5.3.2: two blocks at 18.4 deg", "rotation of block 1", "deg", drawn);
    figure.series.emplace_back(marks);
    figure.x.range = std::pair(0, 9000);
    figure.y.range = std::pair(0, 20);
    return figure;
}

}  // namespace

void same_displacement(Chapter5Item& item) {
    const double reference = reference_of(item.runs);
    for (const Chapter5Run& run : item.runs) {
        std::vector<std::string>& row =
            item.table.rows.emplace_back(std::vector{run.name, in_words(run.printed_cycle)});
        for (const Engine engine : engines) {
            row.push_back(in_words(cycle_of(reference, compute(run, engine))));
        }
    }
}

void observations(Chapter5Item& item) {
    const std::vector<Chapter5Run>& runs = item.runs;
    const double reference = reference_of(runs);
    std::vector<HockingResult> histories;
    std::vector<HockingResult> clean_histories;
    std::vector<std::vector<OtherListing>> otherwise;
    // The cycle for each start and run; nothing where a run blows out.
    std::vector<std::vector<std::optional<int>>> shifted(static_cast<std::size_t>(item.starts));
    for (const Chapter5Run& run : runs) {
        histories.push_back(compute(run, Engine::recreated));
        clean_histories.push_back(compute(run, Engine::dropped));
        otherwise.push_back(compute_otherwise(run));
        const std::vector<HockingResult> others = compute_shifted(run, Engine::recreated, typed_digit, item.starts);
        CountRange range;
        for (std::size_t start = 0; start < others.size(); ++start) {
            std::optional<int>& cycle = shifted[start].emplace_back();
            if (others[start].outcome != HockingOutcome::blows_out) {
                cycle = cycle_of(reference, others[start]).value_or(run.settings.cycles);
                range.include(*cycle);
            }
        }
        const bool any = range.count > 0;
        item.table.rows.push_back({run.name, std::to_string(item.starts - range.count),
                                   any ? std::to_string(range.least) : "", any ? std::to_string(range.greatest) : ""});
        if (any) {
            item.result.json["spread"][run.name] = {range.least, range.greatest};
        }
    }
    for (const Observation& one : printed_observations()) {
        std::vector<int> cycles;
        std::string computed;
        std::string clean;
        for (const std::size_t run : one.compared) {
            const std::string separator = cycles.empty() ? "" : one.separator;
            cycles.push_back(cycle_of(reference, histories[run]).value_or(runs[run].settings.cycles));
            computed += separator + std::to_string(cycles.back());
            clean += separator + in_words(cycle_of(reference, clean_histories[run]));
        }
        int usable = 0;
        int held = 0;
        for (const std::vector<std::optional<int>>& start : shifted) {
            std::vector<int> at;
            for (const std::size_t run : one.compared) {
                at.insert(at.end(), start[run].has_value(), start[run].value_or(0));
            }
            if (at.size() == one.compared.size()) {
                ++usable;
                held += one.holds(at) ? 1 : 0;
            }
        }
        std::string listings;
        for (std::size_t listing = 0; listing < otherwise.front().size(); ++listing) {
            std::string words;
            for (const std::size_t run : one.compared) {
                words += (words.empty() ? "" : one.separator) +
                         in_words(cycle_of(reference, otherwise[run][listing].result));
            }
            listings += "; " + otherwise.front()[listing].name + ": " + words;
        }
        item.result.json["shifted"][one.name] = {{"held", held}, {"usable", usable}};
        item.result.add(one.what, one.printed, computed,
                        statement(one.holds(cycles)) + "; in " + std::to_string(held) + " of " +
                            std::to_string(usable) + " starts with the last typed digits shifted" + listings,
                        clean);
    }
    item.draw(figure_of_rotations(runs, histories, clean_histories), "observations",
              "Stiffness, time step and damping; dashed: clean engine, dropped.");
}

}  // namespace delabole
