// Reads the requests of a page, which are JSON: their members, and the grid of two inputs over which a map is drawn.
#pragma once

#include "cases/program/results/result_folder.hpp"
#include "parameters/model_interface.hpp"

#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace delabole {

// Thrown if a request of the page cannot be met; the text is for the user of the page.
class LiveRefusal : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

// The member, of the type that is asked for.
template <class Type>
Type member(const Json& json, const char* name) {
    const auto found = json.is_object() ? json.find(name) : json.end();
    if (!json.is_object() || found == json.end()) {
        throw LiveRefusal(std::string("the request has no '") + name + "'");
    }
    const LiveRefusal wrong_kind(std::string("'") + name + "' of the request is of the wrong kind");
    if (std::is_integral_v<Type> && !found->is_number_integer()) {
        throw wrong_kind;  // 1e300 has no int that it could become
    }
    try {
        return found->get<Type>();
    } catch (const Json::exception&) {
        throw wrong_kind;
    }
}

template <class Type>
Type member_or(const Json& json, const char* name, Type otherwise) {
    return json.is_object() && json.contains(name) ? member<Type>(json, name) : otherwise;
}

// Null where it is no number.
Json finite(double value);

// LiveRefusal where there is none.
const Quantity& input_named(const std::vector<Quantity>& inputs, const std::string& name);

// SI value in the unit in which the page shows it.
double in_shown_unit(double value, Dimension dimension);

struct MapAxis {
    std::size_t input;
    std::vector<double> values;  // SI
    double unit;
};

// `name` of the request: {name, lower, upper}; `count` of it: how many values.
MapAxis axis_of_map(const Json& request, const char* name, const char* count, const std::vector<Quantity>& inputs);

// Row by row; null where there is no value, or no more time.
Json over_grid(const MapAxis& x, const MapAxis& y, const std::function<double(double across, double up)>& value);

}  // namespace delabole
