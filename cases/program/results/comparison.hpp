// Comparison of printed with computed values: [[expect]] and the statements of [[sweep]], for `verify`, reports and the
// reproductions of the thesis.
#pragma once

#include "cases/program/case/case_file.hpp"
#include "cases/program/results/analysis.hpp"
#include "plots/report/report.hpp"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace delabole {

enum class Verdict { met, missed, unreachable };

constexpr std::array<std::string_view, 3> enum_names(Verdict) {
    return {"ok", "missed", "unreachable"};
}

struct Comparison {
    std::string what;  // in words, or the quantity with its conditions
    std::string expected;
    std::string computed;
    std::string difference;
    std::string tolerance;
    Verdict verdict = Verdict::met;
    std::string source;  // with the reason if the value is unreachable
    std::string note;
};

// Difference and verdict for a computed and an expected number, SI.
Comparison compare_numbers(double expected, double computed, double tolerance, Dimension dimension);

// A mismatch with a given reason becomes unreachable, and the reason is added to the source.
void excuse(Comparison& comparison, const std::optional<std::string>& unreachable);

// Compares each [[expect]] of a case. Throws Interrupted once the flag of cases/program/terminal/interrupt.hpp is set,
// and CaseError if a value's dimension differs from that of its quantity.
std::vector<Comparison> compare_expectations(const CaseFile& file);

}  // namespace delabole
