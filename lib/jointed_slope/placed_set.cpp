#include "jointed_slope/placed_set.hpp"

#include "jointed_slope/counted_random.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace delabole {

namespace {

enum Stream : std::uint64_t { of_spacing = 1, of_traces = 2 };

}  // namespace

StraightLine line_of_dip(double dip) {
    const double size = std::abs(dip);
    const double out = dip < 0 ? -1 : 1;
    return {{out * std::sin(size), -std::cos(size)}, {out * std::cos(size), std::sin(size)}, 0};
}

std::vector<double> joint_positions(const JointSetCut& set, std::uint64_t seed, double first,
                                    const DistanceRange& extent, std::int64_t& number_of_first, SlopeCheck& check) {
    const double scatter = set.scatter.value_or(0);
    const double farthest = std::max(std::abs(extent.lowest - first), std::abs(extent.highest - first));
    std::vector<double> positions;
    if (!(farthest / set.spacing < static_cast<double>(most_slope_blocks))) {
        check = SlopeCheck::too_many_blocks;
        return positions;
    }
    // The spacing between two joints has the number of the upper one.
    const auto spacing_after = [&](std::int64_t number) {
        return set.spacing * (1 + scatter * (2 * counted_uniform(seed, of_spacing, number) - 1));
    };
    // Staggering moves joints by up to one spacing in either direction.
    const double reach = 2 * set.spacing * (1 + scatter);
    number_of_first = 0;
    double position = first;
    while (position > extent.lowest - reach) {
        --number_of_first;
        position -= spacing_after(number_of_first);
    }
    for (std::int64_t number = number_of_first; position < extent.highest + reach; ++number) {
        positions.push_back(position);
        // The joint at the offset is exact, from whichever side the sum approaches it.
        position = number + 1 == 0 ? first : position + spacing_after(number);
    }
    return positions;
}

Reach::Reach(const JointSetCut& set, std::uint64_t seed, Polygon<> region, double snap, double anchor)
    : persistence_(set.persistence.value_or(1)),
      trace_(set.trace_length.value_or(0)),
      seed_(seed),
      region_(std::move(region)),
      snap_(snap),
      anchor_(anchor) {}

double Reach::first_trace(std::int64_t number) const {
    return anchor_ + period() * counted_uniform(seed_, of_traces, number);
}

std::vector<LinePart> Reach::in_region(const StraightLine& line) const {
    std::vector<double> places;
    for (std::size_t index = 0; index < region_.size(); ++index) {
        const PlanePoint<>& a = region_[index];
        const PlanePoint<>& b = region_[(index + 1) % region_.size()];
        const double of_a = line.distance(a);
        const double of_b = line.distance(b);
        if ((of_a > 0) != (of_b > 0)) {
            places.push_back((line.place(a) * std::abs(of_b) + line.place(b) * std::abs(of_a)) /
                             (std::abs(of_a) + std::abs(of_b)));
        }
    }
    std::sort(places.begin(), places.end());
    std::vector<LinePart> parts;
    for (std::size_t index = 0; index + 1 < places.size(); index += 2) {
        parts.push_back({places[index], places[index + 1]});
    }
    return parts;
}

bool Reach::contains(const StraightLine& line, std::int64_t number, double first, double last, double snaps) const {
    const double tolerance = snaps * snap_;
    if (persistence_ < 1) {
        const double begin = first_trace(number);
        const double trace = begin + period() * std::floor((first + tolerance - begin) / period());
        if (!(last - tolerance <= trace + trace_)) {
            return false;
        }
    }
    return region_.empty() || std::ranges::any_of(in_region(line), [&](const LinePart& part) {
               return first > part.begin - tolerance && last < part.end + tolerance;
           });
}

std::vector<LinePart> Reach::parts(const StraightLine& line, std::int64_t number, double first, double last) const {
    const std::vector<LinePart> allowed = region_.empty() ? std::vector<LinePart>{{first, last}} : in_region(line);
    std::vector<LinePart> parts;
    const auto add = [&](double begin, double end) {
        for (const LinePart& part : allowed) {
            const LinePart common{std::max({begin, part.begin, first}), std::min({end, part.end, last})};
            if (common.end - common.begin > least_part * snap_) {
                parts.push_back(common);
            }
        }
    };
    if (persistence_ >= 1) {
        add(first, last);
        return parts;
    }
    if (!(trace_ > least_part * snap_)) {
        return parts;
    }
    const double begin = first_trace(number);
    for (double index = std::floor((first - begin) / period()); begin + index * period() < last; ++index) {
        add(begin + index * period(), begin + index * period() + trace_);
    }
    return parts;
}

}  // namespace delabole
