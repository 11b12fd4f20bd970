// Names and dimensions of what the models answer, as far as the reader has to know them: to convert the values of
// [[expect]] and [[fit.observation]].
#pragma once

#include "parameters/model_interface.hpp"

#include <functional>
#include <string_view>
#include <vector>

namespace delabole {

// Outputs of the model of a name; the programs may pass their models' own lists.
using OutputsOf = std::function<std::vector<Quantity>(std::string_view model)>;

std::vector<Quantity> known_outputs(std::string_view model);

}  // namespace delabole
