// Rows of a reproduction: their verdicts, and how they are told on screen and in reports.
#include "cases/program/thesis/reproduction.hpp"
#include "plots/drawing/text.hpp"

#include <algorithm>
#include <array>

namespace delabole {

Remark statement(bool met) {
    return Remark(met ? RowVerdict::met : RowVerdict::not_met);
}

Remark operator+(Remark remark, std::string_view more) {
    remark += more;
    return remark;
}

std::string in_words(const Remark& remark) {
    constexpr std::array verdicts{"", "statement met", "statement NOT met"};
    return verdicts[static_cast<std::size_t>(remark.verdict)] + remark.text;
}

namespace {

bool names_clean_engine(const std::vector<PrintedRow>& rows) {
    return std::ranges::any_of(rows, [](const PrintedRow& row) { return !row.clean.empty(); });
}

}  // namespace

Table printed_table(const std::string& caption, const std::vector<PrintedRow>& rows) {
    Table table{caption, {"quantity", "printed"_number, "computed"_number, "difference"_number, "remark"}};
    const bool both = names_clean_engine(rows);
    if (both) {
        table.columns.insert(table.columns.begin() + 3, "clean engine"_number);
    }
    for (const PrintedRow& row : rows) {
        table.rows.push_back({row.what, row.printed, row.computed, row.difference, in_words(row.remark)});
        if (both) {
            table.rows.back().insert(table.rows.back().begin() + 3, row.clean);
        }
    }
    return table;
}

namespace {

struct ScreenColumn {
    std::string_view heading;
    std::size_t width;  // characters
};

// The widths add up to lines of 118 characters, two blanks between columns included.
constexpr std::array<ScreenColumn, 5> screen_columns{
    {{"quantity", 46}, {"printed", 22}, {"computed", 22}, {"difference", 13}, {"met", 7}}};

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        lines.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return lines;
}

// Each cell is wrapped in its column.
std::string screen_row(const std::array<std::string, screen_columns.size()>& cells) {
    std::array<std::vector<std::string>, screen_columns.size()> wrapped_cells;
    std::size_t height = 0;
    for (std::size_t column = 0; column < cells.size(); ++column) {
        wrapped_cells[column] = lines_of(wrapped(cells[column], screen_columns[column].width));
        height = std::max(height, wrapped_cells[column].size());
    }
    std::string text;
    for (std::size_t number = 0; number < height; ++number) {
        std::string line;
        std::size_t begin = 0;  // of the column
        for (std::size_t column = 0; column < cells.size(); ++column) {
            const std::vector<std::string>& lines = wrapped_cells[column];
            const std::size_t used = letter_count(line);
            if (number < lines.size() && !lines[number].empty()) {
                line += std::string(begin > used ? begin - used : 0, ' ') + lines[number];
            }
            begin += screen_columns[column].width + 2;
        }
        text += line + '\n';
    }
    return text;
}

// The note stands below its row, indented.
std::string screen_note(const std::string& text) {
    constexpr std::size_t width = 114;  // with the indentation as wide as the columns
    std::string note;
    for (const std::string& line : lines_of(wrapped(text, width))) {
        note += "    " + line + '\n';
    }
    return text.empty() ? "" : note;
}

}  // namespace

std::string screen_table(const std::vector<PrintedRow>& rows) {
    std::array<std::string, screen_columns.size()> headings;
    std::ranges::transform(screen_columns, headings.begin(), &ScreenColumn::heading);
    std::string text = screen_row(headings);
    std::string place;
    for (const PrintedRow& row : rows) {
        if (row.place != place) {
            place = row.place;
            text += '\n' + place + '\n';
        }
        constexpr std::array verdicts{"", "met", "NOT met"};
        text += screen_row({row.what, row.printed, row.computed, row.difference,
                            verdicts[static_cast<std::size_t>(row.remark.verdict)]});
        text += screen_note(row.clean.empty() ? "" : "clean engine: " + row.clean);
        const std::size_t first = row.remark.text.find_first_not_of(":;, ");
        text += screen_note(first == std::string::npos ? "" : row.remark.text.substr(first));
    }
    return text;
}

RowCounts count_rows(const std::vector<PrintedRow>& rows) {
    RowCounts counts;
    for (const PrintedRow& row : rows) {
        const bool printed = !row.printed.empty() && row.printed != "not printed";
        switch (row.remark.verdict) {
        case RowVerdict::met:
            ++counts.met;
            break;
        case RowVerdict::not_met:
            ++counts.not_met;
            break;
        case RowVerdict::none:
            ++(printed ? counts.beside : counts.not_printed);
            break;
        }
    }
    return counts;
}

std::string in_words(const RowCounts& counts) {
    return "statements met " + std::to_string(counts.met) + ", not met " + std::to_string(counts.not_met) +
           "; computed beside the printed " + std::to_string(counts.beside) + "; not printed " +
           std::to_string(counts.not_printed);
}

}  // namespace delabole
