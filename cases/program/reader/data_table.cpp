#include "cases/program/reader/data_table.hpp"

#include "cases/program/reader/names.hpp"
#include "fitting/work/bare_number.hpp"

#include <algorithm>
#include <utility>

namespace delabole {
namespace {

struct Cell {
    std::string text;
    Place place;
};

struct Line {
    Place place;
    std::string_view text;
};

// Lines of data, with the line ends of any system.
std::vector<Line> lines_of(std::string_view text) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (text.starts_with(byte_order_mark)) {
        text.remove_prefix(byte_order_mark.size());
    }
    std::vector<Line> lines;
    for (int number = 1; !text.empty(); ++number) {
        const std::size_t end = text.find('\n');
        std::string_view line = text.substr(0, end);
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
        if (line.ends_with('\r')) {
            line.remove_suffix(1);
        }
        if (!line.empty() && line.front() != '#') {
            lines.push_back({{.line = number, .column = 1}, line});
        }
    }
    return lines;
}

// Splits a line at the commas outside quotes.
class Splitter {
  public:
    Splitter(const Line& line, Reading& reading) : rest_(line.text), place_(line.place), reading_(&reading) {}

    // Complains and returns false if quotes are not closed or are followed by other text.
    bool split(std::vector<Cell>& cells) {
        while (true) {
            Cell& cell = cells.emplace_back(Cell{{}, place_});
            const bool read = !rest_.empty() && rest_.front() == '"' ? read_quoted(cell) : read_plain(cell);
            if (!read) {
                return false;
            }
            if (rest_.empty()) {
                return true;
            }
            advance(1);
        }
    }

  private:
    bool read_plain(Cell& cell) {
        const std::size_t end = std::min(rest_.find(','), rest_.size());
        cell.text = rest_.substr(0, end);
        advance(end);
        return true;
    }

    bool read_quoted(Cell& cell) {
        advance(1);
        while (true) {
            const std::size_t quote = rest_.find('"');
            if (quote == std::string_view::npos) {
                reading_->complain(cell.place, "", "", "quotes are opened here and not closed on this line");
                return false;
            }
            cell.text += rest_.substr(0, quote);
            advance(quote + 1);
            if (rest_.empty() || rest_.front() == ',') {
                return true;
            }
            if (rest_.front() != '"') {
                reading_->complain(place_, "", "", "a comma has to follow the closing quotes");
                return false;
            }
            cell.text += '"';
            advance(1);
        }
    }

    // Columns count characters, so the later bytes of a UTF-8 sequence do not count.
    void advance(std::size_t bytes) {
        for (const char byte : rest_.substr(0, bytes)) {
            place_.column += (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U ? 0 : 1;
        }
        rest_.remove_prefix(bytes);
    }

    std::string_view rest_;
    Place place_;
    Reading* reading_;
};

struct TableColumn {
    const TableColumnField* field;
    std::string unit;  // as written in a quantity, "kg/m3"; empty for a ratio, a word or a text
};

std::string unit_of(std::string_view suffix) {
    std::string unit(suffix);
    for (std::size_t at = unit.find("_per_"); at != std::string::npos; at = unit.find("_per_", at)) {
        unit.replace(at, 5, "/");
    }
    std::ranges::replace(unit, '_', ' ');
    return unit;
}

bool has_unit(const TableColumnField& field) {
    return field.kind == TableColumnField::Kind::number && field.dimension != Dimension::ratio;
}

// The field with the longest key with which the name begins.
const TableColumnField* field_of(const std::string& name, const std::vector<TableColumnField>& fields) {
    const TableColumnField* found = nullptr;
    for (const TableColumnField& field : fields) {
        const bool meant = name == field.key || (has_unit(field) && name.starts_with(field.key + "_"));
        if (meant && (found == nullptr || field.key.size() > found->key.size())) {
            found = &field;
        }
    }
    return found;
}

std::string example_column(const TableColumnField& field) {
    return has_unit(field) ? field.key + std::string(display_unit(field.dimension).suffix) : field.key;
}

void complain_unknown(const Cell& cell, const std::vector<TableColumnField>& fields, Reading& reading) {
    std::vector<std::string> names(fields.size());
    std::ranges::transform(fields, names.begin(), example_column);
    reading.complain(cell.place, cell.text, "", "is not a column of this table" + suggestion(cell.text, names));
}

bool unit_fits(const Cell& cell, const TableColumn& column, Reading& reading) {
    if (!has_unit(*column.field)) {
        return true;
    }
    if (column.unit.empty()) {
        reading.complain(cell.place, cell.text, "", "has no unit, e.g. " + example_column(*column.field));
        return false;
    }
    const ParsedQuantity one = parse_quantity("1 " + column.unit, column.field->dimension);
    if (one.status != QuantityStatus::ok) {
        reading.complain(cell.place, cell.text, "", one.message);
    }
    return one.status == QuantityStatus::ok;
}

// Empty if a column is wrong.
std::vector<TableColumn> read_header(const Line& line, const std::vector<TableColumnField>& fields, Reading& reading) {
    std::vector<Cell> cells;
    if (!Splitter(line, reading).split(cells)) {
        return {};
    }
    // The contents of the file are not shown, since a case may name any file that its reader can read, and the message
    // may be sent on.
    if (std::ranges::none_of(cells, [&](const Cell& cell) { return field_of(cell.text, fields) != nullptr; })) {
        reading.complain(line.place, "", "",
                         "names none of the columns of this table: " + separated(fields, ", ", example_column));
        return {};
    }
    std::vector<TableColumn> columns;
    for (const Cell& cell : cells) {
        const TableColumnField* field = field_of(cell.text, fields);
        if (field == nullptr) {
            complain_unknown(cell, fields, reading);
            continue;
        }
        TableColumn column{field, {}};
        if (cell.text.size() > field->key.size()) {
            column.unit = unit_of(std::string_view(cell.text).substr(field->key.size() + 1));
        }
        if (std::ranges::find(columns, field, &TableColumn::field) != columns.end()) {
            reading.complain(cell.place, cell.text, "", "is given twice");
        } else if (unit_fits(cell, column, reading)) {
            columns.push_back(std::move(column));
        }
    }
    for (const TableColumnField& field : fields) {
        if (field.required && reading.clean() &&
            std::ranges::find(columns, &field, &TableColumn::field) == columns.end()) {
            reading.complain(line.place, field.key, "", "is missing: a column " + example_column(field));
        }
    }
    return reading.clean() ? columns : std::vector<TableColumn>{};
}

Node node_of(const Cell& cell, const TableColumn& column) {
    Node node;
    node.place = node.key_place = cell.place;
    node.kind = Node::Kind::text;
    node.text = column.unit.empty() ? cell.text : cell.text + " " + column.unit;
    if (column.field->kind == TableColumnField::Kind::number && !has_unit(*column.field)) {
        if (const auto number = bare_number(cell.text)) {
            node.kind = Node::Kind::real;
            node.real = *number;
        }
    }
    return node;
}

}  // namespace

std::vector<Node> table_rows(std::string_view text, const std::vector<TableColumnField>& fields, Reading& reading) {
    const std::vector<Line> lines = lines_of(text);
    if (lines.empty()) {
        reading.complain({.line = 1, .column = 1}, "", "", "holds no table: its first line names the columns");
        return {};
    }
    const std::vector<TableColumn> columns = read_header(lines.front(), fields, reading);
    std::vector<Node> rows;
    for (std::size_t index = 1; index < lines.size() && !columns.empty(); ++index) {
        std::vector<Cell> cells;
        if (!Splitter(lines[index], reading).split(cells)) {
            continue;
        }
        if (cells.size() != columns.size()) {
            reading.complain(lines[index].place, "", "",
                             "has " + std::to_string(cells.size()) + " cells where the header has " +
                                 std::to_string(columns.size()));
            continue;
        }
        Node& row = rows.emplace_back();
        row.place = lines[index].place;
        for (std::size_t at = 0; at < cells.size(); ++at) {
            if (!cells[at].text.empty() || columns[at].field->kind == TableColumnField::Kind::text) {
                row.entries.push_back({columns[at].field->key, node_of(cells[at], columns[at])});
            }
        }
    }
    return rows;
}

}  // namespace delabole
