// Runs another program without a shell.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
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
    bool given_up = false;   // killed because the caller gave it up
    std::string problem;     // the cause of failure: "exit code 1", "stopped by signal 9"; otherwise empty
    std::string output;      // first 64 KiB of its standard output and standard error
};

// Runs `program` with `arguments` in `folder`, with empty standard input, and waits for its end; after `time_limit` it
// is killed, and so it is once `give_up`, asked ten times a second, is true. No failure of the program throws an
// exception or raises a signal in the caller.
ProcessResult run_program(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                          const std::filesystem::path& folder, std::chrono::seconds time_limit,
                          const std::function<bool()>& give_up = {});

// Kills the program that is running; for a caller that ends without returning from run_program. May be called in a
// signal handler.
void kill_running_program();

}  // namespace delabole
