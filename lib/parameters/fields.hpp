// One table per parameter or result struct: key, dimension, allowed range, meaning, member.
//
// A described struct has `static constexpr auto fields()` returning a FieldTable. The case reader, the writers, the
// named-number view of the loops, the exact derivatives and the documentation all go through these tables, so that a
// C++ member, a case key, a CSV column and a JSON key are one word.
//
// Meaning of a member's type:
//   number                 a required number
//   std::optional<number>  a number that may be absent; absence has the meaning the field's text gives
//   described struct       a section (inlined, its keys stand in the surrounding section); std::optional of it is a
//                          section that may be absent
//   std::variant, keyed    a section whose `kind` selects the alternative; each alternative has `kind` and `fields()`
//   std::variant, inlined  exactly one alternative's keys stand in the surrounding section (no `kind`, no own section)
//   std::vector<struct>    an array of tables
//   enum                   one word out of enum_names(Enum): the names of its enumerators
//   std::string            any text; std::vector of it, a list of texts, which may be absent
//
// A result may also describe a function of its members without arguments: its return value is the value.
//
// with_default(field) is a field that keeps its in-class default if it is absent. absent_is(value, field) is an
// optional number whose absence stands for that value: where texts tell it, they take it from there (field_text.hpp).
// refers_to(what, field) is a text that names something: the numbers of Dimension::named behind it have dimension and
// range of the named input or output.
#pragma once

#include <array>
#include <cmath>
#include <concepts>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace delabole {

enum class Dimension {
    ratio,              // 1
    angle,              // rad
    length,             // m
    area,               // m2 (m3 per metre run)
    volume,             // m3
    stress,             // Pa
    unit_weight,        // N/m3
    force,              // N
    force_per_length,   // N/m
    moment_per_length,  // N m/m
    energy_per_length,  // J/m
    density,            // kg/m3
    stiffness,          // N/m per metre run
    time,               // s
    speed,              // m/s
    acceleration,       // m/s2
    angular_speed,      // rad/s
    named,              // that of the input or output that the struct names
};

// The unit in which a dimension is displayed, and the factor to the SI base unit used inside.
struct DisplayUnit {
    std::string_view symbol;  // "kN/m3"; empty for a ratio
    std::string_view suffix;  // "_kN_per_m3", appended to a column name; empty for a ratio
    double si_per_unit;
};

namespace detail {

inline constexpr double radians_per_degree = 3.14159265358979323846 / 180.0;

// In the order of the enumerators of Dimension.
inline constexpr auto display_units = std::to_array<DisplayUnit>({
    {"", "", 1.0},
    {"deg", "_deg", radians_per_degree},
    {"m", "_m", 1.0},
    {"m2", "_m2", 1.0},
    {"m3", "_m3", 1.0},
    {"kPa", "_kPa", 1e3},
    {"kN/m3", "_kN_per_m3", 1e3},
    {"kN", "_kN", 1e3},
    {"kN/m", "_kN_per_m", 1e3},
    {"kN m/m", "_kN_m_per_m", 1e3},
    {"J/m", "_J_per_m", 1.0},
    {"kg/m3", "_kg_per_m3", 1.0},
    {"MN/m/m", "_MN_per_m_per_m", 1e6},
    {"s", "_s", 1.0},
    {"m/s", "_m_per_s", 1.0},
    {"m/s2", "_m_per_s2", 1.0},
    {"deg/s", "_deg_per_s", radians_per_degree},
    {"", "", 1.0},
});
static_assert(display_units.size() == static_cast<std::size_t>(Dimension::named) + 1);

}  // namespace detail

constexpr DisplayUnit display_unit(Dimension dimension) {
    return detail::display_units[static_cast<std::size_t>(dimension)];
}

constexpr double degrees(double value) {
    return value * display_unit(Dimension::angle).si_per_unit;
}

// Allowed values, in SI.
struct Interval {
    double lower = -std::numeric_limits<double>::infinity();
    double upper = std::numeric_limits<double>::infinity();
    bool lower_open = false;
    bool upper_open = false;

    // False for NaN.
    constexpr bool contains(double value) const {
        return (lower_open ? value > lower : value >= lower) && (upper_open ? value < upper : value <= upper);
    }
};

constexpr Interval any_number() {
    return {};
}
constexpr Interval at_least(double lower) {
    return {.lower = lower};
}
constexpr Interval more_than(double lower) {
    return {.lower = lower, .lower_open = true};
}
constexpr Interval at_most(double upper) {
    return {.upper = upper};
}
constexpr Interval less_than(double upper) {
    return {.upper = upper, .upper_open = true};
}
constexpr Interval within(double lower, double upper) {
    return {.lower = lower, .upper = upper};
}
constexpr Interval between(double lower, double upper) {
    return {.lower = lower, .upper = upper, .lower_open = true, .upper_open = true};
}
// The lower end is excluded.
constexpr Interval left_open(double lower, double upper) {
    return {.lower = lower, .upper = upper, .lower_open = true};
}
// The upper end is excluded.
constexpr Interval right_open(double lower, double upper) {
    return {.lower = lower, .upper = upper, .upper_open = true};
}

// Kinds of things that a text may name.
enum class NameOf {
    nothing,
    input,
    output,
    measurable,  // an input or an output
    mechanism,   // its inputs and outputs are then meant
};

struct FieldInfo {
    std::string_view key;  // empty for an inlined variant
    std::string_view meaning;
    Dimension dimension = Dimension::ratio;
    Interval range = {};  // unbounded for Dimension::named, which has the range of what it names
    bool has_default = false;
    NameOf name_of = NameOf::nothing;
    std::optional<double> absent = {};  // SI
};

template <class Owner, class Member>
struct Field {
    FieldInfo info;
    Member Owner::*member;

    template <class Object, class Visitor>
    constexpr void visit(Object& object, Visitor& visitor) const {
        if constexpr (std::is_function_v<Member>) {
            const auto value = (object.*member)();
            visitor(info, value);
        } else {
            visitor(info, object.*member);
        }
    }
};

template <class Owner, class Member>
constexpr Field<Owner, Member> number(std::string_view key, Member Owner::*member, Dimension dimension, Interval range,
                                      std::string_view meaning) {
    return {{key, meaning, dimension, range}, member};
}

// A section, an optional section, a keyed variant, an array of tables, an enum or a text.
template <class Owner, class Member>
constexpr Field<Owner, Member> section(std::string_view key, Member Owner::*member, std::string_view meaning) {
    return {{key, meaning}, member};
}

template <class Owner, class Member>
constexpr Field<Owner, Member> inlined(Member Owner::*member, std::string_view meaning) {
    return {{{}, meaning}, member};
}

template <class Owner, class Member>
constexpr Field<Owner, Member> with_default(Field<Owner, Member> field) {
    field.info.has_default = true;
    return field;
}

template <class Owner, class Member>
constexpr Field<Owner, std::optional<Member>> absent_is(double value, Field<Owner, std::optional<Member>> field) {
    field.info.absent = value;
    return field;
}

template <class Owner, class Member>
constexpr Field<Owner, Member> refers_to(NameOf what, Field<Owner, Member> field) {
    field.info.name_of = what;
    return field;
}

namespace detail {

template <std::size_t index, class Type>
struct FieldAt {
    Type field;
};

template <class Indices, class... Types>
struct FieldTableBase;

template <std::size_t... index, class... Types>
struct FieldTableBase<std::index_sequence<index...>, Types...> : FieldAt<index, Types>... {
    template <class Function>
    constexpr void for_each([[maybe_unused]] Function&& function) const {
        (function(this->FieldAt<index, Types>::field), ...);
    }
    template <class Object, class Visitor>
    constexpr void visit(Object& object, Visitor& visitor) const {
        (this->FieldAt<index, Types>::field.visit(object, visitor), ...);
    }
};

}  // namespace detail

// The fields of a described struct in their order, each of its own type. Compilers take half the time and memory for it
// that std::tuple and std::apply take, which matters with hundreds of structs.
template <class... Types>
struct FieldTable : detail::FieldTableBase<std::index_sequence_for<Types...>, Types...> {
    static constexpr std::size_t size = sizeof...(Types);

    constexpr FieldTable(Types... fields)
        : detail::FieldTableBase<std::index_sequence_for<Types...>, Types...>{{std::move(fields)}...} {}
};

// Deduces the type of the field at this index.
template <std::size_t index, class Type>
constexpr const Type& field_at(const detail::FieldAt<index, Type>& table) {
    return table.field;
}

template <class... One, class... Other>
constexpr auto joined(const FieldTable<One...>& one, const FieldTable<Other...>& other) {
    return [&]<std::size_t... first, std::size_t... second>(std::index_sequence<first...>,
                                                            std::index_sequence<second...>) {
        return FieldTable<One..., Other...>(field_at<first>(one)..., field_at<second>(other)...);
    }
    (std::index_sequence_for<One...>(), std::index_sequence_for<Other...>());
}

namespace detail {

// An enumerator or a member, as the compiler spells it in the name of this function; for a number without an enumerator
// it prints a cast, in brackets.
template <auto named>
constexpr std::string_view spelling() {
    std::string_view name = __PRETTY_FUNCTION__;
    name.remove_prefix(name.find("named = ") + std::string_view("named = ").size());
    name = name.substr(0, name.find_first_of(";]"));
    return name.front() == '(' ? std::string_view() : name.substr(name.rfind(':') + 1);
}

template <class Enum, std::size_t count = 0>
constexpr std::size_t enumerator_count() {
    if constexpr (spelling<static_cast<Enum>(count)>().empty()) {
        return count;
    } else {
        return enumerator_count<Enum, count + 1>();
    }
}

}  // namespace detail

// Fields under the name that the member has in C++. Where no dimension is given it is a ratio, and where no range is
// given any number is allowed.
template <auto member>
constexpr auto number(Dimension dimension, Interval range, std::string_view meaning) {
    constexpr std::string_view key = detail::spelling<member>();
    return number(key, member, dimension, range, meaning);
}
template <auto member>
constexpr auto number(Dimension dimension, std::string_view meaning) {
    return number<member>(dimension, any_number(), meaning);
}
template <auto member>
constexpr auto number(Interval range, std::string_view meaning) {
    return number<member>(Dimension::ratio, range, meaning);
}
template <auto member>
constexpr auto number(std::string_view meaning) {
    return number<member>(Dimension::ratio, any_number(), meaning);
}
template <auto member>
constexpr auto section(std::string_view meaning) {
    constexpr std::string_view key = detail::spelling<member>();
    return section(key, member, meaning);
}

// The words for the values of an enum: its enumerators, counted from 0 without a gap. An enum with other words has a
// function of this name beside it.
template <class Enum>
requires std::is_enum_v<Enum>
constexpr auto enum_names(Enum) {
    return []<std::size_t... index>(std::index_sequence<index...>) {
        return std::array{detail::spelling<static_cast<Enum>(index)>()...};
    }
    (std::make_index_sequence<detail::enumerator_count<Enum>()>{});
}

// The word for a value of an enum in a case and in a result.
template <class Enum>
requires std::is_enum_v<Enum>
constexpr std::string_view word_of(Enum value) {
    return enum_names(value)[static_cast<std::size_t>(value)];
}

// The value of a word; nothing if the enum has no such word.
template <class Enum>
requires std::is_enum_v<Enum>
constexpr std::optional<Enum> value_of(std::string_view word) {
    const auto words = enum_names(Enum{});
    for (std::size_t index = 0; index < words.size(); ++index) {
        if (words[index] == word) {
            return static_cast<Enum>(index);
        }
    }
    return std::nullopt;
}

template <class Type>
concept Described = requires {
    std::remove_const_t<Type>::fields();
};

template <class Type>
inline constexpr bool is_optional = false;
template <class Type>
inline constexpr bool is_optional<std::optional<Type>> = true;
template <class Type>
inline constexpr bool is_variant = false;
template <class... Types>
inline constexpr bool is_variant<std::variant<Types...>> = true;
template <class Type>
inline constexpr bool is_vector = false;
template <class Type>
inline constexpr bool is_vector<std::vector<Type>> = true;

// double, integers and all other types with addition and comparison, such as derivatives and numbers of 50 digits.
template <class Type>
concept NumberType =
    !std::is_enum_v<std::remove_const_t<Type>> && !std::same_as<std::remove_const_t<Type>, std::string> &&
    !is_optional<std::remove_const_t<Type>> && requires(const Type& one, const Type& other) {
    one + other;
    { one < other } -> std::convertible_to<bool>;
};

// The table of a described struct, which is made once and not in each function that walks through it.
template <Described Object>
inline constexpr auto field_table = Object::fields();

// Calls visit(field info, member) for each field of a described struct, in the order of the table.
template <Described Object, class Visitor>
constexpr void visit_fields(Object& object, Visitor&& visit) {
    field_table<std::remove_const_t<Object>>.visit(object, visit);
}

// "path.key", where either may be empty.
std::string joined_path(const std::string& path, std::string_view key);
// The element with this index, counted from 0, as a person counts: "key[1]" is the first.
std::string indexed(const std::string& key, std::size_t index);

namespace detail {

template <class Type, class Function>
constexpr void walk_numbers(Type& value, const FieldInfo& info, Function& function) {
    if constexpr (Described<Type>) {
        visit_fields(value, [&](const FieldInfo& inner, auto& member) { walk_numbers(member, inner, function); });
    } else if constexpr (is_optional<std::remove_const_t<Type>>) {
        if (value) {
            walk_numbers(*value, info, function);
        }
    } else if constexpr (is_variant<std::remove_const_t<Type>>) {
        std::visit([&](auto& alternative) { walk_numbers(alternative, info, function); }, value);
    } else if constexpr (is_vector<std::remove_const_t<Type>>) {
        for (auto& element : value) {
            walk_numbers(element, info, function);
        }
    } else if constexpr (NumberType<Type>) {
        function(value, info);
    }
}

template <class Type, class Function>
void walk_named_numbers(Type& value, const FieldInfo& info, const std::string& path, Function& function) {
    if constexpr (Described<Type>) {
        visit_fields(value, [&](const FieldInfo& inner, auto& member) {
            walk_named_numbers(member, inner, joined_path(path, inner.key), function);
        });
    } else if constexpr (is_optional<std::remove_const_t<Type>>) {
        if (value) {
            walk_named_numbers(*value, info, path, function);
        }
    } else if constexpr (is_variant<std::remove_const_t<Type>>) {
        std::visit([&](auto& alternative) { walk_named_numbers(alternative, info, path, function); }, value);
    } else if constexpr (is_vector<std::remove_const_t<Type>>) {
        for (std::size_t index = 0; index < value.size(); ++index) {
            walk_named_numbers(value[index], info, indexed(path, index), function);
        }
    } else if constexpr (NumberType<Type>) {
        function(path, info, value);
    }
}

template <class To, class From>
void convert(const From& from, To& to) {
    if constexpr (Described<From>) {
        [&]<std::size_t... index>(std::index_sequence<index...>) {
            (convert(from.*field_at<index>(field_table<From>).member, to.*field_at<index>(field_table<To>).member),
             ...);
        }
        (std::make_index_sequence<decltype(From::fields())::size>{});
    } else if constexpr (is_optional<From>) {
        if (from) {
            convert(*from, to.emplace());
        } else {
            to.reset();
        }
    } else if constexpr (is_variant<From>) {
        [&]<std::size_t... index>(std::index_sequence<index...>) {
            ((from.index() == index ? convert(std::get<index>(from), to.template emplace<index>()) : void()), ...);
        }
        (std::make_index_sequence<std::variant_size_v<From>>{});
    } else if constexpr (is_vector<From>) {
        to.resize(from.size());
        for (std::size_t index = 0; index < from.size(); ++index) {
            convert(from[index], to[index]);
        }
    } else {
        to = static_cast<To>(from);
    }
}

}  // namespace detail

// Calls function(number, info) for every number present, in table order. No allocation.
template <Described Object, class Function>
constexpr void for_each_number(Object& object, Function&& function) {
    detail::walk_numbers(object, FieldInfo{}, function);
}

// Whether every number is finite and in the range of its field.
template <Described Object>
bool in_range(const Object& object) {
    bool inside = true;
    for_each_number(object, [&](const auto& value, const FieldInfo& info) {
        const auto number = static_cast<double>(value);
        inside = inside && std::isfinite(number) && info.range.contains(number);
    });
    return inside;
}

// Calls function(path, info, number) for every number present; paths read "strength.cohesion", "bolt[1].force".
template <Described Object, class Function>
void for_each_named_number(Object& object, Function&& function) {
    detail::walk_named_numbers(object, FieldInfo{}, std::string{}, function);
}

// The same struct with another scalar, e.g. PlaneFailure<double> to PlaneFailure<a 50-digit number>.
template <class To, Described From>
To with_scalar(const From& from) {
    To to{};
    detail::convert(from, to);
    return to;
}

}  // namespace delabole
