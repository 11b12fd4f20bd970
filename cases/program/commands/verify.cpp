// delabole verify
#include "cases/program/commands/commands.hpp"
#include "cases/program/reader/case_error.hpp"
#include "cases/program/results/comparison.hpp"
#include "cases/program/results/result_folder.hpp"
#include "cases/program/sweeps/sweep_run.hpp"
#include "cases/program/terminal/interrupt.hpp"

#include <algorithm>
#include <array>
#include <iostream>
#include <iterator>
#include <vector>

namespace delabole {

namespace {

Paths case_files(const Paths& given) {
    Paths files;
    for (const std::filesystem::path& path : given.empty() ? Paths{"cases"} : given) {
        std::error_code ignored;  // read_case reports why a path cannot be examined
        if (!std::filesystem::is_directory(path, ignored)) {
            files.push_back(path);
            continue;
        }
        Paths found;
        try {
            for (const auto& entry : std::filesystem::recursive_directory_iterator(path)) {
                if (entry.is_regular_file() && entry.path().extension() == ".toml") {
                    found.push_back(entry.path());
                }
            }
        } catch (const std::filesystem::filesystem_error& error) {
            throw CaseError({{path.string(), 0, 0, {}, {}, "cannot be read: " + error.code().message()}});
        }
        std::sort(found.begin(), found.end());
        files.insert(files.end(), found.begin(), found.end());
    }
    return files;
}

}  // namespace

ExitCode verify_command(const Paths& cases, const Options& options) {
    std::vector<std::vector<std::string>> rows = {
        {"quantity", "expected", "computed", "difference", "tolerance", "verdict"}};
    Json json = Json::array();
    std::array<int, 3> counts{};
    for (const std::filesystem::path& path : case_files(cases)) {
        const CaseFile file = read_case(path, settings_of(options));
        std::vector<Comparison> found;
        try {
            found = compare_expectations(file);
            std::ranges::move(compare_sweeps(file, {}), std::back_inserter(found));
        } catch (const Interrupted&) {
            std::cerr << "delabole: interrupted in " << path.string() << '\n';
            return ExitCode::not_converged;
        }
        if (!found.empty()) {
            rows.push_back({path.string()});
        }
        for (const Comparison& row : found) {
            const std::string verdict(word_of(row.verdict));
            ++counts[static_cast<std::size_t>(row.verdict)];
            rows.push_back({"  " + row.what, row.expected, row.computed, row.difference, row.tolerance, verdict});
            json.push_back({{"case", path.string()},
                            {"quantity", row.what},
                            {"expected", row.expected},
                            {"computed", row.computed},
                            {"difference", row.difference},
                            {"tolerance", row.tolerance},
                            {"verdict", verdict},
                            {"source", row.source}});
        }
    }
    // A wrong folder must not be reported as a success.
    if (json.empty()) {
        const std::string where = cases.size() == 1 ? cases.front().string() : cases.empty() ? "cases" : "all of these";
        throw CaseError({{where, 0, 0, {}, {}, "has no [[expect]] and no printed value: there is nothing to compare"}});
    }
    if (options.json) {
        std::cout << json_text(json);
    } else if (!options.quiet) {
        std::cout << text_table(rows) << counts[0] << " met, " << counts[1] << " missed, " << counts[2]
                  << " known to be unreachable\n";
    }
    return counts[1] == 0 ? ExitCode::ok : ExitCode::mismatch;
}

}  // namespace delabole
