// Files that a case names: any bytes are an outline of finite corners, measured planes or a record of shaking, or have
// words for what is wrong with them.
#include "cases/program/models/kinematics/pole_file.hpp"
#include "cases/program/models/relaxation/shaking_file.hpp"
#include "cases/program/reader/outline_file.hpp"

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <numbers>
#include <string_view>

namespace {

void require(bool kept) {
    if (!kept) {
        std::abort();
    }
}

void look_at(const delabole::OutlineFile& file) {
    require(file.problem.empty() ? file.outline.size() >= 3 : file.outline.empty());
    for (const delabole::SectionPoint& corner : file.outline) {
        require(std::isfinite(corner.x) && std::isfinite(corner.y));
    }
}

void look_at_planes(std::string_view text) {
    try {
        const auto planes = delabole::planes_of_csv(text, "poles.csv");
        require(!planes.empty());
        constexpr double rounding = 1e-12;
        for (const delabole::Orientation& plane : planes) {
            require(plane.dip >= 0 && plane.dip <= std::numbers::pi / 2 + rounding);
            require(plane.dip_direction >= 0 && plane.dip_direction <= 2 * std::numbers::pi + rounding);
        }
    } catch (const delabole::CaseError& error) {
        require(error.what()[0] != '\0');
    }
}

void look_at_shaking(std::string_view text) {
    try {
        double before = -INFINITY;
        for (const delabole::ShakingPoint& point : delabole::shaking_of_csv(text, "shaking.csv")) {
            require(std::isfinite(point.time) && point.time > before);
            require(std::isfinite(point.horizontal) && std::isfinite(point.vertical));
            before = point.time;
        }
        require(std::isfinite(before));
    } catch (const delabole::CaseError& error) {
        require(error.what()[0] != '\0');
    }
}

}  // namespace

// The name is libFuzzer's.
// NOLINTNEXTLINE(readability-identifier-naming)
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    look_at(delabole::outline_of_dxf(text));
    look_at(delabole::outline_of_csv(text));
    look_at_planes(text);
    look_at_shaking(text);
    return 0;
}
