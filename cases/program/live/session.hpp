// A case that a page shows and changes: the models answer its requests in JSON. Files are only written for a report
// that is requested, and there is no network access.
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

// Requests carry `values`: by their names and in display units, the inputs that differ from the case's. All functions
// may be called from several threads at a time. They throw LiveRefusal if a request does not have the form that its
// function describes, names something the case does not have, or gives a value out of its range.
class LiveSession {
  public:
    using WriteReport = std::function<std::filesystem::path(const std::vector<std::string>& settings)>;

    // `text` is the case as it was read into `file`. The report is written by a function, because commands stand above.
    LiveSession(CaseFile file, std::string text, WriteReport write_report);

    // Returns the case: title, description, model, groups of inputs with unit, value, range, meaning and source; names
    // of the two inputs of the map; whether blocks can be set in motion and a support is designed, and the bounds of
    // the parameters that a fit leaves free.
    Json open() const;

    // {values, figures}: returns results, warnings, handles, and the first figure of the report, or with "figures":
    // "all" every one. An impossible slope has a `failure` in words instead of results.
    Json answer(const Json& request) const;

    // {values, handle, to: [x, y]}: returns the values that change, and the answer with them.
    Json drag(const Json& request) const;

    // {values, x: {name, lower, upper}, y: {...}, output, columns, rows}: returns the output over a grid of two inputs,
    // row by row, null where there is no answer.
    Json map(const Json& request) const;

    // {values, x, y, columns, rows}, as for a map, for a case with [fit] whose model is not costly: returns, for the
    // first mechanism that has the case's inputs, observed and predicted values and, if the two inputs are free, the
    // misfit over the grid, priors included.
    Json fit(const Json& request) const;

    // {values}: returns what [sensitivity] and [fit] of the case say of the slope, in sentences: see studied().
    Json study(const Json& request) const;

    // {values}, for a case with [support_design]: returns the values of the support that a run of this slope designs,
    // and what its report says of it.
    Json support(const Json& request) const;

    // {values}: returns the case's text with these values.
    Json save(const Json& request) const;

    // {values}: writes the usual report, also of a support that was chosen by hand, and returns its folder.
    Json report(const Json& request);

    // {values}: returns the blocks, with which a motion begins.
    Json start_motion(const Json& request);
    // {milliseconds} or {steps}: returns what has moved by then; see LiveMotion::picture.
    std::string step_motion(const Json& request);
    // Returns how the motion has ended, see LiveMotion::verdict.
    Json verdict_of_motion(const Json& request);
    // {values}: changes strength, water and other loads from now on.
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
