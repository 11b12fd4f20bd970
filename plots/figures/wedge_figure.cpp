#include "plots/figures/wedge_figure.hpp"

#include "plots/drawing/extent.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace delabole {

namespace {

// Projection of points in space on the picture: x to the right, y upwards, in metres across the line of sight.
class View {
  public:
    View(double azimuth, double elevation) {
        const Direction to_viewer(std::cos(elevation) * std::sin(azimuth), std::cos(elevation) * std::cos(azimuth),
                                  std::sin(elevation));
        right_ = Direction(0, 0, 1).cross(to_viewer).normalized();
        up_ = to_viewer.cross(right_);
    }

    Point operator()(const Direction& point) const { return {point.dot(right_), point.dot(up_)}; }

    Polyline polyline(const std::vector<Direction>& points) const {
        Polyline line;
        std::ranges::transform(points, std::back_inserter(line),
                               [this](const Direction& point) { return (*this)(point); });
        return line;
    }

  private:
    Direction right_;
    Direction up_;
};

View view_of(const WedgeDrawing& drawing) {
    // The view is somewhat from the side, so that face and upper surface can be distinguished.
    return {drawing.face_dip_direction + degrees(25), degrees(28)};
}

double size_of(const WedgeDrawing& drawing) {
    return std::max({drawing.crest_1.norm(), drawing.crest_2.norm(), drawing.line_end.norm(), drawing.crack_1.norm(),
                     drawing.crack_2.norm()});
}

struct Slope {
    std::vector<Direction> face;
    std::vector<Direction> upper;
};

// The face from some distance below the origin to the crest, and the upper surface from the crest to some distance
// behind the wedge.
Slope slope_around(const WedgeDrawing& drawing) {
    const Direction crest = (drawing.crest_2 - drawing.crest_1).normalized();
    Direction down = drawing.face_normal.cross(crest).normalized();
    if (down.z() > 0) {
        down = -down;
    }
    Direction back = drawing.upper_normal.cross(crest).normalized();
    if (back.dot(drawing.face_normal) > 0) {
        back = -back;
    }
    Extent along;
    Extent below;
    Extent behind;
    for (const Direction& corner :
         {Direction(0, 0, 0), drawing.crest_1, drawing.crest_2, drawing.crack_1, drawing.crack_2}) {
        along.include(crest.dot(corner - drawing.crest_1));
        below.include(down.dot(corner - drawing.crest_1));
        behind.include(back.dot(corner - drawing.crest_1));
    }
    const double margin = 0.2 * size_of(drawing);
    const Direction left = drawing.crest_1 + (along.lowest - margin) * crest;
    const Direction right = drawing.crest_1 + (along.highest + margin) * crest;
    const Direction fall = (below.highest + margin / 2) * down;
    const Direction run = (behind.highest + margin) * back;
    return {{left, right, right + fall, left + fall}, {left, right, right + run, left + run}};
}

Figure empty_picture(const WedgeDrawing& drawing) {
    return {.title = drawing.title, .equal_scales = true, .frame = false, .width = 720, .height = 560};
}

void add_surface(Figure& figure, const View& view, std::vector<Direction> outline, Colour colour, double opacity,
                 std::string legend = {}) {
    figure.series.emplace_back(
        Region{.outline = view.polyline(outline), .legend = std::move(legend), .colour = colour, .opacity = opacity});
    outline.push_back(outline.front());
    figure.series.emplace_back(Line{.points = view.polyline(outline), .colour = Colour::black, .width = 1.5});
}

void add_label(Figure& figure, const View& view, const Direction& at, std::string text) {
    figure.labels.push_back({.at = view(at), .text = std::move(text), .align = Label::Align::centre});
}

// Corners of the wedge's faces that are in the open air, after the wedge has moved by `shift`.
std::array<std::vector<Direction>, 2> open_faces(const WedgeDrawing& drawing, const Direction& shift) {
    return {std::vector<Direction>{shift, drawing.crest_1 + shift, drawing.crest_2 + shift},
            {drawing.crest_1 + shift, drawing.crack_1 + shift, drawing.crack_2 + shift, drawing.crest_2 + shift}};
}

void add_ranges(Figure& figure, const View& view, const Slope& slope, const std::vector<Direction>& further) {
    Frame frame;
    for (const std::vector<Direction>* points : {&slope.face, &slope.upper, &further}) {
        frame.include(view.polyline(*points));
    }
    const double margin = 0.03 * frame.size().maxCoeff();
    figure.x = {.range = std::pair{frame.x.lowest - margin, frame.x.highest + margin}, .grid = false};
    figure.y = {.range = std::pair{frame.y.lowest - margin, frame.y.highest + margin}, .grid = false};
}

}  // namespace

Figure wedge_figure(const WedgeDrawing& drawing) {
    const View view = view_of(drawing);
    const Slope slope = slope_around(drawing);
    Figure figure = empty_picture(drawing);
    add_surface(figure, view, slope.upper, Colour::light_grey, 0.35, "upper surface");
    add_surface(figure, view, slope.face, Colour::grey, 0.35, "face");
    const auto [front, top] = open_faces(drawing, Direction(0, 0, 0));
    add_surface(figure, view, top, Colour::rock, 1);
    add_surface(figure, view, front, Colour::rock, 1, "wedge");
    figure.series.emplace_back(Line{.points = view.polyline({Direction(0, 0, 0), drawing.line_end}),
                                    .legend = "line of intersection, inside the rock",
                                    .colour = Colour::vermilion,
                                    .dash = Dash::dashed});
    if (drawing.cracked) {
        figure.series.emplace_back(Line{.points = view.polyline({drawing.crack_1, drawing.line_end, drawing.crack_2}),
                                        .legend = "tension crack, inside the rock",
                                        .colour = Colour::blue,
                                        .dash = Dash::dashed});
    }
    std::vector<Direction> tip;
    if (drawing.sliding.norm() > 0) {
        tip = {0.35 * size_of(drawing) * drawing.sliding};
        figure.series.emplace_back(Arrows{
            .shafts = {{view(Direction(0, 0, 0)), view(tip.front())}}, .legend = "direction of sliding", .width = 4});
    }
    add_label(figure, view, (drawing.crest_1 + drawing.crack_1) / 2, "1");
    add_label(figure, view, (drawing.crest_2 + drawing.crack_2) / 2, "2");
    add_ranges(figure, view, slope, tip);
    return figure;
}

Figure slid_wedge_figure(const WedgeDrawing& drawing) {
    const View view = view_of(drawing);
    const Slope slope = slope_around(drawing);
    Figure figure = empty_picture(drawing);
    const Direction origin(0, 0, 0);
    add_surface(figure, view, slope.upper, Colour::light_grey, 0.35);
    add_surface(figure, view, slope.face, Colour::grey, 0.35);
    const auto [front, top] = open_faces(drawing, origin);
    add_surface(figure, view, top, Colour::white, 1);
    add_surface(figure, view, front, Colour::white, 1);
    add_surface(figure, view, {origin, drawing.crest_1, drawing.crack_1, drawing.line_end}, Colour::sky, 1, "plane 1");
    add_surface(figure, view, {origin, drawing.crest_2, drawing.crack_2, drawing.line_end}, Colour::orange, 1,
                "plane 2");
    if (drawing.cracked) {
        add_surface(figure, view, {drawing.crack_1, drawing.line_end, drawing.crack_2}, Colour::light_grey, 1,
                    "tension crack");
    }
    const Direction shift = 0.9 * drawing.line_end.norm() * drawing.sliding;
    const auto [moved_front, moved_top] = open_faces(drawing, shift);
    add_surface(figure, view, moved_top, Colour::rock, 1);
    add_surface(figure, view, moved_front, Colour::rock, 1, "wedge, slid out");
    std::vector<Direction> moved = moved_front;
    moved.insert(moved.end(), moved_top.begin(), moved_top.end());
    add_ranges(figure, view, slope, moved);
    return figure;
}

}  // namespace delabole
