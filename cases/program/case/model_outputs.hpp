// Names and dimensions of the models' outputs, which the reader needs to convert the values of [[expect]] and
// [[fit.observation]].
#pragma once

#include "cases/program/case/model_list.hpp"
#include "parameters/model_interface.hpp"

#include <functional>
#include <vector>

namespace delabole {

// Outputs of a model after reading; programs may pass lists of their own.
using OutputsOf = std::function<std::vector<Quantity>(const CaseModel& model)>;

std::vector<Quantity> known_outputs(const CaseModel& model);

}  // namespace delabole
