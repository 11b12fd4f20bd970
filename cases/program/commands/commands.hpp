// The commands of the program.
#pragma once

#include "cases/program/terminal/options.hpp"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace delabole {

// All of them may throw UsageError (usage), CaseError (invalid_case) and OutputError (output_failure).
ExitCode run_command(const Paths& cases, const Options& options);
ExitCode fit_command(const std::filesystem::path& path, const Options& options);
ExitCode recover_command(const std::filesystem::path& path, const Options& options);
ExitCode sensitivity_command(const std::filesystem::path& path, const Options& options);
ExitCode trade_command(const std::filesystem::path& path, const Options& options);
// Computes an output over one or two inputs (options.vary) instead of the sweeps of the case.
ExitCode grid_command(const std::filesystem::path& path, const Options& options);
// Compares two cases: inputs and outputs that differ.
ExitCode compare_command(const Paths& cases, const Options& options);
// Serves a page on which the user changes the case and sees the answers, until it is interrupted.
ExitCode live_command(const std::filesystem::path& path, const Options& options);
ExitCode check_command(const Paths& cases, const Options& options);
ExitCode show_command(const std::filesystem::path& path, const Options& options);
// A case to start from; `sets`, if not empty, is the case or the result folder of a study whose joint sets cut the
// slope.
struct CaseToStart {
    std::string name;
    std::filesystem::path sets;
};
ExitCode init_command(const CaseToStart& start, const Options& options);
// Lists the inputs of a model, given by its name or by a case file.
ExitCode inputs_command(const std::string& what, const Options& options);
ExitCode outputs_command(const std::string& what, const Options& options);
ExitCode verify_command(const Paths& cases, const Options& options);
ExitCode reproduce_command(const std::string& what, const Options& options);

// Names that `reproduce` accepts, each with one line of description.
std::vector<std::pair<std::string, std::string>> reproducible();

}  // namespace delabole
