// Texts made from the program's own description of its command line: completion and the manual page.
#pragma once

#include <string>

namespace CLI {
class App;
}

namespace delabole {

// A script for bash, to be sourced. It completes commands, options, words for arguments, folders where a folder is
// asked for, and case files.
std::string bash_completion(const CLI::App& program);

// A manual page for man, section 1.
std::string manual_page(const CLI::App& program);

}  // namespace delabole
