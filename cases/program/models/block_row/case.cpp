// Rows of blocks on a plane: checks of their case for the reader.
#include "cases/program/case/model_cases.hpp"
#include "limit_equilibrium/block_row/block_row.hpp"

namespace delabole {
void check_case(Checker& checker, const BlockRow& row) {
    if (row.block.empty()) {
        checker.complain("block", "is required: at least one [[block]]");
    }
}

}  // namespace delabole
