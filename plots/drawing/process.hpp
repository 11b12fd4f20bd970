// Runs another program without a shell.
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace delabole {

// The first executable of that name in the folders of the environment variable PATH, as an absolute path; empty entries
// of PATH are ignored.
std::optional<std::filesystem::path> find_program(std::string_view name);

struct ProcessResult {
    bool succeeded = false;  // ran, and ended by itself with exit code 0
    bool timed_out = false;  // killed at the time limit
    std::string problem;     // the cause of failure: "exit code 1", "stopped by signal 9"; otherwise empty
    std::string output;      // first 64 KiB of its standard output and standard error
};

// Runs `program` with `arguments` in `folder`, with empty standard input, and waits for its end; after `time_limit` it
// is killed. No failure of the program throws an exception or raises a signal in the caller.
ProcessResult run_program(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                          const std::filesystem::path& folder, std::chrono::seconds time_limit);

}  // namespace delabole
