#include "cases/program/case/model_cases.hpp"
#include "cases/program/case/case_parts.hpp"
#include "cases/program/reader/names.hpp"
#include "cases/program/reader/units.hpp"
#include "limit_equilibrium/block_row/block_row.hpp"
#include "limit_equilibrium/stepped_path/stepped_path.hpp"
#include "strength/shear_strength.hpp"
#include "water/column_tilt.hpp"
#include "wedge_failure/wedge_failure.hpp"

#include <algorithm>

namespace delabole {

// The complaint is placed at the mechanism's own key if it has one, otherwise at that of the case.
void Checker::complain(const std::string& key, std::string message) {
    reading_->complain_at(reading_->knows(prefix_ + key) ? prefix_ + key : key, std::move(message));
}

void check_whole(Checker& checker, const std::string& key, const std::optional<double>& number) {
    if (number && !is_whole(*number)) {
        checker.complain(key, "must be a whole number");
    }
}

void check_bounds(Checker& checker, const std::string& search, const std::string& input,
                  const std::optional<double>& lower, const std::optional<double>& upper) {
    if (lower && upper && !(*lower < *upper)) {
        checker.complain(search + ".lower_" + input,
                         "bounds are reversed: must be less than " + search + ".upper_" + input);
    }
}

void check_strength(Checker& checker, const std::string& section, const StrengthLaw<>& strength) {
    if (!friction_below_90_degrees(strength)) {
        checker.complain(section + ".roughness_angle", "friction_angle + roughness_angle must not exceed 89.9 deg");
    }
}

void check_support(Checker& checker, const std::string& key, const BoltPattern<>& pattern, double slope_height) {
    check_whole(checker, key + ".rows", pattern.rows);
    if (pattern.head_height(static_cast<int>(pattern.rows) - 1) > slope_height) {
        checker.complain(key + ".rows",
                         "put the highest heads above the crest: rows, lowest_height and row_spacing have to end at "
                         "slope.height = " +
                             readable_quantity(slope_height, Dimension::length));
    }
}

void check_required(Checker& checker, const std::vector<RequiredValue<>>& requests, const CaseModel& model) {
    const std::vector<Quantity> inputs = named_inputs(model);
    const auto named = [&](const std::string& key, const std::string& name) {
        const Quantity* input = find_quantity(inputs, name);
        if (input == nullptr) {
            checker.complain(key, "is not an input of this case" + suggestion(name, names_in(inputs)));
        }
        return input;
    };
    for (std::size_t index = 0; index < requests.size(); ++index) {
        const std::string section = indexed("required", index);
        const RequiredValue<>& request = requests[index];
        const Quantity* first = named(section + ".parameter", request.parameter);
        std::vector<std::string> before{request.parameter};
        for (const std::string& other : request.also) {
            const Quantity* input = named(section + ".also", other);
            if (std::ranges::find(before, other) != before.end()) {
                checker.complain(section + ".also",
                                 "\"" + other + "\" is named twice: inputs that take one value are named once each");
            } else if (first != nullptr && input != nullptr && first->dimension != input->dimension) {
                checker.complain(section + ".also",
                                 "\"" + other + "\" has another dimension than " + request.parameter);
            }
            before.push_back(other);
        }
    }
}

void complete_model(Reading& reading, CaseModel& model, const std::filesystem::path& case_path,
                    const std::string& prefix) {
    if (!reading.clean()) {
        return;
    }
    std::visit([&](auto& alternative) { take_files(reading, alternative, case_path.parent_path(), prefix); }, model);
    if (reading.clean()) {
        Checker checker(reading, prefix);
        std::visit([&](const auto& alternative) { check_case(checker, alternative); }, model);
    }
}

std::vector<Quantity> known_outputs(const CaseModel& model) {
    return std::visit([](const auto& alternative) { return possible_outputs(alternative); }, model);
}

}  // namespace delabole
