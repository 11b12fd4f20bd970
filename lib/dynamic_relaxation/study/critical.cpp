#include "dynamic_relaxation/study/critical.hpp"

#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

namespace delabole {

namespace {

// Why a run shows neither that the blocks stand nor that they fail; empty if it shows either.
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

// Values tried are shares of the ratio found, or of the way to the angle from where the blocks should stand.
constexpr std::array less_demanding_shares = {0.98, 0.96, 0.93, 0.9, 0.8, 0.7, 0.5};

class Bisection {
  public:
    Bisection(const std::function<CriticalProbe(double)>& probe, double should_stand, double should_fail,
              double tolerance, BracketMean mean)
        : probe_(probe), tolerance_(tolerance), mean_(mean), stands_low_(should_stand < should_fail) {
        critical_.stands = should_stand;
        critical_.fails = should_fail;
    }

    CriticalValue find() {
        const std::optional<bool> first = stands_at(critical_.stands);
        if (!first) {
            return critical_;
        }
        if (!*first) {
            critical_.status = CriticalStatus::fails_everywhere;
            critical_.fails = critical_.last;
            return critical_;
        }
        const std::optional<bool> second = stands_at(critical_.fails);
        if (!second) {
            return critical_;
        }
        if (*second) {
            critical_.status = CriticalStatus::stands_everywhere;
            critical_.stands = critical_.last;
            return critical_;
        }
        // Blocks that fall before they rest pass the threshold of onset at one angle, and just not at the next.
        const auto may_fail_before = [&] { return crept_ || rested_in_motion_ == (mean_ == BracketMean::geometric); };
        while (bisect() && may_fail_before() && fails_where_less_is_demanded()) {
        }
        return critical_;
    }

  private:
    // Returns nothing, and sets the status, if the run had no answer.
    std::optional<bool> stands_at(double value) {
        const CriticalProbe run = probe_(value);
        critical_.last = value;
        ++critical_.runs;
        critical_.steps += run.steps;
        critical_.contacts_evaluated += run.contacts_evaluated;
        if (const auto status = no_answer(run.outcome)) {
            critical_.status = *status;
            return std::nullopt;
        }
        const bool stands = run.outcome == RelaxationOutcome::equilibrium;
        (stands ? critical_.seen_to_stand : critical_.seen_to_fail) = true;
        if (stands) {
            stood_.push_back(value);
            rested_in_motion_ = run.rested_in_motion;
            crept_ = run.crept;
        } else {
            critical_.held_by_corners = run.outcome == RelaxationOutcome::held_by_corners;
        }
        return stands;
    }

    // Returns false, and sets the status, if a run had no answer.
    bool bisect() {
        while (std::abs(critical_.stands - critical_.fails) > tolerance_) {
            const double middle =
                mean_ == BracketMean::geometric ? std::sqrt(critical_.stands * critical_.fails) : critical_.value();
            if (middle == critical_.stands || middle == critical_.fails) {
                break;
            }
            const std::optional<bool> stands = stands_at(middle);
            if (!stands) {
                return false;
            }
            (*stands ? critical_.stands : critical_.fails) = middle;
        }
        return true;
    }

    bool demands_less(double one, double other) const { return stands_low_ ? one < other : one > other; }

    // Whether the blocks fail at a value less demanding than the one at which bisection found them to stand; the
    // bracket then lies between that value and the nearest less demanding one at which they stood. A run without an
    // answer is ignored here.
    bool fails_where_less_is_demanded() {
        const double should_stand = stood_.front();
        const double found = critical_.stands;
        const std::span<const double> shares(less_demanding_shares);
        for (const double share : mean_ == BracketMean::geometric ? shares.first(4)
                                  : crept_                        ? shares
                                                                  : shares.last(4)) {
            const double value = mean_ == BracketMean::arithmetic ? should_stand + share * (found - should_stand)
                                 : stands_low_                    ? found * share
                                                                  : found / share;
            if (!demands_less(should_stand, value)) {
                break;
            }
            const std::optional<bool> stands = stands_at(value);
            if (critical_.status == CriticalStatus::interrupted) {
                break;
            }
            critical_.status = CriticalStatus::found;
            if (stands && !*stands) {
                critical_.stands_again = critical_.stands_again.value_or(found);
                critical_.fails = value;
                critical_.stands = should_stand;
                for (const double stood : stood_) {
                    if (demands_less(critical_.stands, stood) && demands_less(stood, value)) {
                        critical_.stands = stood;
                    }
                }
                return true;
            }
        }
        return false;
    }

    const std::function<CriticalProbe(double)>& probe_;
    double tolerance_;
    BracketMean mean_;
    bool stands_low_;
    std::vector<double> stood_;
    bool rested_in_motion_ = false;  // in the last run that stood
    bool crept_ = false;             // likewise
    CriticalValue critical_;
};

}  // namespace

CriticalValue find_critical(const std::function<CriticalProbe(double)>& probe, double should_stand, double should_fail,
                            double tolerance, BracketMean mean) {
    return Bisection(probe, should_stand, should_fail, tolerance, mean).find();
}

}  // namespace delabole
