// The folder that a command leaves behind: result.json, resolved.toml, tables as CSV, figures and report.html in one
// folder.
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

// "fig_2_8" of "cases/plane_failure/fig_2_8.toml".
std::string stem_of(const CaseFile& file);

std::vector<Setting> settings_of(const Options& options);

// Shows sentences, tables and figures in the units of the case's [report], until the next case.
void show_units_of(const CaseFile& file);

// The case's title, or its name, with what --set has changed.
std::string title_of(const CaseFile& file, const Options& options);

// A number in its display unit under a name that carries the unit: "crack_depth_m", "plane_dip_deg".
std::string column_name(std::string_view name, Dimension dimension);
// Rounding of lengths, areas, angles and forces (1e-11 in SI) is 0.
double in_display_unit(double value, Dimension dimension);
// With its unit, in so many digits.
std::string in_digits(double value, Dimension dimension, int digits);
// Six digits for a reader, who compares with printed values; CSV and JSON have all of them.
std::string in_six_digits(double value, Dimension dimension);

// {"factor_of_safety": 1.247, "crack_depth_m": 4.348, "outcome": "stable"}. Infinite values become the word "infinite".
Json json_of(const std::vector<NamedOutput>& outputs);
// result.json of `delabole run`, but for its provenance.
Json json_of(const CaseFile& file, const Analysis& analysis);
Json json_number(double value);
// A number in its display unit.
Json json_of(double value, Dimension dimension);
// One list for each row.
Json json_of_matrix(const Eigen::MatrixXd& matrix);
// [lower, upper], in display units.
Json json_of(const Interval& interval, Dimension dimension);
// Indented, with a line end. Bytes that are not UTF-8, as a file name may contain, are replaced.
std::string json_text(const Json& json);

// A CSV file has a number or a text in each place.
using Cell = std::variant<double, std::string>;

// Comma-separated, with a header; texts are quoted where they need it, numbers in full precision. A text that a
// spreadsheet would take for a formula, because it begins with =, +, -, @, a tab or a line break and is no number,
// begins with an apostrophe instead: a case from somebody else must not compute anything in its reader's spreadsheet.
class CsvTable {
  public:
    explicit CsvTable(std::vector<std::string> columns);
    void add_row(const std::vector<Cell>& row);
    const std::string& text() const { return text_; }

  private:
    std::string text_;
};

// Titles of the numbers of a described struct, and the numbers below them.
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

// Version, revision, case, hash, settings, wall time: what a result was made from.
Json provenance(const CaseFile& file, const std::string& command, const Options& options, double wall_seconds);
Provenance provenance_block(const Json& provenance);

// Whether figures are still drawn once the flag of cases/program/terminal/interrupt.hpp is set: a back-analysis shows
// what it has, the rest is soon repeated and ends by Interrupted.
enum class OnInterrupt { finish, stop };

// --out, or results/<name>, where <name> is of the case and of the command, so that `run` and `fit` of one case leave
// each other alone. UsageError for names that are folders of their own there, as "..": the case file "...toml".
std::filesystem::path result_path(const Options& options, const std::string& name);

// Takes figures instead of a folder.
using FigureTaker = std::function<void(const Figure& figure, const std::string& caption)>;

// One result of one process: see FolderClaim.
class ResultFolder {
  public:
    // Keeps nothing and draws nothing: for those who want the numbers of a report alone.
    ResultFolder() : threads_(1), with_report_(false), on_interrupt_(OnInterrupt::finish) {}
    // The same, but figures go to the taker.
    explicit ResultFolder(FigureTaker taker) : ResultFolder() { taker_ = std::move(taker); }
    // Creates the folder and claims it; of several ranks only the leader does. OutputError where that is impossible, or
    // where a symbolic link stands for something that is to be written; what --out names itself may be one.
    // result.json is to be written last and so says that all the rest is there.
    ResultFolder(const Options& options, const std::string& name, OnInterrupt on_interrupt);

    void when_interrupted(OnInterrupt on_interrupt) { on_interrupt_ = on_interrupt; }

    const std::filesystem::path& path() const { return path_; }
    // The number that the command was given, for long work.
    int threads() const { return threads_; }
    // How much of the work whose results these are is done, 0 to 1, and what is being done. Told to the command where
    // it listens; from one thread at a time.
    void report_progress(double share, const std::string& what) const;
    void on_progress(std::function<void(double, const std::string&)> listener) { on_progress_ = std::move(listener); }
    // OutputError also where the name was written before: names of sweeps and mechanisms become those of files, and
    // what has them already is not lost.
    void write(const std::string& name, std::string_view text) const;
    // A figure that cannot be drawn is reported inside the report and by a warning on standard error, --quiet or not: a
    // report without its figures is not what was asked for. After an interrupt gnuplot runs for a moment only, and the
    // report alone says so.
    FigureInReport draw(const Figure& figure, const std::string& name, const std::string& caption) const;
    void write_report(const Report& report) const;
    // Enters files, named from the folder, that something else is about to write here: the next result removes them
    // too.
    void enter(const std::vector<std::string>& names) const;

  private:
    std::filesystem::path path_;
    std::unique_ptr<FolderClaim> claim_;
    int threads_;
    bool with_report_;
    OnInterrupt on_interrupt_;
    std::function<void(double, const std::string&)> on_progress_ = {};
    FigureTaker taker_ = {};
    mutable GnuplotRuns gnuplot_runs_ = {};
    mutable std::set<std::string> written_ = {};
};

// Columns aligned for a terminal, the first to the left, the others to the right.
std::string text_table(const std::vector<std::vector<std::string>>& rows);

class Stopwatch {
  public:
    double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

  private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace delabole
