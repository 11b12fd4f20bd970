#include "cases/impossible_case.hpp"

#include "cases/model_reports.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace delabole {

Problem impossible(const CaseFile& file, std::string_view failure) {
    return std::visit(
        [&](const auto& parameters) {
            const std::vector<std::string> keys = blamed_keys(parameters, failure);
            const auto blamed =
                std::ranges::find_if(keys, [&](const std::string& key) { return file.places.contains(key); });
            return blamed == keys.end()
                       ? problem_at(file, keys.empty() ? "" : keys.front(), explain_failure(parameters, failure, ""))
                       : problem_at(file, *blamed, explain_failure(parameters, failure, *blamed));
        },
        file.model);
}

}  // namespace delabole
