// Kinds of members of described structs (parameters/fields.hpp) that only the reading and writing of cases
// distinguishes. In addition to those in fields.hpp, a case may hold a bool, written if it is true; a WrittenValue,
// kept as it was written; a std::vector<double>, a list of values; and a Polyline, points whose coordinates have the
// dimension of the field.
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

// The key that tells which alternative of a keyed variant a section is: `kind`, or the `kind_key` of the alternatives.
template <class Variant>
constexpr std::string_view kind_key() {
    using First = std::variant_alternative_t<0, Variant>;
    if constexpr (requires { First::kind_key; }) {
        return First::kind_key;
    } else {
        return "kind";
    }
}

// A struct that stores the dimension of its numbers of Dimension::named.
template <class Object>
concept has_own_dimension = requires(Object object) {
    { object.dimension } -> std::same_as<Dimension&>;
};

// A struct of a few values that a case writes as an inline table.
template <class Object>
inline constexpr bool is_written_in_line = requires {
    Object::written_in_line;
};

using PairOfTexts = std::array<std::string, 2>;

// A variant of which one alternative is given; a WrittenValue is not one but a value.
template <class Type>
inline constexpr bool is_choice = is_variant<Type> && !std::same_as<Type, WrittenValue>;

// A list of texts, empty if the case has none.
template <class Type>
inline constexpr bool is_list_of_texts = std::same_as<Type, std::vector<std::string>>;

}  // namespace delabole
