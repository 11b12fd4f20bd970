// Any bit patterns as coordinates: no crash, no sanitizer finding, and the promises of polyline.hpp kept.
#include "geometry/polyline.hpp"

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>

// The name is libFuzzer's.
// NOLINTNEXTLINE(readability-identifier-naming)
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size < 1 + sizeof(delabole::Point)) {
        return 0;
    }
    const std::size_t count = data[0];
    delabole::Point point;
    std::memcpy(point.data(), data + 1, sizeof(point));
    delabole::Polyline line((size - 1) / sizeof(point) - 1);
    for (std::size_t index = 0; index < line.size(); ++index) {
        std::memcpy(line[index].data(), data + 1 + (index + 1) * sizeof(point), sizeof(point));
    }

    const double total = delabole::length(line);
    const delabole::Polyline resampled = delabole::resample(line, count);
    const bool resamplable = count >= 2 && total > 0;
    if (resampled.size() != (resamplable ? count : 0)) {
        std::abort();
    }
    const double distance = delabole::signed_distance(line, point);
    if (line.size() < 2 && !std::isnan(distance)) {
        std::abort();
    }
    return 0;
}
