// The output folder of a command: result.json, resolved.toml, tables as CSV, figures and report.html.
#pragma once

#include "cases/program/case/case_file.hpp"
#include "cases/program/results/analysis.hpp"
#include "cases/program/results/folder_claim.hpp"
#include "cases/program/terminal/options.hpp"
#include "plots/drawing/figure.hpp"
#include "plots/report/report.hpp"

#include <Eigen/Core>
#include <nlohmann/json.hpp>

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace delabole {

using Json = nlohmann::ordered_json;

// The stem of the file's name: "fig_2_8" for "cases/plane_failure/fig_2_8.toml".
std::string stem_of(const CaseFile& file);

std::vector<Setting> settings_of(const Options& options);

// Selects the units of the case's [report] for sentences, tables and figures until the next case.
void show_units_of(const CaseFile& file);

// The title of the case, or its name, followed by the settings of --set.
std::string title_of(const CaseFile& file, const Options& options);

// A name that carries the display unit of its number: "crack_depth_m", "plane_dip_deg".
std::string column_name(std::string_view name, Dimension dimension);
// The value in its display unit. Lengths, areas and angles below 1e-11 in SI, forces and moments below 1e-6 and
// energies below 1e-9 are rounding and become 0.
double in_display_unit(double value, Dimension dimension);
// A value with its unit, with that many significant digits.
std::string in_digits(double value, Dimension dimension, int digits);
// Four significant digits, for tables of results; counts have six. CSV and JSON have all digits.
std::string in_table_digits(double value, Dimension dimension);
// The same of a number, or a word as it is.
std::string in_table_digits(const std::variant<double, std::string>& value, Dimension dimension);
// Six significant digits, for values that must be told apart or are compared with printed ones.
std::string in_six_digits(double value, Dimension dimension);

// {"factor_of_safety": 1.247, "crack_depth_m": 4.348, "outcome": "stable"}. An infinite value becomes the word
// "infinite".
Json json_of(const std::vector<NamedOutput>& outputs);
// result.json of `delabole run` without its provenance.
Json json_of(const CaseFile& file, const Analysis& analysis);
Json json_number(double value);
// A number in its display unit.
Json json_of(double value, Dimension dimension);
// One list for each row.
Json json_of_matrix(const Eigen::MatrixXd& matrix);
// [lower, upper], in display units.
Json json_of(const Interval& interval, Dimension dimension);
// A member of a result: a number in its display unit, an enumerator by its word, null for what is absent.
template <class Value>
Json json_of_member(const Value& value, Dimension dimension) {
    if constexpr (std::is_enum_v<Value>) {
        return word_of(value);
    } else if constexpr (is_optional<Value>) {
        return value ? json_of_member(*value, dimension) : Json(nullptr);
    } else if constexpr (!std::is_integral_v<Value> && requires { json_of(value, dimension); }) {
        return json_of(value, dimension);
    } else if constexpr (requires { json_of(value); }) {
        return json_of(value);
    } else {
        return value;
    }
}
// Puts members of a result into JSON, each under its name in C++.
template <auto... member, class Result>
void put(Json& json, const Result& result, Dimension dimension = Dimension::ratio) {
    ((json[std::string(detail::spelling<member>())] = json_of_member(result.*member, dimension)), ...);
}
// Indented, with a line end. Bytes that are not UTF-8, which a file name may contain, are replaced.
std::string json_text(const Json& json);

// A cell of a CSV file: a number or a text.
using Cell = std::variant<double, std::string>;

// Comma-separated values with a header; texts are quoted if needed, numbers are in full precision. A text that a
// spreadsheet would take for a formula, because it begins with =, +, -, @, a tab or a line break and is not a number,
// gets an apostrophe in front: a case from another person must not run formulas in the reader's spreadsheet.
class CsvTable {
  public:
    explicit CsvTable(std::vector<std::string> columns);
    void add_row(const std::vector<Cell>& row);
    const std::string& text() const { return text_; }

  private:
    std::string text_;
};

// Appends the titles of the numbers of a described struct; append_cells appends the numbers.
template <Described Row>
void append_titles(std::vector<std::string>& titles) {
    const Row names{};
    for_each_named_number(names, [&](const std::string& name, const FieldInfo& info, double) {
        titles.push_back(column_name(name, info.dimension));
    });
}
template <Described Row>
void append_cells(std::vector<Cell>& cells, const Row& row) {
    for_each_number(
        row, [&](double value, const FieldInfo& info) { cells.emplace_back(in_display_unit(value, info.dimension)); });
}

// Version, revision, case, hash, settings and wall time, which tell how a result was made.
Json provenance(const CaseFile& file, const std::string& command, const Options& options, double wall_seconds);
Provenance provenance_block(const Json& provenance);

// Whether figures are still drawn after an interrupt: a back-analysis shows what it has finished; other commands are
// quickly repeated and end with Interrupted.
enum class OnInterrupt { finish, stop };

// Throws UsageError for a name that would mean another folder, such as ".." for the case file "...toml".
void refuse_as_folder(const std::string& name, const std::string& where);

// --out, or results/<name>, where <name> is made from the case and the command, so that `run` and `fit` of one case do
// not overwrite each other. Throws UsageError for names that refuse_as_folder refuses.
std::filesystem::path result_path(const Options& options, const std::string& name);

// Receives figures in place of a folder.
using FigureTaker = std::function<void(const Figure& figure, const std::string& caption)>;

// One result of one process; see FolderClaim.
class ResultFolder {
  public:
    // Neither writes nor draws anything; used when only the numbers of a report are needed.
    ResultFolder() : threads_(1), with_report_(false), on_interrupt_(OnInterrupt::finish) {}
    // The same, but the taker receives the figures.
    explicit ResultFolder(FigureTaker taker) : ResultFolder() { taker_ = std::move(taker); }
    // Creates the folder and claims it; of several ranks only the leader does so. Throws OutputError if that is
    // impossible, or if a symbolic link stands in place of a file to be written; the folder named by --out may itself
    // be a link. result.json is written last, so that its presence shows that all other files are there.
    ResultFolder(const Options& options, const std::string& name, OnInterrupt on_interrupt);

    void when_interrupted(OnInterrupt on_interrupt) { on_interrupt_ = on_interrupt; }

    const std::filesystem::path& path() const { return path_; }
    // The number of threads given to the command, for long work.
    int threads() const { return threads_; }
    // Reports the share of the work done, 0 to 1, and what is being done to the command, if it listens; called by one
    // thread at a time.
    void report_progress(double share, const std::string& what) const;
    void on_progress(std::function<void(double, const std::string&)> listener) { on_progress_ = std::move(listener); }
    // Throws OutputError also if a file of that name was already written for this result: names of sweeps and
    // mechanisms become file names, and no file may be lost.
    void write(const std::string& name, std::string_view text) const;
    // Puts a text, such as "Table 3.2: ", before the titles of all figures that are drawn from now on.
    void name_figures(std::string begin) const { titles_begin_ = std::move(begin); }
    // If a figure cannot be drawn, the report says so, and a warning appears on standard error even with --quiet,
    // because the report is then incomplete. After an interrupt figures are drawn only for a moment, and only the
    // report tells which are missing.
    FigureInReport draw(const Figure& figure, const std::string& name, const std::string& caption) const;
    void write_report(const Report& report) const;
    // Lists files, named relative to the folder, that other code is about to write here, so that the next result
    // removes them.
    void enter(const std::vector<std::string>& names) const;

  private:
    std::filesystem::path path_;
    std::unique_ptr<FolderClaim> claim_;
    int threads_;
    bool with_report_;
    OnInterrupt on_interrupt_;
    std::function<void(double, const std::string&)> on_progress_ = {};
    FigureTaker taker_ = {};
    mutable std::string titles_begin_;
    mutable std::set<std::string> written_ = {};
};

// A report under way, and the folder of its figures and tables.
struct Sheet {
    const ResultFolder& folder;
    Report& report;

    void add(ReportBlock block) const { report.add(std::move(block)); }
    void draw(const Figure& figure, const std::string& name, const std::string& caption) const {
        add(folder.draw(figure, name, caption));
    }
    void write(const std::string& name, std::string_view text) const { folder.write(name, text); }
};

// Columns for a terminal, the first aligned to the left, the others to the right.
std::string text_table(const std::vector<std::vector<std::string>>& rows);

class Stopwatch {
  public:
    double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

  private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace delabole
