// A check before the TOML library is used, whose trees are built and freed recursively.
#pragma once

#include <optional>
#include <string_view>

namespace delabole {

struct NestingExcess {
    int line;
    int column;
};

// The first place where brackets are nested, or a dotted key is, more than `limit` levels deep. Strings and comments do
// not count. For text that is not TOML the result has no meaning.
std::optional<NestingExcess> excessive_nesting(std::string_view text, int limit);

}  // namespace delabole
