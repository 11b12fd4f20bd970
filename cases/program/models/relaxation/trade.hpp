// The numerical settings of dynamic relaxation that `delabole trade` varies, and the search for a critical value.
#pragma once

#include "dynamic_relaxation/study/relaxation_study.hpp"
#include "fitting/studies/trade.hpp"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace delabole {

// Step fraction, stiffness ratio, local, viscous and kinetic damping, start, equilibrium ratio and threshold of onset.
// The stiffness ratio is left out if joints of the case have a stiffness of their own.
std::vector<TradeParameter> trade_parameters(const RelaxationStudy& study);

// The study with these values of its settings. A time step given by the case is replaced by the step fraction.
RelaxationStudy with_parameters(const RelaxationStudy& study, const std::vector<TradeParameter>& parameters,
                                std::span<const double> values);

// The search of `critical`, which the study must have, with each setting varied alone, combinations of settings, and
// the three qualities.
TradeProblem trade_problem(const RelaxationStudy& study, std::optional<double> truth, int threads);

// Remarks on parts of the case that the sweep ignores.
std::vector<std::string> trade_remarks(const RelaxationStudy& study);

}  // namespace delabole
