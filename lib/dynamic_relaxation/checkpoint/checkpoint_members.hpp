// The members of all that a checkpoint holds or depends on: one list for each struct, for writing and for reading.
// A new member also requires a higher checkpoint_version (checkpoint_bytes.cpp).
#pragma once

#include "dynamic_relaxation/study/relaxation_study.hpp"
#include "numerics/archive.hpp"

namespace delabole {

DELABOLE_MEMBERS(Motion, x, y, sine, versine, vx, vy, spin, angle)
DELABOLE_MEMBERS(EdgeEnds, start_weight, end_weight, inverse_blend, rival, rival_sine, rival_cosine, alone, unused)
DELABOLE_MEMBERS(JointLaw, normal_stiffness, shear_stiffness, normal_dashpot, shear_dashpot, friction,
                 residual_friction, cohesion, residual_cohesion)
DELABOLE_MEMBERS(ContactBlocks, block, other, twin, ends, joint)
DELABOLE_MEMBERS(ContactCorner, corner, edge)
DELABOLE_MEMBERS(ContactShapeOf<double>, arm_x, arm_y, other_arm_x, other_arm_y, along_x, along_y, gap, from_start,
                 to_end)
DELABOLE_MEMBERS(ContactNumbersOf<double>, shear, place, damping, normal_drag, shear_drag, slip, friction)
DELABOLE_MEMBERS(ContactFlagsOf<bool>, touching, sliding, broken, beneath, yields, insists, tried)
// The base classes of a composed struct.
template <class Object, class... Bases>
auto bases_of(Object& object) {
    return std::tie(static_cast<std::conditional_t<std::is_const_v<Object>, const Bases, Bases>&>(object)...);
}
template <IsMaybeConst<RelaxationContact> Object>
auto members_of(Object& object) {
    return bases_of<Object, ContactBlocks, ContactCorner, ContactShapeOf<double>>(object);
}
template <IsMaybeConst<ContactMemory> Object>
auto members_of(Object& object) {
    return bases_of<Object, ContactNumbersOf<double>, ContactFlagsOf<bool>>(object);
}
static_assert(sizeof(RelaxationContact) == 9 * sizeof(double) + 8 * sizeof(std::uint32_t) &&
                  sizeof(ContactMemory) == 8 * sizeof(double),
              "a member has come: it is to be saved, too");

DELABOLE_MEMBERS(ForceOnCorner, x, y, moment, other_moment)
DELABOLE_MEMBERS(ContactList, contact, ends, joint, memory, force, open_until)
DELABOLE_MEMBERS(PairPose, x, y, first_angle, second_angle)
DELABOLE_MEMBERS(WatchedPair, first, second, begin, pose, distance, holds)
DELABOLE_MEMBERS(BlockOverlap, block, other, depth, share, area)
DELABOLE_MEMBERS(WatchState, pair, travelled, due, neighbours_until, step_until, stable_step, step, searches,
                 pair_checks)
DELABOLE_MEMBERS(NoticedMotion, moved, x, y, angle)
DELABOLE_MEMBERS(OutlineShift, x, y, angle)
DELABOLE_MEMBERS(BondMemory, state, time, damping, normal_drag, shear_drag, bending_drag, shift)
DELABOLE_MEMBERS(BoltMemory, extension_at_start, yielded)
DELABOLE_MEMBERS(EnergyBalance, applied, prescribed, kinetic, elastic, friction, bonds, dashpots, local_damping,
                 kinetic_damping, elastic_at_start)
DELABOLE_MEMBERS(FirstCrack, time, tilt, block, other)
DELABOLE_MEMBERS(StartBalance, unbalanced_ratio, cut_short)
DELABOLE_MEMBERS(SlipOverFace, upward, slip)
DELABOLE_MEMBERS(RelaxationState, time, step, last_step, steps, contacts_evaluated, motion, origin, start_balance,
                 noticed, checks_at_rest, removed, base_slip, dropped_slip, contacts, watch, bond, bolt, energy_balance,
                 unbalanced, unbalanced_then, kinetic_then, kinetic_before, kinetic_rising, onset_time,
                 in_thresholds_then, first_crack, overlap, outcome, held_by_corners)

DELABOLE_MEMBERS(JointMaterial, normal_stiffness, shear_stiffness, friction_angle, residual_friction_angle, cohesion,
                 tensile_strength, bond, residual_cohesion)
DELABOLE_MEMBERS(BondMaterial, young_modulus, shear_modulus, tensile_strength, cohesion, friction_angle, spacing)
DELABOLE_MEMBERS(FaceBond, block, edge, other, other_edge, of_rock)
DELABOLE_MEMBERS(RelaxationBlock, outline, density, fixed, held_at_first, joint)
DELABOLE_MEMBERS(Gravity, acceleration, tilt, final_tilt, rate, interval, start)
DELABOLE_MEMBERS(PointForce, block, at, force)
DELABOLE_MEMBERS(BoltSegment, bolt, block, other, at, other_at, stiffness, pretension, capacity)
DELABOLE_MEMBERS(EdgePart, begin, end)
DELABOLE_MEMBERS(FacePressure, block, edge, at_first, at_second, part, drains)
DELABOLE_MEMBERS(TimedVector, time, value)
DELABOLE_MEMBERS(PrescribedMotion, block, velocity, angular_velocity, pivot, start, duration)
DELABOLE_MEMBERS(Removal, block, time)
DELABOLE_MEMBERS(Belt, speed, friction_angle)
DELABOLE_MEMBERS(RelaxationScene, block, material, gravity, force, pressure, shaking, motion, removal, bond, belt, bolt)
DELABOLE_MEMBERS(RelaxationSettings, step_fraction, time_step, viscous_damping, local_damping, kinetic_damping, creep,
                 mass_scaling, start, ramp_time, consolidation_time, equilibrium_ratio, onset_rotation, onset_slide,
                 collapse_rotation, collapse_displacement, stop_at_onset, stop_at_equilibrium, stop_at_collapse,
                 taken_away_below, duration, most_steps, crack_opening, overlap_limit, corners_bear, threads)

DELABOLE_MEMBERS(BlockMonitor, block)
DELABOLE_MEMBERS(ContactMonitor, block, other)
DELABOLE_MEMBERS(HistoryRequest, interval, block, contact)
DELABOLE_MEMBERS(CriticalPlan, parameter, lower, upper, tolerance, path, material)
DELABOLE_MEMBERS(MonitoredBlock, x, y, rotation, velocity_x, velocity_y, angular_velocity)
DELABOLE_MEMBERS(MonitoredContact, horizontal, vertical, normal, overlap)
DELABOLE_MEMBERS(HistoryLine, time, tilt, energy, block, contact, base_slip, rotation, bolt)
DELABOLE_MEMBERS(BlockOutcome, movement, rotation, displacement, base_slip)
DELABOLE_MEMBERS(CornerForce, block, other, at, force, normal, shear, overlap, sliding)
DELABOLE_MEMBERS(BoltPull, at, other_at, force, yielded, holds)
DELABOLE_MEMBERS(MotionFrame, time, tilt, motion, outcome, bolt, force)
DELABOLE_MEMBERS(MotionRecord, frame, interval, next)
DELABOLE_MEMBERS(CriticalProbe, outcome, steps, contacts_evaluated, rested_in_motion, crept, without_run)
DELABOLE_MEMBERS(SearchProgress, probe, probe_state, consolidated, failed)
DELABOLE_MEMBERS(FailureStage, block, moved, start, onset, time, steps, contacts_evaluated)
DELABOLE_MEMBERS(StudyProgress, state, next_line, history, record, slope, stage, search)

}  // namespace delabole
