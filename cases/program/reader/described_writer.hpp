// Writes any described struct (parameters/fields.hpp) as TOML: first the values of a section, then its sections.
#pragma once

#include "cases/program/reader/described_kinds.hpp"
#include "cases/program/reader/document.hpp"
#include "cases/program/reader/names.hpp"
#include "cases/program/reader/units.hpp"
#include "geometry/polyline.hpp"
#include "parameters/model_interface.hpp"

#include <string>
#include <type_traits>
#include <variant>

namespace delabole {

// `named` is the dimension of the quantity that the section around names.
template <Described Object>
void write_values(std::string& text, const Object& object, Dimension named = Dimension::ratio);
template <Described Object>
void write_sections(std::string& text, const Object& object, const std::string& path,
                    Dimension named = Dimension::ratio);

inline void write_line(std::string& text, std::string_view key, const std::string& value) {
    text += std::string(key) + " = " + value + "\n";
}
// Writes nothing if the value is empty.
inline void write_text(std::string& text, std::string_view key, const std::string& value) {
    if (!value.empty()) {
        write_line(text, key, in_quotes(value));
    }
}

inline std::string list_in_quotes(const std::vector<std::string>& words) {
    return std::string(1, '[').append(separated(words, ", ", in_quotes)).append(1, ']');
}

inline std::string written_conditions(const std::vector<Condition>& conditions) {
    const std::string table = separated(conditions, ", ", [](const Condition& condition) {
        return in_quotes(condition.input) + " = " + written_quantity(condition.value, condition.dimension);
    });
    return table.empty() ? "{}" : "{ " + table + " }";
}

inline std::string written(const WrittenValue& value) {
    const auto* number = std::get_if<double>(&value);
    return number != nullptr ? written_quantity(*number, Dimension::ratio) : in_quotes(std::get<std::string>(value));
}

inline std::string written_list(const std::vector<double>& values, Dimension dimension) {
    std::string list;
    for (const double value : values) {
        list += (list.empty() ? "[" : ", ") + written_quantity(value, dimension);
    }
    return list + "]";
}

// Points with a unit are written on lines of their own.
inline std::string written_polyline(const Polyline& line, Dimension dimension) {
    const bool lines = dimension != Dimension::ratio;
    std::string list;
    for (const Point& point : line) {
        list += (lines          ? "\n    "
                 : list.empty() ? ""
                                : ", ") +
                written_list({point.x(), point.y()}, dimension) + (lines ? "," : "");
    }
    return "[" + list + (lines ? "\n]" : "]");
}

// Turns lines of values into an inline table.
inline std::string in_one_line(std::string lines) {
    lines.pop_back();
    for (std::size_t at = lines.find('\n'); at != std::string::npos; at = lines.find('\n', at)) {
        lines.replace(at, 1, ", ");
    }
    return "{ " + lines + " }";
}

namespace detail {

template <class Object>
Dimension dimension_named(const Object& object, Dimension around) {
    if constexpr (has_own_dimension<Object>) {
        return object.dimension;
    } else {
        return around;
    }
}

template <class Member>
void write_value(std::string& text, const FieldInfo& info, const Member& member, Dimension named) {
    if constexpr (is_optional<Member>) {
        if (!member) {
            return;
        }
        if constexpr (std::same_as<Member, std::optional<std::vector<Condition>>>) {
            write_line(text, info.key, written_conditions(*member));
        } else {
            write_value(text, info, *member, named);
        }
    } else if constexpr (std::same_as<Member, bool>) {
        if (member) {
            write_line(text, info.key, "true");
        }
    } else if constexpr (std::same_as<Member, WrittenValue>) {
        write_line(text, info.key, written(member));
    } else if constexpr (std::same_as<Member, std::vector<double>>) {
        if (!member.empty()) {
            write_line(text, info.key,
                       written_list(member, info.dimension == Dimension::named ? named : info.dimension));
        }
    } else if constexpr (std::integral<Member>) {
        write_line(text, info.key, std::to_string(member));
    } else if constexpr (NumberType<Member>) {
        write_line(text, info.key,
                   written_quantity(member, info.dimension == Dimension::named ? named : info.dimension));
    } else if constexpr (std::is_enum_v<Member>) {
        write_line(text, info.key, in_quotes(word_of(member)));
    } else if constexpr (std::same_as<Member, std::string>) {
        if (!member.empty() || !info.has_default) {
            write_line(text, info.key, in_quotes(member));
        }
    } else if constexpr (std::same_as<Member, PairOfTexts>) {
        write_line(text, info.key, list_in_quotes({member.begin(), member.end()}));
    } else if constexpr (std::same_as<Member, Polyline>) {
        write_line(text, info.key, written_polyline(member, info.dimension));
    } else if constexpr (std::same_as<Member, std::vector<Condition>>) {
        if (!member.empty()) {
            write_line(text, info.key, written_conditions(member));
        }
    } else if constexpr (is_list_of_texts<Member>) {
        if (!member.empty()) {
            write_line(text, info.key, list_in_quotes(member));
        }
    } else if constexpr (is_variant<Member>) {
        if (info.key.empty()) {
            std::visit(
                [&](const auto& alternative) {
                    if constexpr (requires { alternative.kind; }) {
                        write_line(text, kind_key<Member>(), in_quotes(alternative.kind));
                    }
                    write_values(text, alternative, named);
                },
                member);
        }
    } else if constexpr (Described<Member>) {
        if (info.key.empty()) {
            write_values(text, member, named);
        } else if constexpr (is_written_in_line<Member>) {
            std::string lines;
            write_values(lines, member, named);
            write_line(text, info.key, in_one_line(lines));
        }
    }
}

// Members that are written after their key, and not as a section.
template <class Member>
inline constexpr bool is_value =
    NumberType<Member> || std::is_enum_v<Member> || std::same_as<Member, std::string> || is_list_of_texts<Member> ||
    std::same_as<Member, PairOfTexts> || std::same_as<Member, Polyline> ||
    std::same_as<Member, std::vector<Condition>> || std::same_as<Member, std::vector<double>> ||
    std::same_as<Member, WrittenValue> || is_written_in_line<Member>;

template <class Member>
void write_section(std::string& text, const FieldInfo& info, const Member& member, const std::string& path,
                   Dimension named) {
    if constexpr (is_optional<Member>) {
        if (member) {
            write_section(text, info, *member, path, named);
        }
    } else if constexpr (is_value<Member>) {
        return;
    } else if constexpr (is_vector<Member>) {
        const std::string inner = joined_path(path, info.key);
        for (const auto& element : member) {
            text += "\n[[" + inner + "]]\n";
            write_values(text, element, named);
            write_sections(text, element, inner, named);
        }
    } else if constexpr (is_variant<Member>) {
        std::visit(
            [&](const auto& alternative) {
                if (info.key.empty()) {
                    write_sections(text, alternative, path, named);
                    return;
                }
                const std::string inner = joined_path(path, info.key);
                text += "\n[" + inner + "]\n";
                if constexpr (requires { alternative.kind; }) {
                    write_line(text, kind_key<Member>(), in_quotes(alternative.kind));
                }
                write_values(text, alternative, named);
                write_sections(text, alternative, inner, named);
            },
            member);
    } else if constexpr (Described<Member>) {
        const std::string inner = info.key.empty() ? path : joined_path(path, info.key);
        if (!info.key.empty()) {
            text += "\n[" + inner + "]\n";
            write_values(text, member, named);
        }
        write_sections(text, member, inner, named);
    }
}

}  // namespace detail

template <Described Object>
void write_values(std::string& text, const Object& object, Dimension named) {
    const Dimension own = detail::dimension_named(object, named);
    visit_fields(object,
                 [&](const FieldInfo& info, const auto& member) { detail::write_value(text, info, member, own); });
}

template <Described Object>
void write_sections(std::string& text, const Object& object, const std::string& path, Dimension named) {
    const Dimension own = detail::dimension_named(object, named);
    visit_fields(object, [&](const FieldInfo& info, const auto& member) {
        detail::write_section(text, info, member, path, own);
    });
}

// Writes the fields of `object` that differ from `base`, with values and sections separate. Read over `base` they give
// `object`.
template <Described Object>
void write_differences(std::string& values, std::string& sections, const Object& base, const Object& object,
                       const std::string& path) {
    field_table<Object>.for_each([&](const auto& one) {
        const auto& before = base.*one.member;
        const auto& after = object.*one.member;
        using Member = std::remove_cvref_t<decltype(after)>;
        if constexpr (Described<Member>) {
            if (one.info.key.empty()) {
                write_differences(values, sections, before, after, path);
                return;
            }
        }
        std::string old_value;
        std::string old_section;
        std::string new_value;
        std::string new_section;
        detail::write_value(old_value, one.info, before, Dimension::ratio);
        detail::write_section(old_section, one.info, before, path, Dimension::ratio);
        detail::write_value(new_value, one.info, after, Dimension::ratio);
        detail::write_section(new_section, one.info, after, path, Dimension::ratio);
        if (old_value != new_value) {
            values += new_value;
            if (is_list_of_texts<Member> && new_value.empty()) {
                write_line(values, one.info.key, "[]");
            }
        }
        if (old_section != new_section) {
            sections += new_section;
            if (is_vector<Member> && new_section.empty()) {
                write_line(values, one.info.key, "[]");
            }
        }
    });
}

}  // namespace delabole
