#include "cases/program/live/figure_json.hpp"

#include "parameters/fields.hpp"

#include <cmath>

namespace delabole {

namespace {

Json number(double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json point(const Point& at) {
    return Json::array({number(at.x()), number(at.y())});
}

Json line_of(const Polyline& points) {
    Json json = Json::array();
    for (const Point& at : points) {
        json.push_back(point(at));
    }
    return json;
}

Json json_of(const Line& line) {
    return {{"kind", "line"},
            {"points", line_of(line.points)},
            {"legend", line.legend},
            {"colour", word_of(line.colour)},
            {"dash", word_of(line.dash)},
            {"width", line.width}};
}

Json json_of(const Points& points) {
    return {{"kind", "points"},
            {"points", line_of(points.points)},
            {"legend", points.legend},
            {"colour", word_of(points.colour)},
            {"marker", word_of(points.marker)},
            {"size", points.size}};
}

Json json_of(const Region& region) {
    return {{"kind", "region"},
            {"points", line_of(region.outline)},
            {"legend", region.legend},
            {"colour", word_of(region.colour)},
            {"opacity", region.opacity}};
}

Json json_of(const Boxes& boxes) {
    Json list = Json::array();
    for (const Boxes::Box& box : boxes.boxes) {
        list.push_back(Json::array({point(box.lower_left), point(box.upper_right)}));
    }
    return {{"kind", "boxes"}, {"boxes", list}, {"legend", boxes.legend}, {"colour", word_of(boxes.colour)}};
}

Json json_of(const HeatMap& map) {
    Json rows = Json::array();
    for (Eigen::Index row = 0; row < map.values.rows(); ++row) {
        Json values = Json::array();
        for (Eigen::Index column = 0; column < map.values.cols(); ++column) {
            values.push_back(number(map.values(row, column)));
        }
        rows.push_back(std::move(values));
    }
    return {{"kind", "heat_map"}, {"x", map.x_values}, {"y", map.y_values}, {"values", rows}, {"ceiling", map.ceiling}};
}

Json json_of(const Arrows& arrows) {
    Json list = Json::array();
    for (const Arrows::Shaft& shaft : arrows.shafts) {
        list.push_back(Json::array({point(shaft.from), point(shaft.to)}));
    }
    return {{"kind", "arrows"},
            {"shafts", list},
            {"legend", arrows.legend},
            {"colour", word_of(arrows.colour)},
            {"width", arrows.width}};
}

Json json_of(const Axis& axis) {
    Json json{{"title", axis.title}, {"unit", axis.unit}, {"grid", axis.grid}};
    if (axis.range) {
        json["range"] = Json::array({number(axis.range->first), number(axis.range->second)});
    }
    for (const auto& [at, text] : axis.ticks) {
        json["ticks"].push_back(Json::array({number(at), text}));
    }
    return json;
}

Json json_of(const Label& label) {
    return {{"at", point(label.at)},
            {"text", label.text},
            {"align", word_of(label.align)},
            {"colour", word_of(label.colour)},
            {"raise", label.raise},
            {"boxed", label.boxed},
            {"size", label.size}};
}

}  // namespace

Json json_of(const Figure& figure) {
    Json json{{"title", figure.title},   {"x", json_of(figure.x)},
              {"y", json_of(figure.y)},  {"equal_scales", figure.equal_scales},
              {"frame", figure.frame},   {"width", figure.width},
              {"height", figure.height}, {"series", Json::array()},
              {"labels", Json::array()}, {"arrows", Json::array()}};
    for (const Series& series : figure.series) {
        json["series"].push_back(std::visit([](const auto& one) { return json_of(one); }, series));
    }
    for (const Label& label : figure.labels) {
        json["labels"].push_back(json_of(label));
    }
    for (const Arrow& arrow : figure.arrows) {
        json["arrows"].push_back({{"from", point(arrow.from)},
                                  {"to", point(arrow.to)},
                                  {"colour", word_of(arrow.colour)},
                                  {"both_heads", arrow.both_heads}});
    }
    return json;
}

}  // namespace delabole
