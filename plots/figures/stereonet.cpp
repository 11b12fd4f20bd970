#include "plots/figures/stereonet.hpp"

#include "kinematics/poles.hpp"
#include "plots/drawing/contour.hpp"
#include "plots/drawing/free_place.hpp"
#include "plots/drawing/text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

namespace delabole {

namespace {

constexpr double right_angle = std::numbers::pi / 2;

// Sets differ in colour, marker and dash, so that a black and white copy can be read.
constexpr std::array set_colours{Colour::blue, Colour::vermilion, Colour::green, Colour::purple, Colour::orange};
constexpr std::array set_markers{Marker::filled_circle, Marker::filled_triangle, Marker::filled_square,
                                 Marker::filled_diamond, Marker::cross};
constexpr std::array set_dashes{Dash::solid, Dash::dashed, Dash::dotted};

template <class Values>
auto of_set(const Values& values, std::size_t set) {
    return values[set % values.size()];
}

std::string degrees_text(double angle) {
    return human_number(angle / degrees(1), 3);
}

// "85/282.5": dip and dip direction, or plunge and trend, to a tenth of a degree.
std::string attitude(double inclination, double azimuth) {
    const auto tenths = [](double angle) { return human_number(std::round(angle / degrees(0.1)) / 10, 4); };
    return tenths(inclination) + "/" + tenths(azimuth);
}

std::string name_of(const std::string& set, const Orientation& plane) {
    return human_name(set) + " " + attitude(plane.dip, plane.dip_direction);
}

Point on_primitive(double azimuth, double radius) {
    return {radius * std::sin(azimuth), radius * std::cos(azimuth)};
}

constexpr double margin = 1.17;  // of the net's radius; leaves room for the azimuths around the primitive circle

Figure bare_circle(std::string title, int size) {
    return {.title = std::move(title),
            .x = {.range = std::pair{-margin, margin}, .grid = false},
            .y = {.range = std::pair{-margin, margin}, .grid = false},
            .equal_scales = true,
            .frame = false,
            .width = size,
            .height = size};
}

Figure empty_net(std::string_view title, std::string_view shown) {
    return bare_circle(title.empty() ? std::string(shown) : std::string(title) + ": " + std::string(shown), 720);
}

// Adds primitive circle, ticks and azimuths; they come last, so that they cover everything that ends at the circle.
void add_compass(Figure& figure, NetProjection projection) {
    figure.series.emplace_back(Line{.points = plunge_circle(0, projection, 361), .colour = Colour::black, .width = 2});
    std::vector<Polyline> ticks{{Point(-0.025, 0), Point(0.025, 0)}, {Point(0, -0.025), Point(0, 0.025)}};
    for (int azimuth = 0; azimuth < 360; azimuth += 10) {
        const double length = azimuth == 0 ? 0.055 : azimuth % 30 == 0 ? 0.035 : 0.02;
        ticks.push_back({on_primitive(degrees(azimuth), 1), on_primitive(degrees(azimuth), 1 + length)});
    }
    figure.series.emplace_back(Line{.points = broken_line(ticks), .colour = Colour::black, .width = 1.5});
    for (int azimuth = 0; azimuth < 360; azimuth += 30) {
        figure.labels.push_back({.at = on_primitive(degrees(azimuth), azimuth == 0 ? 1.1 : 1.105),
                                 .text = azimuth == 0 ? "N" : std::to_string(azimuth),
                                 .align = Label::Align::centre,
                                 .boxed = false});
    }
}

void add_primitive(Figure& figure, NetProjection projection) {
    add_compass(figure, projection);
    figure.labels.push_back({.at = {1.16, -1.14},
                             .text = projection == NetProjection::equal_area ? "equal area, lower hemisphere"
                                                                             : "equal angle, lower hemisphere",
                             .align = Label::Align::right,
                             .colour = Colour::grey,
                             .boxed = false});
}

// Adds a text to the net at the place where it hides least.
void add_name(Figure& figure, const std::vector<LabelPlace>& places, const std::string& text, Colour colour) {
    add_where_free(places, text, Point::Constant(figure.width / (2 * margin)), figure, colour);
}

// Adds a text on its curve, near the middle.
void add_name_along(Figure& figure, const Polyline& curve, const std::string& text, Colour colour) {
    std::vector<LabelPlace> places;
    for (const double share : {0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8}) {
        const auto index = static_cast<std::size_t>(share * static_cast<double>(curve.size() - 1));
        places.push_back({curve[index], Label::Align::centre});
    }
    add_name(figure, places, text, colour);
}

void add_circle(Figure& figure, const Orientation& plane, NetProjection projection, Colour colour, Dash dash,
                double width) {
    figure.series.emplace_back(
        Line{.points = great_circle(plane, projection), .colour = colour, .dash = dash, .width = width});
}

void add_face(Figure& figure, const Orientation& face, NetProjection projection) {
    add_circle(figure, face, projection, Colour::black, Dash::solid, 4);
}

void name_plane(Figure& figure, const std::string& name, const Orientation& plane, NetProjection projection,
                Colour colour) {
    add_name_along(figure, great_circle(plane, projection), name_of(name, plane), colour);
}

void add_planes(Figure& figure, const std::vector<DrawnJointSet>& sets, NetProjection projection) {
    for (std::size_t index = 0; index < sets.size(); ++index) {
        add_circle(figure, sets[index].mean, projection, of_set(set_colours, index), of_set(set_dashes, index), 3);
    }
}

void name_planes(Figure& figure, const std::vector<DrawnJointSet>& sets, NetProjection projection) {
    for (std::size_t index = 0; index < sets.size(); ++index) {
        name_plane(figure, sets[index].name, sets[index].mean, projection, of_set(set_colours, index));
    }
}

void add_zone(Figure& figure, Polyline outline, std::string legend, Colour colour) {
    if (!outline.empty()) {
        figure.series.emplace_back(
            Region{.outline = std::move(outline), .legend = std::move(legend), .colour = colour, .opacity = 0.45});
    }
}

struct CountedPoles {
    std::vector<Direction> normals;
    std::vector<double> weights;
    void add(const std::vector<Orientation>& planes, const std::vector<double>& own_weights, std::size_t most) {
        for (std::size_t index = 0; index < std::min(most, planes.size()); ++index) {
            const double weight = own_weights.empty() ? 1.0 : own_weights[index];
            // Planes sampled without scatter are all equal and give one pole.
            if (index > 0 && planes[index].dip == planes[index - 1].dip &&
                planes[index].dip_direction == planes[index - 1].dip_direction) {
                weights.back() += weight;
                continue;
            }
            normals.push_back(upward_normal(planes[index]));
            weights.push_back(weight);
        }
    }
};

CountedPoles counted_poles(const StereonetDrawing& drawing) {
    constexpr std::size_t most_sampled = 1000;
    CountedPoles poles;
    for (const DrawnJointSet& set : drawing.joint_set) {
        poles.add(set.planes, set.weights, drawing.measured ? set.planes.size() : most_sampled);
    }
    poles.add(drawing.without_set, drawing.weights_without_set, drawing.without_set.size());
    return poles;
}

// Adds contours at `level`, then at next(level), and so on up to the highest value; `legend` makes the legend from the
// list of levels.
void add_contours(Figure& figure, const DensityGrid& grid, double level, double (*next)(double),
                  const std::function<std::string(const std::string& levels)>& legend) {
    double highest = 0;
    for (const double value : grid.values.reshaped()) {
        highest = std::isfinite(value) ? std::max(highest, value) : highest;
    }
    std::vector<Polyline> parts;
    std::string levels;
    constexpr int most_levels = 8;
    for (int count = 0; count < most_levels && level < highest; ++count, level = next(level)) {
        for (const Polyline& chain : contour_lines(grid.coordinates, grid.coordinates, grid.values, level)) {
            for (Polyline& part : inside_primitive(chain)) {
                parts.push_back(std::move(part));
            }
        }
        levels += (levels.empty() ? "" : ", ") + human_number(level, 3);
    }
    if (!parts.empty()) {
        figure.series.emplace_back(
            Line{.points = broken_line(parts), .legend = legend(levels), .colour = Colour::grey, .width = 1.5});
    }
}

std::string poles_are(const StereonetDrawing& drawing) {
    return drawing.measured ? "measured" : "sampled";
}

void add_density_contours(Figure& figure, const StereonetDrawing& drawing) {
    const CountedPoles poles = counted_poles(drawing);
    if (poles.normals.empty() || drawing.grid_side < 4) {
        return;
    }
    add_contours(
        figure,
        pole_density_grid(poles.normals, poles.weights, drawing.kernel_concentration, drawing.projection,
                          drawing.grid_side),
        2, [](double level) { return 2 * level; },
        [&](const std::string& levels) {
            return "density of the " + poles_are(drawing) + " poles, " + levels + " times uniform";
        });
}

void add_poles(Figure& figure, const StereonetDrawing& drawing) {
    constexpr std::size_t most_drawn = 150;
    bool named = false;
    for (std::size_t index = 0; index < drawing.joint_set.size(); ++index) {
        const DrawnJointSet& set = drawing.joint_set[index];
        Points poles{.colour = of_set(set_colours, index), .marker = of_set(set_markers, index), .size = 0.4};
        const std::size_t drawn = drawing.measured ? set.planes.size() : std::min(most_drawn, set.planes.size());
        for (std::size_t plane = 0; plane < drawn; ++plane) {
            poles.points.push_back(projected_pole(set.planes[plane], drawing.projection));
        }
        if (poles.points.empty()) {
            continue;
        }
        if (!named) {
            poles.legend = poles_are(drawing) + " poles" +
                           (drawing.measured ? "" : ", at most " + std::to_string(most_drawn) + " of a set");
            named = true;
        }
        figure.series.emplace_back(std::move(poles));
    }
    Points others{.legend = "measured poles of no set", .colour = Colour::grey, .marker = Marker::circle, .size = 0.5};
    for (const Orientation& plane : drawing.without_set) {
        others.points.push_back(projected_pole(plane, drawing.projection));
    }
    if (!others.points.empty()) {
        figure.series.emplace_back(std::move(others));
    }
}

void add_mean_poles(Figure& figure, const StereonetDrawing& drawing) {
    for (std::size_t index = 0; index < drawing.joint_set.size(); ++index) {
        const DrawnJointSet& set = drawing.joint_set[index];
        const Point pole = projected_pole(set.mean, drawing.projection);
        // A white background separates the mark from the poles around it.
        figure.series.emplace_back(
            Points{.points = {pole}, .colour = Colour::white, .marker = of_set(set_markers, index), .size = 3});
        figure.series.emplace_back(Points{.points = {pole},
                                          .legend = name_of(set.name, set.mean),
                                          .colour = of_set(set_colours, index),
                                          .marker = of_set(set_markers, index),
                                          .size = 2});
    }
}

// "1–3, 5" for the first three and the fifth.
std::string gathered_labels(const std::vector<DrawnIntersection>& intersections,
                            const std::vector<std::size_t>& indices) {
    std::string text;
    for (std::size_t begin = 0, end = 0; begin < indices.size(); begin = end) {
        for (end = begin + 1; end < indices.size() && indices[end] == indices[end - 1] + 1;) {
            ++end;
        }
        text += (text.empty() ? "" : ", ") + intersections[indices[begin]].label;
        if (end - begin > 1) {
            text += (end - begin == 2 ? ", " : "–") + intersections[indices[end - 1]].label;
        }
    }
    return text;
}

// Lines that lie close together have one label, above the highest of them.
void add_intersection_labels(Figure& figure, const std::vector<DrawnIntersection>& intersections,
                             const Polyline& points) {
    constexpr double close = 0.15;  // of the net's radius, about the width of a label
    std::vector<std::vector<std::size_t>> groups;
    for (std::size_t index = 0; index < points.size(); ++index) {
        const auto near = std::ranges::find_if(groups, [&](const std::vector<std::size_t>& group) {
            return (points[group.front()] - points[index]).norm() < close;
        });
        if (near == groups.end()) {
            groups.push_back({index});
        } else {
            near->push_back(index);
        }
    }
    for (const std::vector<std::size_t>& group : groups) {
        const std::size_t highest =
            *std::ranges::max_element(group, {}, [&](std::size_t index) { return points[index].y(); });
        figure.labels.push_back({.at = points[highest],
                                 .text = gathered_labels(intersections, group),
                                 .align = Label::Align::centre,
                                 .raise = 1.1});
    }
}

}  // namespace

Figure pole_figure(const StereonetDrawing& drawing) {
    const NetProjection projection = drawing.projection;
    const std::string friction = degrees_text(drawing.friction_angle);
    Figure figure = empty_net(drawing.title, "poles");
    add_zone(
        figure,
        planar_sliding_zone(drawing.slope, drawing.friction_angle, drawing.lateral_limit.planar_sliding, projection),
        "poles that slide, ±" + degrees_text(drawing.lateral_limit.planar_sliding) + "°", Colour::rock);
    add_zone(figure,
             flexural_toppling_zone(drawing.slope, drawing.friction_angle, drawing.lateral_limit.flexural_toppling,
                                    projection),
             "poles that topple (flexural), ±" + degrees_text(drawing.lateral_limit.flexural_toppling) + "°",
             Colour::sky);
    add_poles(figure, drawing);
    add_density_contours(figure, drawing);
    const Orientation face{drawing.slope.face_dip, drawing.slope.face_dip_direction};
    // Names in the legend, because the net has no free place for so many.
    figure.series.emplace_back(Line{.points = great_circle(face, projection),
                                    .legend = name_of("face", face),
                                    .colour = Colour::black,
                                    .width = 4});
    figure.series.emplace_back(Line{.points = daylight_envelope(drawing.slope, projection),
                                    .legend = "daylight envelope",
                                    .colour = Colour::black,
                                    .dash = Dash::dashed,
                                    .width = 2});
    figure.series.emplace_back(Line{.points = plunge_circle(right_angle - drawing.friction_angle, projection),
                                    .legend = "friction circle, planes dipping " + friction + "°",
                                    .colour = Colour::black,
                                    .dash = Dash::dotted,
                                    .width = 2});
    add_mean_poles(figure, drawing);
    add_primitive(figure, projection);
    return figure;
}

Figure kamb_figure(const StereonetDrawing& drawing) {
    Figure figure = empty_net(drawing.title, "Kamb's density of the measured poles");
    const CountedPoles poles = counted_poles(drawing);
    add_poles(figure, drawing);
    if (!poles.normals.empty()) {
        const auto density = [&](const Direction& at) { return kamb_density(poles.normals, poles.weights, at); };
        add_contours(
            figure, density_grid(density, drawing.projection, drawing.grid_side), 3,
            [](double level) { return level + 3; },
            [](const std::string& levels) { return levels + " standard deviations above uniform poles"; });
    }
    add_primitive(figure, drawing.projection);
    return figure;
}

Figure rosette_figure(const std::string& title, const std::vector<Orientation>& planes,
                      const std::vector<double>& weights) {
    constexpr std::size_t classes = 18;
    constexpr double width = std::numbers::pi / classes;
    std::array<double, classes> petals{};
    for (std::size_t index = 0; index < planes.size(); ++index) {
        const double strike = std::fmod(planes[index].dip_direction + right_angle, std::numbers::pi);
        petals[std::min(static_cast<std::size_t>(strike / width), classes - 1)] += weights.empty() ? 1 : weights[index];
    }
    const double largest = *std::ranges::max_element(petals);
    double total = 0;
    for (const double petal : petals) {
        total += petal;
    }
    Figure figure = bare_circle(title, 560);
    bool named = false;
    for (std::size_t petal = 0; petal < classes && largest > 0; ++petal) {
        for (const double end : {0.0, std::numbers::pi}) {
            const double radius = std::sqrt(petals[petal] / largest);
            Polyline outline{Point(0, 0)};
            for (int step = 0; step <= 10 && radius > 0; ++step) {
                outline.push_back(on_primitive(end + (static_cast<double>(petal) + step / 10.0) * width, radius));
            }
            if (outline.size() > 2) {
                figure.series.emplace_back(Region{
                    .outline = outline,
                    .legend = named ? "" : "strikes; at the circle " + human_number(100 * largest / total, 3) + " %",
                    .colour = Colour::blue,
                    .opacity = 0.6});
                named = true;
            }
        }
    }
    add_compass(figure, NetProjection::equal_area);
    return figure;
}

Figure plane_figure(const StereonetDrawing& drawing) {
    const NetProjection projection = drawing.projection;
    const std::string friction = degrees_text(drawing.friction_angle);
    Figure figure = empty_net(drawing.title, "mean planes and intersections");
    add_zone(figure, wedge_sliding_zone(drawing.slope, drawing.friction_angle, projection),
             "intersections of wedges that slide (primary zone)", Colour::rock);
    add_zone(figure, secondary_wedge_sliding_zone(drawing.slope, drawing.friction_angle, projection),
             "where they slide on one steeper plane, if at all (secondary zone)", Colour::pale_vermilion);
    add_zone(figure, toppling_axis_zone(drawing.slope, drawing.lateral_limit.direct_toppling, projection),
             "axes of toppling columns, ±" + degrees_text(drawing.lateral_limit.direct_toppling) + "°", Colour::sky);
    add_zone(figure, oblique_toppling_axis_zone(drawing.slope, drawing.friction_angle, projection),
             "oblique axes, within " + friction + "° of vertical", Colour::light_grey);
    add_face(figure, {drawing.slope.face_dip, drawing.slope.face_dip_direction}, projection);
    add_planes(figure, drawing.joint_set, projection);
    figure.series.emplace_back(Line{.points = plunge_circle(drawing.friction_angle, projection),
                                    .legend = "friction circle, lines plunging " + friction + "°",
                                    .colour = Colour::black,
                                    .dash = Dash::dotted,
                                    .width = 2});
    Points lines{.legend = "lines of intersection", .colour = Colour::black, .size = 1.2};
    for (const DrawnIntersection& intersection : drawing.intersection) {
        lines.points.push_back(projected_line(intersection.line, projection));
    }
    add_intersection_labels(figure, drawing.intersection, lines.points);
    if (!lines.points.empty()) {
        figure.series.emplace_back(std::move(lines));
    }
    add_primitive(figure, projection);
    name_plane(figure, "face", {drawing.slope.face_dip, drawing.slope.face_dip_direction}, projection, Colour::black);
    name_planes(figure, drawing.joint_set, projection);
    return figure;
}

Figure wedge_net_figure(const WedgeNet& net) {
    const NetProjection projection = net.projection;
    Figure figure = empty_net(net.title, "planes of the wedge");
    const Orientation face = plane_with_normal(upward_normal(net.face));
    add_face(figure, face, projection);
    add_circle(figure, net.upper_surface, projection, Colour::grey, Dash::solid, 2);
    add_planes(figure, net.planes, projection);
    figure.series.emplace_back(Points{.points = {projected_line(net.line, projection)},
                                      .legend = "line of intersection " + attitude(net.line.plunge, net.line.trend),
                                      .colour = Colour::black,
                                      .size = 2});
    if (net.sliding && net.sliding->plunge >= 0) {
        figure.series.emplace_back(
            Points{.points = {projected_line(*net.sliding, projection)},
                   .legend = "direction of sliding " + attitude(net.sliding->plunge, net.sliding->trend),
                   .colour = Colour::vermilion,
                   .marker = Marker::circle,
                   .size = 3});
    }
    add_primitive(figure, projection);
    name_plane(figure, "face", face, projection, Colour::black);
    name_plane(figure, "upper surface", net.upper_surface, projection, Colour::grey);
    name_planes(figure, net.planes, projection);
    return figure;
}

}  // namespace delabole
