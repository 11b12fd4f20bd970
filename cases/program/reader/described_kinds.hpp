// Members of described structs (parameters/fields.hpp) that only reading and writing of cases tells apart.
#pragma once

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

// A member that is a list of texts, empty where the case has none.
template <class Type>
inline constexpr bool is_list_of_texts = std::same_as<Type, std::vector<std::string>>;

}  // namespace delabole
