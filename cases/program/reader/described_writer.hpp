// Writes any described struct (parameters/fields.hpp) as TOML: first the values of a section, then its sections.
#pragma once

#include "cases/program/reader/described_kinds.hpp"
#include "cases/program/reader/document.hpp"
#include "cases/program/reader/units.hpp"
#include "parameters/fields.hpp"

#include <string>
#include <type_traits>
#include <variant>

namespace delabole {

template <Described Object>
void write_values(std::string& text, const Object& object);
template <Described Object>
void write_sections(std::string& text, const Object& object, const std::string& path);

inline std::string joined_path(const std::string& path, std::string_view key) {
    return path.empty() ? std::string(key) : path + "." + std::string(key);
}

inline void write_line(std::string& text, std::string_view key, const std::string& value) {
    text += std::string(key) + " = " + value + "\n";
}

inline std::string list_in_quotes(const std::vector<std::string>& words) {
    std::string list;
    for (const std::string& word : words) {
        list += (list.empty() ? "" : ", ") + in_quotes(word);
    }
    return std::string(1, '[').append(list).append(1, ']');
}

namespace detail {

template <class Member>
void write_value(std::string& text, const FieldInfo& info, const Member& member) {
    if constexpr (is_optional<Member>) {
        if (member) {
            write_value(text, info, *member);
        }
    } else if constexpr (NumberType<Member>) {
        write_line(text, info.key, written_quantity(member, info.dimension));
    } else if constexpr (std::is_enum_v<Member>) {
        write_line(text, info.key, in_quotes(word_of(member)));
    } else if constexpr (std::same_as<Member, std::string>) {
        write_line(text, info.key, in_quotes(member));
    } else if constexpr (is_list_of_texts<Member>) {
        if (!member.empty()) {
            write_line(text, info.key, list_in_quotes(member));
        }
    } else if constexpr (is_variant<Member>) {
        if (info.key.empty()) {
            std::visit([&](const auto& alternative) { write_values(text, alternative); }, member);
        }
    } else if constexpr (Described<Member>) {
        if (info.key.empty()) {
            write_values(text, member);
        }
    }
}

template <class Member>
void write_section(std::string& text, const FieldInfo& info, const Member& member, const std::string& path) {
    if constexpr (is_optional<Member>) {
        if (member) {
            write_section(text, info, *member, path);
        }
    } else if constexpr (is_vector<Member> && !is_list_of_texts<Member>) {
        const std::string inner = joined_path(path, info.key);
        for (const auto& element : member) {
            text += "\n[[" + inner + "]]\n";
            write_values(text, element);
            write_sections(text, element, inner);
        }
    } else if constexpr (is_variant<Member>) {
        std::visit(
            [&](const auto& alternative) {
                if (info.key.empty()) {
                    write_sections(text, alternative, path);
                    return;
                }
                const std::string inner = joined_path(path, info.key);
                text += "\n[" + inner + "]\n";
                if constexpr (requires { alternative.kind; }) {
                    write_line(text, kind_key<Member>(), in_quotes(alternative.kind));
                }
                write_values(text, alternative);
                write_sections(text, alternative, inner);
            },
            member);
    } else if constexpr (Described<Member>) {
        const std::string inner = info.key.empty() ? path : joined_path(path, info.key);
        if (!info.key.empty()) {
            text += "\n[" + inner + "]\n";
            write_values(text, member);
        }
        write_sections(text, member, inner);
    }
}

}  // namespace detail

template <Described Object>
void write_values(std::string& text, const Object& object) {
    visit_fields(object, [&](const FieldInfo& info, const auto& member) { detail::write_value(text, info, member); });
}

template <Described Object>
void write_sections(std::string& text, const Object& object, const std::string& path) {
    visit_fields(object,
                 [&](const FieldInfo& info, const auto& member) { detail::write_section(text, info, member, path); });
}

// What replaces parts of `base` when `object` is read over it: only the fields that differ, values and sections apart.
template <Described Object>
void write_differences(std::string& values, std::string& sections, const Object& base, const Object& object,
                       const std::string& path) {
    std::apply(
        [&](const auto&... field) {
            const auto write = [&](const auto& one) {
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
                detail::write_value(old_value, one.info, before);
                detail::write_section(old_section, one.info, before, path);
                detail::write_value(new_value, one.info, after);
                detail::write_section(new_section, one.info, after, path);
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
            };
            (write(field), ...);
        },
        Object::fields());
}

}  // namespace delabole
