#include "dynamic_relaxation/blocks/neighbours.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace delabole {

namespace {

struct Box {
    double left = std::numeric_limits<double>::infinity();
    double right = -std::numeric_limits<double>::infinity();
    double bottom = std::numeric_limits<double>::infinity();
    double top = -std::numeric_limits<double>::infinity();

    bool overlaps(const Box& other) const {
        return left <= other.right && other.left <= right && bottom <= other.top && other.bottom <= top;
    }
};

struct Entry {
    std::int64_t row;
    std::int64_t column;
    std::uint32_t block;

    // NOLINTNEXTLINE(modernize-use-nullptr): clang-tidy 14 takes a defaulted comparison for one with zero.
    auto operator<=>(const Entry&) const = default;
};

Box box_of(const Bodies& bodies, const std::vector<Motion>& motion, std::size_t block, double reach) {
    Box box;
    for (std::size_t corner = bodies.range[block].begin; corner < bodies.range[block].end; ++corner) {
        const PlanePoint<> at = moved_corner(bodies, motion, corner);
        box.left = std::min(box.left, at.x());
        box.right = std::max(box.right, at.x());
        box.bottom = std::min(box.bottom, at.y());
        box.top = std::max(box.top, at.y());
    }
    return {box.left - reach, box.right + reach, box.bottom - reach, box.top + reach};
}

// Cells are as wide as a free block of median size.
double cell_width(const Bodies& bodies, const std::vector<char>& removed) {
    std::vector<double> radius;
    for (std::size_t block = 0; block < bodies.size(); ++block) {
        if (bodies.fixed[block] == 0 && removed[block] == 0) {
            radius.push_back(bodies.radius[block]);
        }
    }
    if (radius.empty()) {
        return 1;
    }
    const auto middle = radius.begin() + static_cast<std::ptrdiff_t>(radius.size() / 2);
    std::nth_element(radius.begin(), middle, radius.end());
    return 2 * *middle;
}

}  // namespace

std::vector<BlockPair> neighbouring_blocks(const Bodies& bodies, const std::vector<Motion>& motion,
                                           const std::vector<char>& removed, const std::vector<double>& reach) {
    // A block that covers more cells than this is compared with all others instead. So is every block where there are
    // few, and any block thrown so far away that its cells cannot be numbered.
    constexpr double most_cells = 4096;
    constexpr double farthest = 1e15;  // cells
    constexpr std::size_t few_blocks = 16;
    const double width = cell_width(bodies, removed);
    const auto cell = [&](double coordinate) { return static_cast<std::int64_t>(std::floor(coordinate / width)); };
    const auto may_touch = [&](std::uint32_t first, std::uint32_t second) {
        return bodies.fixed[first] == 0 || bodies.fixed[second] == 0;
    };
    std::vector<Box> boxes(bodies.size());
    std::vector<Entry> entries;
    std::vector<std::uint32_t> large;
    entries.reserve(4 * bodies.size());
    for (std::uint32_t block = 0; block < bodies.size(); ++block) {
        if (removed[block] != 0) {
            continue;
        }
        const Box& box = boxes[block] = box_of(bodies, motion, block, reach[block]);
        const double away = std::max({-box.left, box.right, -box.bottom, box.top});
        if (bodies.size() <= few_blocks || !(away < farthest * width) ||
            (box.right - box.left + width) / width * ((box.top - box.bottom + width) / width) > most_cells) {
            large.push_back(block);
            continue;
        }
        for (std::int64_t row = cell(box.bottom); row <= cell(box.top); ++row) {
            for (std::int64_t column = cell(box.left); column <= cell(box.right); ++column) {
                entries.push_back({row, column, block});
            }
        }
    }
    std::sort(entries.begin(), entries.end());
    std::vector<BlockPair> pairs;
    const auto add = [&](std::uint32_t first, std::uint32_t second) {
        pairs.emplace_back(std::min(first, second), std::max(first, second));
    };
    for (std::size_t first = 0; first < entries.size(); ++first) {
        const Entry& entry = entries[first];
        for (std::size_t second = first + 1;
             second < entries.size() && entries[second].row == entry.row && entries[second].column == entry.column;
             ++second) {
            const Box& one = boxes[entry.block];
            const Box& two = boxes[entries[second].block];
            // A pair that shares several cells is counted in the cell of the lower left corner of the common area of
            // its boxes.
            if (may_touch(entry.block, entries[second].block) && one.overlaps(two) &&
                cell(std::max(one.bottom, two.bottom)) == entry.row &&
                cell(std::max(one.left, two.left)) == entry.column) {
                add(entry.block, entries[second].block);
            }
        }
    }
    for (std::size_t index = 0; index < large.size(); ++index) {
        for (std::uint32_t block = 0; block < bodies.size(); ++block) {
            const bool earlier_large = std::find(large.begin(), large.begin() + static_cast<std::ptrdiff_t>(index) + 1,
                                                 block) != large.begin() + static_cast<std::ptrdiff_t>(index) + 1;
            if (removed[block] == 0 && !earlier_large && may_touch(large[index], block) &&
                boxes[large[index]].overlaps(boxes[block])) {
                add(large[index], block);
            }
        }
    }
    std::sort(pairs.begin(), pairs.end());
    return pairs;
}

}  // namespace delabole
