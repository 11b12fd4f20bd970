#include "cases/analysis.hpp"

#include "cases/model_reports.hpp"
#include "kinematics/kinematics.hpp"
#include "plane_failure/plane_failure.hpp"
#include "water/column_tilt.hpp"

#include <algorithm>
#include <stdexcept>

namespace delabole {

const NamedOutput* Analysis::find(std::string_view name) const {
    const auto found =
        std::find_if(outputs.begin(), outputs.end(), [&](const NamedOutput& output) { return output.name == name; });
    return found == outputs.end() ? nullptr : &*found;
}

CaseModel with_conditions(const CaseModel& model, const std::vector<Condition>& conditions) {
    CaseModel changed = model;
    for (const Condition& condition : conditions) {
        bool found = false;
        std::visit(
            [&](auto& parameters) {
                for_each_named_number(parameters, [&](const std::string& path, const FieldInfo&, double& value) {
                    if (path == condition.input) {
                        value = condition.value;
                        found = true;
                    }
                });
            },
            changed);
        if (!found) {
            throw std::invalid_argument("the case has no input '" + condition.input + "'");
        }
    }
    return changed;
}

ModelInterface interface_of(const CaseModel& model) {
    return std::visit([](const auto& parameters) { return model_interface(parameters); }, model);
}

Analysis analyse_model(const CaseModel& model) {
    return std::visit([](const auto& parameters) { return analyse_case(parameters); }, model);
}

}  // namespace delabole
