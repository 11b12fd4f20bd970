// The options of a command, apart from how they are spelt, and how a command ends.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace delabole {

class Ranks;

enum class ExitCode {
    ok = 0,
    mismatch = 1,  // verify: a value outside its tolerance
    usage = 2,
    invalid_case = 3,   // also: a physical impossibility in a case that asks for an answer
    not_converged = 4,  // also: interrupted
    output_failure = 5,
    internal_error = 70,  // a fault of the program or the machine, not of the user
};

// The command line asks for something that does not exist or does not go together.
class UsageError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

struct Options {
    std::filesystem::path out;          // empty: results/<name of the case>
    std::vector<std::string> settings;  // key=value
    bool json = false;
    bool quiet = false;
    bool no_report = false;  // neither report nor figures
    bool full = false;       // init: every key
    int threads = 1;
    const Ranks* ranks = nullptr;  // processes that work together; null: this one alone
    double seconds_between_checkpoints = 60;
    std::optional<std::uint64_t> seed;
    int repetitions = 100;                // of a recovery
    bool at_best = false;                 // recover the best fit instead of draws of the prior
    std::vector<std::string> mechanisms;  // the only ones to be fitted; empty: all that are not costly
    bool with_costly = false;             // and those
    std::vector<std::string> vary;        // grid: input=from:to:points
    std::vector<std::string> outputs;     // grid: what is asked at each point
    std::filesystem::path store;          // of evaluations; empty: evaluations.sqlite in the result folder
};

// Whether this process prints and writes: of several ranks only one does.
bool leads(const Options& options);

using Paths = std::vector<std::filesystem::path>;

}  // namespace delabole
