// A guard in front of the TOML library, whose trees are built and freed recursively.
#pragma once

#include <optional>
#include <string_view>

namespace delabole {

struct NestingExcess {
    int line;
    int column;
};

// First place where brackets are nested, or a dotted key is, more than `limit` levels deep. Strings and comments do not
// count. Text that is not TOML gives some answer too.
std::optional<NestingExcess> excessive_nesting(std::string_view text, int limit);

}  // namespace delabole
