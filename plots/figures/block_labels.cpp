#include "plots/figures/block_labels.hpp"

#include "plots/drawing/extent.hpp"
#include "plots/drawing/polygon.hpp"
#include "plots/drawing/text.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <utility>

namespace delabole {

namespace {

constexpr double smallest_label = 12;  // px
constexpr double beside_size = 15;     // px

struct Numeral {
    const DrawnBlock* block;
    Point at;
    double size;  // px
    // Which labels remain if there is no room for all of them.
    enum class Thinned { counted, always, never } thinned;
};

class BlockLabels {
  public:
    BlockLabels(const std::vector<DrawnBlock>& blocks, const DrawnAcrossBlocks& across, double metres_per_px)
        : blocks_(blocks), across_(across), metres_per_px_(metres_per_px) {}

    std::vector<Label> labels() const {
        std::vector<Numeral> numerals = all_numerals();
        keep_fixed(numerals);
        std::vector<Numeral> shown = thinned_out(numerals);
        const bool every = shown.size() == numerals.size();
        std::vector<Label> result;
        for (Numeral& numeral : shown) {
            numeral.at = every ? place_of(numeral) : numeral.at;
        }
        // If there is no room for all numbers, the few that hide no velocity arrow would be of no use.
        std::erase_if(shown, [&](const Numeral& numeral) {
            return covers_velocity(place_of_text(numeral)) ||
                   (!every && !across_.velocities.empty() && numeral.block->mode != DrawnMode::fixed);
        });
        if (!every) {
            erase_in_small_blocks(shown);
        }
        for (const Numeral& numeral : shown) {
            result.push_back(label_of(numeral, !every));
        }
        for (const Numeral& numeral : beside(shown)) {
            result.push_back(label_of(numeral, false));
        }
        return result;
    }

  private:
    static Label label_of(const Numeral& numeral, bool boxed) {
        return {.at = numeral.at,
                .text = numeral.block->label,
                .align = Label::Align::centre,
                .boxed = boxed,
                .size = numeral.size / text_height};
    }

    // Leaves out the labels that take most of their blocks, if few do.
    void erase_in_small_blocks(std::vector<Numeral>& shown) const {
        const auto takes_most = [&](const Numeral& numeral) {
            constexpr double most = 0.4;
            return text_size(numeral).prod() > most * std::abs(area_properties(numeral.block->outline).area);
        };
        if (4 * std::ranges::count_if(shown, takes_most) < std::ssize(shown)) {
            std::erase_if(shown, takes_most);
        }
    }

    // Whether a fixed block is long and thin, such as a base.
    bool bar(const DrawnBlock& block) const {
        if (block.mode != DrawnMode::fixed || block.label.empty()) {
            return false;
        }
        double length = 0;
        for (const Point& corner : block.outline) {
            length = std::max(length, (corner - block.outline.front()).norm());
        }
        const double thickness = std::abs(area_properties(block.outline).area) / length;
        return length > 4 * thickness && length > 3 * smallest_label * metres_per_px_;
    }

    // Whether the text does not touch the outline of the block.
    bool fits(const DrawnBlock& block, double size) const {
        const Numeral numeral{&block, centroid_of(block), size, Numeral::Thinned::always};
        return !crosses(widened(place_of_text(numeral)), closed(block.outline));
    }

    bool goes_beside(const DrawnBlock& block) const { return bar(block) && !fits(block, beside_size); }

    // Labels beside long thin blocks, at places where nothing else is drawn.
    std::vector<Numeral> beside(const std::vector<Numeral>& inside_blocks) const {
        std::vector<Numeral> taken = inside_blocks;
        std::vector<Numeral> result;
        for (const DrawnBlock& block : blocks_) {
            if (!goes_beside(block)) {
                continue;
            }
            for (const Point& place : places_beside(block)) {
                const Numeral numeral{&block, place, beside_size, Numeral::Thinned::always};
                if (nothing_drawn(place_of_text(numeral)) &&
                    std::ranges::none_of(taken, [&](const Numeral& other) { return touch(numeral, other); })) {
                    taken.push_back(numeral);
                    result.push_back(numeral);
                    break;
                }
            }
        }
        return result;
    }

    // Places next to the middle, the quarters and the ends of the block's faces; faces that point downwards come first.
    std::vector<Point> places_beside(const DrawnBlock& block) const {
        const Polyline edge = closed(block.outline);
        const double turn = area_properties(block.outline).area < 0 ? -1 : 1;
        std::vector<std::pair<double, Point>> places;
        for (std::size_t face = 1; face < edge.size(); ++face) {
            const Point along = edge[face] - edge[face - 1];
            if (!(along.norm() > 0)) {
                continue;
            }
            const Point outward = turn * Point(along.y(), -along.x()) / along.norm();
            const Point half = 0.5 * text_size({&block, {}, beside_size, Numeral::Thinned::always});
            const double gap = 5 * metres_per_px_ + half.dot(outward.cwiseAbs());
            for (const double share : {0.5, 0.25, 0.75, 0.05, 0.95}) {
                // Long faces come before the short ones at the ends of the block.
                places.emplace_back(outward.y() - along.norm() / (along.norm() + half.norm()),
                                    edge[face - 1] + share * along + gap * outward);
            }
        }
        std::ranges::stable_sort(places, {}, &std::pair<double, Point>::first);
        std::vector<Point> result;
        std::ranges::transform(places, std::back_inserter(result), &std::pair<double, Point>::second);
        return result;
    }

    bool nothing_drawn(const Rectangle& text) const {
        const Rectangle wider = widened(text);
        const Point centre = 0.5 * (text.lowest + text.highest);
        return (wider.lowest.array() >= across_.frame.lowest.array()).all() &&
               (wider.highest.array() <= across_.frame.highest.array()).all() && !crosses(wider, across_.water) &&
               !covers_velocity(wider) &&
               std::ranges::none_of(across_.arrows,
                                    [&](const Arrows::Shaft& arrow) { return crosses(wider, arrow.from, arrow.to); }) &&
               std::ranges::none_of(blocks_, [&](const DrawnBlock& block) {
                   return crosses(wider, closed(block.outline)) || crosses(wider, closed(block.displaced)) ||
                          inside(block.outline, centre);
               });
    }

    // The text with a margin, so that it touches nothing.
    Rectangle widened(const Rectangle& text) const {
        const Point around = Point::Constant(2 * metres_per_px_);
        return {text.lowest - around, text.highest + around};
    }

    bool covers_velocity(const Rectangle& text) const {
        return std::ranges::any_of(across_.velocities,
                                   [&](const Arrows::Shaft& arrow) { return crosses(text, arrow.from, arrow.to); });
    }

    Rectangle place_of_text(const Numeral& numeral) const {
        const Point half = 0.5 * text_size(numeral);
        return {numeral.at - half, numeral.at + half};
    }

    std::vector<Numeral> all_numerals() const {
        std::vector<Numeral> numerals;
        std::vector<double> sizes;
        for (const DrawnBlock& block : blocks_) {
            if (!block.label.empty() && !goes_beside(block)) {
                const double size = fitting_size(block);
                numerals.push_back({&block, centroid_of(block), size, Numeral::Thinned::counted});
                sizes.push_back(size);
            }
        }
        if (sizes.empty()) {
            return {};
        }
        // All labels have the same size, that of the smaller blocks; the smallest quarter of the blocks does not reduce
        // it.
        std::ranges::sort(sizes);
        const double common = std::clamp(sizes[sizes.size() / 4], smallest_label, text_height);
        // If most blocks have room for a label, the others have none, since it would only hide the block.
        if (sizes[sizes.size() / 2] >= smallest_label) {
            std::erase_if(numerals, [](const Numeral& numeral) { return numeral.size < smallest_label; });
        }
        for (Numeral& numeral : numerals) {
            numeral.size = std::clamp(numeral.size, smallest_label, common);
        }
        return numerals;
    }

    // The height is a little less than that of a line, because numbers have no descenders.
    Point text_size(const Numeral& numeral) const {
        return metres_per_px_ *
               Point(letter_width * numeral.size * static_cast<double>(letter_count(numeral.block->label)),
                     0.85 * numeral.size);
    }

    // Greatest height of a text that stays within its block, px.
    double fitting_size(const DrawnBlock& block) const {
        const Point at = centroid_of(block);
        if (bar(block)) {
            // The chords of a sloping bar are long, and yet the text would touch its sides.
            return fits(block, text_height) ? text_height : beside_size;
        }
        const double letters = static_cast<double>(letter_count(block.label)) + 0.4;
        return std::min(chord(block.outline, at, 0) / (letter_width * letters), chord(block.outline, at, 1)) /
               metres_per_px_;
    }

    // A measure of what a text at this place hides or crosses.
    double disturbance(const DrawnBlock& block, const Rectangle& text) const {
        const Point around = Point::Constant(4 * metres_per_px_);  // for the heads of the arrows
        const Rectangle wider{text.lowest - around, text.highest + around};
        double sum = 0;
        sum += crosses(text, closed(block.outline)) ? 3 : 0;
        sum += crosses(text, across_.water) ? 2 : 0;
        for (const Arrows::Shaft& velocity : across_.velocities) {
            sum += crosses(wider, velocity.from, velocity.to) ? 4 : 0;
        }
        for (const Arrows::Shaft& arrow : across_.arrows) {
            sum += crosses(text, arrow.from, arrow.to) ? 4 : crosses(wider, arrow.from, arrow.to) ? 1 : 0;
        }
        for (const DrawnBlock& other : blocks_) {
            sum += crosses(text, closed(other.displaced)) ? 0.5 : 0;
        }
        return sum;
    }

    // The place in the block with the least disturbance, and the one nearest to the centroid among equal places.
    Point place_of(const Numeral& numeral) const {
        constexpr int steps = 16;
        const DrawnBlock& block = *numeral.block;
        const Point half = 0.5 * text_size(numeral);
        Frame frame;
        frame.include(block.outline);
        const Point diagonal = frame.size();
        Point best = numeral.at;
        double least = disturbance(block, {best - half, best + half});
        for (int row = 1; row < steps && least > 0; ++row) {
            for (int column = 1; column < steps; ++column) {
                const Point place = frame.lowest() + Point(column, row).cwiseProduct(diagonal) / steps;
                if (!inside(block.outline, place)) {
                    continue;
                }
                const double badness =
                    disturbance(block, {place - half, place + half}) + (place - numeral.at).norm() / diagonal.norm();
                if (badness < least) {
                    least = badness;
                    best = place;
                }
            }
        }
        return best;
    }

    // Keeps the numbers of the largest fixed blocks, as far as they do not overlap. Other labels that overlap these are
    // removed before any are thinned out.
    void keep_fixed(std::vector<Numeral>& numerals) const {
        std::vector<Numeral*> fixed;
        for (Numeral& numeral : numerals) {
            if (numeral.block->mode == DrawnMode::fixed) {
                fixed.push_back(&numeral);
            }
        }
        std::ranges::stable_sort(fixed, std::greater{}, [](const Numeral* numeral) {
            return std::abs(area_properties(numeral->block->outline).area);
        });
        std::vector<Numeral*> kept;
        for (Numeral* numeral : fixed) {
            if (std::ranges::none_of(kept, [&](const Numeral* other) { return touch(*numeral, *other); })) {
                kept.push_back(numeral);
            }
        }
        for (Numeral& numeral : numerals) {
            if (std::ranges::any_of(kept, [&](const Numeral* other) { return touch(numeral, *other); })) {
                numeral.thinned = Numeral::Thinned::never;
            }
        }
        for (Numeral* numeral : kept) {
            numeral->thinned = Numeral::Thinned::always;
        }
    }

    // Keeps as many labels as do not overlap.
    std::vector<Numeral> thinned_out(const std::vector<Numeral>& numerals) const {
        std::vector<Numeral> shown = numerals;
        for (const std::size_t step : {2, 5, 10, 20, 50, 100, 200, 500, 1000}) {
            if (apart(shown)) {
                break;
            }
            shown.clear();
            for (std::size_t index = 0; index < numerals.size(); ++index) {
                // 1, 3, 5, ... for step 2, otherwise 1, 5, 10, ...
                const bool counts = step == 2 ? index % 2 == 0 : index == 0 || (index + 1) % step == 0;
                const Numeral& numeral = numerals[index];
                if (numeral.thinned == Numeral::Thinned::counted ? counts
                                                                 : numeral.thinned == Numeral::Thinned::always) {
                    shown.push_back(numeral);
                }
            }
        }
        return shown;
    }

    bool apart(const std::vector<Numeral>& numerals) const {
        const auto neighbours_touch = [this](const Numeral& one, const Numeral& next) { return touch(one, next); };
        return std::ranges::adjacent_find(numerals, neighbours_touch) == numerals.end();
    }

    bool touch(const Numeral& one, const Numeral& other) const {
        const Point distance = (one.at - other.at).cwiseAbs();
        const Point needed = 1.2 * 0.5 * (text_size(one) + text_size(other));
        return (distance.array() < needed.array()).all();
    }

    const std::vector<DrawnBlock>& blocks_;
    const DrawnAcrossBlocks& across_;
    double metres_per_px_;
};

}  // namespace

Point centroid_of(const DrawnBlock& block) {
    return area_properties(block.outline).centroid;
}

std::vector<Label> block_labels(const std::vector<DrawnBlock>& blocks, const DrawnAcrossBlocks& across,
                                double metres_per_px) {
    return BlockLabels(blocks, across, metres_per_px).labels();
}

}  // namespace delabole
