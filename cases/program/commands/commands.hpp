// The commands of the program.
#pragma once

#include "cases/program/terminal/options.hpp"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace delabole {

// Each may throw UsageError (usage), CaseError (invalid_case) and OutputError (output_failure).
ExitCode run_command(const Paths& cases, const Options& options);
ExitCode fit_command(const std::filesystem::path& path, const Options& options);
ExitCode recover_command(const std::filesystem::path& path, const Options& options);
ExitCode sensitivity_command(const std::filesystem::path& path, const Options& options);
ExitCode trade_command(const std::filesystem::path& path, const Options& options);
// An output over one or two inputs (options.vary), in place of the sweeps of the case.
ExitCode grid_command(const std::filesystem::path& path, const Options& options);
// Two cases: inputs and outputs that differ.
ExitCode compare_command(const Paths& cases, const Options& options);
// Serves a page on which the case is changed and answers, until it is interrupted.
ExitCode live_command(const std::filesystem::path& path, const Options& options);
ExitCode check_command(const Paths& cases, const Options& options);
ExitCode show_command(const std::filesystem::path& path, const Options& options);
ExitCode init_command(const std::string& name, const Options& options);
// Lists the inputs of a model, by its name, or of the model of a case file.
ExitCode inputs_command(const std::string& what, const Options& options);
ExitCode outputs_command(const std::string& what, const Options& options);
ExitCode verify_command(const Paths& cases, const Options& options);
ExitCode reproduce_command(const std::string& what, const Options& options);

// Names that `reproduce` accepts, with a line on each.
std::vector<std::pair<std::string, std::string>> reproducible();

}  // namespace delabole
