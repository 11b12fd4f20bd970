// delabole verify
#include "cases/program/commands/commands.hpp"
#include "cases/program/reader/case_error.hpp"
#include "cases/program/reader/units.hpp"
#include "cases/program/results/analysis.hpp"
#include "cases/program/results/result_folder.hpp"
#include "cases/program/terminal/interrupt.hpp"
#include "fitting/work/words.hpp"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>
#include <tuple>
#include <vector>

namespace delabole {

namespace {

enum class Verdict { met, missed, unreachable };

constexpr std::array<std::string_view, 3> enum_names(Verdict) {
    return {"ok", "MISMATCH", "unreachable"};
}

struct Comparison {
    std::string quantity;  // with its conditions
    std::string expected;
    std::string computed;
    std::string difference;
    std::string tolerance;
    Verdict verdict;
    std::string source;
};

std::string conditions_in_words(const std::vector<Condition>& conditions, const CaseModel& model) {
    std::string text;
    std::visit(
        [&](const auto& parameters) {
            for_each_named_number(parameters, [&](const std::string& path, const FieldInfo& info, double) {
                for (const Condition& condition : conditions) {
                    if (condition.input == path) {
                        text += (text.empty() ? " at " : ", ") + path + " = " +
                                readable_quantity(condition.value, info.dimension);
                    }
                }
            });
        },
        model);
    return text;
}

// A value written in a case, whose dimension only the computed result tells.
double written_number(const CaseFile& file, const Expectation& expected, const WrittenValue& written,
                      Dimension dimension) {
    const ParsedQuantity parsed = parse_value(written, dimension);
    if (parsed.status != QuantityStatus::ok) {
        throw CaseError(
            {{file.name, expected.place.line, expected.place.column, expected.quantity, {}, parsed.message}});
    }
    return parsed.value;
}

std::string written_word(const Expectation& expected) {
    const auto* word = std::get_if<std::string>(&expected.value);
    return word == nullptr ? shortest_number(std::get<double>(expected.value)) : *word;
}

Comparison compare_number(const CaseFile& file, const Expectation& expected, const NamedOutput& output,
                          double computed) {
    const Dimension dimension = output.dimension;
    const double target = written_number(file, expected, expected.value, dimension);
    const double difference = computed - target;
    const double tolerance = expected.tolerance ? written_number(file, expected, *expected.tolerance, dimension)
                                                : expected.relative_tolerance.value_or(0.0) * std::abs(target);
    Comparison row;
    row.expected = readable_quantity(target, dimension);
    row.computed = readable_quantity(computed, dimension);
    row.difference = value_in_words(difference, dimension);
    row.tolerance = value_in_words(tolerance, dimension);
    row.verdict = std::abs(difference) <= tolerance ? Verdict::met : Verdict::missed;
    return row;
}

Analysis analysis_of(const CaseFile& file, const std::vector<Condition>& conditions) {
    AnalysisWork work;
    work.watch = [](double, const std::string&, bool) { return !interrupt_flag(); };
    return analyse_model(with_conditions(file.model, conditions), work);
}

Comparison compare(const CaseFile& file, const Expectation& expected, const Analysis& analysis) {
    const NamedOutput* output = analysis.find(expected.quantity);
    Comparison row;
    if (!analysis.failure.empty()) {
        const bool foreseen = expected.quantity == "check";
        const std::string word = foreseen ? written_word(expected) : "";
        row = {{}, word, analysis.failure,
               {}, {},   foreseen && word == analysis.failure ? Verdict::met : Verdict::missed,
               {}};
    } else if (output == nullptr) {
        row = {{}, {}, "not a result of this model", {}, {}, Verdict::missed, {}};
    } else if (const auto* number = std::get_if<double>(&output->value)) {
        row = compare_number(file, expected, *output, *number);
    } else {
        const std::string word = written_word(expected);
        const std::string& computed = std::get<std::string>(output->value);
        row = {{}, word, computed, {}, {}, word == computed ? Verdict::met : Verdict::missed, {}};
    }
    row.quantity = expected.quantity + conditions_in_words(expected.conditions, file.model);
    row.source = expected.source;
    if (row.verdict == Verdict::missed && expected.unreachable) {
        row.verdict = Verdict::unreachable;
        row.source += " (" + *expected.unreachable + ")";
    }
    return row;
}

Paths case_files(const Paths& given) {
    Paths files;
    for (const std::filesystem::path& path : given.empty() ? Paths{"cases"} : given) {
        std::error_code ignored;  // what cannot be looked at is left to the reader, who says why
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
        if (file.expectations.empty()) {
            continue;
        }
        rows.push_back({path.string()});
        const auto in_order = [](const std::vector<Condition>& first, const std::vector<Condition>& second) {
            const auto key = [](const Condition& condition) { return std::tie(condition.input, condition.value); };
            return std::ranges::lexicographical_compare(first, second, {}, key, key);
        };
        std::map<std::vector<Condition>, Analysis, decltype(in_order)> analyses(in_order);
        for (const Expectation& expected : file.expectations) {
            const auto [found, is_new] = analyses.try_emplace(expected.conditions);
            if (is_new) {
                found->second = analysis_of(file, expected.conditions);
            }
            const Comparison row = compare(file, expected, found->second);
            if (interrupt_flag()) {
                std::cerr << "delabole: interrupted in " << path.string() << '\n';
                return ExitCode::not_converged;
            }
            const std::string verdict(word_of(row.verdict));
            ++counts[static_cast<std::size_t>(row.verdict)];
            rows.push_back({"  " + row.quantity, row.expected, row.computed, row.difference, row.tolerance, verdict});
            json.push_back({{"case", path.string()},
                            {"quantity", row.quantity},
                            {"expected", row.expected},
                            {"computed", row.computed},
                            {"difference", row.difference},
                            {"tolerance", row.tolerance},
                            {"verdict", verdict},
                            {"source", row.source}});
        }
    }
    // A wrong folder must not look like a success.
    if (json.empty()) {
        const std::string where = cases.size() == 1 ? cases.front().string() : cases.empty() ? "cases" : "all of these";
        throw CaseError({{where, 0, 0, {}, {}, "has no [[expect]] entry: there is nothing to compare"}});
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
