#include "cases/program/reader/line_chains.hpp"

#include "cases/program/reader/units.hpp"
#include "geometry/polygon.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace delabole {

namespace {

// Ends whose distance is less than this share of the drawing's size are the same point.
constexpr double same_point = 1e-6;

double size_of(const std::vector<LineChain>& chains) {
    double size = 0;
    const SectionPoint& first = chains.front().point.front();
    for (const LineChain& chain : chains) {
        for (const SectionPoint& point : chain.point) {
            size = std::max({size, std::abs(point.x - first.x), std::abs(point.y - first.y)});
        }
    }
    return size;
}

// The ends of open chains sorted by place, so that a chain that continues from a point is found without checking all
// others.
class OpenEnds {
  public:
    OpenEnds(const std::vector<LineChain>& chains, double near) : chains_(chains), near_(near) {
        for (std::size_t index = 0; index < chains.size(); ++index) {
            if (!chains[index].closed) {
                cells_[cell_of(chains[index].point.front())].insert(index);
                cells_[cell_of(chains[index].point.back())].insert(index);
            }
        }
    }

    bool meet(const SectionPoint& one, const SectionPoint& other) const {
        return std::hypot(one.x - other.x, one.y - other.y) <= near_;
    }

    // The first remaining chain with an end at the point.
    std::optional<std::size_t> chain_at(const SectionPoint& point) const {
        std::optional<std::size_t> first;
        const Cell around = cell_of(point);
        for (const double column : {-1, 0, 1}) {
            for (const double row : {-1, 0, 1}) {
                const auto cell = cells_.find({around.first + column, around.second + row});
                if (cell == cells_.end()) {
                    continue;
                }
                const auto found = std::ranges::find_if(cell->second, [&](std::size_t index) {
                    return meet(point, chains_[index].point.front()) || meet(point, chains_[index].point.back());
                });
                if (found != cell->second.end() && (!first || *found < *first)) {
                    first = *found;
                }
            }
        }
        return first;
    }

    void remove(std::size_t index) {
        cells_[cell_of(chains_[index].point.front())].erase(index);
        cells_[cell_of(chains_[index].point.back())].erase(index);
    }

  private:
    using Cell = std::pair<double, double>;

    // Points that coincide lie in the same cell or in two adjacent cells. If all points coincide, there is one cell.
    Cell cell_of(const SectionPoint& point) const {
        const double width = 2 * near_;
        const auto count = [&](double coordinate) { return width > 0 ? std::floor(coordinate / width) : 0; };
        return {count(point.x), count(point.y)};
    }

    const std::vector<LineChain>& chains_;
    double near_;
    std::map<Cell, std::set<std::size_t>> cells_ = {};
};

}  // namespace

std::vector<LineChain> joined(std::vector<LineChain> chains) {
    OpenEnds ends(chains, same_point * size_of(chains));
    std::vector<bool> used(chains.size(), false);
    std::vector<LineChain> result;
    for (std::size_t index = 0; index < chains.size(); ++index) {
        if (used[index]) {
            continue;
        }
        if (chains[index].closed) {
            result.push_back(std::move(chains[index]));
            continue;
        }
        ends.remove(index);
        LineChain chain = std::move(chains[index]);
        const auto grow = [&] {
            while (const std::optional<std::size_t> next = ends.chain_at(chain.point.back())) {
                ends.remove(*next);
                used[*next] = true;
                LineChain& other = chains[*next];
                if (!ends.meet(chain.point.back(), other.point.front())) {
                    std::reverse(other.point.begin(), other.point.end());
                }
                chain.point.insert(chain.point.end(), other.point.begin() + 1, other.point.end());
                chain.joined = true;
            }
        };
        grow();
        if (chain.point.size() > 3 && ends.meet(chain.point.front(), chain.point.back())) {
            chain.point.pop_back();
            chain.closed = true;
        } else {
            std::reverse(chain.point.begin(), chain.point.end());
            grow();
        }
        result.push_back(std::move(chain));
    }
    return result;
}

void turn_anticlockwise(std::vector<SectionPoint>& outline) {
    Polygon<> polygon;
    for (const SectionPoint& point : outline) {
        polygon.emplace_back(point.x, point.y);
    }
    if (area_properties(polygon).area < 0) {
        std::reverse(outline.begin() + 1, outline.end());
    }
}

std::string gap_in_words(const std::vector<LineChain>& chains, double unit) {
    constexpr std::size_t most_compared = 200;
    std::vector<SectionPoint> ends;
    for (const LineChain& chain : chains) {
        if (!chain.closed) {
            ends.push_back(chain.point.front());
            ends.push_back(chain.point.back());
        }
    }
    if (ends.size() < 2 || ends.size() > most_compared) {
        return {};
    }
    double narrowest = std::numeric_limits<double>::infinity();
    std::pair<SectionPoint, SectionPoint> gap{ends[0], ends[1]};
    for (std::size_t one = 0; one < ends.size(); ++one) {
        for (std::size_t other = one + 1; other < ends.size(); ++other) {
            const double width = std::hypot(ends[one].x - ends[other].x, ends[one].y - ends[other].y);
            const bool same_line = one / 2 == other / 2;
            if (width < narrowest && (!same_line || chains.size() == 1)) {
                narrowest = width;
                gap = {ends[one], ends[other]};
            }
        }
    }
    const auto length = [&](double value) { return readable_quantity(unit * value, Dimension::length); };
    const auto place = [&](const SectionPoint& point) { return "x = " + length(point.x) + ", y = " + length(point.y); };
    return length(narrowest) + " wide, from " + place(gap.first) + " to " + place(gap.second);
}

}  // namespace delabole
