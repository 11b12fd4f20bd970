#include "plots/drawing/contour.hpp"

#include <compare>
#include <limits>
#include <map>
#include <utility>

namespace delabole {

namespace {

// A side of a cell, by the grid point it starts from: along x (horizontal) or along y.
struct Side {
    Eigen::Index row;
    Eigen::Index column;
    bool horizontal;

    auto operator<=>(const Side& other) const = default;
};

class Grid {
  public:
    Grid(const std::vector<double>& x_values, const std::vector<double>& y_values, const Eigen::MatrixXd& values,
         double level)
        : x_values_(x_values), y_values_(y_values), values_(values), level_(level) {}

    std::vector<std::pair<Side, Side>> segments() const {
        std::vector<std::pair<Side, Side>> result;
        for (Eigen::Index row = 0; row + 1 < values_.rows(); ++row) {
            for (Eigen::Index column = 0; column + 1 < values_.cols(); ++column) {
                add_cell(row, column, result);
            }
        }
        return result;
    }

    Point crossing(const Side& side) const {
        const Eigen::Index next_row = side.row + (side.horizontal ? 0 : 1);
        const Eigen::Index next_column = side.column + (side.horizontal ? 1 : 0);
        const double first = values_(side.row, side.column);
        const double second = values_(next_row, next_column);
        const double share = (level_ - first) / (second - first);
        return (1 - share) * at(side.row, side.column) + share * at(next_row, next_column);
    }

  private:
    Point at(Eigen::Index row, Eigen::Index column) const {
        return {x_values_[static_cast<std::size_t>(column)], y_values_[static_cast<std::size_t>(row)]};
    }

    bool above(Eigen::Index row, Eigen::Index column) const { return values_(row, column) >= level_; }

    void add_cell(Eigen::Index row, Eigen::Index column, std::vector<std::pair<Side, Side>>& result) const {
        if (!values_.block<2, 2>(row, column).allFinite()) {
            return;
        }
        const Side bottom{row, column, true};
        const Side top{row + 1, column, true};
        const Side left{row, column, false};
        const Side right{row, column + 1, false};
        const bool lower_left = above(row, column);
        const bool lower_right = above(row, column + 1);
        const bool upper_left = above(row + 1, column);
        const bool upper_right = above(row + 1, column + 1);

        std::vector<Side> crossed;
        if (lower_left != lower_right) {
            crossed.push_back(bottom);
        }
        if (lower_right != upper_right) {
            crossed.push_back(right);
        }
        if (upper_right != upper_left) {
            crossed.push_back(top);
        }
        if (upper_left != lower_left) {
            crossed.push_back(left);
        }
        if (crossed.size() == 2) {
            result.emplace_back(crossed[0], crossed[1]);
        } else if (crossed.size() == 4) {
            const bool middle = values_.block<2, 2>(row, column).mean() >= level_;
            if (middle == lower_left) {  // the corners lower right and upper left are cut off
                result.emplace_back(bottom, right);
                result.emplace_back(top, left);
            } else {
                result.emplace_back(left, bottom);
                result.emplace_back(right, top);
            }
        }
    }

    const std::vector<double>& x_values_;
    const std::vector<double>& y_values_;
    const Eigen::MatrixXd& values_;
    double level_;
};

}  // namespace

std::vector<Polyline> contour_lines(const std::vector<double>& x_values, const std::vector<double>& y_values,
                                    const Eigen::MatrixXd& values, double level) {
    if (values.cols() != static_cast<Eigen::Index>(x_values.size()) ||
        values.rows() != static_cast<Eigen::Index>(y_values.size())) {
        return {};
    }
    const Grid grid(x_values, y_values, values, level);
    const std::vector<std::pair<Side, Side>> segments = grid.segments();
    std::multimap<Side, std::size_t> touching;
    for (std::size_t index = 0; index < segments.size(); ++index) {
        touching.emplace(segments[index].first, index);
        touching.emplace(segments[index].second, index);
    }

    std::vector<bool> used(segments.size(), false);
    const auto walk = [&](std::size_t start, Side from) {
        Polyline chain{grid.crossing(from)};
        for (std::size_t index = start; index < segments.size();) {
            used[index] = true;
            from = segments[index].first == from ? segments[index].second : segments[index].first;
            chain.push_back(grid.crossing(from));
            index = segments.size();
            const auto [begin, end] = touching.equal_range(from);
            for (auto neighbour = begin; neighbour != end; ++neighbour) {
                if (!used[neighbour->second]) {
                    index = neighbour->second;
                }
            }
        }
        return chain;
    };

    std::vector<Polyline> chains;
    // Open polylines are followed first, from an end; the others are closed and may begin anywhere.
    for (const bool open : {true, false}) {
        for (std::size_t index = 0; index < segments.size(); ++index) {
            for (const Side& end : {segments[index].first, segments[index].second}) {
                if (!used[index] && (!open || touching.count(end) == 1)) {
                    chains.push_back(walk(index, end));
                }
            }
        }
    }
    return chains;
}

Polyline broken_line(const std::vector<Polyline>& chains) {
    constexpr double gap = std::numeric_limits<double>::quiet_NaN();
    Polyline line;
    for (const Polyline& chain : chains) {
        if (!line.empty()) {
            line.emplace_back(gap, gap);
        }
        line.insert(line.end(), chain.begin(), chain.end());
    }
    return line;
}

}  // namespace delabole
