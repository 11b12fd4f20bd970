// The text of a case as a tree of plain values, each with its place. Only these files use the TOML library.
#pragma once

#include "cases/program/reader/case_error.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace delabole {

struct Place {
    int line = 0;  // from 1; 0 for a value given by --set
    int column = 0;
    bool from_option = false;  // given by --set
};

struct Entry;

// One value of the tree. Only the member that belongs to `kind` is meaningful.
struct Node {
    enum class Kind { table, array, text, integer, real, boolean, date };

    Kind kind = Kind::table;
    Place place;      // of the value
    Place key_place;  // of its key; that of the value if it has none
    std::string text;
    std::int64_t integer = 0;
    double real = 0;
    bool boolean = false;
    std::vector<Entry> entries;  // of a table, in the order of the file
    std::vector<Node> elements;  // of an array

    const Node* find(std::string_view key) const;
    Node* find(std::string_view key);
};

struct Entry {
    std::string key;
    Node value;
};

inline constexpr std::size_t largest_case_bytes = std::size_t{4} << 20U;

// Throws CaseError for text that is too long, not UTF-8, not TOML, nested too deep or made of too many values.
// `name` names the text in messages.
Node parse_document(std::string_view text, std::string_view name);

// One `--set key=value`.
struct Setting {
    std::string key;    // "slope.height", "bolt[1].force"
    std::string value;  // a TOML value, 0.5 or "40 m"; any other text, such as 40 m, is taken as a string
};

// Splits "key=value". Throws CaseError if there is no "=" or no key.
Setting parse_setting(std::string_view text);

// Sets or adds the value at a path such as bolt[1].force; missing sections are created. Returns the reason if that is
// impossible, otherwise an empty text.
std::string put_value(Node& root, std::string_view path, Node value);

// The same for a setting; a problem is added to `problems`.
void apply_setting(Node& root, const Setting& setting, std::vector<Problem>& problems);

// A value as shown in messages: "40 m" in quotes, 0.5 without, at most about 60 characters, no control characters.
std::string shown(const Node& node);
std::string shown(std::string_view text);

// Text as written in a case file between double quotes, including the quotes.
std::string in_quotes(std::string_view text);

}  // namespace delabole
