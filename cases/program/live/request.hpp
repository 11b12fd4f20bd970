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

// Returns the member if it has the requested type.
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

// Returns null for a number that is not finite.
Json finite(double value);

// Throws LiveRefusal if there is no such input.
const Quantity& input_named(const std::vector<Quantity>& inputs, const std::string& name);

// Converts an SI value to the unit in which the page shows it.
double in_shown_unit(double value, Dimension dimension);

struct MapAxis {
    std::size_t input;
    std::vector<double> values;  // SI
    double unit;
};

// Reads {name, lower, upper} from the member `name` of the request and the number of values from `count`.
MapAxis axis_of_map(const Json& request, const char* name, const char* count, const std::vector<Quantity>& inputs);

// Values are stored row by row, null where there is no value or no more time.
Json over_grid(const MapAxis& x, const MapAxis& y, const std::function<double(double across, double up)>& value);

}  // namespace delabole
