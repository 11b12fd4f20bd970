#include "cases/program/results/result_folder.hpp"

#include "cases/program/case/case_writer.hpp"
#include "cases/program/terminal/interrupt.hpp"
#include "fitting/work/bare_number.hpp"
#include "fitting/work/ranks.hpp"
#include "plots/drawing/atomic_file.hpp"
#include "plots/drawing/text.hpp"
#include "plots/report/shown_units.hpp"
#include "version/version.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <iostream>

namespace delabole {

namespace {

// A number in full precision; infinite values and NaN as words, as in JSON.
std::string shortest(double value) {
    if (!std::isfinite(value)) {
        return std::isnan(value) ? "undefined" : value > 0 ? "infinite" : "-infinite";
    }
    std::array<char, 32> buffer{};
    return {buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr};
}

bool may_be_formula(std::string_view text) {
    return !text.empty() && std::string_view("=+-@\t\r\n").find(text.front()) != std::string_view::npos &&
           !bare_number(text.substr(text.starts_with('+') ? 1 : 0));
}

// Below this a number is only rounding.
double rounding_of(Dimension dimension) {
    switch (dimension) {
    case Dimension::length:
    case Dimension::area:
    case Dimension::angle:
        return 1e-11;  // less than the size of an atom
    case Dimension::force:
    case Dimension::force_per_length:
    case Dimension::moment_per_length:
        return 1e-6;  // the weight of a grain of sand; that of a column is 1e6 N/m
    case Dimension::energy_per_length:
        return 1e-9;  // that grain, let fall by a millimetre
    default:
        return 0;
    }
}

std::string quoted(const std::string& text) {
    const bool formula = may_be_formula(text);
    if (!formula && text.find_first_of(",\"\n\r") == std::string::npos) {
        return text;
    }
    std::string result = formula ? "\"'" : "\"";
    for (const char letter : text) {
        result += letter == '"' ? "\"\"" : std::string(1, letter);
    }
    return result + '"';
}

}  // namespace

std::string stem_of(const CaseFile& file) {
    return std::filesystem::path(file.name).stem().string();
}

std::vector<Setting> settings_of(const Options& options) {
    std::vector<Setting> settings;
    for (const std::string& text : options.settings) {
        settings.push_back(parse_setting(text));
    }
    return settings;
}

void show_units_of(const CaseFile& file) {
    show_units_in(file.report ? file.report->units : UnitSystem::metric);
}

std::string title_of(const CaseFile& file, const Options& options) {
    std::string changed;
    for (const Setting& setting : settings_of(options)) {
        if (setting.key != "title" && setting.key != "description") {
            changed += (changed.empty() ? "" : ", ") + setting.key + " = " + setting.value;
        }
    }
    const std::string title = file.title.empty() ? file.name : file.title;
    return changed.empty() ? title : title + " [" + changed + "]";
}

std::string column_name(std::string_view name, Dimension dimension) {
    return std::string(name) + std::string(display_unit(dimension).suffix);
}

double in_display_unit(double value, Dimension dimension) {
    return std::abs(value) < rounding_of(dimension) ? 0 : value / display_unit(dimension).si_per_unit;
}

std::string in_digits(double value, Dimension dimension, int digits) {
    const DisplayUnit unit = shown_unit(dimension);
    std::string text = human_number(in_display_unit(value, dimension) == 0 ? 0 : value / unit.si_per_unit, digits);
    if (!unit.symbol.empty()) {
        text.append(" ").append(unit.symbol);
    }
    return text;
}

std::string in_table_digits(double value, Dimension dimension) {
    const bool counts = dimension == Dimension::ratio && value == std::round(value);
    return in_digits(value, dimension, counts ? 6 : 4);
}

std::string in_table_digits(const Cell& value, Dimension dimension) {
    const auto* number = std::get_if<double>(&value);
    return number != nullptr ? in_table_digits(*number, dimension) : std::get<std::string>(value);
}

std::string in_six_digits(double value, Dimension dimension) {
    return in_digits(value, dimension, 6);
}

Json json_number(double value) {
    if (std::isfinite(value)) {
        return value;
    }
    return std::isnan(value) ? "undefined" : value > 0 ? "infinite" : "-infinite";
}

Json json_of(double value, Dimension dimension) {
    return json_number(in_display_unit(value, dimension));
}

Json json_of_matrix(const Eigen::MatrixXd& matrix) {
    Json json = Json::array();
    for (const auto row : matrix.rowwise()) {
        json.push_back(std::vector<double>(row.begin(), row.end()));
    }
    return json;
}

Json json_of(const std::vector<NamedOutput>& outputs) {
    Json json = Json::object();
    for (const NamedOutput& output : outputs) {
        if (const auto* number = std::get_if<double>(&output.value)) {
            json[column_name(output.name, output.dimension)] = json_of(*number, output.dimension);
        } else {
            json[output.name] = std::get<std::string>(output.value);
        }
    }
    return json;
}

Json json_of(const CaseFile& file, const Analysis& analysis) {
    Json json;
    json["status"] = analysis.status;
    json["title"] = file.title;
    json["model"] = std::string(model_name(file.model));
    json["results"] = json_of(analysis.outputs);
    json["warnings"] = analysis.warnings;
    return json;
}

Json json_of(const Interval& interval, Dimension dimension) {
    return Json::array({json_of(interval.lower, dimension), json_of(interval.upper, dimension)});
}

std::string json_text(const Json& json) {
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

CsvTable::CsvTable(std::vector<std::string> columns) {
    add_row({columns.begin(), columns.end()});
}

void CsvTable::add_row(const std::vector<Cell>& row) {
    for (std::size_t index = 0; index < row.size(); ++index) {
        text_ += index == 0 ? "" : ",";
        if (const auto* number = std::get_if<double>(&row[index])) {
            text_ += shortest(*number);
        } else {
            text_ += quoted(std::get<std::string>(row[index]));
        }
    }
    text_ += '\n';
}

Json provenance(const CaseFile& file, const std::string& command, const Options& options, double wall_seconds) {
    Json json;
    json["program"] = "delabole " + std::string(version());
    json["revision"] = std::string(revision());
    json["command"] = command;
    json["case"] = file.name;
    json["case_hash"] = case_hash(file);
    json["settings"] = options.settings;
    if (options.seed) {
        json["seed"] = *options.seed;
    }
    json["threads"] = options.threads;
    if (options.ranks != nullptr && !options.ranks->alone()) {
        json["ranks"] = options.ranks->count();
    }
    json["wall_seconds"] = wall_seconds;
    return json;
}

Provenance provenance_block(const Json& provenance) {
    Provenance block;
    for (const auto& [key, value] : provenance.items()) {
        block.entries.emplace_back(key, value.is_string() ? value.get<std::string>()
                                                          : value.dump(-1, ' ', false, Json::error_handler_t::replace));
    }
    return block;
}

namespace {

bool too_late_for_figures() {
    constexpr double still_drawn = 0.7;  // s; with the rest of the report, a command then ends within 2 s of Ctrl-C
    return seconds_since_interrupt() > still_drawn;
}

// All cases of a command share it: a gnuplot that hangs is waited for only once.
GnuplotRuns gnuplot_runs{.give_up = too_late_for_figures};

}  // namespace

void refuse_as_folder(const std::string& name, const std::string& where) {
    if (name.empty() || name == "." || name == "..") {
        throw UsageError("\"" + name + "\" cannot be the name of a folder " + where);
    }
}

std::filesystem::path result_path(const Options& options, const std::string& name) {
    if (!options.out.empty()) {
        return options.out;
    }
    refuse_as_folder(name, "in results: name one with --out");
    return std::filesystem::path("results") / name;
}

ResultFolder::ResultFolder(const Options& options, const std::string& name, OnInterrupt on_interrupt)
    : path_(result_path(options, name)),
      threads_(options.threads),
      with_report_(!options.no_report),
      on_interrupt_(on_interrupt) {
    if (options.out.empty()) {
        refuse_link(path_.parent_path());
        refuse_link(path_);
    }
    for (const std::string_view written : {"result.json", "resolved.toml", "report.html", "figures", "frames"}) {
        refuse_link(path_ / written);
    }
    const std::filesystem::path result = path_ / "result.json";
    std::error_code ignored;
    if (std::filesystem::is_directory(result, ignored)) {
        throw OutputError(result, "it is a folder");
    }
    if (leads(options)) {
        claim_ = std::make_unique<FolderClaim>(path_);
    } else {
        create_output_folder(path_);
    }
}

void ResultFolder::enter(const std::vector<std::string>& names) const {
    if (claim_ != nullptr) {
        claim_->enter(names);
    }
}

void ResultFolder::report_progress(double share, const std::string& what) const {
    if (on_progress_) {
        on_progress_(share, what);
    }
}

void ResultFolder::write(const std::string& name, std::string_view text) const {
    if (path_.empty()) {
        return;
    }
    if (!written_.insert(name).second) {
        throw OutputError(path_ / name, "the result has another table of this name: rename the sweep or mechanism");
    }
    enter({name});
    write_file_atomically(path_ / name, text);
}

FigureInReport ResultFolder::draw(const Figure& figure, const std::string& name, const std::string& caption) const {
    if (taker_) {
        taker_(figure, caption);
    }
    if (!with_report_) {
        return {{}, caption};
    }
    if (on_interrupt_ == OnInterrupt::stop) {
        stop_if_interrupted();
    }
    if (too_late_for_figures()) {
        gnuplot_runs.none_because = "the work was interrupted";
    }
    std::string file = name;
    for (int number = 2; !written_.insert("figures/" + file).second; ++number) {
        file = name + "_" + std::to_string(number);
    }
    enter({"figures/" + file + ".gp", "figures/" + file + ".svg", "figures/" + file + ".png"});
    Figure shown = in_shown_units(figure);
    shown.title.insert(0, titles_begin_);
    const FigureFiles files = write_figure(shown, path_ / "figures", file, gnuplot_runs);
    if (files.write_error) {
        throw *files.write_error;
    }
    if (files.status != FigureStatus::ok && !interrupt_flag()) {
        std::cerr << "warning: figure " << name << " was not drawn: " << files.message << '\n';
    }
    return {files, caption};
}

void ResultFolder::write_report(const Report& report) const {
    if (!with_report_) {
        return;
    }
    enter({"report.html"});
    delabole::write_report(in_shown_units(report), path_ / "report.html");
}

std::string text_table(const std::vector<std::vector<std::string>>& rows) {
    return aligned_columns(rows, FurtherColumns::right);
}

}  // namespace delabole
