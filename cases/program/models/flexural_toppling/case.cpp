// Flexural toppling by limit equilibrium: checks of its case for the reader.
#include "cases/program/case/model_cases.hpp"

namespace delabole {
void check_case(Checker& checker, const FlexuralSlope& slope) {
    if (slope.column.empty()) {
        checker.complain("column", "is required: at least one [[column]]");
    }
}

}  // namespace delabole
