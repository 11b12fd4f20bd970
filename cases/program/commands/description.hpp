// A description of the program, and the texts made from it: completion and the manual page.
#pragma once

#include <string>
#include <vector>

namespace delabole {

struct DescribedOption {
    std::vector<std::string> names;  // "--out", "-h"
    std::string value;               // "DIR"; empty for a flag
    std::string meaning;
};

struct DescribedCommand {
    std::string name;
    std::string meaning;
    std::string argument = {};  // "CASE"; empty for none
    std::string argument_meaning = {};
    std::vector<std::string> words = {};  // words that the argument may be, besides a file
    std::vector<DescribedOption> options = {};
    std::string footer = {};  // an example
};

struct DescribedProgram {
    std::string name;
    std::string version;
    std::string meaning;
    std::vector<DescribedCommand> commands;
};

// A script for bash, to be sourced. It completes commands, options, words for arguments, folders where a folder is
// asked for, and case files.
std::string bash_completion(const DescribedProgram& program);

// A manual page for man, section 1.
std::string manual_page(const DescribedProgram& program);

}  // namespace delabole
