// Printed values beside computed ones: [[expect]] and the statements of [[sweep]], for `verify`, reports and the
// reproductions of the thesis alike.
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
    return {"ok", "MISMATCH", "unreachable"};
}

struct Comparison {
    std::string what;  // in words, or a quantity with its conditions
    std::string expected;
    std::string computed;
    std::string difference;
    std::string tolerance;
    Verdict verdict = Verdict::met;
    std::string source;  // with the reason where it is unreachable
    std::string note;
};

// Difference and verdict of a number beside an expected one, SI.
Comparison compare_numbers(double expected, double computed, double tolerance, Dimension dimension);

// A mismatch for which there is a reason is unreachable, and the reason follows the source.
void excuse(Comparison& comparison, const std::optional<std::string>& unreachable);

// Each [[expect]] of a case. Interrupted once the flag of cases/program/terminal/interrupt.hpp is set; CaseError where
// a value has another dimension than what it is compared with.
std::vector<Comparison> compare_expectations(const CaseFile& file);

}  // namespace delabole
