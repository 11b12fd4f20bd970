// Fig 5.13 of the thesis: the run that blew out at cycle 677, and why.
#include "cases/relaxation_drawing.hpp"
#include "cases/reproduction_chapter_5.hpp"
#include "plots/text.hpp"

#include <algorithm>
#include <cmath>

namespace delabole {

namespace {

std::string face_in_words(HockingFace face) {
    return human_name(enum_names(face)[static_cast<std::size_t>(face)]);
}

std::string in_inches(double metres, int digits) {
    return human_number(metres / inch, digits) + " in";
}

struct BlowOuts {
    int count = 0;
    int first = 0;
    int last = 0;
};

BlowOuts blow_outs(const Chapter5Run& run, double unit, int starts) {
    BlowOuts found;
    const std::vector<HockingBlock> blocks = make_blocks(run.columns);
    for (int seed = 1; seed <= starts; ++seed) {
        const HockingResult result = run_hocking(perturbed(blocks, unit, static_cast<unsigned>(seed)), run.settings);
        if (result.blow_out_cycle) {
            found.first = found.count == 0 ? *result.blow_out_cycle : std::min(found.first, *result.blow_out_cycle);
            found.last = std::max(found.last, *result.blow_out_cycle);
            ++found.count;
        }
    }
    return found;
}

Table mechanism(const Chapter5Run& run, const HockingFaceChange& change) {
    const double half_width = run.columns.width / 2;
    const double half_height = run.columns.heights[0] / 2;
    const double dashpot = change.dashpot_force / (change.stored_position - change.new_position);
    const double weight = 2 * run.columns.width * run.columns.heights[0] * run.settings.density * run.settings.gravity;
    const auto force = [](double value) { return human_number(value / 1000, 4) + " kN/m"; };
    return {"The slot at cycle " + std::to_string(change.cycle),
            {{"quantity"}, {"value", true}},
            {
                {"corner", "foot of block 1's uphill side"},
                {"neighbour", "block 2"},
                {"face before: downhill side, stored distance from its axis", in_inches(change.stored_position, 8)},
                {"true overlap with that face", in_inches(half_width - change.stored_position, 3)},
                {"face now: base, distance from its axis", in_inches(change.new_position, 8)},
                {"true overlap with this face", in_inches(half_height - change.new_position, 3)},
                {"difference taken for a movement of one cycle",
                 in_inches(change.stored_position - change.new_position, 6)},
                {"half of height less width", in_inches(half_height - half_width, 6)},
                {"dashpot, N/m per metre in one cycle", human_number(dashpot, 4)},
                {"spring force", force(change.spring_force)},
                {"dashpot force", force(change.dashpot_force)},
                {"weight of both blocks", force(weight)},
            }};
}

}  // namespace

Reproduction reproduce_fig_5_13(const ResultFolder& folder, Report& report) {
    Reproduction result;
    const Chapter5Run run = blow_out_run();
    const HockingResult computed = delabole::run(run);
    const int cycle = computed.blow_out_cycle.value_or(0);
    report.blocks.emplace_back(Heading{"Fig 5.13: two blocks of a/b = 7 blow out"});
    result.rows.push_back({"a/b = 7: cycle at which the blocks blow out", "677",
                           cycle > 0 ? std::to_string(cycle) : "never",
                           cycle > 0 ? std::to_string(cycle - run.printed_cycle.value_or(0)) : "",
                           "at 8 deg; the inclination is not printed"});
    result.json["cycle"] = cycle;
    if (computed.blow_out) {
        const HockingFaceChange& change = *computed.blow_out;
        report.blocks.emplace_back(Paragraph{
            "The blocks are dropped on their springs, rock forward together and come down again. When the raised foot "
            "of block 1 lands beside the toe of block 2, the corner is inside block 2 by some ten-thousandths of a "
            "millimetre both through its side and through its base, and the face found changes from " +
            face_in_words(change.from) + " to " + face_in_words(change.to) +
            ". The listing keeps one slot for this corner and this neighbour. It subtracts the distance from one axis, "
            "stored for the side, from the distance from the other axis, now that of the base, and hands the "
            "difference to the dashpot as a movement of one cycle."});
        report.blocks.emplace_back(mechanism(run, change));
        result.json["jump_in"] = (change.stored_position - change.new_position) / inch;
        result.json["dashpot_force_N_per_m"] = change.dashpot_force;
        result.json["from"] = std::string(enum_names(change.from)[static_cast<std::size_t>(change.from)]);
        result.json["to"] = std::string(enum_names(change.to)[static_cast<std::size_t>(change.to)]);
        Chapter5Run before = run;
        before.settings.print_interval = 1;
        before.settings.cycles = cycle + run.settings.cycles_after_blow_out;
        before.settings.stop_rotation = INFINITY;
        const HockingResult fine = delabole::run(before);
        report.blocks.emplace_back(folder.draw(
            frames_figure("Fig 5.13: blow-out of the 7 inch blocks", before, fine, {cycle - 1, cycle + 2, cycle + 6}),
            "fig_5_13", "Just before, and two and six cycles after the face changes."));
    }
    Chapter5Run mended = run;
    mended.settings.slot_memory = HockingSlotMemory::per_face;
    const HockingResult without = delabole::run(mended);
    result.rows.push_back({"the same, slots that forget when the face changes", "",
                           without.blow_out_cycle ? outcome_in_words(without) : "no blow-out", "",
                           std::to_string(without.face_change_count) + " changes of face"});
    result.json["blows_out_with_slots_per_face"] = without.blow_out_cycle.has_value();

    Table spread{"Coordinates shifted at random, 100 starts each",
                 {{"shift"},
                  {"blow out", true},
                  {"first at cycle", true},
                  {"last at cycle", true},
                  {"blow out, slots per face", true}},
                 {}};
    for (const double unit : {1e-12, 1e-9, 1e-8, 1e-7, 1e-6}) {
        const BlowOuts listing = blow_outs(run, unit, 100);
        const BlowOuts per_face = blow_outs(mended, unit, 100);
        spread.rows.push_back({human_number(unit, 2) + " m", std::to_string(listing.count),
                               std::to_string(listing.first), std::to_string(listing.last),
                               std::to_string(per_face.count)});
        result.json["starts"].push_back({{"shift_m", unit},
                                         {"blow_out", listing.count},
                                         {"first", listing.first},
                                         {"last", listing.last},
                                         {"blow_out_with_slots_per_face", per_face.count}});
    }
    report.blocks.emplace_back(spread);
    Table others{"Inclinations from half a degree below atan(b/a) to half a degree above, in steps of 0.01 deg",
                 {{"a/b", true}, {"runs", true}, {"blow out", true}, {"blow out, slots per face", true}},
                 {}};
    for (const double slenderness : {3.0, 5.0, 7.0, 10.0}) {
        int listing = 0;
        int per_face = 0;
        const int lowest = static_cast<int>(std::lround(100 * (std::atan(1 / slenderness) / degrees(1) - 0.5)));
        constexpr int steps = 100;
        for (int step = 0; step <= steps; ++step) {
            Chapter5Run other = run;
            other.columns.heights.assign(2, slenderness * inch);
            other.columns.base_height = slenderness * inch;
            other.columns.dip = degrees((lowest + step) / 100.0);
            other.settings.stiffness = run.settings.stiffness * slenderness / 7;
            other.settings.cycles = 2500;
            listing += delabole::run(other).blow_out_cycle ? 1 : 0;
            other.settings.slot_memory = HockingSlotMemory::per_face;
            per_face += delabole::run(other).blow_out_cycle ? 1 : 0;
        }
        others.rows.push_back({human_number(slenderness, 2), std::to_string(steps + 1), std::to_string(listing),
                               std::to_string(per_face)});
        result.json["by_slenderness"].push_back(
            {{"a_over_b", slenderness}, {"blow_out", listing}, {"blow_out_with_slots_per_face", per_face}});
    }
    report.blocks.emplace_back(others);
    report.blocks.emplace_back(printed_table("Blow-out", result.rows));
    return result;
}

}  // namespace delabole
