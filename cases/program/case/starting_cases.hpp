// Short cases to start from, which `delabole init` writes: the files of cases/starting/, embedded in the program.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace delabole {

// Names of models and of the other starting cases: a slope cut by joints, a back-analysis, a sensitivity study.
std::vector<std::string> starting_case_names();

// A valid short case. Throws std::invalid_argument for other names.
std::string starting_case(std::string_view name);

// The valid case from which the commented template of a model is made. In the template, everything from [sources] or
// [[expect]] on becomes comments.
std::string template_case(std::string_view model);

// Table of example values for keys that such a case does not have.
extern const std::string_view template_values;

}  // namespace delabole
