// One case analysed: every model behind the same few functions, so that run, verify and the loops need not know which.
#pragma once

#include "cases/case_file.hpp"
#include "parameters/model_interface.hpp"

#include <string>
#include <variant>
#include <vector>

namespace delabole {

// A number in SI or a word, under the name by which [[expect]], JSON and CSV know it.
struct NamedOutput {
    std::string name;
    std::string meaning;
    Dimension dimension = Dimension::ratio;
    std::variant<double, std::string> value;
};

struct Analysis {
    std::string failure;  // name of the check that failed, empty where there is an answer
    std::vector<NamedOutput> outputs;
    std::vector<std::string> warnings;

    const NamedOutput* find(std::string_view name) const;
};

// Named numbers of the model set to other values than the case's. Unknown names: std::invalid_argument.
CaseModel with_conditions(const CaseModel& model, const std::vector<Condition>& conditions);

Analysis analyse_model(const CaseModel& model);

// The model as the loops see it.
ModelInterface interface_of(const CaseModel& model);

// "plane_does_not_daylight" in a sentence that says what to change.
std::string explain_failure(std::string_view failure);

}  // namespace delabole
