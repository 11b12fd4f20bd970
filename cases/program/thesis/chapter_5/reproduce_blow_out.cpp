// Fig 5.13 of the thesis: the run that blew out at cycle 677, and why.
#include "cases/program/terminal/interrupt.hpp"
#include "cases/program/thesis/chapter_5/chapter_5.hpp"
#include "cases/program/thesis/chapter_5/relaxation_drawing.hpp"
#include "plots/drawing/text.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace delabole {

namespace {

std::string in_inches(double metres, int digits) {
    return human_number(metres / inch, digits) + " in";
}

// The parts of the listing that may be corrected.
struct Variant {
    std::string name;
    HockingSlotMemory memory;
    double guard;  // m
};

const std::vector<Variant>& variants() {
    static const std::vector<Variant> all = {{"as listed", HockingSlotMemory::per_neighbour, 1e-5},
                                             {"without the guard", HockingSlotMemory::per_neighbour, 0},
                                             {"slots per face", HockingSlotMemory::per_face, 1e-5}};
    return all;
}

Chapter5Run varied(Chapter5Run run, const Variant& variant) {
    run.settings.slot_memory = variant.memory;
    run.settings.crossing_guard = variant.guard;
    return run;
}

// Counts the cycles at which some runs blow out.
CountRange blow_outs(const std::vector<HockingResult>& results) {
    CountRange found;
    for (const HockingResult& result : results) {
        if (result.blow_out_cycle) {
            found.include(*result.blow_out_cycle);
        }
    }
    return found;
}

Chapter5Run of_slenderness(const Chapter5Run& run, double slenderness) {
    Chapter5Run other = run;
    other.columns.heights.assign(2, slenderness * inch);
    other.columns.base_height = slenderness * inch;
    other.settings.stiffness = run.settings.stiffness * run.columns.width / run.columns.heights[0] * slenderness;
    return other;
}

// Describes the slot that serves block 1's uphill foot against block 2; `before` is the print one cycle earlier.
std::vector<std::vector<std::string>> mechanism(const Chapter5Run& run, const HockingFaceChange& change,
                                                const HockingPrint& before) {
    const std::vector<HockingBlock> blocks = make_blocks(run.columns);
    const Point& centroid = before.blocks[1].centroid;
    const Point foot = corners_of(blocks[0], before.blocks[0])[2];
    const Point toe = corners_of(blocks[1], before.blocks[1])[3];
    const double half_width = run.columns.width / 2;
    const double half_height = run.columns.heights[0] / 2;
    const double weight = 2 * run.columns.width * run.columns.heights[0] * run.settings.density * run.settings.gravity;
    const auto small = [](double metres) { return human_number(metres * 1e6, 3) + " µm"; };
    const auto force = [](double value) { return human_number(value / 1000, 4) + " kN/m"; };
    return {
        {"cycle", std::to_string(change.cycle)},
        {"face found before, and now", human_name(word_of(change.from)) + ", " + human_name(word_of(change.to))},
        {"inclination of block 2's base, deg",
         human_number((run.columns.dip + before.blocks[1].angle) / degrees(1), 6)},
        {"atan(1/7), deg", human_number(std::atan(1.0 / 7) / degrees(1), 6)},
        {"foot from the vertical below block 2's centroid", small(foot.x() - centroid.x())},
        {"toe of block 2 from that vertical", small(toe.x() - centroid.x())},
        {"overlap of the foot with block 2's side", small(half_width - change.stored_position)},
        {"height of the foot above block 2's base", small(half_height - change.new_position)},
        {"stored distance, from the axis along the side", in_inches(change.stored_position, 6)},
        {"new distance, from the axis along the base", in_inches(change.new_position, 6)},
        {"difference taken for the movement of one cycle", in_inches(change.stored_position - change.new_position, 5)},
        {"spring force", force(change.spring_force)},
        {"dashpot force", force(change.dashpot_force)},
        {"weight of both blocks", force(weight)},
    };
}

}  // namespace

void blow_out(Chapter5Item& item) {
    const Chapter5Run& run = item.runs.front();
    Reproduction& result = item.result;
    const HockingResult computed = compute(run, Engine::recreated);
    const int printed = run.printed_cycle.value_or(0);
    const int cycle = computed.blow_out_cycle.value_or(0);
    result.add({"a/b = 7: cycle at which the blocks blow out", std::to_string(printed),
                in_words(computed.blow_out_cycle), cycle > 0 ? std::to_string(cycle - printed) : "",
                "at 8 deg; the inclination is not printed"});
    result.json["cycle"] = cycle;
    if (computed.blow_out) {
        const HockingFaceChange& change = *computed.blow_out;
        Chapter5Run fine = run;
        fine.settings.print_interval = 1;
        fine.settings.cycles = cycle + run.settings.cycles_after_blow_out;
        fine.settings.stop_rotation = std::numeric_limits<double>::infinity();
        const HockingResult every_cycle = compute(fine, Engine::recreated);
        item.table.rows = mechanism(fine, change, print_at(every_cycle, cycle - 1));
        result.json["jump_in"] = (change.stored_position - change.new_position) / inch;
        item.draw(frames_figure("Fig 5.13: blow-out of the 7 inch blocks", fine, every_cycle,
                                {cycle - 1, cycle + 3, cycle + 6}),
                  "fig_5_13", "Just before, and three and six cycles after.");
    }
    for (const Variant& variant : variants()) {
        const HockingResult other = compute(varied(run, variant), Engine::recreated);
        result.json["blows_out"][variant.name] = other.blow_out_cycle.has_value();
        result.add("the same, " + variant.name, "", other.blow_out_cycle ? outcome_in_words(other) : "no blow-out",
                   std::to_string(other.face_change_count) + " changes of face");
    }
}

void blow_outs_of_shifted_starts(Chapter5Item& item) {
    const Chapter5Run& run = item.runs.front();
    for (const double unit : {1e-12, 1e-9, 1e-8, 1e-7, 1e-6}) {
        std::vector<std::string>& row = item.table.rows.emplace_back(std::vector{human_number(unit, 2) + " m"});
        CountRange listed;
        for (const Variant& variant : variants()) {
            const CountRange found =
                blow_outs(compute_shifted(varied(run, variant), Engine::recreated, unit, item.starts));
            listed = row.size() == 1 ? found : listed;  // the first variant
            row.push_back(std::to_string(found.count));
            item.result.json["shifted_starts"][row.front()][variant.name] = found.count;
        }
        row.insert(row.end(), {std::to_string(listed.least), std::to_string(listed.greatest)});
    }
}

// The same random starts for both programs: free blocks shifted by a typed digit, inclinations from half a degree below
// atan(b/a) to half a degree above.
void blow_outs_of_random_starts(Chapter5Item& item) {
    const Chapter5Run& run = item.runs.front();
    int listed_blow_outs = 0;
    int clean_blow_outs = 0;
    double worst_error = 0;
    for (const double slenderness : {3.0, 5.0, 7.0, 10.0}) {
        const Chapter5Run sized = of_slenderness(run, slenderness);
        std::mt19937 random(677);
        std::uniform_real_distribution<double> any(-0.5, 0.5);
        std::vector<HockingResult> listed;
        std::vector<HockingResult> clean;
        double error = 0;
        double speed = 0;
        for (int seed = 1; seed <= item.starts; ++seed) {
            stop_if_interrupted();
            Chapter5Run start = sized;
            start.columns.coordinate_unit = 0;
            start.columns.dip = std::atan(1 / slenderness) + degrees(any(random));
            const std::vector<HockingBlock> blocks =
                perturbed(make_blocks(start.columns), typed_digit, static_cast<unsigned>(seed));
            listed.push_back(compute(start, Engine::recreated, blocks));
            const CleanRun other = run_clean(start, blocks, RelaxationStart::dropped);
            clean.push_back(other.history);
            error = std::max(error, other.energy_error);
            speed = std::max(speed, other.largest_speed);
        }
        const int listed_count = blow_outs(listed).count;
        const int clean_count = blow_outs(clean).count;
        const double fall = std::sqrt(2 * run.settings.gravity * slenderness * inch);
        item.table.rows.push_back({human_number(slenderness, 2), std::to_string(listed_count),
                                   std::to_string(clean_count), human_number(100 * error, 2), human_number(speed, 3),
                                   human_number(fall, 3)});
        listed_blow_outs += listed_count;
        clean_blow_outs += clean_count;
        worst_error = std::max(worst_error, error);
        item.result.json["random_starts"].push_back({{"slenderness", slenderness},
                                                     {"re-created", listed_count},
                                                     {"clean", clean_count},
                                                     {"energy_error", error},
                                                     {"largest_speed_m_per_s", speed},
                                                     {"speed_of_fall_m_per_s", fall}});
    }
    item.result.add(std::to_string(4 * item.starts) + " random starts", "",
                    std::to_string(listed_blow_outs) + " blow-outs",
                    "energy error at most " + human_number(100 * worst_error, 2) + " %",
                    std::to_string(clean_blow_outs) + " blow-outs");
}

}  // namespace delabole
