#include "dynamic_relaxation/study/critical.hpp"

#include <cmath>
#include <optional>

namespace delabole {

namespace {

// Why a run says neither that the blocks stand nor that they fail; nothing where it does.
std::optional<CriticalStatus> no_answer(RelaxationOutcome outcome) {
    switch (outcome) {
    case RelaxationOutcome::equilibrium:
    case RelaxationOutcome::held_by_corners:
    case RelaxationOutcome::onset:
    case RelaxationOutcome::collapse:
        return std::nullopt;
    case RelaxationOutcome::undecided:
        return CriticalStatus::undecided;
    case RelaxationOutcome::overlap_too_large:
    case RelaxationOutcome::energy_not_balanced:
    case RelaxationOutcome::motion_not_finite:
        return CriticalStatus::run_failed;
    case RelaxationOutcome::interrupted:
        return CriticalStatus::interrupted;
    case RelaxationOutcome::scene_not_valid:
        break;
    }
    return CriticalStatus::not_valid;
}

}  // namespace

CriticalValue find_critical(const std::function<CriticalProbe(double)>& probe, double should_stand, double should_fail,
                            double tolerance, BracketMean mean) {
    CriticalValue critical;
    critical.stands = should_stand;
    critical.fails = should_fail;
    // Returns nothing, with the status set, where the run had no answer.
    const auto stands_at = [&](double value) -> std::optional<bool> {
        const CriticalProbe run = probe(value);
        critical.last = value;
        ++critical.runs;
        critical.steps += run.steps;
        critical.contacts_evaluated += run.contacts_evaluated;
        if (const auto status = no_answer(run.outcome)) {
            critical.status = *status;
            return std::nullopt;
        }
        const bool stands = run.outcome == RelaxationOutcome::equilibrium;
        critical.held_by_corners =
            stands ? critical.held_by_corners : run.outcome == RelaxationOutcome::held_by_corners;
        return stands;
    };
    const std::optional<bool> first = stands_at(should_stand);
    if (!first) {
        return critical;
    }
    if (!*first) {
        critical.status = CriticalStatus::fails_everywhere;
        return critical;
    }
    const std::optional<bool> second = stands_at(should_fail);
    if (!second) {
        return critical;
    }
    if (*second) {
        critical.status = CriticalStatus::stands_everywhere;
        return critical;
    }
    while (std::abs(critical.stands - critical.fails) > tolerance) {
        const double middle =
            mean == BracketMean::geometric ? std::sqrt(critical.stands * critical.fails) : critical.value();
        if (middle == critical.stands || middle == critical.fails) {
            break;
        }
        const std::optional<bool> stands = stands_at(middle);
        if (!stands) {
            break;
        }
        (*stands ? critical.stands : critical.fails) = middle;
    }
    return critical;
}

}  // namespace delabole
