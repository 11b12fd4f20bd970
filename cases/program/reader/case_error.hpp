// All problems of a case, thrown together.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace delabole {

struct Problem {
    std::string file;     // as named by the caller; "--set" for a value given on the command line
    int line = 0;         // from 1; 0 if the problem has no place in a file
    int column = 0;       // from 1, in characters
    std::string key;      // "slope.height", "bolt[2].force"; empty if the problem concerns no key
    std::string value;    // as written, quoted if text; empty if the problem concerns no value
    std::string message;  // what is wrong and what would be right
};

// slope.toml:7:12: slope.height = "-3 m": must be more than 0 m
std::string to_string(const Problem& problem);

// The only exception for bad input. what() has one line per problem, in the order of the file.
class CaseError : public std::runtime_error {
  public:
    // `left_out` is the number of further problems that are not listed.
    explicit CaseError(std::vector<Problem> problems, std::size_t left_out = 0);

    const std::vector<Problem>& problems() const noexcept { return problems_; }

  private:
    std::vector<Problem> problems_;
};

}  // namespace delabole
