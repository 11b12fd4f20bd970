#include "cases/program/models/stepped_base/columns.hpp"

#include "plots/drawing/text.hpp"

#include <array>
#include <cmath>

namespace delabole {

namespace {

constexpr std::size_t most_named_columns = 200;
constexpr std::size_t most_rows = 60;

struct ColumnNumber {
    std::string_view name;
    Dimension dimension;
    std::string_view meaning;
    double ColumnResult::*member;
};

constexpr std::array column_numbers{
    ColumnNumber{"width", Dimension::length, "width of its base", &ColumnResult::width},
    ColumnNumber{"height", Dimension::length, "height of its middle line", &ColumnResult::height},
    ColumnNumber{"weight", Dimension::force_per_length, "weight", &ColumnResult::weight},
    ColumnNumber{"upper_force", Dimension::force_per_length, "normal force of the column above",
                 &ColumnResult::upper_force},
    ColumnNumber{"upper_force_height", Dimension::length, "height above the base at which that acts",
                 &ColumnResult::upper_force_height},
    ColumnNumber{"lower_force", Dimension::force_per_length, "normal force needed from the column below",
                 &ColumnResult::lower_force},
    ColumnNumber{"lower_force_height", Dimension::length, "height above the base at which that acts",
                 &ColumnResult::lower_force_height},
    ColumnNumber{"against_toppling", Dimension::force_per_length, "force from below that prevents toppling",
                 &ColumnResult::against_toppling},
    ColumnNumber{"against_sliding", Dimension::force_per_length, "force from below that prevents sliding",
                 &ColumnResult::against_sliding},
    ColumnNumber{"normal_reaction", Dimension::force_per_length, "effective normal force of the base",
                 &ColumnResult::normal_reaction},
    ColumnNumber{"shear_reaction", Dimension::force_per_length, "shear force of the base, up-dip",
                 &ColumnResult::shear_reaction},
    ColumnNumber{"friction_ratio", Dimension::ratio, "shear force of the base over normal force",
                 &ColumnResult::friction_ratio},
    ColumnNumber{"reaction_position", Dimension::ratio, "share of the width, from the toe corner, where they act",
                 &ColumnResult::reaction_position}};

std::string in_cell(double value, Dimension dimension) {
    return std::isfinite(value) ? human_number(in_display_unit(value, dimension), 5) : "infinite";
}

std::string remark(const ColumnResult& column) {
    std::string text;
    if (column.mode != ColumnMode::topples && !column.reaction_inside_base) {
        text = "R outside the base: would turn";
    }
    if (!column.base_friction_holds) {
        text += text.empty() ? "" : "; ";
        text += "more than the base can bear";
    }
    return text;
}

}  // namespace

void append_column_outputs(Analysis& analysis, const std::vector<ColumnResult>& columns) {
    if (columns.size() > most_named_columns) {
        return;
    }
    for (const ColumnResult& column : columns) {
        const std::string name = "column[" + std::to_string(column.number) + "].";
        analysis.outputs.push_back({name + "mode", "what it does with the strength as given", Dimension::ratio,
                                    std::string(word_of(column.mode)), true});
        for (const ColumnNumber& number : column_numbers) {
            analysis.outputs.push_back({name + std::string(number.name), std::string(number.meaning), number.dimension,
                                        column.*number.member, true});
        }
    }
}

Table column_table(const std::string& caption, const std::vector<ColumnResult>& columns) {
    const auto force = [](double value) { return in_cell(value, Dimension::force_per_length); };
    const auto length = [](double value) { return in_cell(value, Dimension::length); };
    const auto ratio = [](double value) { return in_cell(value, Dimension::ratio); };
    std::size_t step = 1;
    for (const std::size_t factor : {2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10000, 20000}) {
        step = columns.size() / step > most_rows ? factor : step;
    }
    const std::string unit = std::string(display_unit(Dimension::force_per_length).symbol);
    Table table{caption + (step > 1 ? " One column in " + std::to_string(step) + "; columns.csv has all." : ""),
                {{"column", true},
                 "mode",
                 {"height, m", true},
                 {"weight, " + unit, true},
                 {"P above, " + unit, true},
                 {"at, m", true},
                 {"P below, " + unit, true},
                 {"at, m", true},
                 {"R, " + unit, true},
                 {"S, " + unit, true},
                 {"S / R", true},
                 {"R at / width", true},
                 "remark"}};
    for (std::size_t index = 0; index < columns.size(); ++index) {
        const ColumnResult& column = columns[index];
        if (index > 0 && (index + 1) % step != 0) {
            continue;
        }
        table.rows.push_back({std::to_string(column.number), std::string(word_of(column.mode)), length(column.height),
                              force(column.weight), force(column.upper_force), length(column.upper_force_height),
                              force(column.lower_force), length(column.lower_force_height),
                              force(column.normal_reaction), force(column.shear_reaction), ratio(column.friction_ratio),
                              ratio(column.reaction_position), remark(column)});
    }
    return table;
}

std::string columns_csv(const std::vector<ColumnResult>& as_given, const std::vector<ColumnResult>& limiting) {
    std::vector<std::string> titles{"strength", "column", "mode"};
    for (const ColumnNumber& number : column_numbers) {
        titles.push_back(column_name(number.name, number.dimension));
    }
    titles.emplace_back("reaction_inside_base");
    titles.emplace_back("base_friction_holds");
    CsvTable csv(titles);
    const auto add = [&](const std::string& strength, const std::vector<ColumnResult>& columns) {
        for (const ColumnResult& column : columns) {
            std::vector<std::variant<double, std::string>> row{strength, static_cast<double>(column.number),
                                                               std::string(word_of(column.mode))};
            for (const ColumnNumber& number : column_numbers) {
                row.emplace_back(in_display_unit(column.*number.member, number.dimension));
            }
            row.emplace_back(column.reaction_inside_base ? "yes" : "no");
            row.emplace_back(column.base_friction_holds ? "yes" : "no");
            csv.add_row(row);
        }
    };
    add("as_given", as_given);
    add("limiting", limiting);
    return csv.text();
}

}  // namespace delabole
