// The knobs of dynamic relaxation and the search for a critical value, as `delabole trade` turns them.
#pragma once

#include "dynamic_relaxation/study/relaxation_study.hpp"
#include "fitting/studies/trade.hpp"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace delabole {

// Step fraction, stiffness ratio, local, viscous and kinetic damping, start, equilibrium ratio and threshold of onset.
// No stiffness ratio where joints of the case give their own stiffness.
std::vector<TradeKnob> trade_knobs(const RelaxationStudy& study);

// The study at these values of its knobs. A case's own time step gives way to the step fraction.
RelaxationStudy with_knobs(const RelaxationStudy& study, const std::vector<TradeKnob>& knobs,
                           std::span<const double> values);

// The search of `critical`, which must be there, over one knob at a time, corners and the three qualities.
TradeProblem trade_problem(const RelaxationStudy& study, std::optional<double> truth, int threads);

// Remarks on parts of the case that the sweep passes over.
std::vector<std::string> trade_remarks(const RelaxationStudy& study);

}  // namespace delabole
