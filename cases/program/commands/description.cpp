#include "cases/program/commands/description.hpp"

#include "cases/program/case/starting_cases.hpp"
#include "cases/program/commands/commands.hpp"
#include "cases/program/reader/names.hpp"
#include "version/version.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <iterator>
#include <string_view>
#include <vector>

namespace delabole {

namespace {

std::vector<const CLI::Option*> options_of(const CLI::App& command, bool positional = false) {
    return command.get_options(
        [positional](const CLI::Option* option) { return option->get_positional() == positional; });
}

// "-h" and "--help".
std::vector<std::string> names_of(const CLI::Option& option) {
    std::vector<std::string> names;
    for (const std::string& name : option.get_snames()) {
        names.push_back("-" + name);
    }
    for (const std::string& name : option.get_lnames()) {
        names.push_back("--" + name);
    }
    return names;
}

// "DIR"; empty for a flag. CLI11 puts the condition that it checks after a colon.
std::string value_of(const CLI::Option& option) {
    const std::string type = option.get_type_name();
    return option.get_items_expected_max() > 0 ? type.substr(0, type.find(':')) : "";
}

// Names of all options whose value has this name, as alternatives of a case statement; never empty.
std::string options_with_value(const CLI::App& program, std::string_view value) {
    std::vector<std::string> found;
    for (const CLI::App* command : program.get_subcommands({})) {
        for (const CLI::Option* option : options_of(*command)) {
            for (const std::string& name : names_of(*option)) {
                if (value_of(*option) == value && std::ranges::find(found, name) == found.end()) {
                    found.push_back(name);
                }
            }
        }
    }
    return found.empty() ? "''" : separated(found, "|");
}

// Words that a command accepts as its argument besides files.
std::vector<std::string> words_for(const std::string& command) {
    if (command == "init" || command == "inputs" || command == "outputs") {
        return starting_case_names();
    }
    std::vector<std::string> words;
    if (command == "reproduce") {
        for (const auto& [name, meaning] : reproducible()) {
            words.push_back(name);
        }
    }
    return words;
}

// Text escaped for troff: no line is a request, and hyphens are those on a keyboard.
std::string troff(std::string_view text) {
    std::string escaped;
    bool line_begins = true;
    for (const char letter : text) {
        if (line_begins && (letter == '.' || letter == '\'')) {
            escaped += "\\&";
        }
        if (letter == '\\') {
            escaped += "\\e";
        } else if (letter == '-') {
            escaped += "\\-";
        } else {
            escaped += letter;
        }
        line_begins = letter == '\n';
    }
    return escaped;
}

// Text whose line breaks are kept.
std::string troff_lines(std::string_view text) {
    return ".nf\n" + troff(text) + "\n.fi\n";
}

}  // namespace

std::string bash_completion(const CLI::App& program) {
    const std::string own_name = program.get_name();
    const std::string function = "_" + own_name;
    const std::vector<const CLI::App*> commands = program.get_subcommands({});
    std::vector<std::string> names;
    for (const CLI::App* command : commands) {
        names.push_back(command->get_name());
    }
    std::string text = "# Completion of " + own_name + " for bash, made from its own description of its commands.\n";
    text += function + R"(() {
    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} options= words= files=
    COMPREPLY=()
    if ((COMP_CWORD == 1)); then
        mapfile -t COMPREPLY < <(compgen -W ")" +
            separated(names, " ") + R"( --help --version --bash-completion --manual-page" -- "$word")
        return
    fi
    case $before in
    )" + options_with_value(program, "DIR") +
            R"()
        mapfile -t COMPREPLY < <(compgen -d -- "$word")
        return
        ;;
    )" + options_with_value(program, "FILE") +
            R"()
        mapfile -t COMPREPLY < <(compgen -f -- "$word")
        return
        ;;
    )" + options_with_value(program, "KEY=VALUE") +
            R"()
        compopt -o nospace
        return
        ;;
    esac
    case ${COMP_WORDS[1]} in
)";
    for (const CLI::App* command : commands) {
        const std::string& name = command->get_name();
        text += "    " + name + ")\n        options=\"";
        std::vector<std::string> options;
        for (const CLI::Option* option : options_of(*command)) {
            std::ranges::move(names_of(*option), std::back_inserter(options));
        }
        text += separated(options, " ") + "\"\n";
        if (const std::vector<std::string> words = words_for(name); !words.empty()) {
            text += "        words=\"" + separated(words, " ") + "\"\n";
        }
        if (command->get_option_no_throw("CASE") != nullptr) {
            text += "        files=yes\n";
        }
        text += "        ;;\n";
    }
    text += R"(    esac
    if [[ $word == -* ]]; then
        mapfile -t COMPREPLY < <(compgen -W "$options" -- "$word")
        return
    fi
    mapfile -t COMPREPLY < <(
        compgen -W "$words" -- "$word"
        if [[ $files ]]; then
            compgen -f -X '!*.toml' -- "$word"
            compgen -d -- "$word"
        fi
    )
}
complete -o filenames -F )" +
            function + " " + own_name + "\n";
    return text;
}

std::string manual_page(const CLI::App& program) {
    const std::string own_name = program.get_name();
    std::string text = ".TH " + own_name + " 1 \"\" \"" + own_name + " " + troff(version()) + "\"\n";
    text += ".SH NAME\n" + own_name + " \\- " + "back\\-analysis of rock\\-slope failures\n";
    text += ".SH SYNOPSIS\n.B " + own_name + "\n.I command\n[\\fIargument\\fR ...] [\\fIoption\\fR ...]\n";
    text += ".SH DESCRIPTION\n" + troff(program.get_description()) + "\n.SH COMMANDS\n";
    for (const CLI::App* command : program.get_subcommands({})) {
        const CLI::Option& argument = *options_of(*command, true).front();
        const std::string argument_name = argument.get_name(true);
        text += ".SS " + own_name + " " + command->get_name() + " " + argument_name + "\n";
        const std::string meaning = command->get_description();
        text += meaning.find('\n') == std::string::npos ? troff(meaning) + "\n" : troff_lines(meaning);
        text += ".TP\n.I " + argument_name + "\n" + troff(argument.get_description()) + "\n";
        for (const CLI::Option* option : options_of(*command)) {
            const std::string value = value_of(*option);
            text += ".TP\n.B " + troff(separated(names_of(*option), ", ")) +
                    (value.empty() ? "" : " \\fI" + value + "\\fR") + "\n" + troff(option->get_description()) + "\n";
        }
        text += ".PP\n" + troff_lines(command->get_footer());
    }
    return text;
}

}  // namespace delabole
