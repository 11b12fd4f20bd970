// Reads tables of test data (CSV) into rows of a described struct (parameters/fields.hpp).
//
// Lines that begin with # are comments; the first other line names the columns. A column name is a key of the struct,
// followed by the unit of its numbers unless they are ratios: "slope_height_in", "density_kg_per_m3". Cells with commas
// or quotes are enclosed in quotes, and inner quotes are doubled. An empty cell means an absent number or an empty
// text.
#pragma once

#include "cases/program/reader/case_error.hpp"
#include "cases/program/reader/described_reader.hpp"
#include "cases/program/reader/ordinary_file.hpp"

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace delabole {

// Fields of a row that are alike: words and texts, ratios, other numbers. The comments of the table say what they are.
template <auto... member>
constexpr auto table_columns() {
    return FieldTable{section<member>("")...};
}
template <auto... member>
constexpr auto table_columns(Interval range) {
    return FieldTable{number<member>(range, "")...};
}
template <auto... member>
constexpr auto table_columns(Dimension dimension, Interval range) {
    return FieldTable{number<member>(dimension, range, "")...};
}

// The columns of three and more such groups.
template <class One, class Other, class... More>
constexpr auto joined(const One& one, const Other& other, const More&... more) requires(sizeof...(More) > 0) {
    return joined(joined(one, other), more...);
}

struct TableColumnField {
    enum class Kind { number, word, text };
    std::string key;
    Dimension dimension;
    Kind kind;
    bool required;  // every row needs a value in this column
};

// One table node for each row, with keys without units and numbers with them; its place is the first cell. Complains
// about columns that are unknown, missing, given twice or in a wrong unit, about rows of another length and about
// quotes. Empty if a column is wrong.
std::vector<Node> table_rows(std::string_view text, const std::vector<TableColumnField>& fields, Reading& reading);

template <Described Row>
std::vector<TableColumnField> table_fields() {
    std::vector<TableColumnField> fields;
    const auto add = [&]<class Member>(const FieldInfo& info, const Member&) {
        using Kind = TableColumnField::Kind;
        constexpr Kind kind = std::is_same_v<Member, std::string> ? Kind::text
                              : std::is_enum_v<Member>            ? Kind::word
                                                                  : Kind::number;
        static_assert(kind != Kind::number || NumberType<Member> || is_optional<Member>,
                      "a row holds numbers, optional numbers, words and texts");
        fields.push_back({std::string(info.key), info.dimension, kind, !is_optional<Member>});
    };
    Row row{};
    visit_fields(row, add);
    return fields;
}

// The `check` of a table whose rows need no check as a whole.
inline constexpr auto any_rows = [](Reading&, const auto&, const std::vector<Node>&) {};

// Throws CaseError with all problems, each with line and column; `name` names the text in messages. If every single row
// is right, `check(reading, rows, nodes)` is called, which may complain at the place of a node.
template <Described Row, class Check = decltype(any_rows)>
std::vector<Row> parse_table(std::string_view text, std::string_view name, const Check& check = any_rows) {
    Reading reading{std::string(name)};
    const std::vector<Node> nodes = table_rows(text, table_fields<Row>(), reading);
    std::vector<Row> rows(nodes.size());
    for (std::size_t index = 0; index < nodes.size(); ++index) {
        Section section(reading, nodes[index], "");
        read_fields(section, rows[index]);
    }
    if (reading.clean()) {
        check(reading, rows, nodes);
    }
    reading.finish();
    return rows;
}

// Reads the file that a key names and returns parse(text, name). If the file cannot be read or parsed, it complains and
// returns nothing.
template <class Parse>
auto read_table_file(Reading& reading, const std::string& key, const std::filesystem::path& path, std::string_view what,
                     std::size_t largest, const Parse& parse) -> decltype(parse(what, what)) {
    const FileContent content = read_ordinary_file(path, what, largest);
    if (!content.fault.empty()) {
        reading.complain_at(key, path.string() + " " + content.fault);
        return {};
    }
    try {
        return parse(content.bytes, path.string());
    } catch (const CaseError& error) {
        for (const Problem& problem : error.problems()) {
            reading.complain(problem);
        }
        return {};
    }
}

}  // namespace delabole
