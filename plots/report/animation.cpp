#include "plots/report/animation.hpp"
#include "fitting/work/words.hpp"

#include "geometry/polygon.hpp"
#include "plots/drawing/extent.hpp"
#include "plots/drawing/svg.hpp"
#include "plots/drawing/text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <string_view>

namespace delabole {

namespace {

constexpr double width = 640;  // px, as in the other figures
constexpr double greatest_height = 560;
constexpr double strip = 64;       // below the scene, for scale bar and legend
constexpr std::size_t many = 100;  // blocks, above which lines are thinner so that they do not hide the colours
constexpr double degree = std::numbers::pi / 180;
constexpr double length_share = 1e-4;  // of the diagonal of the picture
constexpr double angle_unit = 1e-4;    // rad
// In units of length_share and angle_unit: a block that has moved or rotated further is shown at this limit.
constexpr double farthest = 1e7;

constexpr int levels = 16;
constexpr char absent = '-';

// Colours from light to dark, so that a black and white copy can be read as well.
std::string colour_of(int level) {
    constexpr std::array<std::array<double, 3>, 4> stops{
        {{0xf7, 0xf1, 0xdc}, {0xfe, 0xc4, 0x4f}, {0xd9, 0x5f, 0x0e}, {0x7a, 0x1f, 0x05}}};
    const double place = static_cast<double>(level) / (levels - 1) * (stops.size() - 1);
    const auto stop = std::min(static_cast<std::size_t>(place), stops.size() - 2);
    const double share = place - static_cast<double>(stop);
    std::string text = "#";
    for (std::size_t channel = 0; channel < 3; ++channel) {
        const double value = (1 - share) * stops[stop][channel] + share * stops[stop + 1][channel];
        const auto byte = static_cast<unsigned>(std::lround(value));
        constexpr std::string_view digits = "0123456789abcdef";
        text += {digits[byte / 16], digits[byte % 16]};
    }
    return text;
}

constexpr std::string_view colour_of_fixed = "#a9a9a9";

std::string fixed_point(double value, int decimals) {
    std::array<char, 64> buffer{};
    const double shown = value == 0 ? 0 : value;
    const auto end =
        std::to_chars(buffer.data(), buffer.data() + buffer.size(), shown, std::chars_format::fixed, decimals);
    std::string text(buffer.data(), end.ptr);
    if (decimals > 0) {
        text.erase(text.find_last_not_of('0') + 1);
        text.erase(text.find_last_not_of('.') + 1);
    }
    return text == "-0" ? "0" : text;
}

// Encodes the motion in the form that the script reads.
void append_number(std::string& text, int value) {
    constexpr std::string_view alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    unsigned rest = (static_cast<unsigned>(std::abs(value)) << 1U) | (value < 0 ? 1U : 0U);
    do {
        const unsigned digit = rest & 31U;
        rest >>= 5U;
        text += alphabet[digit | (rest > 0 ? 32U : 0U)];
    } while (rest > 0);
}

Point turned(const Point& point, double angle) {
    return {std::cos(angle) * point.x() - std::sin(angle) * point.y(),
            std::sin(angle) * point.x() + std::cos(angle) * point.y()};
}

double finite_or_zero(double value) {
    return std::isfinite(value) ? value : 0;
}

bool can_be_drawn(const AnimatedBlock& block) {
    return block.outline.size() >= 3 &&
           std::ranges::all_of(block.outline, [](const Point& corner) { return corner.allFinite(); });
}

void keep_within(Extent& extent, const Extent& limit, double room) {
    extent.lowest = std::max(extent.lowest, limit.lowest - room);
    extent.highest = std::min(extent.highest, limit.highest + room);
}

struct State {
    std::array<int, 3> pose;
    char level;

    bool operator==(const State&) const = default;
};

class Drawing {
  public:
    explicit Drawing(const BlockAnimation& animation) : animation_(animation) {
        for (const AnimatedBlock& block : animation.blocks) {
            drawn_.push_back(can_be_drawn(block));
            centroid_.push_back(drawn_.back() ? area_properties(block.outline).centroid : Point(0, 0));
        }
        frame_scene();
        for (const AnimationFrame& frame : animation.frames) {
            for (std::size_t block = 0; block < animation.blocks.size(); ++block) {
                if (is_shown(frame, block)) {
                    darkest_ = std::max(darkest_, finite_or_zero(frame.poses[block].colour));
                }
            }
            for (const AnimatedBar& bar : frame.bars) {
                strongest_ = std::max(strongest_, finite_or_zero(bar.force));
            }
        }
    }

    bool empty() const { return animation_.frames.empty() || seen_.empty(); }

    std::string svg() const {
        const AnimationFrame& last = animation_.frames.back();
        const std::string name = "Blocks at " + human_number(last.time, 4) + " s" +
                                 (animation_.outcome.empty() ? "" : ": " + animation_.outcome);
        std::string text = "<svg viewBox=\"0 0 " + fixed_point(width, 0) + " " + fixed_point(height_ + strip, 1) +
                           "\" width=\"100%\" role=\"img\" aria-label=\"" + escape_html(name) + "\">\n";
        const std::string pen = animation_.blocks.size() > many ? "0.6" : "1.2";
        text += "<g class=\"scene\" stroke=\"#1b1b1b\" stroke-width=\"" + pen +
                "\" stroke-linejoin=\"round\" transform=\"" + turn_of(last) + "\">\n";
        for (std::size_t block = 0; block < animation_.blocks.size(); ++block) {
            text += group_of(block, state_of(last, block));
        }
        for (const AnimatedBar& bar : last.bars) {
            text += drawing_of(bar_state_of(bar), last.tilt);
        }
        // A white rectangle hides whatever lies below the scene; it is somewhat higher than needed because pixels are
        // rounded.
        text += "</g>\n<rect y=\"" + fixed_point(height_, 1) + "\" width=\"" + fixed_point(width, 0) + "\" height=\"" +
                fixed_point(2 * strip, 0) + "\" fill=\"#fff\"/>\n";
        return text + scale_bar() + legend() + "</svg>\n";
    }

    bool labelled() const {
        return std::ranges::any_of(animation_.blocks, [](const AnimatedBlock& block) { return !block.label.empty(); });
    }

    std::string moment() const {
        const std::size_t frames = animation_.frames.size();
        const AnimationFrame& last = animation_.frames.back();
        const bool tilts = std::ranges::any_of(animation_.frames, [](const auto& frame) { return frame.tilt != 0; });
        return "time " + human_number(last.time, 4) + " s, " +
               (tilts ? "tilt " + human_number(last.tilt / degree, 4) + "°, " : std::string()) + "frame " +
               std::to_string(frames) + " of " + std::to_string(frames);
    }

    // The data hold only numbers and strings without quotes or markup.
    std::string json() const {
        const std::vector<std::size_t> moving = blocks_that_change();
        std::string times;
        std::string tilts;
        std::string poses;
        std::string level;
        std::string bars;
        std::vector<std::array<int, 3>> before(moving.size(), {0, 0, 0});
        std::vector<BarState> bars_before(animation_.frames.front().bars.size());
        for (const AnimationFrame& frame : animation_.frames) {
            const std::string comma = times.empty() ? "" : ",";
            times += comma + fixed_point(finite_or_zero(frame.time), 6);
            tilts += comma + fixed_point(finite_or_zero(frame.tilt) / degree, 4);
            for (std::size_t index = 0; index < moving.size(); ++index) {
                const State state = state_of(frame, moving[index]);
                // The position of an absent block does not matter; the last one known takes the least space.
                const std::array<int, 3> pose = state.level == absent ? before[index] : state.pose;
                for (std::size_t part = 0; part < 3; ++part) {
                    append_number(poses, pose[part] - before[index][part]);
                }
                before[index] = pose;
                level += state.level;
            }
            for (std::size_t index = 0; index < bars_before.size(); ++index) {
                const BarState state = bar_state_of(frame.bars[index]);
                for (std::size_t part = 0; part < state.size(); ++part) {
                    append_number(bars, state[part] - bars_before[index][part]);
                }
                bars_before[index] = state;
            }
        }
        std::string numbers;
        std::string places;
        for (const std::size_t block : moving) {
            const std::string comma = numbers.empty() ? "" : ",";
            const Point at = on_paper(centroid_[block]);
            numbers += comma + std::to_string(block);
            places += comma + fixed_point(at.x(), 2) + "," + fixed_point(at.y(), 2);
        }
        std::string colours;
        for (int index = 0; index < levels; ++index) {
            colours += (index == 0 ? "\"" : ",\"") + colour_of(index) + "\"";
        }
        const Point pivot = on_paper({0, 0});
        return "{\"times\":[" + times + "],\"tilts\":[" + tilts + "],\"moving\":[" + numbers + "],\"at\":[" + places +
               "],\"pivot\":[" + fixed_point(pivot.x(), 2) + "," + fixed_point(pivot.y(), 2) +
               "],\"length\":" + fixed_point(length_unit_ * scale_, 6) +
               ",\"angle\":" + fixed_point(angle_unit / degree, 9) + ",\"colours\":[" + colours + "],\"poses\":\"" +
               poses + "\",\"levels\":\"" + level + "\",\"bars\":\"" + bars +
               "\",\"force\":" + fixed_point(strongest_ / force_steps, 9) + ",\"unit\":\"" +
               escape_html(animation_.bar_unit) + "\"}";
    }

  private:
    bool is_shown(const AnimationFrame& frame, std::size_t block) const {
        return drawn_[block] && block < frame.poses.size() && frame.poses[block].present &&
               frame.poses[block].displacement.allFinite() && std::isfinite(frame.poses[block].rotation);
    }

    // Includes the corners of a block as seen, with gravity down.
    void include(Frame& box, const AnimationFrame& frame, std::size_t block) const {
        const BlockPose& pose = frame.poses[block];
        for (const Point& corner : animation_.blocks[block].outline) {
            const Point moved = centroid_[block] + pose.displacement + turned(corner - centroid_[block], pose.rotation);
            box.include(turned(moved, finite_or_zero(frame.tilt)));
        }
    }

    // The picture holds all positions of the free blocks within half the extent of the initial scene around it: a block
    // that flies further must not make all others tiny.
    void frame_scene() {
        Frame all;
        for (const AnimationFrame& frame : animation_.frames) {
            for (std::size_t block = 0; block < animation_.blocks.size(); ++block) {
                if (!is_shown(frame, block)) {
                    continue;
                }
                if (&frame == &animation_.frames.front() || all.empty()) {
                    include(all, frame, block);
                }
                if (!animation_.blocks[block].fixed) {
                    include(seen_, frame, block);
                }
            }
        }
        if (seen_.empty()) {
            seen_ = all;
        }
        if (seen_.empty()) {
            return;
        }
        keep_within(seen_.x, all.x, all.x.size() / 2);
        keep_within(seen_.y, all.y, all.y.size() / 2);
        const double margin = 0.1 * seen_.size().maxCoeff();
        for (Extent* extent : {&seen_.x, &seen_.y}) {
            extent->lowest -= margin;
            extent->highest += margin;
        }
        scale_ = std::min(width / seen_.x.size(), greatest_height / seen_.y.size());
        height_ = seen_.y.size() * scale_;
        length_unit_ = length_share * std::hypot(seen_.x.size(), seen_.y.size());
        if (!std::isfinite(scale_) || !(length_unit_ > 0)) {
            seen_ = {};
        }
    }

    // px; the scene stands in the middle of the picture.
    Point on_paper(const Point& point) const {
        const double centre = (seen_.x.lowest + seen_.x.highest) / 2;
        return {width / 2 + (point.x() - centre) * scale_, (seen_.y.highest - point.y()) * scale_};
    }

    State state_of(const AnimationFrame& frame, std::size_t block) const {
        if (!is_shown(frame, block)) {
            return {{0, 0, 0}, absent};
        }
        const auto in_units = [](double value, double unit) {
            return static_cast<int>(std::lround(std::clamp(value / unit, -farthest, farthest)));
        };
        const BlockPose& pose = frame.poses[block];
        const double shade = darkest_ > 0 ? std::max(0.0, finite_or_zero(pose.colour)) / darkest_ : 0;
        constexpr std::string_view digits = "0123456789abcdef";
        return {{in_units(pose.displacement.x(), length_unit_), in_units(pose.displacement.y(), length_unit_),
                 in_units(pose.rotation, angle_unit)},
                digits[static_cast<std::size_t>(std::lround(shade * (levels - 1)))]};
    }

    // The ends of a bar in tenths of a pixel, its force as a share of the greatest, and its state: 0 intact, 1 yielded,
    // 2 not shown.
    using BarState = std::array<int, 6>;
    static constexpr double force_steps = 10'000;

    BarState bar_state_of(const AnimatedBar& bar) const {
        const Point from = on_paper(bar.from);
        const Point to = on_paper(bar.to);
        if (!bar.present || !from.allFinite() || !to.allFinite() || !std::isfinite(bar.force)) {
            return {0, 0, 0, 0, 0, 2};
        }
        const auto whole = [](double value) {
            return static_cast<int>(std::lround(std::clamp(value, -farthest, farthest)));
        };
        return {whole(10 * from.x()),
                whole(10 * from.y()),
                whole(10 * to.x()),
                whole(10 * to.y()),
                whole(strongest_ > 0 ? bar.force / strongest_ * force_steps : 0),
                bar.yielded ? 1 : 0};
    }

    // Must draw the bar as the script does.
    std::string drawing_of(const BarState& bar, double tilt) const {
        const auto& [x1, y1, x2, y2, force, how] = bar;
        const auto pixels = [](int tenths) { return fixed_point(tenths / 10.0, 1); };
        const std::string hidden = how == 2 ? " display=\"none\"" : "";
        const std::string kind = how == 1 ? " yielded" : "";
        std::string text = "<path class=\"bar" + kind + "\" d=\"M" + pixels(x1) + " " + pixels(y1) + "L" + pixels(x2) +
                           " " + pixels(y2) + "\"" + hidden + "/>";
        // The text extends towards the rock, which is inside the picture. It is below a bar that rises in that
        // direction and above one that falls.
        const bool rises = turned(Point(x2 - x1, y1 - y2), finite_or_zero(tilt)).y() > 0;
        text += "<text class=\"force" + kind + "\" text-anchor=\"" + (x2 < x1 ? "end" : "start") + "\" dy=\"" +
                (rises ? "22" : "-8") + "\" transform=\"translate(" + pixels(x1) + " " + pixels(y1) + ") rotate(" +
                fixed_point(finite_or_zero(tilt) / degree, 4) + ")\"" + hidden + ">" +
                human_number(force * strongest_ / force_steps, 4) + " " + escape_html(animation_.bar_unit) +
                (how == 1 ? ", yielded" : "") + "</text>\n";
        return text;
    }

    // Blocks that differ in some frame from the last one, which the page shows first.
    std::vector<std::size_t> blocks_that_change() const {
        std::vector<std::size_t> result;
        for (std::size_t block = 0; block < animation_.blocks.size(); ++block) {
            const State last = state_of(animation_.frames.back(), block);
            if (std::any_of(animation_.frames.begin(), animation_.frames.end(),
                            [&](const AnimationFrame& frame) { return state_of(frame, block) != last; })) {
                result.push_back(block);
            }
        }
        return result;
    }

    std::string turn_of(const AnimationFrame& frame) const {
        const Point pivot = on_paper({0, 0});
        return "rotate(" + fixed_point(-finite_or_zero(frame.tilt) / degree, 4) + " " + fixed_point(pivot.x(), 2) +
               " " + fixed_point(pivot.y(), 2) + ")";
    }

    std::string group_of(std::size_t block, const State& state) const {
        const AnimatedBlock& drawn = animation_.blocks[block];
        const Point at = on_paper(centroid_[block]);
        const double unit = length_unit_ * scale_;
        const auto& [right, up, turn] = state.pose;
        std::string text = "<g transform=\"translate(" + fixed_point(at.x() + right * unit, 2) + " " +
                           fixed_point(at.y() - up * unit, 2) + ") rotate(" +
                           fixed_point(-turn * angle_unit / degree, 3) + ")\"";
        if (state.level == absent) {
            text += " display=\"none\"";
        }
        const int level = state.level == absent ? 0 : state.level <= '9' ? state.level - '0' : state.level - 'a' + 10;
        // The colour is set on the group, because the script changes it there.
        text += " fill=\"" + colour_of(level) + "\">";
        if (!drawn_[block]) {
            return text + "</g>\n";
        }
        Extent span_x;
        Extent span_y;
        std::string path;
        for (const Point& corner : drawn.outline) {
            const Point from_centroid = (corner - centroid_[block]) * scale_;
            path += (path.empty() ? "M" : "L") + fixed_point(from_centroid.x(), 2) + " " +
                    fixed_point(-from_centroid.y(), 2);
            span_x.include(from_centroid.x());
            span_y.include(from_centroid.y());
        }
        text += "<path d=\"" + path + "Z\"";
        if (drawn.fixed) {
            text.append(" fill=\"").append(colour_of_fixed).append("\"");
        }
        text += "/>" + cracks_of(block);
        // The height of the letters is at most half that of the block; labels that would be too small to read are left
        // out.
        constexpr double smallest = 7;
        constexpr double largest = 18;
        const auto letters = static_cast<double>(std::max<std::size_t>(letter_count(drawn.label), 1));
        const double size = std::min({largest, 0.5 * span_y.size(), 1.3 * span_x.size() / letters});
        if (size >= smallest && !drawn.label.empty()) {
            text += "<text class=\"label\" style=\"font-size:" + fixed_point(size, 1) + "px\">" +
                    escape_html(drawn.label) + "</text>";
        }
        return text + "</g>\n";
    }

    std::string cracks_of(std::size_t block) const {
        std::string text;
        for (const AnimatedCrack& crack : animation_.blocks[block].cracks) {
            if (!crack.from.allFinite() || !crack.to.allFinite()) {
                continue;
            }
            const Point from = (crack.from - centroid_[block]) * scale_;
            const Point to = (crack.to - centroid_[block]) * scale_;
            text += "<path class=\"crack\" data-from=\"" + std::to_string(crack.first_frame) + "\" d=\"M" +
                    fixed_point(from.x(), 2) + " " + fixed_point(-from.y(), 2) + "L" + fixed_point(to.x(), 2) + " " +
                    fixed_point(-to.y(), 2) + "\"";
            text += crack.first_frame < animation_.frames.size() ? "/>" : " display=\"none\"/>";
        }
        return text;
    }

    // A scale bar of 1, 2 or 5 times a power of ten, at most a quarter of the width.
    std::string scale_bar() const {
        const DisplayUnit unit = shown_unit(Dimension::length);
        const double scale = scale_ * unit.si_per_unit;
        const double room = width / 4 / scale;
        const double decade = std::pow(10, std::floor(std::log10(room)));
        const double length = room >= 5 * decade ? 5 * decade : room >= 2 * decade ? 2 * decade : decade;
        const std::string y = fixed_point(height_ + 20, 1);
        const std::string right = fixed_point(8 + length * scale, 1);
        return "<path class=\"scale\" d=\"M8 " + fixed_point(height_ + 14, 1) + "V" + y + "H" + right + "V" +
               fixed_point(height_ + 14, 1) +
               "\" fill=\"none\" stroke=\"#1b1b1b\" stroke-width=\"2\"/>\n<text x=\"8\" y=\"" +
               fixed_point(height_ + 44, 1) + "\">" + escape_html(human_number(length, 3)) + " " +
               std::string(unit.symbol) + "</text>\n";
    }

    std::string legend() const {
        if (animation_.colour.empty()) {
            return {};
        }
        constexpr double cell = 16;
        constexpr double left = width - 8 - levels * cell;
        std::string text;
        for (int level = 0; level < levels; ++level) {
            text += "<rect x=\"" + fixed_point(left + level * cell, 1) + "\" y=\"" + fixed_point(height_ + 8, 1) +
                    "\" width=\"" + fixed_point(cell, 0) + "\" height=\"14\" fill=\"" + colour_of(level) + "\"/>";
        }
        const std::string unit = animation_.unit.empty() ? "" : " " + animation_.unit;
        return text + "\n<text x=\"" + fixed_point(left, 1) + "\" y=\"" + fixed_point(height_ + 44, 1) + "\">" +
               escape_html(animation_.colour) + " 0</text>\n<text x=\"" + fixed_point(width - 8, 1) + "\" y=\"" +
               fixed_point(height_ + 44, 1) + "\" text-anchor=\"end\">" +
               escape_html(human_number(darkest_, 3) + unit) + "</text>\n";
    }

    const BlockAnimation& animation_;
    std::vector<bool> drawn_ = {};
    Polyline centroid_ = {};
    Frame seen_ = {};         // m, gravity down
    double scale_ = 1;        // px per m
    double height_ = 0;       // px, of the scene
    double length_unit_ = 1;  // m
    double darkest_ = 0;
    double strongest_ = 0;
};

}  // namespace

std::string animation_html(const BlockAnimation& animation) {
    const Drawing drawing(animation);
    if (drawing.empty()) {
        return "<div class=\"missing\">Animation missing: there is no frame with a block to show</div>\n";
    }
    std::string html = "<div class=\"animation\" role=\"group\" aria-label=\"Animation\">\n" + drawing.svg();
    html += "<p class=\"moment\">" + drawing.moment() + "</p>\n";
    if (!animation.outcome.empty()) {
        html += "<p class=\"moment\">" + escape_html("Outcome: " + animation.outcome) + "</p>\n";
    }
    html +=
        "<div class=\"controls\" hidden>\n<button type=\"button\">Back</button>\n"
        "<button type=\"button\">Play</button>\n<button type=\"button\">Step</button>\n"
        "<input type=\"range\" min=\"0\" max=\"0\" value=\"0\" step=\"1\" aria-label=\"Frame\">\n"
        "<select aria-label=\"Speed\"></select>\n";
    if (drawing.labelled()) {
        html += "<label><input type=\"checkbox\">numbers</label>\n";
    }
    html += "</div>\n";
    return html + "<script type=\"application/json\">" + drawing.json() + "</script>\n</div>\n";
}

}  // namespace delabole
