// Names and dimensions of what the models answer, as far as the reader has to know them: to convert the values of
// [[expect]] and [[fit.observation]].
#pragma once

#include "cases/program/case/model_list.hpp"
#include "parameters/model_interface.hpp"

#include <functional>
#include <vector>

namespace delabole {

// Outputs of a model as it was read; the programs may pass their models' own lists.
using OutputsOf = std::function<std::vector<Quantity>(const CaseModel& model)>;

std::vector<Quantity> known_outputs(const CaseModel& model);

}  // namespace delabole
