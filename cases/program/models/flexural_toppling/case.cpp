// Flexural toppling by limit equilibrium, as the reader knows it.
#include "cases/program/case/model_cases.hpp"

namespace delabole {
void check_case(Checker& checker, const FlexuralSlope& slope) {
    if (slope.column.empty()) {
        checker.complain("column", "is required: at least one [[column]]");
    }
}

}  // namespace delabole
