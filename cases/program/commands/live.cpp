// delabole live
#include "cases/program/commands/commands.hpp"
#include "cases/program/live/server.hpp"
#include "cases/program/reader/ordinary_file.hpp"
#include "cases/program/results/problems_of_case.hpp"
#include "cases/program/results/result_folder.hpp"
#include "cases/program/terminal/interrupt.hpp"

#include <spawn.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <iostream>
#include <string>

namespace delabole {

namespace {

// Opens the address in a browser if there is a screen. A failure does not matter, because the address is printed as
// well.
void open_in_browser(std::string address) {
    if (std::getenv("DISPLAY") == nullptr && std::getenv("WAYLAND_DISPLAY") == nullptr) {
        return;
    }
    std::string program = "xdg-open";
    std::array<char*, 3> arguments{program.data(), address.data(), nullptr};
    pid_t child = 0;
    ::posix_spawnp(&child, program.c_str(), nullptr, nullptr, arguments.data(), environ);
}

}  // namespace

ExitCode live_command(const std::filesystem::path& path, const Options& options) {
    if (path == "-") {
        throw UsageError("live: a case from standard input cannot be saved or reported: name a file");
    }
    CaseFile file = read_case(path, settings_of(options));
    refuse_impossible(file);
    show_units_of(file);
    LiveSession session(file, read_ordinary_file(path, "a case file", largest_case_bytes).bytes,
                        [&](const std::vector<std::string>& settings) {
                            Options report = options;
                            report.quiet = true;
                            report.json = false;
                            report.settings.insert(report.settings.end(), settings.begin(), settings.end());
                            run_command({path}, report);
                            return result_path(options, stem_of(file));
                        });
    LiveServer server(session);
    std::cout << "open " << server.address() << " in a browser on this machine; Ctrl-C ends it" << std::endl;
    if (!options.quiet) {
        open_in_browser(server.address());
    }
    server.serve([] { return interrupt_flag().load(); });
    return ExitCode::ok;
}

}  // namespace delabole
