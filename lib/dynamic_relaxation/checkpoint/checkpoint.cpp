#include "dynamic_relaxation/checkpoint/checkpoint.hpp"

#include "dynamic_relaxation/step/outcome.hpp"

#include <utility>

namespace delabole {

namespace {

std::uint64_t hash_of(const RelaxationScene& scene, const RelaxationSettings& settings) {
    RelaxationSettings of_a_step = settings;
    of_a_step.duration = 0;
    of_a_step.most_steps = 0;
    of_a_step.threads = 0;
    ArchiveWriter writer;
    writer.put(scene);
    writer.put(of_a_step);
    return fnv_1a(writer.bytes());
}

}  // namespace

bool fits(const RelaxationState& state, const RelaxationScene& scene) {
    const std::size_t blocks = scene.block.size();
    if (state.motion.size() != blocks || state.origin.size() != blocks || state.removed.size() != blocks ||
        state.base_slip.size() != blocks || state.dropped_slip.size() != blocks ||
        state.checks_at_rest.size() != blocks || state.noticed.moved.size() != blocks ||
        state.bond.size() != scene.bond.size() || state.bolt.size() != scene.bolt.size() ||
        (state.first_crack && (state.first_crack->block >= blocks || state.first_crack->other >= blocks))) {
        return false;
    }
    std::vector<std::size_t> corners_before{0};
    for (const RelaxationBlock& block : scene.block) {
        corners_before.push_back(corners_before.back() + block.outline.size());
    }
    const auto is_of = [&](std::size_t corner, std::size_t block) {
        return block < blocks && corner >= corners_before[block] && corner < corners_before[block + 1];
    };
    const ContactList& list = state.contacts;
    const std::size_t contacts = list.contact.size();
    const WatchState& watch = state.watch;
    const NoticedMotion& noticed = state.noticed;
    for (const auto* const each : {&watch.travelled, &watch.due, &watch.neighbours_until, &watch.step_until,
                                   &watch.stable_step, &noticed.x, &noticed.y, &noticed.angle}) {
        if (each->size() != blocks) {
            return false;
        }
    }
    std::size_t begin = 0;
    for (const WatchedPair& pair : watch.pair) {
        if (pair.first >= blocks || pair.second >= blocks || pair.begin < begin || pair.begin > contacts) {
            return false;
        }
        begin = pair.begin;
    }
    if (list.memory.size() != contacts || list.force.size() != contacts || list.open_until.size() != contacts) {
        return false;
    }
    for (std::size_t index = 0; index < contacts; ++index) {
        const RelaxationContact contact = list.contact[index];
        if (!is_of(contact.corner, contact.block) || !is_of(contact.edge, contact.other) ||
            (contact.twin != no_twin && contact.twin >= contacts) || contact.ends >= list.ends.size() ||
            contact.joint >= list.joint.size() || (list.memory[index].touching && list.open_until[index] != not_open)) {
            return false;
        }
    }
    return state.outcome < enum_names(RelaxationOutcome{}).size();
}

std::string checkpoint_of(const RelaxationScene& scene, const RelaxationSettings& settings,
                          const RelaxationState& state) {
    ArchiveWriter body;
    body.put(state);
    return seal_checkpoint(hash_of(scene, settings), body.bytes());
}

RestoredState restore_checkpoint(std::string_view bytes, const RelaxationScene& scene,
                                 const RelaxationSettings& settings) {
    const OpenedCheckpoint opened = open_checkpoint(bytes, hash_of(scene, settings));
    if (opened.check != CheckpointCheck::ok) {
        return {opened.check};
    }
    ArchiveReader body(opened.body);
    RelaxationState state;
    body.get(state);
    if (!body.whole() || !fits(state, scene)) {
        return {CheckpointCheck::damaged};
    }
    return {CheckpointCheck::ok, std::move(state)};
}

}  // namespace delabole
