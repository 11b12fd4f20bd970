// Reads any described struct (parameters/fields.hpp) from a section by its table of fields.
#pragma once

#include "cases/program/reader/described_kinds.hpp"
#include "cases/program/reader/names.hpp"
#include "cases/program/reader/section.hpp"
#include "parameters/fields.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>
#include <variant>

namespace delabole {

template <Described Object>
void read_fields(Section& section, Object& object);

namespace detail {

// Calls function.operator()<index, Alternative>() for each alternative of a variant.
template <class Variant, class Function>
void for_each_alternative(Function&& function) {
    [&]<std::size_t... index>(std::index_sequence<index...>) {
        (function.template operator()<index, std::variant_alternative_t<index, Variant>>(), ...);
    }
    (std::make_index_sequence<std::variant_size_v<Variant>>{});
}

template <class Alternative, class Function>
void for_each_field_key(Function&& function) {
    field_table<Alternative>.for_each([&](const auto& field) { function(field.info.key); });
}

template <class Alternative>
std::vector<std::string> field_keys() {
    std::vector<std::string> keys;
    for_each_field_key<Alternative>([&](std::string_view key) { keys.emplace_back(key); });
    return keys;
}

template <class Member>
constexpr bool may_be_absent(const FieldInfo& info) {
    return info.has_default || is_optional<Member> || is_vector<Member>;
}

// The required keys of each alternative of an inlined variant, which stand for it in a message.
template <class Variant>
std::vector<std::string> alternative_names() {
    std::vector<std::string> names;
    for_each_alternative<Variant>([&]<std::size_t, class Alternative>() {
        std::string name;
        Alternative alternative{};
        visit_fields(alternative, [&]<class Member>(const FieldInfo& info, const Member&) {
            if (!may_be_absent<Member>(info) || is_list_of_texts<Member>) {
                name += (name.empty() ? "" : " with ") + std::string(info.key);
            }
        });
        names.push_back(std::move(name));
    });
    return names;
}

template <class Type>
inline constexpr bool is_keyed_variant = false;
template <class... Types>
inline constexpr bool is_keyed_variant<std::variant<Types...>> = (requires { Types::kind; } && ...);

template <class Variant>
std::vector<std::string> kind_names() {
    std::vector<std::string> names;
    for_each_alternative<Variant>([&]<std::size_t, class Alternative>() { names.emplace_back(Alternative::kind); });
    return names;
}

template <class Enum>
std::vector<std::string> enum_words() {
    std::vector<std::string> words;
    for (const std::string_view word : enum_names(Enum{})) {
        words.emplace_back(word);
    }
    return words;
}

template <class Variant>
struct InlinedChoice {
    std::vector<std::size_t> given;      // alternatives with at least one key in the section
    std::vector<std::size_t> by_option;  // those among them with a key given by --set
};

template <class Variant>
InlinedChoice<Variant> given_alternatives(const Section& section) {
    InlinedChoice<Variant> choice;
    for_each_alternative<Variant>([&]<std::size_t index, class Alternative>() {
        bool given = false;
        bool by_option = false;
        for_each_field_key<Alternative>([&](std::string_view key) {
            const Node* node = section.peek(key);
            given = given || node != nullptr;
            by_option = by_option || (node != nullptr && node->place.from_option);
        });
        if (given) {
            choice.given.push_back(index);
        }
        if (by_option) {
            choice.by_option.push_back(index);
        }
    });
    return choice;
}

// Reads an inlined variant, of which exactly one alternative may have keys. If --set gives another alternative, it
// replaces the one in the file.
template <class Variant>
void read_inlined_variant(Section& section, const FieldInfo& info, Variant& variant) {
    for_each_alternative<Variant>([&]<std::size_t, class Alternative>() {
        for_each_field_key<Alternative>([&](std::string_view key) { section.allow(key); });
    });
    InlinedChoice<Variant> choice = given_alternatives<Variant>(section);
    if (choice.given.size() > 1 && choice.by_option.size() == 1) {
        choice.given = choice.by_option;
    }
    if (choice.given.size() != 1) {
        section.reading().lose_inputs();
        const std::vector<std::string> names = alternative_names<Variant>();
        std::vector<std::string> present;
        for (const std::size_t index : choice.given) {
            present.push_back(names[index]);
        }
        const std::string one_of = (present.empty() ? "needs one of " : "takes only one of ") + choices(names) + ": " +
                                   std::string(info.meaning);
        const std::string found = present.empty() ? "" : " (given: " + choices(present) + ")";
        section.reading().complain(section.place(), section.path().empty() ? std::string("the case") : section.path(),
                                   {}, one_of + found);
        return;
    }
    for_each_alternative<Variant>([&]<std::size_t index, class Alternative>() {
        if (choice.given.front() == index) {
            read_fields(section, variant.template emplace<index>());
        }
    });
}

template <class Variant>
std::string kinds_with_key(std::string_view key) {
    std::vector<std::string> kinds;
    for_each_alternative<Variant>([&]<std::size_t, class Alternative>() {
        const std::vector<std::string> keys = field_keys<Alternative>();
        if (std::ranges::find(keys, key) != keys.end()) {
            kinds.emplace_back(Alternative::kind);
        }
    });
    return choices(kinds);
}

// Reads the alternative chosen by the section's `kind`; complains and returns nothing if it chooses none.
template <class Variant>
std::optional<std::size_t> read_kind(Section& section, Variant& variant) {
    const std::vector<std::string> kinds = kind_names<Variant>();
    constexpr std::string_view key = kind_key<Variant>();
    const Node* kind = section.require(key, choices(kinds));
    const auto chosen =
        kind == nullptr ? std::nullopt : read_choice(section.reading(), *kind, section.path_of(key), kinds);
    for_each_alternative<Variant>([&]<std::size_t index, class Alternative>() {
        if (chosen == index) {
            read_fields(section, variant.template emplace<index>());
        } else if (!chosen) {
            for_each_field_key<Alternative>([&](std::string_view other) { section.allow(other); });
        }
    });
    if (!chosen) {
        section.reading().lose_inputs();
    }
    return chosen;
}

template <class Variant>
void read_keyed_variant(Section& section, Variant& variant) {
    const auto chosen = read_kind(section, variant);
    if (!chosen) {
        return;
    }
    section.finish([&](std::string_view unknown) {
        const std::string others = kinds_with_key<Variant>(unknown);
        const std::string of = " of " + std::string(kind_key<Variant>()) + ' ';
        return others.empty() ? "" : of + kind_names<Variant>()[*chosen] + ", but" + of + others;
    });
}

template <class Member>
void read_node(Section& section, const Node& node, const std::string& path, const FieldInfo& info, Member& member) {
    Reading& reading = section.reading();
    if constexpr (std::same_as<Member, bool>) {
        if (node.kind != Node::Kind::boolean) {
            reading.complain(node.place, path, shown(node), "must be true or false");
        }
        member = node.boolean;
    } else if constexpr (std::same_as<Member, WrittenValue>) {
        member = read_written(reading, node, path).value_or(0.0);
    } else if constexpr (std::same_as<Member, std::vector<double>>) {
        if (node.kind != Node::Kind::array) {
            reading.complain(node.place, path, shown(node), "must be a list of values");
        }
        for (std::size_t index = 0; index < node.elements.size(); ++index) {
            member.push_back(
                read_number(reading, node.elements[index], indexed(path, index), info.dimension, info.range)
                    .value_or(0));
        }
    } else if constexpr (std::integral<Member>) {
        member = static_cast<Member>(read_whole_number(reading, node, path, info.range).value_or(0));
    } else if constexpr (NumberType<Member>) {
        member = read_number(reading, node, path, info.dimension, info.range).value_or(0);
    } else if constexpr (std::same_as<Member, std::string>) {
        member = read_text(reading, node, path).value_or("");
    } else if constexpr (std::is_enum_v<Member>) {
        const auto index = read_choice(reading, node, path, enum_words<Member>());
        member = static_cast<Member>(index.value_or(0));
    } else if constexpr (std::same_as<Member, Polyline>) {
        member = read_polyline(reading, node, path, info.dimension);
    } else if constexpr (std::same_as<Member, PairOfTexts>) {
        member = read_pair(reading, node, path, info.meaning);
    } else if constexpr (is_vector<Member>) {
        const std::vector<Node>* tables = as_tables(reading, node, path);
        if (tables == nullptr) {
            reading.lose_inputs();
            return;
        }
        for (std::size_t index = 0; index < tables->size(); ++index) {
            Section element(section, (*tables)[index], indexed(path, index));
            read_fields(element, member.emplace_back());
            element.finish();
        }
    } else if constexpr (Described<Member> || is_keyed_variant<Member>) {
        const Node* table = as_table(reading, node, path);
        if (table == nullptr) {
            reading.lose_inputs();
            return;
        }
        Section inner(section, *table, path);
        if constexpr (is_keyed_variant<Member>) {
            read_keyed_variant(inner, member);
        } else {
            read_fields(inner, member);
            inner.finish();
        }
    }
}

template <class Member>
std::string requirement(const FieldInfo& info) {
    std::string text = text_of(info);
    if constexpr (NumberType<Member>) {
        const std::string range = readable_range(info.range, info.dimension);
        text += " (" + (range.empty() ? std::string(dimension_words(info.dimension).phrase) : range) + ")";
    } else if constexpr (std::is_enum_v<Member>) {
        text += " (" + choices(enum_words<Member>()) + ")";
    } else if constexpr (is_keyed_variant<Member>) {
        text += " (a section with " + std::string(kind_key<Member>()) + " = " + choices(kind_names<Member>()) + ")";
    } else if constexpr (Described<Member>) {
        text += " (a section)";
    }
    return text;
}

// The field with the dimension and range of the quantity that the section names, if the field is a value of that
// quantity; nothing if the name is unknown.
inline std::optional<FieldInfo> resolved(const Section& section, const FieldInfo& info) {
    FieldInfo own = info;
    if (info.dimension == Dimension::named) {
        static const Quantity nothing_named{};  // a ratio
        const Quantity* named = section.named().value_or(&nothing_named);
        if (named == nullptr) {
            return std::nullopt;
        }
        const bool unbounded = std::isinf(info.range.lower) && std::isinf(info.range.upper);
        own.dimension = named->dimension;
        own.range = unbounded ? named->range : info.range;
    }
    return own;
}

template <class Member>
void read_member(Section& section, const FieldInfo& field, Member& member) {
    const std::optional<FieldInfo> info = resolved(section, field);
    if (!info) {
        section.allow(field.key);
    } else if (info->key.empty()) {
        if constexpr (is_keyed_variant<Member>) {
            read_kind(section, member);
        } else if constexpr (is_choice<Member>) {
            read_inlined_variant(section, *info, member);
        } else if constexpr (Described<Member>) {
            read_fields(section, member);
        }
    } else if constexpr (is_list_of_texts<Member>) {
        if (info->name_of == NameOf::nothing) {
            read_words(section, info->key, member);
        } else {
            read_names(section, info->key, info->name_of, info->meaning, member);
        }
    } else if constexpr (std::same_as<Member, std::vector<Condition>>) {
        member = read_conditions(section, info->key);
    } else if constexpr (std::same_as<Member, std::optional<std::vector<Condition>>>) {
        if (section.contains(info->key)) {
            member = read_conditions(section, info->key);
        } else {
            section.allow(info->key);
        }
    } else if constexpr (std::same_as<Member, std::string>) {
        if (info->has_default) {
            member = read_optional_text(section, info->key);
        } else if (info->name_of == NameOf::nothing) {
            const Node* node = section.require(info->key, info->meaning);
            member =
                node == nullptr ? "" : read_text(section.reading(), *node, section.path_of(info->key)).value_or("");
        } else {
            member = read_name(section, info->key, info->name_of, info->meaning);
        }
    } else if (may_be_absent<Member>(*info) && !std::same_as<Member, Polyline>) {
        if (const Node* node = section.take(info->key)) {
            const auto read = [&](auto& value) { read_node(section, *node, section.path_of(info->key), *info, value); };
            if constexpr (is_optional<Member>) {
                read(member.emplace());
                if constexpr (std::same_as<Member, std::optional<std::string>>) {
                    if (member->find_first_not_of(" \t\r\n") == std::string::npos) {
                        section.complain(info->key, *node, "must not be empty: " + std::string(info->meaning));
                    }
                }
            } else {
                read(member);
            }
        }
    } else {
        const Node* node = section.require(info->key, requirement<Member>(*info));
        if (node != nullptr) {
            read_node(section, *node, section.path_of(info->key), *info, member);
        } else if constexpr (Described<Member> || is_choice<Member>) {
            section.reading().lose_inputs();
        }
    }
}

}  // namespace detail

// Reads every field of the table and complains about missing, wrong and out-of-range values. Keys that the table does
// not have are left to the section's finish(). A member with a complaint is zero.
template <Described Object>
void read_fields(Section& section, Object& object) {
    visit_fields(object, [&](const FieldInfo& info, auto& member) { detail::read_member(section, info, member); });
    if constexpr (has_own_dimension<Object>) {
        const Quantity* named = section.named().value_or(nullptr);
        object.dimension = named == nullptr ? Dimension::ratio : named->dimension;
    }
}

// Reads only the fields that the section has; each replaces the object's former value as a whole.
template <Described Object>
void replace_fields(Section& section, Object& object) {
    visit_fields(object, [&](const FieldInfo& info, auto& member) {
        using Member = std::remove_cvref_t<decltype(member)>;
        if constexpr (Described<Member>) {
            if (info.key.empty()) {
                replace_fields(section, member);
                return;
            }
        }
        bool given = section.contains(info.key);
        if constexpr (is_variant<Member>) {
            given = given || (info.key.empty() && !detail::given_alternatives<Member>(section).given.empty());
        }
        if (given) {
            member = Member{};
            detail::read_member(section, info, member);
        } else {
            section.allow(info.key);
        }
    });
}

}  // namespace delabole
