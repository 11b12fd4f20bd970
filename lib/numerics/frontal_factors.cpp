#include "numerics/frontal_factors.hpp"

#include "numerics/lanes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <type_traits>
#include <utility>

namespace delabole {

namespace {

constexpr std::size_t none = static_cast<std::size_t>(-1);

// Groups that are eliminated together, and the other groups that their elimination affects, by their places in the
// order.
struct Set {
    std::vector<int> pivots;
    std::vector<int> others;  // in increasing order
    std::size_t parent = none;
    bool merged = false;
};

// Each group with those that its elimination affects, all by places in the order.
std::vector<Set> sets_of_one(const std::vector<std::vector<int>>& neighbours, std::span<const int> order) {
    const std::size_t groups = order.size();
    std::vector<int> place(groups);
    for (std::size_t at = 0; at < groups; ++at) {
        place[static_cast<std::size_t>(order[at])] = static_cast<int>(at);
    }
    std::vector<Set> sets(groups);
    std::vector<std::vector<std::size_t>> below(groups);
    std::vector<std::size_t> noticed(groups, none);
    for (std::size_t at = 0; at < groups; ++at) {
        Set& set = sets[at];
        set.pivots = {static_cast<int>(at)};
        noticed[at] = at;
        const auto notice = [&](int other) {
            if (other > static_cast<int>(at) && std::exchange(noticed[static_cast<std::size_t>(other)], at) != at) {
                set.others.push_back(other);
            }
        };
        for (const int neighbour : neighbours[static_cast<std::size_t>(order[at])]) {
            notice(place[static_cast<std::size_t>(neighbour)]);
        }
        for (const std::size_t child : below[at]) {
            for (const int other : sets[child].others) {
                notice(other);
            }
        }
        std::ranges::sort(set.others);
        if (!set.others.empty()) {
            set.parent = static_cast<std::size_t>(set.others.front());
            below[set.parent].push_back(at);
        }
    }
    return sets;
}

// Merges a set into the set above it if they have few groups or nearly the same neighbours, so that one larger matrix
// with some zeros costs less. The loop goes from the bottom upwards.
void merge(std::vector<Set>& sets) {
    constexpr std::size_t few = 4;
    constexpr double most_zeros = 0.15;  // of the pivots' columns
    std::vector<std::size_t> zeros(sets.size(), 0);
    for (std::size_t at = 0; at < sets.size(); ++at) {
        Set& set = sets[at];
        if (set.parent == none) {
            continue;
        }
        Set& parent = sets[set.parent];
        const std::size_t pivots = set.pivots.size() + parent.pivots.size();
        const std::size_t added = set.pivots.size() * (parent.pivots.size() + parent.others.size() - set.others.size());
        const std::size_t lacking = zeros[at] + zeros[set.parent] + added;
        const double share =
            static_cast<double>(lacking) / static_cast<double>(pivots * (pivots + parent.others.size()));
        if (added == 0 || pivots <= few || share < most_zeros) {
            parent.pivots.insert(parent.pivots.begin(), set.pivots.begin(), set.pivots.end());
            zeros[set.parent] = lacking;
            set.merged = true;
        }
    }
    for (Set& set : sets) {
        while (set.parent != none && sets[set.parent].merged) {
            set.parent = sets[set.parent].parent;
        }
    }
}

// The remaining sets in an order in which each comes after all sets below it, and the sets below one set are adjacent.
std::vector<std::size_t> from_below(const std::vector<Set>& sets) {
    std::vector<std::size_t> order;
    std::vector<std::size_t> to_visit;
    std::vector<std::vector<std::size_t>> below(sets.size());
    for (std::size_t at = 0; at < sets.size(); ++at) {
        if (!sets[at].merged) {
            (sets[at].parent == none ? to_visit : below[sets[at].parent]).push_back(at);
        }
    }
    while (!to_visit.empty()) {
        const std::size_t at = to_visit.back();
        to_visit.pop_back();
        order.push_back(at);
        to_visit.insert(to_visit.end(), below[at].begin(), below[at].end());
    }
    std::ranges::reverse(order);
    return order;
}

// A part of a dense matrix by columns.
struct Columns {
    double* at;
    std::size_t stride;
};

// Eight numbers, or as many of them as there are rows.
template <bool whole>
DELABOLE_INLINED void load_rows(std::size_t rows, const double* from, EightLanes& to) {
    to = EightLanes{};
    std::memcpy(&to, from, whole ? sizeof(to) : rows * sizeof(double));
}

// Subtracts a product: up to eight rows and some columns of c - a b.
template <std::size_t columns, bool whole>
DELABOLE_INLINED void subtract_tile(std::size_t rows, std::size_t inner, const Columns& a, const Columns& b,
                                    const Columns& c) {
    std::array<EightLanes, columns> sum;
    for (std::size_t column = 0; column < columns; ++column) {
        load_rows<whole>(rows, c.at + column * c.stride, sum[column]);
    }
    for (std::size_t k = 0; k < inner; ++k) {
        EightLanes left;
        load_rows<whole>(rows, a.at + k * a.stride, left);
        for (std::size_t column = 0; column < columns; ++column) {
            sum[column] -= left * b.at[k + column * b.stride];
        }
    }
    for (std::size_t column = 0; column < columns; ++column) {
        std::memcpy(c.at + column * c.stride, &sum[column], whole ? sizeof(EightLanes) : rows * sizeof(double));
    }
}

// Computes c - a b; a has `rows` rows and `inner` columns.
DELABOLE_INLINED void subtract_product(std::size_t rows, std::size_t columns, std::size_t inner, const Columns& a,
                                       const Columns& b, const Columns& c) {
    constexpr std::size_t wide = 4;
    constexpr std::size_t high = lane_count<EightLanes>;
    for (std::size_t row = 0; row < rows; row += high) {
        const std::size_t left = std::min(high, rows - row);
        const Columns of_a{a.at + row, a.stride};
        const auto subtract = [&]<bool whole>(std::bool_constant<whole>) __attribute__((always_inline)) {
            std::size_t column = 0;
            for (; column + wide <= columns; column += wide) {
                subtract_tile<wide, whole>(left, inner, of_a, {b.at + column * b.stride, b.stride},
                                           {c.at + row + column * c.stride, c.stride});
            }
            for (; column < columns; ++column) {
                subtract_tile<1, whole>(left, inner, of_a, {b.at + column * b.stride, b.stride},
                                        {c.at + row + column * c.stride, c.stride});
            }
        };
        if (left == high) {
            subtract(std::true_type{});
        } else {
            subtract(std::false_type{});
        }
    }
}

// Solves rows `begin` to `end` of the columns from which the pivots from `begin` to `end` are eliminated.
DELABOLE_INLINED void solve_lower(std::size_t begin, std::size_t end, std::size_t columns, const Columns& lower,
                                  const Columns& right) {
    for (std::size_t column = 0; column < columns; ++column) {
        double* const to = right.at + column * right.stride;
        for (std::size_t pivot = begin; pivot < end; ++pivot) {
            const double by = to[pivot];
            const double* const from = lower.at + pivot * lower.stride;
            for (std::size_t row = pivot + 1; row < end; ++row) {
                to[row] -= by * from[row];
            }
        }
    }
}

struct DenseFront {
    std::size_t pivots;
    std::size_t others;
    Columns lower;
    Columns upper;
    Columns rest;
    int* exchanged;
};

// Eliminates the pivots `begin` to `end` in their own columns.
DELABOLE_INLINED bool eliminate_columns(const DenseFront& front, std::size_t begin, std::size_t end) {
    // Rows are not exchanged unless entries would grow otherwise.
    constexpr double large_enough = 0.1;
    const std::size_t rows = front.pivots + front.others;
    const Columns& lower = front.lower;
    for (std::size_t pivot = begin; pivot < end; ++pivot) {
        double* const column = lower.at + pivot * lower.stride;
        std::size_t best = pivot;
        for (std::size_t row = pivot + 1; row < front.pivots; ++row) {
            best = std::abs(column[row]) > std::abs(column[best]) ? row : best;
        }
        best = std::abs(column[pivot]) >= large_enough * std::abs(column[best]) ? pivot : best;
        front.exchanged[pivot] = static_cast<int>(best);
        if (best != pivot) {
            for (std::size_t other = 0; other < front.pivots; ++other) {
                std::swap(lower.at[pivot + other * lower.stride], lower.at[best + other * lower.stride]);
            }
            for (std::size_t other = 0; other < front.others; ++other) {
                std::swap(front.upper.at[pivot + other * front.upper.stride],
                          front.upper.at[best + other * front.upper.stride]);
            }
        }
        const double inverse = 1 / column[pivot];
        if (!std::isfinite(inverse) || !std::isfinite(column[pivot])) {
            return false;
        }
        for (std::size_t row = pivot + 1; row < rows; ++row) {
            column[row] *= inverse;
        }
        for (std::size_t other = pivot + 1; other < end; ++other) {
            double* const to = lower.at + other * lower.stride;
            const double by = to[pivot];
            for (std::size_t row = pivot + 1; row < rows; ++row) {
                to[row] -= by * column[row];
            }
        }
    }
    return true;
}

DELABOLE_FOR_EACH_PROCESSOR
bool eliminate_pivots(const DenseFront& front) {
    constexpr std::size_t at_once = 12;
    const std::size_t rows = front.pivots + front.others;
    const auto part = [](const Columns& columns, std::size_t row, std::size_t column) __attribute__((always_inline)) {
        return Columns{columns.at + row + column * columns.stride, columns.stride};
    };
    for (std::size_t begin = 0; begin < front.pivots; begin += at_once) {
        const std::size_t end = std::min(begin + at_once, front.pivots);
        if (!eliminate_columns(front, begin, end)) {
            return false;
        }
        const Columns right = part(front.lower, 0, end);
        solve_lower(begin, end, front.pivots - end, front.lower, right);
        subtract_product(rows - end, front.pivots - end, end - begin, part(front.lower, end, begin),
                         part(right, begin, 0), part(right, end, 0));
        solve_lower(begin, end, front.others, front.lower, front.upper);
        subtract_product(front.pivots - end, front.others, end - begin, part(front.lower, end, begin),
                         part(front.upper, begin, 0), part(front.upper, end, 0));
    }
    subtract_product(front.others, front.others, front.pivots, part(front.lower, front.pivots, 0), front.upper,
                     front.rest);
    return true;
}

DELABOLE_FOR_EACH_PROCESSOR
void subtract_multiple(std::size_t count, double by, const double* from, double* to) {
    for (std::size_t row = 0; row < count; ++row) {
        to[row] -= by * from[row];
    }
}

}  // namespace

FrontalFactors::FrontalFactors(const SparsePattern& pattern, int width, std::span<const int> order) {
    const auto wide = static_cast<std::size_t>(width);
    const std::size_t groups = order.size();
    std::vector<std::vector<int>> neighbours(groups);
    for (std::size_t group = 0; group < groups; ++group) {
        const auto begin = static_cast<std::size_t>(pattern.column_begin[wide * group]);
        const auto end = static_cast<std::size_t>(pattern.column_begin[wide * group + 1]);
        for (std::size_t entry = begin; entry < end; entry += wide) {
            neighbours[group].push_back(pattern.row[entry] / width);
        }
    }
    std::vector<Set> sets = sets_of_one(neighbours, order);
    merge(sets);
    const std::vector<std::size_t> from_bottom = from_below(sets);
    std::vector<std::size_t> front_of_set(sets.size(), none);
    std::vector<std::size_t> front_of_group(groups);  // front in which the group is a pivot
    std::size_t numbers = 0;
    std::size_t pivots = 0;
    for (const std::size_t at : from_bottom) {
        const Set& set = sets[at];
        front_of_set[at] = front_.size();
        const Front front{.pivots = wide * set.pivots.size(),
                          .others = wide * set.others.size(),
                          .unknowns = unknown_.size(),
                          .lower = numbers,
                          .upper = numbers + wide * set.pivots.size() * wide * (set.pivots.size() + set.others.size()),
                          .first_pivot = pivots,
                          .in_parent = 0,
                          .parent = front_.size(),
                          .children = 0};
        pivots += front.pivots;
        numbers = front.upper + front.pivots * front.others;
        for (const std::vector<int>* part : {&set.pivots, &set.others}) {
            for (const int place : *part) {
                const int group = order[static_cast<std::size_t>(place)];
                for (int one = 0; one < width; ++one) {
                    unknown_.push_back(width * group + one);
                }
            }
        }
        for (const int place : set.pivots) {
            front_of_group[static_cast<std::size_t>(order[static_cast<std::size_t>(place)])] = front_.size();
        }
        front_.push_back(front);
    }
    for (const std::size_t at : from_bottom) {
        if (sets[at].parent != none) {
            const std::size_t parent = front_of_set[sets[at].parent];
            front_[front_of_set[at]].parent = parent;
            ++front_[parent].children;
        }
    }
    find_places_in_parents(wide * groups);
    find_entries(pattern, wide, front_of_group);
    factor_.resize(numbers);
    exchanged_.resize(wide * groups);
}

// Records the position of each unknown of a front in it; places of other unknowns are left as they are.
void FrontalFactors::note_places(const Front& front, std::vector<std::size_t>& place) const {
    for (std::size_t one = 0; one < front.pivots + front.others; ++one) {
        place[static_cast<std::size_t>(unknown_[front.unknowns + one])] = one;
    }
}

void FrontalFactors::find_places_in_parents(std::size_t unknowns) {
    std::vector<std::size_t> place(unknowns, none);
    for (std::size_t at = 0; at < front_.size(); ++at) {
        Front& front = front_[at];
        if (front.parent != at) {
            note_places(front_[front.parent], place);
            front.in_parent = place_.size();
            for (std::size_t one = 0; one < front.others; ++one) {
                place_.push_back(place[static_cast<std::size_t>(unknown_[front.unknowns + front.pivots + one])]);
            }
        }
    }
}

// `pivot_in`: the front in which each group is a pivot.
void FrontalFactors::find_entries(const SparsePattern& pattern, std::size_t width,
                                  const std::vector<std::size_t>& pivot_in) {
    std::vector<std::size_t> place(width * pivot_in.size(), none);
    for (std::size_t at = 0; at < front_.size(); ++at) {
        const Front& front = front_[at];
        note_places(front, place);
        for (std::size_t one = 0; one < front.pivots + front.others; ++one) {
            const auto column = static_cast<std::size_t>(unknown_[front.unknowns + one]);
            for (auto entry = static_cast<std::size_t>(pattern.column_begin[column]);
                 entry < static_cast<std::size_t>(pattern.column_begin[column + 1]); ++entry) {
                const auto row = static_cast<std::size_t>(pattern.row[entry]);
                // The entry belongs to the front in which the first of the two groups is a pivot.
                if (std::min(pivot_in[row / width], pivot_in[column / width]) != at) {
                    continue;
                }
                entry_.push_back({entry, one < front.pivots
                                             ? front.lower + place[row] + one * (front.pivots + front.others)
                                             : front.upper + place[row] + (one - front.pivots) * front.pivots});
            }
        }
    }
}

// Adds the remainder of a child to the parent's columns and to the parent's own remainder.
void FrontalFactors::take_up(const Front& child, const Front& front, const double* left, double* rest) {
    const std::span<const std::size_t> place(place_.data() + child.in_parent, child.others);
    const auto among_pivots =
        static_cast<std::size_t>(std::lower_bound(place.begin(), place.end(), front.pivots) - place.begin());
    const std::size_t rows = front.pivots + front.others;
    for (std::size_t column = 0; column < child.others; ++column) {
        const double* const from = left + column * child.others;
        if (column < among_pivots) {
            double* const to = factor_.data() + front.lower + place[column] * rows;
            for (std::size_t row = 0; row < child.others; ++row) {
                to[place[row]] += from[row];
            }
            continue;
        }
        const std::size_t other = place[column] - front.pivots;
        double* const to = factor_.data() + front.upper + other * front.pivots;
        for (std::size_t row = 0; row < among_pivots; ++row) {
            to[place[row]] += from[row];
        }
        double* const to_rest = rest + other * front.others - front.pivots;
        for (std::size_t row = among_pivots; row < child.others; ++row) {
            to_rest[place[row]] += from[row];
        }
    }
}

bool FrontalFactors::eliminate(const Front& front, double* rest) {
    return eliminate_pivots({front.pivots,
                             front.others,
                             {factor_.data() + front.lower, front.pivots + front.others},
                             {factor_.data() + front.upper, front.pivots},
                             {rest, front.others},
                             exchanged_.data() + front.first_pivot});
}

bool FrontalFactors::factor(std::span<const double> values) {
    std::ranges::fill(factor_, 0.0);
    for (const Entry& entry : entry_) {
        factor_[entry.to] = values[entry.from];
    }
    // The fronts whose remainders lie on the stack, the last one on top.
    std::vector<std::size_t> waiting;
    stack_.clear();
    for (std::size_t at = 0; at < front_.size(); ++at) {
        const Front& front = front_[at];
        rest_.assign(front.others * front.others, 0.0);
        for (std::size_t child = 0; child < front.children; ++child) {
            const Front& below = front_[waiting.back()];
            waiting.pop_back();
            const std::size_t begin = stack_.size() - below.others * below.others;
            take_up(below, front, stack_.data() + begin, rest_.data());
            stack_.resize(begin);
        }
        if (!eliminate(front, rest_.data())) {
            return false;
        }
        if (front.parent != at) {
            stack_.insert(stack_.end(), rest_.begin(), rest_.end());
            waiting.push_back(at);
        }
    }
    return true;
}

void FrontalFactors::solve(Eigen::VectorXd& vector) {
    const auto value_of = [&](const Front& front, std::size_t one) -> double& {
        return vector(unknown_[front.unknowns + one]);
    };
    const auto gather = [&](const Front& front) {
        gathered_.resize(front.pivots + front.others);
        for (std::size_t one = 0; one < gathered_.size(); ++one) {
            gathered_[one] = value_of(front, one);
        }
    };
    for (const Front& front : front_) {
        gather(front);
        const std::size_t rows = front.pivots + front.others;
        for (std::size_t pivot = 0; pivot < front.pivots; ++pivot) {
            const auto exchanged = static_cast<std::size_t>(exchanged_[front.first_pivot + pivot]);
            std::swap(gathered_[pivot], gathered_[exchanged]);
        }
        for (std::size_t pivot = 0; pivot < front.pivots; ++pivot) {
            const std::size_t below = pivot + 1;
            subtract_multiple(rows - below, gathered_[pivot], factor_.data() + front.lower + pivot * rows + below,
                              gathered_.data() + below);
        }
        for (std::size_t one = 0; one < rows; ++one) {
            value_of(front, one) = gathered_[one];
        }
    }
    for (std::size_t at = front_.size(); at-- > 0;) {
        const Front& front = front_[at];
        gather(front);
        const std::size_t rows = front.pivots + front.others;
        for (std::size_t other = 0; other < front.others; ++other) {
            subtract_multiple(front.pivots, gathered_[front.pivots + other],
                              factor_.data() + front.upper + other * front.pivots, gathered_.data());
        }
        for (std::size_t pivot = front.pivots; pivot-- > 0;) {
            const double* const column = factor_.data() + front.lower + pivot * rows;
            gathered_[pivot] /= column[pivot];
            subtract_multiple(pivot, gathered_[pivot], column, gathered_.data());
            value_of(front, pivot) = gathered_[pivot];
        }
    }
}

}  // namespace delabole
