#include "cases/program/reports/study_reports.hpp"

#include "dynamic_relaxation/study/relaxation_study.hpp"
#include "fitting/work/words.hpp"
#include "plots/drawing/text.hpp"
#include "plots/figures/study_figures.hpp"

#include <algorithm>
#include <map>
#include <numeric>

namespace delabole {

namespace {

bool is_quality(const std::string& group) {
    return value_of<RelaxationQuality>(group).has_value();
}

std::string setting_in_words(const std::vector<TradeParameter>& parameters, const TradeSetting& setting) {
    const std::string change = change_in_words(parameters, setting);
    if (change.empty()) {
        return "as in the case";
    }
    return is_quality(setting.group) ? setting.group + ": " + change : change;
}

double middle(const TradeAnswer& answer) {
    return (answer.stands + answer.fails) / 2;
}

std::string status_of(const TradeRow& row) {
    return row.answer.failure.empty() ? "found" : std::string(row.answer.failure);
}

Table settings_table(const std::string& caption, const TradeTruth& truth, const std::vector<TradeParameter>& parameters,
                     const TradeResult& result, const std::vector<std::size_t>& rows) {
    const Dimension dimension = truth.dimension;
    Table table{caption,
                {"setting",
                 {human_name(truth.quantity), true},
                 "error"_number,
                 "at most"_number,
                 "contacts evaluated"_number,
                 "steps"_number,
                 "seconds"_number}};
    for (const std::size_t index : rows) {
        const TradeRow& row = result.rows[index];
        const bool found = row.answer.failure.empty();
        table.rows.push_back({setting_in_words(parameters, row.setting),
                              found ? in_six_digits(middle(row.answer), dimension) : human_name(row.answer.failure),
                              row.error ? value_in_words(*row.error, dimension) : "",
                              row.error ? value_in_words(row.error_bound, dimension) : "",
                              human_number(row.answer.cost, 3), human_number(row.answer.steps, 3),
                              human_number(row.answer.wall_seconds, 2)});
    }
    return table;
}

std::string csv_of(const TradeTruth& truth, const std::vector<TradeParameter>& parameters, const TradeResult& result) {
    const Dimension dimension = truth.dimension;
    std::vector<std::string> columns = {"group"};
    for (const TradeParameter& parameter : parameters) {
        columns.push_back(parameter.name);
    }
    columns.emplace_back("status");
    for (const std::string_view name :
         std::initializer_list<std::string_view>{"stands", "fails", truth.quantity, "error", "error_at_most"}) {
        columns.push_back(column_name(name, dimension));
    }
    columns.insert(columns.end(), {"contacts_evaluated", "steps", "runs", "on_front", "wall_seconds"});
    CsvTable csv(columns);
    for (const TradeRow& row : result.rows) {
        std::vector<Cell> cells = {row.setting.group};
        for (std::size_t index = 0; index < parameters.size(); ++index) {
            const double value = row.setting.values[index];
            cells.push_back(parameters[index].words.empty() ? Cell(value)
                                                            : Cell(level_in_words(parameters[index], value)));
        }
        cells.emplace_back(status_of(row));
        const auto value_cell = [&](bool known, double value) {
            cells.push_back(known ? Cell(in_display_unit(value, dimension)) : Cell(""));
        };
        const bool found = row.answer.failure.empty();
        value_cell(found, row.answer.stands);
        value_cell(found, row.answer.fails);
        value_cell(found, middle(row.answer));
        value_cell(row.error.has_value(), row.error.value_or(0));
        value_cell(row.error.has_value(), row.error_bound);
        cells.insert(cells.end(), {row.answer.cost, row.answer.steps, row.answer.runs, row.on_front ? "yes" : "no",
                                   row.answer.wall_seconds});
        csv.add_row(cells);
    }
    return csv.text();
}

Json json_of(const std::vector<TradeParameter>& parameters, const TradeRow& row, Dimension dimension) {
    Json json;
    json["group"] = row.setting.group;
    for (std::size_t index = 0; index < parameters.size(); ++index) {
        const double value = row.setting.values[index];
        json["settings"][parameters[index].name] =
            parameters[index].words.empty() ? json_number(value) : Json(level_in_words(parameters[index], value));
    }
    json["status"] = status_of(row);
    if (row.answer.failure.empty()) {
        json[column_name("stands", dimension)] = in_display_unit(row.answer.stands, dimension);
        json[column_name("fails", dimension)] = in_display_unit(row.answer.fails, dimension);
    }
    if (row.error) {
        json[column_name("error", dimension)] = in_display_unit(*row.error, dimension);
        json[column_name("error_at_most", dimension)] = in_display_unit(row.error_bound, dimension);
    }
    json["contacts_evaluated"] = row.answer.cost;
    json["steps"] = row.answer.steps;
    json["runs"] = row.answer.runs;
    json["on_front"] = row.on_front;
    json["wall_seconds"] = row.answer.wall_seconds;
    return json;
}

// Groups in the order of their first setting. The first two, the case's own setting and the qualities, are drawn last,
// so that they lie on top.
std::vector<TradeCloud> clouds_of(const TradeResult& result, Dimension dimension) {
    std::vector<TradeCloud> clouds;
    std::map<std::string, std::size_t> place;
    for (const TradeRow& row : result.rows) {
        const std::string group = is_quality(row.setting.group)   ? "draft, standard, reference"
                                  : row.setting.group == "own"    ? "as in the case"
                                  : row.setting.group == "corner" ? "several parameters"
                                                                  : human_name(row.setting.group);
        const auto [found, added] = place.try_emplace(group, clouds.size());
        if (added) {
            clouds.push_back({group, {}});
        }
        if (row.error) {
            clouds[found->second].points.emplace_back(std::max(row.answer.cost, 1.0),
                                                      in_display_unit(row.error_bound, dimension));
        }
    }
    std::rotate(clouds.begin(), clouds.begin() + std::min<std::ptrdiff_t>(2, std::ssize(clouds)), clouds.end());
    return clouds;
}

TradeDrawing drawing_of(const TradeResult& result, const TradeTruth& truth) {
    const Dimension dimension = truth.dimension;
    TradeDrawing drawing;
    drawing.title = "Accuracy against cost";
    drawing.cost = "contacts evaluated in the whole search";
    drawing.error = "error of the " + human_name(truth.quantity) + ", at most";
    drawing.error_unit = display_unit(dimension).symbol;
    drawing.clouds = clouds_of(result, dimension);
    drawing.resolution = in_display_unit(truth.half_bracket, dimension);
    for (const std::size_t index : front_of(result)) {
        const TradeRow& row = result.rows[index];
        drawing.front.emplace_back(std::max(row.answer.cost, 1.0), in_display_unit(row.error_bound, dimension));
    }
    for (const TradeRow& row : result.rows) {
        if (row.error && is_quality(row.setting.group)) {
            drawing.labels.push_back(
                {.at = {std::max(row.answer.cost, 1.0), in_display_unit(row.error_bound, dimension)},
                 .text = row.setting.group,
                 .align = Label::Align::centre,
                 .raise = 1});
        }
    }
    return drawing;
}

std::vector<std::size_t> all_rows(const TradeResult& result) {
    std::vector<std::size_t> rows(result.rows.size());
    std::iota(rows.begin(), rows.end(), std::size_t{0});
    return rows;
}

}  // namespace

StudyDocuments document_trade(const std::vector<TradeParameter>& parameters, const TradeResult& result,
                              const TradeTruth& truth, const Sheet& sheet) {
    sheet.write("trade.csv", csv_of(truth, parameters, result));

    const Dimension dimension = truth.dimension;
    const std::string quantity = human_name(truth.quantity);
    const std::string held_against =
        result.truth
            ? "Errors are differences from " + in_six_digits(*result.truth, dimension) + ", " + truth.where_from + "."
            : "There is nothing to hold the answers against: " + truth.where_from + " was not found.";
    const Table best = settings_table("The most accurate setting of each decade of cost", truth, parameters, result,
                                      best_of_each_decade(result));
    sheet.add(Heading{"Accuracy against cost"});
    sheet.add(Paragraph{held_against +
                        " \"At most\" is the distance of the far end of the final bracket, which no luck "
                        "makes small. The cost is the number of contact forces computed in the whole search, "
                        "the same on every machine; seconds are those of this machine and decide nothing."});
    sheet.add(best);
    sheet.draw(trade_figure(drawing_of(result, truth)), "trade",
               "Error against cost: each parameter alone around the case's own settings, several together, and the "
               "qualities. Settings without an answer are in the table.");
    sheet.add(settings_table("Settings that none is both cheaper and at least as accurate as", truth, parameters,
                             result, front_of(result)));
    sheet.add(settings_table("All settings", truth, parameters, result, all_rows(result)));

    StudyDocuments documents;
    documents.json["quantity"] = truth.quantity;
    if (result.truth) {
        documents.json[column_name("truth", dimension)] = in_display_unit(*result.truth, dimension);
    }
    documents.json["truth_from"] = truth.where_from;
    documents.json["settings"] = Json::array();
    for (const TradeRow& row : result.rows) {
        documents.json["settings"].push_back(json_of(parameters, row, dimension));
    }
    std::vector<std::vector<std::string>> lines = {
        {"best of each decade of cost", quantity, "error", "at most", "contacts evaluated", "steps", "seconds"}};
    lines.insert(lines.end(), best.rows.begin(), best.rows.end());
    documents.screen = held_against + "\n\n" + text_table(lines);
    return documents;
}

}  // namespace delabole
