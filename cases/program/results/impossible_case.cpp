#include "cases/program/results/impossible_case.hpp"

#include "cases/program/reader/case_error.hpp"
#include "cases/program/reader/data_table.hpp"
#include "cases/program/results/analysis.hpp"
#include "cases/program/results/model_reports.hpp"
#include "cases/program/results/problems_of_case.hpp"

#include <algorithm>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

namespace delabole {

namespace {

struct StatedImpossibility {
    std::string model;
    std::string check;
    std::string keys;  // separated by blanks
    std::string words;
    static constexpr auto fields() {
        using S = StatedImpossibility;
        return FieldTable{section<&S::model>("word of the model"), section<&S::check>("name of the check that failed"),
                          with_default(section<&S::keys>("keys that may be to blame")),
                          section<&S::words>("what is wrong")};
    }
};

}  // namespace

Impossibility stated_impossibility(std::string_view model, std::string_view failure) {
    static const auto all = parse_table<StatedImpossibility>(impossible_cases, "impossible_cases.csv");
    const auto found = std::ranges::find_if(
        all, [&](const StatedImpossibility& one) { return one.model == model && one.check == failure; });
    if (found == all.end()) {
        return {{}, "a number is outside its allowed range"};
    }
    std::istringstream keys(found->keys);
    return {{std::istream_iterator<std::string>(keys), {}}, found->words};
}

Problem impossible(const CaseFile& file, std::string_view failure) {
    return std::visit(
        [&](const auto& parameters) {
            const Impossibility found = impossibility(parameters, failure);
            const std::vector<std::string>& keys = found.keys;
            const auto blamed =
                std::ranges::find_if(keys, [&](const std::string& key) { return file.places.contains(key); });
            if (blamed == keys.end()) {
                return problem_at(file, keys.empty() ? "" : keys.front(), found.words);
            }
            const std::string limit = found.limit ? found.limit(*blamed) : "";
            return problem_at(file, *blamed, limit.empty() ? found.words : limit);
        },
        file.model);
}

void refuse_impossible(const CaseFile& file) {
    const std::string failure = failure_of(file.model);
    if (!failure.empty()) {
        throw CaseError({impossible(file, failure)});
    }
    if (file.fit) {
        fit_problem_of(file, 1, std::nullopt);
    }
    if (file.sensitivity) {
        sensitivity_problem_of(file, 1, std::nullopt);
    }
}

}  // namespace delabole
