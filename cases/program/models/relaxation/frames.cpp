// A run of blocks as an animation.
#include "plots/report/frames.hpp"
#include "cases/program/models/relaxation/figures.hpp"
#include "cases/program/terminal/interrupt.hpp"
#include "dynamic_relaxation/study/cracks.hpp"
#include "fitting/work/words.hpp"
#include "plots/drawing/text.hpp"

#include <algorithm>
#include <cmath>

namespace delabole {

namespace {

BlockAnimation animation_of(const RelaxationRun& made, const Bodies& bodies) {
    BlockAnimation animation;
    // A run that is followed for a given time continues after its verdict, whose moment is that of onset.
    const bool on_time = made.result.onset_time && *made.result.onset_time < made.result.time;
    animation.outcome =
        human_name(word_of(made.result.outcome)) +
        (on_time ? ", began at " + value_in_words(*made.result.onset_time, Dimension::time) + ", followed to "
                 : std::string(" at ")) +
        value_in_words(made.result.time, Dimension::time);
    animation.colour = "speed";
    animation.unit = shown_unit(Dimension::speed).symbol;
    animation.bar_unit = shown_unit(Dimension::force_per_length).symbol;
    animation.caption = "The blocks in motion, gravity downwards" +
                        std::string(made.scene.bolt.empty() ? "" : ", bolts with their tension") +
                        ". The same frames, with contact forces, are in frames/ for ParaView.";
    for (std::size_t block = 0; block < bodies.size(); ++block) {
        const bool fixed = bodies.fixed[block] != 0;
        AnimatedBlock shown{{}, label_of(block, fixed), fixed};
        for (const PlanePoint<>& corner : made.scene.block[block].outline) {
            shown.outline.push_back(corner);
        }
        animation.blocks.push_back(std::move(shown));
    }
    for (const BrokenBond& bond : broken_bonds(made.scene, bodies, *made.end)) {
        const auto first = std::ranges::lower_bound(made.frames, bond.time, {}, &MotionFrame::time);
        animation.blocks[bond.block].cracks.push_back(
            {bond.from, bond.to, static_cast<std::size_t>(first - made.frames.begin())});
    }
    for (const MotionFrame& frame : made.frames) {
        AnimationFrame shown{frame.time, frame.tilt, {}, {}};
        for (const BoltPull& bolt : frame.bolt) {
            shown.bars.push_back({bolt.at, bolt.other_at,
                                  bolt.force / shown_unit(Dimension::force_per_length).si_per_unit, bolt.yielded > 0,
                                  bolt.holds});
        }
        for (std::size_t block = 0; block < bodies.size(); ++block) {
            const Motion& motion = frame.motion[block];
            shown.poses.push_back({Point(motion.x, motion.y), motion.angle,
                                   std::hypot(motion.vx, motion.vy) / shown_unit(Dimension::speed).si_per_unit,
                                   !is_gone(frame.outcome[block].movement)});
        }
        animation.frames.push_back(std::move(shown));
    }
    return animation;
}

BlockFrame frame_of(const MotionFrame& frame, const Bodies& bodies) {
    const Upright upright(frame.tilt);
    BlockFrame shown;
    shown.time = frame.time;
    shown.tilt = frame.tilt;
    for (const std::string_view word : enum_names(BlockMovement{})) {
        shown.movements.emplace_back(word);
    }
    for (std::size_t block = 0; block < bodies.size(); ++block) {
        const BlockOutcome& outcome = frame.outcome[block];
        if (is_gone(outcome.movement)) {
            continue;
        }
        const Motion& motion = frame.motion[block];
        FrameBlock moved;
        for (std::size_t corner = bodies.range[block].begin; corner < bodies.range[block].end; ++corner) {
            moved.outline.push_back(upright(moved_corner(bodies, frame.motion, corner)));
        }
        moved.number = static_cast<int>(block) + 1;
        moved.fixed = bodies.fixed[block] != 0;
        moved.movement = static_cast<int>(outcome.movement);
        moved.displacement = upright(PlanePoint<>(motion.x, motion.y));
        moved.rotation = motion.angle;
        moved.velocity = upright(PlanePoint<>(motion.vx, motion.vy));
        shown.blocks.push_back(std::move(moved));
    }
    for (const CornerForce& force : frame.force) {
        shown.contacts.push_back({upright(force.at), upright(force.force), force.normal, force.shear, force.sliding,
                                  static_cast<int>(force.block) + 1, static_cast<int>(force.other) + 1});
    }
    return shown;
}

}  // namespace

void append_frames(const RelaxationRun& made, const Sheet& sheet) {
    if (made.frames.empty()) {
        return;
    }
    const Bodies bodies = make_bodies(made.scene);
    sheet.add(animation_of(made, bodies));
    if (sheet.folder.path().empty()) {
        return;  // nothing is written
    }
    if (interrupt_flag()) {
        // They can be a hundred megabytes for a large slope; the same command writes them once it has continued to the
        // end of the run.
        sheet.add(Paragraph{"Frames for ParaView are written when the run has come to its end."});
        return;
    }
    sheet.folder.enter({});  // removes the frames of an earlier result, and their folder
    FrameFolder frames(sheet.folder.path() / "frames", "run");
    std::vector<std::string> names = frames.file_names(made.frames.size());
    for (std::string& name : names) {
        name.insert(0, "frames/");
    }
    sheet.folder.enter(names);
    for (const MotionFrame& frame : made.frames) {
        frames.add(frame_of(frame, bodies));
    }
}

}  // namespace delabole
