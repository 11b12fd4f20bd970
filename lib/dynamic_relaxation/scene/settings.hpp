// Numerical settings of dynamic relaxation. None of them is a property of the rock; `delabole trade` measures the
// effect and the cost of each.
#pragma once

#include <cstddef>
#include <optional>

namespace delabole {

enum class RelaxationStart {
    preloaded,  // springs compressed to equilibrium under the first loads; if fewer than 400 free blocks with cohesion
                // or bonds find none, it is sought again under loads that grow in ten steps
    dropped,    // springs free, full gravity at once
    ramped,     // springs free, gravity grows from zero over `ramp_time`
    stepped,    // as preloaded, but the first loads grow in ten equal steps, with an equilibrium after each
};

constexpr bool is_preloaded(RelaxationStart start) {
    return start == RelaxationStart::preloaded || start == RelaxationStart::stepped;
}

enum class RelaxationQuality { draft, standard, reference };

// The numbers that a quality sets together. They were chosen with `delabole trade`: with a preloaded start the critical
// value depends on the stiffness alone, and steps of 0.1 to 0.6 of the stable one give the same bracket.
struct RelaxationAccuracy {
    double step_fraction;
    double stiffness_ratio;
    double equilibrium_ratio;
};

constexpr RelaxationAccuracy accuracy_of(RelaxationQuality quality) {
    switch (quality) {
    case RelaxationQuality::draft:
        return {0.8, 3e5, 1e-5};
    case RelaxationQuality::reference:
        return {0.4, 1e8, 1e-7};
    case RelaxationQuality::standard:
        break;
    }
    return {0.6, 1e6, 1e-6};
}

struct RelaxationSettings {
    // Fraction of the greatest stable step of the blocks on springs and dashpots, 0.01 to 0.8: from 0.9 on standing
    // blocks vibrate for ever. Blocks that collide get at most 0.3, and with local damping the fraction is at most
    // 0.96 / (1 + local damping).
    double step_fraction = accuracy_of(RelaxationQuality::standard).step_fraction;
    std::optional<double> time_step{};  // s; replaces the fraction, which still limits it: a longer step is divided

    double viscous_damping = 0.2;  // contact dashpots, as a fraction of critical damping; 0 to 2
    double local_damping = 0.2;    // fraction of the unbalanced force that acts against the velocity; 0 to below 1
    bool kinetic_damping = false;  // sets all velocities to zero at each peak of the kinetic energy
    // A preloaded start without equilibrium begins where blocks have crept to without inertia, just short of the
    // thresholds of onset. This serves to find out whether they stand, not to follow their motion.
    bool creep = false;
    bool mass_scaling = false;  // gives light blocks the inertia of heavy ones: for equilibria, not for motion

    RelaxationStart start = RelaxationStart::preloaded;
    double ramp_time = 0;           // s; of a ramped start
    double consolidation_time = 0;  // s, initial period in which the blocks of `held` do not move

    // Equilibrium: the greatest unbalanced force on a block, as a share of its weight, is below this value, and the
    // kinetic energy does not grow; on a belt, also the speeds are below this share of the belt's.
    double equilibrium_ratio = accuracy_of(RelaxationQuality::standard).equilibrium_ratio;
    // rad; a larger rotation after which no equilibrium is found is the onset of failure. A run that is to stop there
    // goes on up to twice as far where motion slows down, because blocks that fall back have not failed.
    double onset_rotation = 0.01;
    double onset_slide = 0.01;         // as a fraction of the block's size, in the same sense
    double collapse_rotation = 0.5;    // rad
    double collapse_displacement = 1;  // of the block's size
    bool stop_at_onset = false;
    bool stop_at_equilibrium = true;
    bool stop_at_collapse = true;  // otherwise a collapse is followed until the blocks come to rest
    // m, elevation in the section: a free block that lies wholly below it has left the slope and is removed.
    std::optional<double> taken_away_below{};
    double duration = 60;  // s of model time, at most
    std::size_t most_steps = 100'000'000;

    // m; a larger opening between faces of free neighbours is the first tension crack. Unset: crack detection is off.
    std::optional<double> crack_opening{};

    // Greatest overlap of a contact, and of the blocks themselves, as a fraction of the shortest edge of the two
    // blocks; a run that exceeds it is stopped. At least 0.02: overlaps are checked whenever two blocks have moved by a
    // hundredth of that edge, or, if they are fast, by the distance that may take them to the limit.
    double overlap_limit = 0.05;
    // Whether blocks held only by corners on corners are in equilibrium (contact/corner_choice.hpp).
    bool corners_bear = false;
    std::size_t threads = 1;
};

}  // namespace delabole
