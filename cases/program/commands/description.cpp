#include "cases/program/commands/description.hpp"

#include "cases/program/reader/names.hpp"

#include <algorithm>

namespace delabole {

namespace {

std::vector<std::string> option_names(const DescribedCommand& command) {
    std::vector<std::string> names;
    for (const DescribedOption& option : command.options) {
        names.insert(names.end(), option.names.begin(), option.names.end());
    }
    return names;
}

// Names of all options whose value has this name, as alternatives of a case statement; never empty.
std::string options_with_value(const DescribedProgram& program, std::string_view value) {
    std::vector<std::string> names;
    for (const DescribedCommand& command : program.commands) {
        for (const DescribedOption& option : command.options) {
            for (const std::string& name : option.names) {
                if (option.value == value && std::ranges::find(names, name) == names.end()) {
                    names.push_back(name);
                }
            }
        }
    }
    return names.empty() ? "''" : separated(names, "|");
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

std::string bash_completion(const DescribedProgram& program) {
    const std::string function = "_" + program.name;
    std::vector<std::string> commands;
    for (const DescribedCommand& command : program.commands) {
        commands.push_back(command.name);
    }
    std::string text =
        "# Completion of " + program.name + " for bash, made from its own description of its commands.\n";
    text += function + R"(() {
    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} options= words= files=
    COMPREPLY=()
    if ((COMP_CWORD == 1)); then
        mapfile -t COMPREPLY < <(compgen -W ")" +
            separated(commands, " ") + R"( --help --version --bash-completion --manual-page" -- "$word")
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
    for (const DescribedCommand& command : program.commands) {
        text += "    " + command.name + ")\n        options=\"" + separated(option_names(command), " ") + "\"\n";
        if (!command.words.empty()) {
            text += "        words=\"" + separated(command.words, " ") + "\"\n";
        }
        if (command.argument == "CASE") {
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
            function + " " + program.name + "\n";
    return text;
}

std::string manual_page(const DescribedProgram& program) {
    std::string text = ".TH " + program.name + " 1 \"\" \"" + program.name + " " + troff(program.version) + "\"\n";
    text += ".SH NAME\n" + program.name + " \\- " + "back\\-analysis of rock\\-slope failures\n";
    text += ".SH SYNOPSIS\n.B " + program.name + "\n.I command\n[\\fIargument\\fR ...] [\\fIoption\\fR ...]\n";
    text += ".SH DESCRIPTION\n" + troff(program.meaning) + "\n.SH COMMANDS\n";
    for (const DescribedCommand& command : program.commands) {
        text += ".SS " + program.name + " " + command.name + (command.argument.empty() ? "" : " " + command.argument) +
                "\n";
        text += command.meaning.find('\n') == std::string::npos ? troff(command.meaning) + "\n"
                                                                : troff_lines(command.meaning);
        if (!command.argument.empty() && !command.argument_meaning.empty()) {
            text += ".TP\n.I " + command.argument + "\n" + troff(command.argument_meaning) + "\n";
        }
        for (const DescribedOption& option : command.options) {
            text += ".TP\n.B " + troff(separated(option.names, ", ")) +
                    (option.value.empty() ? "" : " \\fI" + option.value + "\\fR") + "\n" + troff(option.meaning) + "\n";
        }
        if (!command.footer.empty()) {
            text += ".PP\n" + troff_lines(command.footer);
        }
    }
    return text;
}

}  // namespace delabole
