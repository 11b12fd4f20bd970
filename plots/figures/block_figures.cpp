#include "plots/figures/block_figures.hpp"
#include "fitting/work/words.hpp"

#include "plots/drawing/contour.hpp"
#include "plots/drawing/extent.hpp"
#include "plots/drawing/gnuplot_words.hpp"
#include "plots/drawing/polygon.hpp"
#include "plots/drawing/text.hpp"
#include "plots/figures/block_labels.hpp"
#include "plots/figures/mode_style.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace delabole {

namespace {

constexpr double plot_width = 620;            // px
constexpr double greatest_plot_height = 680;  // px
// Length of the arrow of the greatest force, px; less if the blocks are closer together.
constexpr double longest_arrow = 85;
constexpr double shortest_arrow = 40;
// Least length of an arrow; a shorter one would be hidden by its head.
constexpr double visible_arrow = 18;

double metres_per_px(const Frame& frame) {
    return std::max(frame.x.size() / plot_width, frame.y.size() / greatest_plot_height);
}

// Moves a drawing to its elevation and removes what cannot be drawn.
BlockDrawing prepared(BlockDrawing drawing) {
    const auto prepare = [&](Polyline& line) {
        std::erase_if(line, [](const Point& point) { return !point.allFinite(); });
        line = raised(std::move(line), drawing.toe_elevation);
    };
    for (DrawnBlock& block : drawing.blocks) {
        prepare(block.outline);
        prepare(block.displaced);
    }
    std::erase_if(drawing.blocks, [](const DrawnBlock& block) { return block.outline.size() < 3; });
    for (Polyline* line : {&drawing.base, &drawing.ground, &drawing.water, &drawing.tension_crack}) {
        prepare(*line);
    }
    std::erase_if(drawing.forces, [](const DrawnForce& force) {
        return !force.at.allFinite() || !force.force.allFinite() || force.force.norm() == 0;
    });
    for (DrawnForce& force : drawing.forces) {
        force.at.y() += drawing.toe_elevation;
    }
    for (Arrows::Shaft& velocity : drawing.velocities.shafts) {
        velocity.from.y() += drawing.toe_elevation;
        velocity.to.y() += drawing.toe_elevation;
    }
    for (std::vector<DrawnCrack>* cracks : {&drawing.broken, &drawing.open_joints}) {
        std::erase_if(*cracks,
                      [](const DrawnCrack& crack) { return !crack.from.allFinite() || !crack.to.allFinite(); });
        for (DrawnCrack& crack : *cracks) {
            crack.from.y() += drawing.toe_elevation;
            crack.to.y() += drawing.toe_elevation;
        }
    }
    return drawing;
}

class BlockPicture {
  public:
    explicit BlockPicture(const BlockDrawing& drawing) : drawing_(prepared(drawing)) {}

    Figure draw() {
        const bool from_toe = reaches_origin();
        figure_ = {.title = drawing_.title,
                   .x = {.title = from_toe ? "distance from the toe" : "x", .unit = "m", .grid = false},
                   .y = {.title = from_toe && drawing_.toe_elevation == 0 ? "height above the toe" : "elevation",
                         .unit = "m",
                         .grid = false},
                   .equal_scales = true,
                   .width = static_cast<int>(plot_width) + 100};
        measure();
        place_force_key();
        add_rock();
        add_blocks();
        add_line(figure_, {.points = drawing_.base});
        add_line(figure_, {.points = drawing_.ground, .legend = "ground surface"});
        add_line(figure_, {drawing_.tension_crack, "tension crack", Colour::purple, Dash::dashed, 4});
        add_cracks(drawing_.open_joints, "open joint", Colour::blue, 2.5);
        add_cracks(drawing_.broken, "broken rock", Colour::vermilion, 4);
        add_water();
        add_forces();
        if (!drawing_.velocities.shafts.empty()) {
            figure_.series.emplace_back(drawing_.velocities);
        }
        std::ranges::move(
            block_labels(
                drawing_.blocks,
                {drawing_.water, across_labels(), drawing_.velocities.shafts, {frame_.lowest(), frame_.highest()}},
                metres_per_px_),
            std::back_inserter(figure_.labels));
        figure_.x.range = std::pair{frame_.x.lowest, frame_.x.highest};
        figure_.y.range = std::pair{frame_.y.lowest, frame_.y.highest};
        // The numbers of the vertical axis take about 35 px of the width, and a wide picture so much of its height; a
        // title of two lines and the horizontal axis need about 165 px of the height.
        const double height_at_full_width = (plot_width - 35) * frame_.y.size() / frame_.x.size();
        figure_.height =
            static_cast<int>(std::max(std::min(frame_.y.size() / metres_per_px_, height_at_full_width), 150.0)) + 165;
        return std::move(figure_);
    }

  private:
    std::vector<const Polyline*> lines() const {
        return {&drawing_.base, &drawing_.ground, &drawing_.water, &drawing_.tension_crack};
    }

    // Whether the toe may be the origin: the blocks of a section that was drawn in the coordinates of a survey lie far
    // from it.
    bool reaches_origin() const {
        Frame drawn;
        for (const DrawnBlock& block : drawing_.blocks) {
            drawn.include(block.outline);
        }
        const double near = 0.01 * std::max(drawn.x.size(), drawn.y.size());
        const auto holds = [&](const Extent& extent, double value) {
            return extent.lowest - near <= value && value <= extent.highest + near;
        };
        return drawn.empty() || (holds(drawn.x, 0) && holds(drawn.y, drawing_.toe_elevation));
    }

    // A base may extend far beyond the blocks on it; only the part within the surroundings of the free blocks is shown.
    void include_fixed_blocks() {
        constexpr double surroundings = 0.5;  // of the extent of the free blocks
        const Frame free = frame_;
        const double room = surroundings * std::max(free.x.size(), free.y.size());
        for (const DrawnBlock& block : drawing_.blocks) {
            if (block.mode != DrawnMode::fixed) {
                continue;
            }
            Polyline shown = block.outline;
            for (Point& point : shown) {
                if (!free.x.empty()) {
                    point = {std::clamp(point.x(), free.x.lowest - room, free.x.highest + room),
                             std::clamp(point.y(), free.y.lowest - room, free.y.highest + room)};
                }
            }
            frame_.include(shown);
        }
    }

    // The scale of the forces follows from the frame without them; their arrows may then enlarge the frame.
    void measure() {
        for (const DrawnBlock& block : drawing_.blocks) {
            if (block.mode != DrawnMode::fixed) {
                frame_.include(block.outline);
                frame_.include(block.displaced);
            }
        }
        include_fixed_blocks();
        for (const Polyline* line : lines()) {
            frame_.include(*line);
        }
        for (const DrawnForce& force : drawing_.forces) {
            frame_.include(force.at);
            greatest_force_ = std::max(greatest_force_, force.force.norm());
        }
        if (!(std::max(frame_.x.size(), frame_.y.size()) > 0)) {
            const Point around(1, 1);
            const Point only = frame_.lowest();
            frame_.include(frame_.empty() ? Polyline{{0, 0}, around} : Polyline{only - around, only + around});
        }
        if (greatest_force_ > 0) {
            metres_per_newton_ = greatest_arrow() / greatest_force_;
            least_arrow_ = std::min(visible_arrow * metres_per_px(frame_), greatest_arrow());
        }
        chains_ = as_chains();
        for (const DrawnForce& force : drawing_.forces) {
            const Arrows::Shaft shaft = shaft_of(force);
            frame_.include(Polyline{shaft.from, shaft.to});
        }
        for (const Arrows::Shaft& velocity : drawing_.velocities.shafts) {
            frame_.include(Polyline{velocity.from, velocity.to});
        }
        Extent surface;
        for (const Polyline* line : {&drawing_.base, &drawing_.ground}) {
            for (const Point& point : *line) {
                surface.include(point.x());
            }
        }
        const double margin = 0.06 * std::max(frame_.x.size(), frame_.y.size());
        frame_.y = {frame_.y.lowest - margin, frame_.y.highest + margin};
        // The lines of the base and the ground are cut off at the sides of the frame.
        frame_.x = {frame_.x.lowest - (surface.lowest > frame_.x.lowest ? margin : 0),
                    frame_.x.highest + (surface.highest < frame_.x.highest ? margin : 0)};
        // The axis must be wide enough for its numbers even for a single slender block.
        const double widening = 0.5 * (0.6 * frame_.y.size() - frame_.x.size());
        if (widening > 0) {
            frame_.x = {frame_.x.lowest - widening, frame_.x.highest + widening};
        }
        metres_per_px_ = metres_per_px(frame_);
    }

    // About one and a half times the spacing of the blocks, m, so that the arrows of neighbours do not join into a
    // chain.
    double greatest_arrow() const {
        std::vector<double> spacing;
        for (std::size_t index = 1; index < drawing_.blocks.size(); ++index) {
            spacing.push_back((centroid_of(drawing_.blocks[index]) - centroid_of(drawing_.blocks[index - 1])).norm());
        }
        if (spacing.empty()) {
            return longest_arrow * metres_per_px(frame_);
        }
        std::sort(spacing.begin(), spacing.end());
        return std::clamp(1.5 * spacing[spacing.size() / 2], shortest_arrow * metres_per_px(frame_),
                          longest_arrow * metres_per_px(frame_));
    }

    // Whether the heads of arrows would cover the blocks: if there is less area for each force than the square of a
    // head and its surroundings.
    bool as_chains() {
        constexpr double least_area = 22 * 22;  // px2
        double area = 0;
        std::size_t blocks = 0;
        for (const DrawnBlock& block : drawing_.blocks) {
            if (block.mode != DrawnMode::fixed) {
                area += std::abs(area_properties(block.outline).area);
                ++blocks;
            }
        }
        const double px = metres_per_px(frame_);
        if (blocks == 0 || area >= least_area * px * px * static_cast<double>(drawing_.forces.size())) {
            return false;
        }
        block_size_ = std::sqrt(area / static_cast<double>(blocks));
        return true;
    }

    // The shaft of an arrow, or a link of a chain: through the contact, as long as a block is wide.
    Arrows::Shaft shaft_of(const DrawnForce& force) const {
        if (chains_) {
            const Point half = 0.5 * block_size_ * force.force.normalized();
            return {force.at - half, force.at + half};
        }
        const double size = force.force.norm();
        const double length = std::max(metres_per_newton_ * size, least_arrow_);
        return {force.at, force.at + length / size * force.force};
    }

    std::vector<Arrows::Shaft> across_labels() const {
        std::vector<Arrows::Shaft> result;
        for (const DrawnForce& force : drawing_.forces) {
            result.push_back(shaft_of(force));
        }
        if (greatest_force_ > 0) {
            result.push_back({key_.from, key_end_});
        }
        return result;
    }

    bool free(const Rectangle& place) const {
        const Point centre = 0.5 * (place.lowest + place.highest);
        for (const DrawnBlock& block : drawing_.blocks) {
            if (crosses(place, closed(block.outline)) || inside(block.outline, centre) ||
                crosses(place, closed(block.displaced))) {
                return false;
            }
        }
        const std::vector<const Polyline*> others = lines();
        return std::none_of(others.begin(), others.end(),
                            [&](const Polyline* line) { return crosses(place, *line); }) &&
               std::none_of(drawing_.forces.begin(), drawing_.forces.end(),
                            [&](const DrawnForce& force) {
                                const Arrows::Shaft shaft = shaft_of(force);
                                return crosses(place, shaft.from, shaft.to);
                            }) &&
               std::none_of(drawing_.velocities.shafts.begin(), drawing_.velocities.shafts.end(),
                            [&](const Arrows::Shaft& velocity) { return crosses(place, velocity.from, velocity.to); });
    }

    // The key stands in a corner that is free of blocks, lines and forces, or else above everything.
    void place_force_key() {
        if (!(greatest_force_ > 0)) {
            return;
        }
        const double unit = shown_unit(Dimension::force_per_length).si_per_unit;
        const double force = tick_step(0.5 * greatest_force_ / unit, 1);
        key_force_ = force * unit;
        const double arrow = chains_ ? shortest_arrow * metres_per_px_ : key_force_ * metres_per_newton_;
        const std::string text =
            human_number(force, 6) + " " + human_unit(shown_unit(Dimension::force_per_length).symbol);
        const double gap = 10 * metres_per_px_;
        const Point size{
            arrow + gap + letter_width * text_height * static_cast<double>(letter_count(text)) * metres_per_px_,
            1.3 * text_height * metres_per_px_};
        const Point inner_lowest = Point(frame_.x.lowest + gap, frame_.y.lowest + gap);
        const Point inner_highest = Point(frame_.x.highest - gap, frame_.y.highest - gap) - size;
        Point place{inner_lowest.x(), frame_.y.highest + 0.5 * gap};
        bool found = false;
        for (const Point& corner : {Point(inner_lowest.x(), inner_highest.y()), inner_highest,
                                    Point(inner_highest.x(), inner_lowest.y()), inner_lowest}) {
            const Point around(gap, gap);
            if (!found && free({corner - around, corner + size + around})) {
                place = corner;
                found = true;
            }
        }
        if (!found) {
            frame_.y.highest += size.y() + 1.5 * gap;
        }
        key_end_ = {place.x() + size.x(), place.y() + 0.5 * size.y()};
        key_ = {{place.x(), place.y() + 0.5 * size.y()}, {place.x() + arrow, place.y() + 0.5 * size.y()}};
        figure_.labels.push_back({.at = {key_.to.x() + gap, key_.to.y()}, .text = text, .boxed = false});
    }

    void add_rock() {
        if (drawing_.base.size() >= 2) {
            Polyline rock = drawing_.base;
            rock.emplace_back(rock.back().x(), frame_.y.lowest);
            rock.emplace_back(drawing_.base.front().x(), frame_.y.lowest);
            figure_.series.emplace_back(Region{.outline = rock, .colour = Colour::rock, .opacity = 0.5});
        }
    }

    void add_rocks() {
        constexpr std::array shades{Colour::rock,  Colour::sky,    Colour::orange,
                                    Colour::green, Colour::purple, Colour::vermilion};
        for (std::size_t rock = 0; rock < drawing_.rocks.size(); ++rock) {
            std::string legend = drawing_.rocks[rock];
            for (const DrawnBlock& block : drawing_.blocks) {
                if (block.rock == rock) {
                    figure_.series.emplace_back(Region{.outline = block.outline,
                                                       .legend = std::exchange(legend, ""),
                                                       .colour = shades[rock % shades.size()],
                                                       .opacity = 0.4});
                }
            }
        }
    }

    void add_blocks() {
        add_rocks();
        for (const DrawnMode mode : drawn_modes) {
            std::string legend(word_of(mode));
            for (const DrawnBlock& block : drawing_.blocks) {
                if (block.mode == mode && !block.rock) {
                    figure_.series.emplace_back(Region{.outline = block.outline,
                                                       .legend = std::exchange(legend, ""),
                                                       .colour = style_of(mode).colour,
                                                       .opacity = style_of(mode).opacity});
                }
            }
        }
        std::vector<Polyline> outlines;
        std::vector<Polyline> displaced;
        for (const DrawnBlock& block : drawing_.blocks) {
            outlines.push_back(closed(block.outline));
            displaced.push_back(closed(block.displaced));
        }
        std::erase_if(displaced, [](const Polyline& outline) { return outline.empty(); });
        // Outlines are thin if there are chains, which run along the joints and have to be seen.
        add_line(figure_, {.points = broken_line(outlines),
                           .colour = chains_ ? Colour::grey : Colour::black,
                           .width = chains_ ? 0.6 : 1.2});
        add_line(figure_, {broken_line(displaced), drawing_.displaced_legend, Colour::vermilion, Dash::dashed, 1.8});
    }

    void add_cracks(const std::vector<DrawnCrack>& cracks, const std::string& legend, Colour colour, double width) {
        std::vector<Polyline> lines;
        for (const DrawnCrack& crack : cracks) {
            lines.push_back({crack.from, crack.to});
        }
        add_line(figure_, {broken_line(lines), legend, colour, Dash::solid, width});
    }

    void add_water() {
        const Polyline& water = drawing_.water;
        add_line(figure_, {.points = water, .legend = "water level", .colour = Colour::blue});
        if (!water.empty()) {
            // The label stands in the middle of the line, away from the small blocks at the toe.
            const std::size_t index = (water.size() - 1) / 2;
            figure_.labels.push_back({.at = 0.5 * (water[index] + water[std::min(index + 1, water.size() - 1)]),
                                      .text = "▽",
                                      .align = Label::Align::centre,
                                      .colour = Colour::blue,
                                      .raise = 0.45,
                                      .boxed = false});
        }
    }

    void add_forces() {
        constexpr std::array kinds{
            std::pair{ForceKind::interblock, Colour::purple}, std::pair{ForceKind::base_reaction, Colour::black},
            std::pair{ForceKind::thrust, Colour::blue},       std::pair{ForceKind::applied, Colour::vermilion},
            std::pair{ForceKind::weight, Colour::green},      std::pair{ForceKind::required, Colour::green}};
        if (chains_) {
            for (const auto& [kind, colour] : kinds) {
                add_chains(kind, colour);
            }
            // The key is a region, because gnuplot cuts the end of a line with a single segment at an angle.
            const Point half(0, 0.5 * chain_width(key_force_) * metres_per_px_);
            figure_.series.emplace_back(
                Region{.outline = {key_.from - half, key_.to - half, key_.to + half, key_.from + half},
                       .colour = Colour::black,
                       .opacity = 1});
            return;
        }
        for (const auto& [kind, colour] : kinds) {
            Arrows arrows{.legend = std::string(word_of(kind)), .colour = colour};
            for (const DrawnForce& force : drawing_.forces) {
                if (force.kind == kind) {
                    arrows.shafts.push_back(shaft_of(force));
                }
            }
            if (!arrows.shafts.empty()) {
                figure_.series.emplace_back(std::move(arrows));
            }
        }
        if (greatest_force_ > 0) {
            figure_.series.emplace_back(Arrows{.shafts = {key_}});
        }
    }

    // px; the line of the greatest force is almost as wide as a block.
    double chain_width(double force) const {
        return std::clamp(0.9 * block_size_ / metres_per_px_, 4.0, 12.0) * force / greatest_force_;
    }

    // A line has one width, so the forces are sorted into classes, as many as the eye can distinguish.
    void add_chains(ForceKind kind, Colour colour) {
        constexpr std::size_t widths = 24;
        std::array<std::vector<Polyline>, widths> links;
        for (const DrawnForce& force : drawing_.forces) {
            if (force.kind == kind) {
                const double share = force.force.norm() / greatest_force_;
                const Arrows::Shaft shaft = shaft_of(force);
                links[std::min(static_cast<std::size_t>(share * widths), widths - 1)].push_back({shaft.from, shaft.to});
            }
        }
        // The thickest class of each kind is the one that the legend shows.
        const auto thickest =
            std::find_if(links.rbegin(), links.rend(), [](const auto& lines) { return !lines.empty(); });
        for (std::size_t number = 0; number < widths; ++number) {
            const double force = greatest_force_ * (static_cast<double>(number) + 0.5) / widths;
            const bool last = thickest != links.rend() && &links[number] == &*thickest;
            add_line(figure_, {.points = broken_line(links[number]),
                               .legend = last ? std::string(word_of(kind)) : "",
                               .colour = colour,
                               .width = chain_width(force)});
        }
    }

    BlockDrawing drawing_;
    Figure figure_ = {};
    Frame frame_ = {};
    double metres_per_px_ = 1;
    double metres_per_newton_ = 0;
    double least_arrow_ = 0;     // m
    double greatest_force_ = 0;  // N/m
    bool chains_ = false;
    double block_size_ = 0;  // m, of the average free block, if forces are drawn as chains
    double key_force_ = 0;   // N/m
    Arrows::Shaft key_ = {};
    Point key_end_ = {};  // of its text
};

}  // namespace

Figure block_figure(const BlockDrawing& drawing) {
    return BlockPicture(drawing).draw();
}

}  // namespace delabole
