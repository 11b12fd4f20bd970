// Any bytes are an outline of finite corners or have words for what is wrong with them, as DXF and as CSV.
#include "cases/program/reader/outline_file.hpp"

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string_view>

namespace {

void look_at(const delabole::OutlineFile& file) {
    bool good = file.problem.empty() ? file.outline.size() >= 3 : file.outline.empty();
    for (const delabole::SectionPoint& corner : file.outline) {
        good = good && std::isfinite(corner.x) && std::isfinite(corner.y);
    }
    if (!good) {
        std::abort();
    }
}

}  // namespace

// The name is libFuzzer's.
// NOLINTNEXTLINE(readability-identifier-naming)
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    look_at(delabole::outline_of_dxf(text));
    look_at(delabole::outline_of_csv(text));
    return 0;
}
