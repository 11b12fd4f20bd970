// Any outline and any cuts: either the reason why there are no blocks, or blocks that fill the outline but for voids,
// are convex and share their edges.
#include "jointed_slope/jointed_section.hpp"

#include "jointed_slope/section_mesh.hpp"
#include "tests/support/jointed_slopes.hpp"

#include <Eigen/Geometry>

#include <fuzzer/FuzzedDataProvider.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <set>
#include <utility>

namespace {

using delabole::PlanePoint;

// Lengths on a grid, so that corners meet, lines run along others and outlines cross; now and then any number at all.
class Drawing {
  public:
    explicit Drawing(FuzzedDataProvider& data) : data_(data) {}

    double number(double lower, double upper) {
        switch (data_.ConsumeIntegralInRange(0, 15)) {
        case 0:
            return data_.ConsumeFloatingPoint<double>();
        case 1:
        case 2:
        case 3:
            return data_.ConsumeFloatingPointInRange(lower, upper);
        default:
            return lower + (upper - lower) * data_.ConsumeIntegralInRange(0, 64) / 64;
        }
    }

    std::vector<delabole::SectionPoint> points(int most) {
        std::vector<delabole::SectionPoint> made(data_.ConsumeIntegralInRange<std::size_t>(0, most));
        for (delabole::SectionPoint& point : made) {
            point.x = number(-32, 32);
            point.y = number(-32, 32);
        }
        return made;
    }

    delabole::SlopeCut cut(int index) {
        const std::string name(1, static_cast<char>('a' + index));
        return delabole::testing::cut(name, data_.ConsumeBool() ? line() : set());
    }

  private:
    std::string earlier() { return {static_cast<char>('a' + data_.ConsumeIntegralInRange(0, 4))}; }

    std::variant<delabole::JointSetCut, delabole::LineCut> line() {
        delabole::LineCut made{};
        made.vertex = points(6);
        if (data_.ConsumeBool()) {
            made.thickness = number(0, 4);
            made.gouge = "gouge";
        }
        if (data_.ConsumeBool()) {
            made.rock_below = "other";
        }
        return made;
    }

    std::variant<delabole::JointSetCut, delabole::LineCut> set() {
        constexpr double right_angle = 1.5707963267948966;
        delabole::JointSetCut made = delabole::testing::joint_set(number(-right_angle, right_angle), number(2, 34));
        if (data_.ConsumeBool()) {
            made.scatter = number(0, 1);
            made.offset = number(-4, 4);
        }
        if (data_.ConsumeBool()) {
            made.persistence = number(0, 1);
            made.trace_length = number(0, 32);
        }
        if (data_.ConsumeBool()) {
            made.region = points(5);
        }
        if (data_.ConsumeBool()) {
            made.ends_on = earlier();
            made.side = data_.ConsumeBool() ? delabole::SideOfLine::above : delabole::SideOfLine::below;
        }
        if (data_.ConsumeBool()) {
            made.staggered_by = earlier();
            made.stagger_share = number(0, 1);
        }
        return made;
    }

    FuzzedDataProvider& data_;
};

// Sections that would take too long are left out: the cutter's own limit is `most_slope_blocks`.
bool too_fine(const delabole::SlopeGeometry& geometry) {
    double size = 0;
    for (const delabole::SectionPoint& point : geometry.outline) {
        size = std::max({size, std::abs(point.x), std::abs(point.y)});
    }
    return std::any_of(geometry.cut.begin(), geometry.cut.end(), [&](const delabole::SlopeCut& cut) {
        const auto* set = std::get_if<delabole::JointSetCut>(&cut.trace);
        return set != nullptr && set->spacing < size / 16;
    });
}

void require(bool kept, const char* promise) {
    if (!kept) {
        std::cerr << promise << '\n';
        std::abort();
    }
}

void look_at(const delabole::SlopeGeometry& geometry, const delabole::JointedSection& made) {
    delabole::Polygon<> outline;
    double size = 0;
    for (const delabole::SectionPoint& point : geometry.outline) {
        outline.emplace_back(point.x, point.y);
        size = std::max(size, (outline.back() - outline.front()).norm());
    }
    // The cutter moves corners that lie nearer than the snap distance to the lowest, foremost or rearmost one on to the
    // same level or upright.
    Eigen::AlignedBox2d bounds;
    for (const PlanePoint<>& corner : outline) {
        bounds.extend(corner);
    }
    const auto moved = [&](double at, double on) { return std::abs(at - on) < made.snap_distance ? on : at; };
    for (PlanePoint<>& corner : outline) {
        corner.y() = moved(corner.y(), bounds.min().y());
        corner.x() = moved(moved(corner.x(), bounds.max().x()), bounds.min().x());
    }
    // Rounding of the coordinates, which count from the first corner, times the way around all blocks.
    const double rounding = 1e-12 * size * size;
    double area = made.crushed_area;
    std::set<std::pair<delabole::MeshIndex, delabole::MeshIndex>> edges;
    for (const delabole::SlopeBlock& block : made.block) {
        const std::size_t count = block.vertex.size();
        require(count >= 3, "a block has three corners");
        for (std::size_t edge = 0; edge < count; ++edge) {
            const delabole::MeshIndex first = block.vertex[edge];
            const delabole::MeshIndex second = block.vertex[(edge + 1) % count];
            const delabole::MeshIndex third = block.vertex[(edge + 2) % count];
            require(edges.emplace(first, second).second, "blocks do not overlap");
            const PlanePoint<> one = made.vertex[second] - made.vertex[first];
            const PlanePoint<> two = made.vertex[third] - made.vertex[second];
            const double straight = delabole::straight_sine * one.norm() * two.norm();
            require(one.x() * two.y() - one.y() * two.x() >= -rounding - straight, "blocks are convex");
        }
        area += delabole::area_properties(outline_of(made, block)).area;
    }
    require(std::abs(area - std::abs(delabole::area_properties(outline).area)) <= rounding, "blocks fill the outline");
}

}  // namespace

// The name is libFuzzer's.
// NOLINTNEXTLINE(readability-identifier-naming)
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    FuzzedDataProvider provider(data, size);
    Drawing drawing(provider);
    delabole::SlopeGeometry geometry = delabole::testing::section(drawing.points(12));
    const int cuts = provider.ConsumeIntegralInRange(0, 5);
    for (int index = 0; index < cuts; ++index) {
        geometry.cut.push_back(drawing.cut(index));
    }
    if (too_fine(geometry)) {
        return 0;
    }
    const delabole::JointedSection made = delabole::testing::cut_in_one_rock(geometry);
    if (made.check == delabole::SlopeCheck::valid) {
        look_at(geometry, made);
    } else {
        require(made.block.empty(), "no blocks where there is a reason for none");
    }
    return 0;
}
