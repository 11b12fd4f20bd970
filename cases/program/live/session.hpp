// A case that a page looks at and changes: what it asks in JSON, answered by the models. No files but those of a report
// that is asked for, no network.
#pragma once

#include "cases/program/case/case_file.hpp"
#include "cases/program/live/motion.hpp"
#include "cases/program/live/request.hpp"
#include "cases/program/results/result_folder.hpp"
#include "cases/program/terminal/options.hpp"
#include "fitting/posterior/fit_problem.hpp"

#include <filesystem>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace delabole {

// Requests carry `values`: inputs by their names in display units, those that differ from the case's. All functions may
// be called from several threads at a time. LiveRefusal where a request has not the form that its function describes,
// names what the case has not, or gives a value out of its range.
class LiveSession {
  public:
    using WriteReport = std::function<std::filesystem::path(const std::vector<std::string>& settings)>;

    // `text` is the case as it was read into `file`. The report is written by a function, because commands stand above.
    LiveSession(CaseFile file, std::string text, WriteReport write_report);

    // The case: title, description, model, groups of inputs with unit, value, range, meaning and source; names of the
    // two inputs of the map; whether blocks can be set in motion and a support is designed, and the bounds of what a
    // fit leaves free.
    Json open() const;

    // {values, figures}: results, warnings, handles, and of the report's figures the first one, or with
    // "figures": "all" every one. An impossible slope has a `failure` in words instead of results.
    Json answer(const Json& request) const;

    // {values, handle, to: [x, y]}: the values that change, and the answer with them.
    Json drag(const Json& request) const;

    // {values, x: {name, lower, upper}, y: {...}, output, columns, rows}: the output over a grid of two inputs, row by
    // row, null where there is no answer.
    Json map(const Json& request) const;

    // {values, x, y, columns, rows}, as for a map, of a case with [fit] whose model is not costly, for the first
    // mechanism that has the case's inputs: what was observed beside what is predicted, and where the two inputs are
    // free, the misfit, priors counted, over the grid.
    Json fit(const Json& request) const;

    // {values}: what the case's [sensitivity] and [fit] say of the slope, in sentences: see studied().
    Json study(const Json& request) const;

    // {values}, of a case with [support_design]: the values of the support that a run of this slope designs, and what
    // its report says of it.
    Json support(const Json& request) const;

    // {values}: the case's text with these values.
    Json save(const Json& request) const;

    // {values}: the folder into which the usual report was written, of a support that was chosen by hand as of that
    // which the run designs.
    Json report(const Json& request);

    // {values}: the blocks, with which a motion begins.
    Json start_motion(const Json& request);
    // {milliseconds} or {steps}: what has moved by then; see LiveMotion::picture.
    std::string step_motion(const Json& request);
    // How it has ended, see LiveMotion::verdict.
    Json verdict_of_motion(const Json& request);
    // {values}: strength, water and other loads from now on.
    Json change_motion(const Json& request);

  private:
    std::vector<Condition> conditions(const Json& request) const;
    CaseModel model(const Json& request) const;
    std::vector<Condition> chosen_support(const std::vector<Condition>& conditions) const;
    Json answer_to(const CaseModel& model, bool all_figures) const;

    const CaseFile file_;
    const std::string text_;
    const std::vector<Quantity> inputs_;
    const std::optional<FitProblem> fit_;  // of one mechanism
    const WriteReport write_report_;
    std::mutex writing_;
    std::mutex moving_;
    std::optional<LiveMotion> motion_;
};

}  // namespace delabole
