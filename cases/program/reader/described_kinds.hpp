// Members of described structs (parameters/fields.hpp) that only reading and writing of cases tells apart. Beside what
// fields.hpp lists a case may hold: a bool, written where it is true; a WrittenValue, kept as it was written; a
// std::vector<double>, a list of values; a Polyline, points whose coordinates have the dimension of the field.
#pragma once

#include "cases/program/reader/units.hpp"
#include "parameters/fields.hpp"

#include <array>
#include <concepts>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace delabole {

// The key that says which alternative of a keyed variant a section is: `kind`, or that which the alternatives name as
// their `kind_key`.
template <class Variant>
constexpr std::string_view kind_key() {
    using First = std::variant_alternative_t<0, Variant>;
    if constexpr (requires { First::kind_key; }) {
        return First::kind_key;
    } else {
        return "kind";
    }
}

// A struct whose numbers of Dimension::named are of the dimension that it keeps.
template <class Object>
concept has_own_dimension = requires(Object object) {
    { object.dimension } -> std::same_as<Dimension&>;
};

// A struct of a few values that a case writes as a table in one line.
template <class Object>
inline constexpr bool is_written_in_line = requires {
    Object::written_in_line;
};

using PairOfTexts = std::array<std::string, 2>;

// Alternatives of which one is given; a WrittenValue is a value.
template <class Type>
inline constexpr bool is_choice = is_variant<Type> && !std::same_as<Type, WrittenValue>;

// A member that is a list of texts, empty where the case has none.
template <class Type>
inline constexpr bool is_list_of_texts = std::same_as<Type, std::vector<std::string>>;

}  // namespace delabole
