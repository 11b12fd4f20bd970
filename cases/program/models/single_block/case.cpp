// A single block on a plane: checks of its case for the reader.
#include "cases/program/case/model_cases.hpp"
#include "cases/program/reader/units.hpp"

namespace delabole {
void check_case(Checker& checker, const SingleBlock& problem) {
    if (!problem.water) {
        return;
    }
    const auto check_depth = [&](const std::string& key, double depth) {
        if (depth > problem.block.height) {
            checker.complain(
                key, "exceeds the height of the block, " + readable_quantity(problem.block.height, Dimension::length));
        }
    };
    check_depth("water.depth_behind", problem.water->depth_behind);
    check_depth("water.depth_in_front", problem.water->depth_in_front.value_or(0));
}

}  // namespace delabole
