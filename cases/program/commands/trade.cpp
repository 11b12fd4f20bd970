// delabole trade
#include "cases/program/models/relaxation/trade.hpp"
#include "cases/program/commands/commands.hpp"
#include "cases/program/reader/case_error.hpp"
#include "cases/program/reports/study_reports.hpp"
#include "cases/program/results/problems_of_case.hpp"
#include "cases/program/results/study_output.hpp"
#include "cases/program/terminal/interrupt.hpp"
#include "cases/program/terminal/progress.hpp"
#include "dynamic_relaxation/step/scene_check.hpp"

namespace delabole {

namespace {

const RelaxationStudy& study_of(const CaseFile& file) {
    const auto* study = std::get_if<RelaxationStudy>(&file.model);
    if (study == nullptr) {
        throw CaseError(
            {problem_at(file, "model", "only a relaxation has numerical settings to trade accuracy for cost")});
    }
    if (!study->critical) {
        throw CaseError(
            {problem_at(file, "critical",
                        "the case has no [critical] section: there is no value whose accuracy could be measured")});
    }
    const RelaxationScene scene = relaxation_scene(*study);
    SceneFault fault = check_scene(scene);
    fault = fault.check == SceneCheck::valid ? check_start(scene) : fault;
    if (fault.check != SceneCheck::valid) {
        throw CaseError({impossible(file, word_of(fault.check))});
    }
    return *study;
}

// The value that the case expects for its own search, without changed inputs.
const Expectation* expected_value(const CaseFile& file, std::string_view quantity) {
    for (const Expectation& expected : file.expectations) {
        if (expected.quantity == quantity && expected.conditions.empty()) {
            return &expected;
        }
    }
    return nullptr;
}

TradeResult trade_with_progress(const TradeProblem& problem, const Options& options) {
    Progress progress(options.quiet);
    const std::string of_all = " of " + std::to_string(problem.settings.size()) + " settings";
    return trade(
        problem, [&](double share, std::size_t finished) { progress.report(share, std::to_string(finished) + of_all); },
        interrupt_flag());
}

// The reason why a result is not a reliable answer; empty if it is.
std::string reservation(const TradeResult& result, std::size_t settings) {
    switch (result.status) {
    case TradeStatus::finished:
        break;
    case TradeStatus::interrupted:
        return "interrupted: " + std::to_string(result.rows.size()) + " of " + std::to_string(settings) +
               " settings were finished and are shown";
    case TradeStatus::nothing_to_compare:
        return "not converged: no setting has both an answer and a value to hold it against; widen [critical] or give "
               "the value in an [[expect]]";
    }
    return {};
}

}  // namespace

ExitCode trade_command(const std::filesystem::path& path, const Options& options) {
    const Stopwatch watch;
    const CaseFile file = read_case(path, settings_of(options));
    show_units_of(file);
    const RelaxationStudy& study = study_of(file);
    const CriticalPlan plan = critical_plan(study);
    const std::string quantity(name_of_critical(plan.parameter));
    const Expectation* expected = expected_value(file, quantity);
    std::optional<double> known;
    if (expected != nullptr) {
        known = parse_value(expected->value, dimension_of(plan.parameter)).value;
    }
    const TradeProblem problem = trade_problem(study, known, options.threads);
    const TradeTruth truth{quantity, dimension_of(plan.parameter),
                           expected != nullptr
                               ? "the case's expected value (" + expected->source + ")"
                               : "what the finest setting found, for want of an [[expect]] of " + quantity + " (" +
                                     change_in_words(problem.parameters, problem.settings[problem.finest]) + ")",
                           plan.tolerance / 2};
    const ResultFolder folder(options, stem_of(file) + "_trade", OnInterrupt::finish);
    const TradeResult result = trade_with_progress(problem, options);
    answer_interrupt();

    Report report{title_of(file, options), file.description, {}};
    const std::string reserved = reservation(result, problem.settings.size());
    add_reservation(reserved, result.status == TradeStatus::interrupted, report);
    const std::vector<std::string> remarks = trade_remarks(study);
    if (!remarks.empty()) {
        report.add(Notice{NoticeKind::warning, "Warnings", remarks});
    }
    StudyDocuments documents = document_trade(problem.parameters, result, truth, {folder, report});
    Json source = provenance(file, "trade", options, watch.seconds());
    Json json;
    json["status"] = std::string(word_of(result.status));
    json["title"] = file.title;
    json["model"] = std::string(model_name(file.model));
    json.update(documents.json);
    json["warnings"] = remarks;
    json["provenance"] = source;
    append_inputs(file, report);
    for (const std::string& remark : remarks) {
        documents.screen += "warning: " + remark + '\n';
    }
    return write_study({file, json, documents.screen, reserved}, folder, options, report);
}

}  // namespace delabole
