// Short cases to start from: what `delabole init` writes, the files of cases/starting/, when the program was built.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace delabole {

// Names of models, and of what else there is a case for: a slope cut by joints, a back-analysis, a sensitivity study.
std::vector<std::string> starting_case_names();

// A valid case of a page. Throws std::invalid_argument for other names.
std::string starting_case(std::string_view name);

// The commented template of a model is made of this valid case. From [sources] or [[expect]] on, its text stands in the
// template as comments.
std::string template_case(std::string_view model);

// Table of values for keys that such a case does not have.
extern const std::string_view template_values;

}  // namespace delabole
