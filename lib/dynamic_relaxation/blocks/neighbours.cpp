#include "dynamic_relaxation/blocks/neighbours.hpp"

#include "numerics/constants.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace delabole {

namespace {

struct Box {
    double left = infinity;
    double right = -infinity;
    double bottom = infinity;
    double top = -infinity;

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

struct Extent {
    double low;
    double high;
    std::uint32_t block;
};

// The extents of blocks across the longest edge of the middle one of them, drawn out by each block's reach, in
// increasing order of `low`. A block whose position is not a number has an extent that overlaps none.
std::vector<Extent> extents(const Bodies& bodies, const std::vector<Motion>& motion, const std::vector<double>& reach,
                            const std::vector<std::uint32_t>& crowd) {
    const CornerRange& middle = bodies.range[crowd[crowd.size() / 2]];
    PlanePoint<> longest(0, 0);
    for (std::size_t corner = middle.begin; corner < middle.end; ++corner) {
        const PlanePoint<> edge =
            moved_corner(bodies, motion, middle.after(corner)) - moved_corner(bodies, motion, corner);
        longest = edge.norm() > longest.norm() ? edge : longest;
    }
    const PlanePoint<> across = PlanePoint<>(-longest.y(), longest.x()) / longest.norm();
    std::vector<Extent> result;
    result.reserve(crowd.size());
    for (const std::uint32_t block : crowd) {
        Extent extent{infinity, -infinity, block};
        for (std::size_t corner = bodies.range[block].begin; corner < bodies.range[block].end; ++corner) {
            const double at = across.dot(moved_corner(bodies, motion, corner));
            extent.low = std::min(extent.low, at - reach[block]);
            extent.high = std::max(extent.high, at + reach[block]);
        }
        result.push_back(extent);
    }
    std::ranges::sort(result, {}, &Extent::low);
    return result;
}

template <class Visit>
void for_overlapping(const std::vector<Extent>& sorted, const Visit& visit) {
    for (auto first = sorted.begin(); first != sorted.end(); ++first) {
        for (auto second = first + 1; second != sorted.end() && second->low <= first->high; ++second) {
            visit(first->block, second->block);
        }
    }
}

}  // namespace

std::vector<BlockPair> neighbouring_blocks(const Bodies& bodies, const std::vector<Motion>& motion,
                                           const std::vector<char>& removed, const std::vector<double>& reach) {
    // A block that covers more cells than this is compared with all others instead. So is every block where there are
    // few, and any block thrown so far away that its cells cannot be numbered.
    constexpr double most_cells = 4096;
    constexpr double farthest = 1e15;  // cells
    constexpr std::size_t few_blocks = 16;
    // Flat, inclined blocks fill a cell by thousands, each in the bounding boxes of all others.
    constexpr std::size_t crowded = 64;
    // Cells are as wide as the free block of median size.
    const double width = 2 * median_of_free(bodies, bodies.radius, removed).value_or(0.5);
    const auto cell = [&](double coordinate) { return static_cast<std::int64_t>(std::floor(coordinate / width)); };
    const auto may_touch = [&](std::uint32_t first, std::uint32_t second) {
        return bodies.fixed[first] == 0 || bodies.fixed[second] == 0;
    };
    std::vector<Box> boxes(bodies.size());
    std::vector<Entry> entries;
    std::vector<std::uint32_t> present;
    std::vector<std::uint32_t> large;
    std::vector<std::uint32_t> crowd;
    entries.reserve(4 * bodies.size());
    for (std::uint32_t block = 0; block < bodies.size(); ++block) {
        if (removed[block] != 0) {
            continue;
        }
        present.push_back(block);
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
    for (auto begin = entries.begin(); begin != entries.end();) {
        const auto end = std::find_if(begin, entries.end(), [&](const Entry& entry) {
            return entry.row != begin->row || entry.column != begin->column;
        });
        const auto compare = [&](std::uint32_t first, std::uint32_t second) {
            const Box& one = boxes[first];
            const Box& two = boxes[second];
            // A pair that shares several cells is counted in the cell of the lower left corner of the common area of
            // its boxes.
            if (may_touch(first, second) && one.overlaps(two) && cell(std::max(one.bottom, two.bottom)) == begin->row &&
                cell(std::max(one.left, two.left)) == begin->column) {
                add(first, second);
            }
        };
        if (end - begin <= static_cast<std::ptrdiff_t>(crowded)) {
            for (auto first = begin; first != end; ++first) {
                for (auto second = first + 1; second != end; ++second) {
                    compare(first->block, second->block);
                }
            }
        } else {
            crowd.clear();
            std::transform(begin, end, std::back_inserter(crowd), [](const Entry& entry) { return entry.block; });
            for_overlapping(extents(bodies, motion, reach, crowd), compare);
        }
        begin = end;
    }
    if (!large.empty()) {
        std::vector<char> is_large(bodies.size(), 0);
        for (const std::uint32_t block : large) {
            is_large[block] = 1;
        }
        for_overlapping(extents(bodies, motion, reach, present), [&](std::uint32_t first, std::uint32_t second) {
            if ((is_large[first] != 0 || is_large[second] != 0) && may_touch(first, second) &&
                boxes[first].overlaps(boxes[second])) {
                add(first, second);
            }
        });
    }
    std::sort(pairs.begin(), pairs.end());
    return pairs;
}

}  // namespace delabole
