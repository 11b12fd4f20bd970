#include "cases/program/reader/case_error.hpp"

#include "cases/program/reader/names.hpp"

#include <utility>

namespace delabole {
namespace {

std::string listing(const std::vector<Problem>& problems, std::size_t left_out) {
    std::string text = separated(problems, "\n", to_string);
    if (left_out > 0) {
        text.append("\nand ").append(std::to_string(left_out)).append(" more");
    }
    return text;
}

}  // namespace

std::string to_string(const Problem& problem) {
    std::string text = problem.file;
    if (problem.line > 0) {
        text.append(":").append(std::to_string(problem.line)).append(":").append(std::to_string(problem.column));
    }
    if (!problem.key.empty()) {
        text += ": " + problem.key;
        if (!problem.value.empty()) {
            text += " = " + problem.value;
        }
    }
    return text + ": " + problem.message;
}

CaseError::CaseError(std::vector<Problem> problems, std::size_t left_out)
    : std::runtime_error(listing(problems, left_out)), problems_(std::move(problems)) {}

}  // namespace delabole
