#include "cases/program/results/comparison.hpp"

#include "cases/program/reader/case_error.hpp"
#include "cases/program/reader/units.hpp"
#include "cases/program/terminal/interrupt.hpp"
#include "fitting/work/words.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace delabole {

namespace {

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

// A value written in a case, converted with the dimension of the computed result.
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
    const double tolerance = expected.tolerance ? written_number(file, expected, *expected.tolerance, dimension)
                                                : expected.relative_tolerance.value_or(0.0) * std::abs(target);
    return compare_numbers(target, computed, tolerance, dimension);
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
        row.expected = word;
        row.computed = analysis.failure;
        row.verdict = foreseen && word == analysis.failure ? Verdict::met : Verdict::missed;
    } else if (output == nullptr) {
        row.computed = "not a result of this model";
        row.verdict = Verdict::missed;
    } else if (const auto* number = std::get_if<double>(&output->value)) {
        row = compare_number(file, expected, *output, *number);
    } else {
        row.expected = written_word(expected);
        row.computed = std::get<std::string>(output->value);
        row.verdict = row.expected == row.computed ? Verdict::met : Verdict::missed;
    }
    row.what = expected.label.empty() ? expected.quantity + conditions_in_words(expected.conditions, file.model)
                                      : expected.label;
    row.source = expected.source;
    row.note = expected.note;
    excuse(row, expected.unreachable);
    return row;
}

}  // namespace

Comparison compare_numbers(double expected, double computed, double tolerance, Dimension dimension) {
    Comparison row;
    row.expected = readable_quantity(expected, dimension);
    row.computed = readable_quantity(computed, dimension);
    row.difference = value_in_words(computed - expected, dimension);
    row.tolerance = value_in_words(tolerance, dimension);
    row.verdict = std::abs(computed - expected) <= tolerance ? Verdict::met : Verdict::missed;
    return row;
}

void excuse(Comparison& comparison, const std::optional<std::string>& unreachable) {
    if (comparison.verdict == Verdict::missed && unreachable) {
        comparison.verdict = Verdict::unreachable;
        comparison.source += (comparison.source.empty() ? "(" : " (") + *unreachable + ")";
    }
}

std::vector<Comparison> compare_expectations(const CaseFile& file) {
    const auto in_order = [](const std::vector<Condition>& first, const std::vector<Condition>& second) {
        const auto key = [](const Condition& condition) { return std::tie(condition.input, condition.value); };
        return std::ranges::lexicographical_compare(first, second, {}, key, key);
    };
    std::map<std::vector<Condition>, Analysis, decltype(in_order)> analyses(in_order);
    std::vector<Comparison> rows;
    for (const Expectation& expected : file.expectations) {
        const auto [found, is_new] = analyses.try_emplace(expected.conditions);
        if (is_new) {
            found->second = analysis_of(file, expected.conditions);
        }
        stop_if_interrupted();
        rows.push_back(compare(file, expected, found->second));
    }
    return rows;
}

}  // namespace delabole
