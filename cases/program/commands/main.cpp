// Parses the arguments, calls the command and returns the exit code.
#include "cases/program/case/case_file.hpp"
#include "cases/program/case/starting_cases.hpp"
#include "cases/program/commands/commands.hpp"
#include "cases/program/commands/description.hpp"
#include "cases/program/reader/case_error.hpp"
#include "cases/program/reader/names.hpp"
#include "cases/program/terminal/interrupt.hpp"
#include "cases/program/terminal/plain_output.hpp"
#include "fitting/work/bare_number.hpp"
#include "fitting/work/evaluation_store.hpp"
#include "fitting/work/ranks.hpp"
#include "fitting/work/words.hpp"
#include "plots/drawing/atomic_file.hpp"
#include "version/version.hpp"

#include <CLI/CLI.hpp>

#include <fcntl.h>
#include <malloc.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <functional>
#include <iostream>
#include <string>
#include <thread>
#include <utility>

namespace {

using delabole::ExitCode;
using delabole::Options;
using delabole::Paths;

int code(ExitCode exit_code) {
    return static_cast<int>(exit_code);
}

// CLI11 converts -1, and any number that is too large, to the largest number. Empty if the text is a valid seed.
std::string is_seed(const std::string& text) {
    return delabole::bare_number<std::uint64_t>(text) ? "" : text + " is not an integer from 0 to 2^64 - 1";
}

// Checked before parsing, because the parser has no message for a missing or mistyped command. Empty if there is a
// command.
std::string missing_command(const CLI::App& app, int argument_count, char** arguments) {
    if (argument_count < 2) {
        return "which command? To begin: delabole init plane_failure --out my_slope.toml, then\n"
               "delabole run my_slope.toml. All commands: delabole --help";
    }
    const std::string word = arguments[1];
    std::vector<std::string> commands;
    for (const CLI::App* command : app.get_subcommands({})) {
        commands.push_back(command->get_name());
    }
    if (word.starts_with('-') || std::ranges::find(commands, word) != commands.end()) {
        return {};
    }
    return "no command is named '" + word + "'" + delabole::suggestion(word, commands) + "; the commands are " +
           delabole::list_in_words(commands);
}

// Options that several commands take.
enum Part : unsigned { settings = 1, json = 2, quiet = 4, output = 8, threads = 16, seed = 32, store = 64 };
constexpr unsigned printing = json | quiet;
constexpr unsigned common = settings | printing;

void add_parts(CLI::App& command, Options& options, unsigned parts) {
    if ((parts & settings) != 0) {
        command
            .add_option("--set", options.settings, "Replace a value of the case, key=value; may be given several times")
            ->type_name("KEY=VALUE")
            ->allow_extra_args(false);
    }
    if ((parts & json) != 0) {
        command.add_flag("--json", options.json, "Print the result as JSON on standard output");
    }
    if ((parts & quiet) != 0) {
        command.add_flag("--quiet", options.quiet, "Print nothing but errors (and what --json asks for)");
    }
    if ((parts & output) != 0) {
        command
            .add_option(
                "--out", options.out,
                "Folder for the results; by default results/<name of the case>, with _fit, _recovery, _sensitivity, "
                "_grid or _trade for those commands (reproduce: with the name of what is reproduced). run puts each of "
                "several cases into a folder of its name there. It holds one result, which takes the place of what "
                "files.txt in it lists; other files stay. Symbolic links in it are not followed, and a second delabole "
                "is refused while one is writing")
            ->type_name("DIR");
        command.add_flag("--no-report", options.no_report,
                         "Neither report nor figures, which take most of a second: for scripts");
    }
    if ((parts & threads) != 0) {
        command.add_option("--threads", options.threads, "Threads, 1 by default; results do not depend on them")
            ->check(CLI::Range(1, 1024))
            ->type_name("N");
    }
    if ((parts & seed) != 0) {
        command.add_option("--seed", options.seed, "Replace the seed of the case")->check(is_seed)->type_name("N");
    }
    if ((parts & store) != 0) {
        command
            .add_option("--store", options.store,
                        "File that keeps the evaluations of costly models (dynamic relaxation), made where it is "
                        "missing: a study that was stopped goes on from it, and others of the same model use them too; "
                        "by default evaluations.sqlite in the result folder")
            ->type_name("FILE");
        command
            .add_option(
                "--runs", options.runs,
                "Folder with tables of earlier runs of costly models, <mechanism>_predictions.csv. The runs that they "
                "list are not made again, even if another version made them; a table of all runs that the study used "
                "is left in the result folder")
            ->type_name("DIR");
    }
}

std::string reproduce_help() {
    std::string text = "Recompute what the thesis prints, printed value beside computed value. WHAT is one of\n";
    for (const auto& [name, meaning] : delabole::reproducible()) {
        text.append("  ").append(name).append(": ").append(meaning).append("\n");
    }
    return text;
}

std::string example(const std::string& command) {
    return "Example:\n  " + command;
}

// The command line's options, and the command they select.
struct Program {
    CLI::App app{
        "Back-analysis of rock-slope failures.\n"
        "Exit codes: 0 ok, 1 verify mismatch, 2 usage, 3 invalid case, 4 not converged or interrupted, "
        "5 output failure, 70 an internal error.",
        "delabole"};
    Options options;
    Paths cases;
    std::filesystem::path one_case;
    std::string word;
    delabole::CaseToStart start;
    std::function<ExitCode()> chosen;

    explicit Program(const delabole::Ranks& ranks) {
        options.ranks = &ranks;
        app.set_version_flag("--version",
                             std::string(delabole::version()) + " (" + std::string(delabole::revision()) + ")");
        app.add_flag_callback(
            "--bash-completion", [this] { print_and_end(delabole::bash_completion(app)); },
            "Print what completes command lines in bash: source <(delabole --bash-completion)");
        app.add_flag_callback(
            "--manual-page", [this] { print_and_end(delabole::manual_page(app)); },
            "Print the manual page: delabole --manual-page | man -l -");
        app.require_subcommand(1);
        app.footer(example("delabole run cases/plane_failure/wyllie_mah_7_1.toml"));
        add_analysis();
        add_case_tools();
        add_proof();
    }

    [[noreturn]] static void print_and_end(const std::string& text) {
        std::cout << text;
        throw CLI::Success();
    }

    // `shared` tells whether several ranks can share the work of the command.
    template <class What>
    void complete(CLI::App* command, unsigned parts, const std::string& line,
                  ExitCode (*run)(const What&, const Options&), const std::type_identity_t<What>& what,
                  bool shared = false) {
        add_parts(*command, options, parts);
        command->footer(example("delabole " + line));
        command->callback([this, run, &what, shared] {
            options.quiet = options.quiet || (shared && !options.ranks->leads());
            chosen = [this, run, &what, shared] {
                if (!shared && !options.ranks->alone()) {
                    throw delabole::UsageError(
                        "of the commands only fit, recover and sensitivity share their work among ranks: run this one "
                        "without mpirun");
                }
                return run(what, options);
            };
        });
    }

    CLI::App* add_on_case(const std::string& name, const std::string& meaning, const std::string& of_case) {
        CLI::App* command = app.add_subcommand(name, meaning);
        command->add_option("CASE", one_case, of_case)->required();
        return command;
    }

    void add_analysis() {
        CLI::App* run = app.add_subcommand("run", "Analyse cases; prints a table and writes a result folder for each");
        run->add_option("CASE", cases, "Case files; - is standard input")->required();
        complete(run, common | output | threads,
                 "run cases/plane_failure/wyllie_mah_7_1.toml --set water.water_depth=\"2 m\"", delabole::run_command,
                 cases);
        run->add_option("--checkpoint-every", options.seconds_between_checkpoints,
                        "Seconds between checkpoints of a long dynamic relaxation, from which the same command goes on "
                        "once it was stopped; 60 by default")
            ->check(CLI::Range(0.0, 86'400.0))  // a day: the bounds appear in the help
            ->type_name("SECONDS");

        CLI::App* fit = add_on_case(
            "fit", "Back-analyse a failure: what its evidence determines, fitted parameters, ranking of mechanisms",
            "Case file with a [fit] section");
        complete(fit, common | output | threads | seed | store,
                 "fit cases/delabole_1967/delabole_1967.toml --mechanism critical_sliding", delabole::fit_command,
                 one_case, true);
        fit->add_option("--mechanism", options.mechanisms, "Fit this mechanism only; may be given again")
            ->type_name("NAME");
        fit->add_flag("--with-costly", options.with_costly,
                      "Fit mechanisms too whose every prediction is a run of dynamic relaxation: minutes")
            ->excludes("--mechanism");

        CLI::App* recover = add_on_case(
            "recover", "Whether a back-analysis finds known parameters again: coverage of its intervals, bias, ranks",
            "Case file with a [fit] section");
        complete(recover, common | output | threads | seed | store,
                 "recover cases/delabole_1967/given_surface.toml --repetitions 4", delabole::recover_command, one_case,
                 true);
        recover->add_option("--repetitions", options.repetitions, "Data sets to make and to fit; 100 by default")
            ->check(CLI::Range(2, 1'000'000))
            ->type_name("N");
        recover->add_flag_callback(
            "--at-best", [this] { options.at_best = true; },
            "Make the data from the best fit instead of draws of the prior");

        CLI::App* live =
            add_on_case("live",
                        "Look at a case in the browser and change it: the answer follows while points are dragged. "
                        "Served to this machine alone, at an address that is printed, until Ctrl-C",
                        "Case file");
        live->add_flag("--quiet", options.quiet, "Open no browser; the address is printed all the same");
        complete(live, settings | output | threads, "live cases/plane_failure/wyllie_mah_7_1.toml",
                 delabole::live_command, one_case);

        complete(add_on_case("sensitivity",
                             "Which parameter matters, the distribution of an answer, the probability of failure",
                             "Case file with a [sensitivity] section"),
                 common | output | threads | seed | store,
                 "sensitivity cases/plane_failure/sau_mau_ping_probability.toml", delabole::sensitivity_command,
                 one_case, true);

        CLI::App* grid = add_on_case("grid", "An output over one or two inputs: curves or a map, and all points as CSV",
                                     "Case file; - is standard input");
        grid->add_option("--vary", options.vary,
                         "Input, or another number of the case by its key, and its values, \"input=from:to:points\" "
                         "(101 points if none are given) or \"input=value,value\"; twice for a map")
            ->type_name("INPUT=VALUES")
            ->required()
            ->allow_extra_args(false);
        grid->add_option("--output", options.outputs,
                         "What is asked at each point; may be given again; by default factor_of_safety")
            ->type_name("NAME")
            ->allow_extra_args(false);
        complete(grid, common | output | threads,
                 "grid cases/plane_failure/wyllie_mah_7_1.toml --vary \"water.water_depth=0 m:4.35 m:30\"",
                 delabole::grid_command, one_case);

        complete(add_on_case(
                     "trade",
                     "Accuracy against cost of a dynamic relaxation: its critical value over the numerical parameters",
                     "Case file of model relaxation with a [critical] section"),
                 common | output | threads, "trade cases/relaxation/single_block.toml", delabole::trade_command,
                 one_case);
    }

    void add_case_tools() {
        CLI::App* check = app.add_subcommand("check", "Read cases and report every error in them");
        check->add_option("CASE", cases, "Case files")->required();
        complete(check, common, "check cases/delabole_1967/delabole_1967.toml", delabole::check_command, cases);

        CLI::App* compare = app.add_subcommand("compare", "Analyse two cases and list which inputs and outputs differ");
        compare->add_option("CASE", cases, "Two case files")->required()->expected(2);
        compare
            ->add_option("--out", options.out,
                         "Folder for a report with the figures side by side and a table; by default nothing is written")
            ->type_name("DIR");
        complete(compare, common | threads,
                 "compare cases/relaxation/two_blocks_3.toml cases/relaxation/two_blocks_5.toml",
                 delabole::compare_command, cases);

        complete(add_on_case(
                     "show",
                     "Print a case as it is understood, in standard units; optional values that are absent stay absent",
                     "Case file"),
                 settings | json, "show cases/delabole_1967/delabole_1967.toml", delabole::show_command, one_case);

        CLI::App* init = app.add_subcommand("init", "Write a short case to start from, to standard output or --out");
        init->add_option("NAME", start.name, delabole::choices(delabole::starting_case_names()))->required();
        init->add_flag("--full", options.full, "Every key that the model knows, with its meaning and range");
        init->add_option("--out", options.out, "File to write; an existing one is not overwritten")->type_name("FILE");
        init->add_option(
                "--sets", start.sets,
                "jointed_slope: cut it by the joint sets of this case of model kinematics, or of the one whose "
                "result folder this is")
            ->type_name("CASE")
            ->excludes("--full");
        complete(init, 0, "init plane_failure --out my_slope.toml", delabole::init_command, start);

        add_list("inputs", "List what can be set, fitted or varied: names, values, ranges, meanings, sources",
                 delabole::inputs_command);
        add_list("outputs", "List what is answered: names for [[expect]], [fit] and [sensitivity], units, meanings",
                 delabole::outputs_command);
    }

    void add_list(const std::string& name, const std::string& meaning,
                  ExitCode (*list)(const std::string& what, const Options& options)) {
        CLI::App* command = app.add_subcommand(name, meaning);
        command
            ->add_option("CASE", word, "A case file, or one of " + delabole::choices(delabole::starting_case_names()))
            ->required();
        complete(command, settings | json, name + " plane_failure", list, word);
    }

    void add_proof() {
        CLI::App* verify = app.add_subcommand(
            "verify", "Compare computed values with the [[expect]] entries of cases and the printed values of sweeps");
        verify->add_option("CASE", cases, "Case files or folders; by default the folder cases, which takes minutes");
        complete(verify, common, "verify cases/plane_failure", delabole::verify_command, cases);

        CLI::App* reproduce = app.add_subcommand("reproduce", reproduce_help());
        reproduce->add_option("WHAT", word, "What to reproduce; by default all that does not take minutes");
        complete(reproduce, printing | output | threads, "reproduce fig2.8", delabole::reproduce_command, word);
    }
};

// If the caller has closed a standard stream, its number would be given to the next file that is opened, and messages
// for the reader would be written into a result. Such a stream is replaced by one that cannot be used.
void occupy_standard_streams() {
    for (const auto& [descriptor, mode] :
         {std::pair{STDIN_FILENO, O_WRONLY}, std::pair{STDOUT_FILENO, O_RDONLY}, std::pair{STDERR_FILENO, O_RDONLY}}) {
        if (::fcntl(descriptor, F_GETFD) < 0) {
            ::open("/dev/null", mode);  // takes the lowest free number, which is this one
        }
    }
}

// Output that did not reach its reader is an error, for example because of a full disk behind `> file`.
int code_if_output_arrived(ExitCode exit_code) {
    if (!std::cout.flush() || std::fflush(stdout) != 0) {
        std::cerr << "delabole: cannot write to standard output\n";
        return code(ExitCode::output_failure);
    }
    return code(exit_code);
}

// Ends with a message. If several ranks meet the same error, the leader's message stands for all; another rank waits
// and prints its own only if it is not ended meanwhile.
int fail(const std::string& message, ExitCode exit_code, const delabole::Ranks& ranks) {
    if (!ranks.leads()) {
        std::this_thread::sleep_for(std::chrono::seconds(3));
    }
    std::cerr << message << '\n';
    std::cerr.flush();
    ranks.end_all(code(exit_code));
    return code(exit_code);
}

int guarded(const std::function<ExitCode()>& command, const delabole::Ranks& ranks) {
    const auto failed = [&](const std::exception& error, ExitCode exit_code) {
        return fail(std::string("delabole: ") + error.what(), exit_code, ranks);
    };
    try {
        return code_if_output_arrived(command());
    } catch (const delabole::UsageError& error) {
        return failed(error, ExitCode::usage);
    } catch (const delabole::CaseError& error) {
        return fail(error.what(), ExitCode::invalid_case, ranks);
    } catch (const delabole::Interrupted& error) {
        return failed(error, ExitCode::not_converged);
    } catch (const delabole::StoreError& error) {
        return failed(error, ExitCode::output_failure);
    } catch (const delabole::OutputError& error) {
        return failed(error, ExitCode::output_failure);
    } catch (const std::exception& error) {
        return fail("delabole: stopped by an error that lies neither in the case nor in the command: " +
                        std::string(error.what()),
                    ExitCode::internal_error, ranks);
    }
}

// A model allocates some megabytes for an evaluation and frees them, many thousands of times. Memory that the process
// keeps need not be mapped anew each time, which took an eighth of the back-analysis of Delabole.
void keep_freed_memory() {
    constexpr int bytes = 32 << 20;  // the greatest that glibc takes
    mallopt(M_MMAP_THRESHOLD, bytes);
    mallopt(M_TRIM_THRESHOLD, bytes);
}

}  // namespace

int main(int argument_count, char** arguments) {
    keep_freed_memory();
    occupy_standard_streams();
    const delabole::PlainOutput plain_output(std::cout);
    const delabole::PlainOutput plain_errors(std::cerr);
    try {
        const delabole::Ranks ranks;
        Program program(ranks);
        if (const std::string missing = missing_command(program.app, argument_count, arguments); !missing.empty()) {
            return ranks.leads() ? fail("delabole: " + missing, ExitCode::usage, ranks) : code(ExitCode::usage);
        }
        try {
            program.app.parse(argument_count, arguments);
        } catch (const CLI::ParseError& error) {
            if (!ranks.leads()) {
                return code(ExitCode::ok);
            }
            // CLI11 has exit codes of its own, above 100; help and version are not errors.
            const bool asked_for = program.app.exit(error) == 0;
            return asked_for ? code_if_output_arrived(ExitCode::ok) : code(ExitCode::usage);
        }
        // mpirun leaves ranks that it ends no time to finish anything.
        if (ranks.alone()) {
            delabole::catch_interrupts();
        }
        return guarded(program.chosen, ranks);
    } catch (const std::exception& error) {
        std::cerr << "delabole: cannot begin: " << error.what() << '\n';
        return code(ExitCode::internal_error);
    }
}
