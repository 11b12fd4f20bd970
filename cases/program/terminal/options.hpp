// The options of a command, independent of their spelling, and the exit codes of a command.
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
    internal_error = 70,  // a fault of the program or the machine, and not of the user
};

// The command line asks for something that does not exist, or for things that exclude each other.
class UsageError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

struct Options {
    std::filesystem::path out;          // empty: results/<name of the case>
    std::vector<std::string> settings;  // key=value
    bool json = false;
    bool quiet = false;
    bool no_report = false;  // neither a report nor figures
    bool full = false;       // init: writes every key
    int threads = 1;
    const Ranks* ranks = nullptr;  // processes that work together; null: this process alone
    double seconds_between_checkpoints = 60;
    std::optional<std::uint64_t> seed;
    int repetitions = 100;                // of a recovery
    bool at_best = false;                 // recover: uses the best fit instead of draws from the prior
    std::vector<std::string> mechanisms;  // only these are fitted; empty: all that are not costly
    bool with_costly = false;             // the costly ones as well
    std::vector<std::string> vary;        // grid: input=from:to:points
    std::vector<std::string> outputs;     // grid: outputs asked for at each point
    std::filesystem::path runs;           // folder with tables of runs of costly models; empty: none
    std::filesystem::path store;          // of evaluations; empty: evaluations.sqlite in the result folder
};

// Whether this process prints and writes; of several ranks only the leading one does.
bool leads(const Options& options);

using Paths = std::vector<std::filesystem::path>;

}  // namespace delabole
