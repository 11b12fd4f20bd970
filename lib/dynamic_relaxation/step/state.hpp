// All that a run needs to continue: nothing else changes from step to step.
#pragma once

#include "dynamic_relaxation/blocks/block_sweep.hpp"
#include "dynamic_relaxation/blocks/bodies.hpp"
#include "dynamic_relaxation/blocks/overlap.hpp"
#include "dynamic_relaxation/contact/bolt_springs.hpp"
#include "dynamic_relaxation/contact/bonds.hpp"
#include "dynamic_relaxation/contact/contact_watch.hpp"
#include "dynamic_relaxation/contact/contacts.hpp"
#include "parameters/fields.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace delabole {

// Energies, J per metre run. Applied work = kinetic + elastic + friction + bonds + dashpots + local damping + kinetic
// damping + residual.
struct EnergyBalance {
    double applied = 0;
    double prescribed = 0;
    double kinetic = 0;
    double elastic = 0;
    double friction = 0;  // includes broken bonds and springs of removed blocks
    double bonds = 0;
    double dashpots = 0;
    double local_damping = 0;
    double kinetic_damping = 0;

    double elastic_at_start = 0;

    static constexpr auto fields() {
        using E = EnergyBalance;
        constexpr Dimension energy = Dimension::energy_per_length;
        return FieldTable{number<&E::applied>(energy, "work of gravity and other loads"),
                          number<&E::prescribed>(energy, "work of moved fixed blocks"),
                          number<&E::kinetic>(energy, "kinetic energy at the end"),
                          number<&E::elastic>(energy, "stored in springs at the end, above the start"),
                          number<&E::friction>(energy, "dissipated by slip"),
                          number<&E::bonds>(energy, "set free by bonds that broke"),
                          number<&E::dashpots>(energy, "dissipated by contact dashpots"),
                          number<&E::local_damping>(energy, "dissipated by local damping"),
                          number<&E::kinetic_damping>(energy, "taken out at energy peaks, and with removed blocks"),
                          number<&E::residual>(energy, "residual of the energy balance"),
                          number<&E::residual_share>(
                              "residual over all energy turned over; 0 where it is rounding of what springs hold")};
    }

    double residual() const {
        return applied + prescribed - kinetic - elastic - friction - bonds - dashpots - local_damping - kinetic_damping;
    }
    // All energy that has been converted.
    double turnover() const;
    // Residual over turnover; 0 if the residual is no more than rounding of the energy of springs, as for blocks that
    // only stand, whose whole turnover is of that size.
    double residual_share() const;
};

// The first crack between two free blocks that were neighbours in the initial geometry.
struct FirstCrack {
    double time = 0;  // s
    double tilt = 0;  // rad, of gravity in the section and of the first moved base together
    std::uint64_t block = 0;
    std::uint64_t other = 0;
};

// The most balanced state that the static solve met: the run starts there, unless blocks have crept farther.
struct StartBalance {
    double unbalanced_ratio = 0;  // greatest unbalanced force on a block, with moment over radius, over its load
    bool cut_short = false;       // ended at the limit of linear solutions: with more there may be a balance
};

struct SlipOverFace {
    double upward = 0;  // cosine of the angle between the face's outward normal and up; 0: no face
    double slip = 0;    // m, negative towards -x
};

// Reason for the removal of a block.
inline constexpr char taken_away = 1;  // by a schedule
inline constexpr char has_left = 2;    // the slope, below a given elevation

struct RelaxationState {
    double time = 0;       // s
    double step = 0;       // s, chosen when contacts were last checked
    double last_step = 0;  // s, of the step that led here; 0 at the start and after velocities were set to zero
    std::uint64_t steps = 0;
    std::uint64_t contacts_evaluated = 0;
    std::vector<Motion> motion = {};
    std::vector<Motion> origin = {};                 // at the start, after the static solve
    std::optional<StartBalance> start_balance = {};  // absent if nothing was preloaded
    NoticedMotion noticed = {};
    std::vector<std::uint32_t> checks_at_rest = {};  // checks in a row without motion (Simulation::rests)
    std::vector<char> removed = {};                  // 0: not removed; otherwise the reason
    std::vector<double> base_slip = {};              // m, of each block over fixed ones up to the last record
    std::vector<SlipOverFace> dropped_slip = {};     // of contacts that have been dropped since
    ContactList contacts = {};
    WatchState watch = {};
    std::vector<BondMemory> bond = {};  // in the order of the scene's bonds
    std::vector<BoltMemory> bolt = {};  // in the order of the scene's bolt segments
    EnergyBalance energy_balance = {};  // sums; momentary values are filled in on request

    // For the decision.
    double unbalanced = 0;       // greatest since the last check
    double unbalanced_then = 0;  // greatest between the two checks before
    double kinetic_then = 0;     // J/m, at the last check
    double kinetic_before = 0;   // J/m, a step ago; for kinetic damping
    bool kinetic_rising = false;
    double onset_time = -1;         // s; negative: no onset
    double in_thresholds_then = 0;  // farthest motion in thresholds of onset, at the last check
    std::optional<FirstCrack> first_crack = {};
    std::optional<BlockOverlap> overlap = {};  // the greatest share that was measured so far
    std::uint64_t outcome = 0;                 // RelaxationOutcome
    std::vector<char> held_by_corners = {};    // for each block, if that is the outcome; otherwise empty
};

// A state at rest from which other runs begin. They take over its motion, springs, slip, broken contacts and time (no
// scheduled event is left). Their energy balance, step count and displacements start at zero.
struct ConsolidatedState {
    RelaxationState at_rest;
};

}  // namespace delabole
