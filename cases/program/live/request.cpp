#include "cases/program/live/request.hpp"

#include "cases/program/reader/names.hpp"
#include "fitting/work/words.hpp"

#include <chrono>
#include <cmath>

namespace delabole {

namespace {

constexpr std::size_t most_map_points = 40'000;
constexpr std::chrono::seconds longest_map{3};

}  // namespace

Json finite(double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

const Quantity& input_named(const std::vector<Quantity>& inputs, const std::string& name) {
    const Quantity* found = find_quantity(inputs, name);
    if (found == nullptr) {
        throw LiveRefusal("the case has no input '" + name + "'" + suggestion(name, names_in(inputs)));
    }
    return *found;
}

double in_shown_unit(double value, Dimension dimension) {
    const DisplayUnit unit = shown_unit(dimension);
    return unit.symbol == display_unit(dimension).symbol ? in_display_unit(value, dimension) : value / unit.si_per_unit;
}

MapAxis axis_of_map(const Json& request, const char* name, const char* count, const std::vector<Quantity>& inputs) {
    const Json axis = member<Json>(request, name);
    const auto input = member<std::string>(axis, "name");
    const Quantity& quantity = input_named(inputs, input);
    const int points = member<int>(request, count);
    if (points < 2 || points > 200) {
        throw LiveRefusal("a map has 2 to 200 rows and columns");
    }
    MapAxis made{*place_of(inputs, input), {}, shown_unit(quantity.dimension).si_per_unit};
    const auto lower = member<double>(axis, "lower");
    const auto upper = member<double>(axis, "upper");
    if (!std::isfinite(lower) || !std::isfinite(upper)) {
        throw LiveRefusal("the ends of a map are numbers");
    }
    for (const double value : spaced_values(lower, upper, points)) {
        made.values.push_back(value * made.unit);
    }
    return made;
}

Json over_grid(const MapAxis& x, const MapAxis& y, const std::function<double(double across, double up)>& value) {
    if (x.values.size() * y.values.size() > most_map_points) {
        throw LiveRefusal("a map has at most " + std::to_string(most_map_points) + " points");
    }
    const auto end = std::chrono::steady_clock::now() + longest_map;
    const auto in_units = [](const MapAxis& axis) {
        Json values = Json::array();
        for (const double at : axis.values) {
            values.push_back(at / axis.unit);
        }
        return values;
    };
    Json rows = Json::array();
    for (const double up : y.values) {
        Json row = Json::array();
        for (const double across : x.values) {
            row.push_back(std::chrono::steady_clock::now() < end ? finite(value(across, up)) : Json(nullptr));
        }
        rows.push_back(std::move(row));
    }
    return {{"x", in_units(x)}, {"y", in_units(y)}, {"values", std::move(rows)}};
}

}  // namespace delabole
