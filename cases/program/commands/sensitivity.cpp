// delabole sensitivity
#include "fitting/sensitivity/sensitivity.hpp"

#include "cases/program/commands/commands.hpp"
#include "cases/program/reader/names.hpp"
#include "cases/program/reports/study_reports.hpp"
#include "cases/program/results/kept_evaluations.hpp"
#include "cases/program/results/model_reports.hpp"
#include "cases/program/results/problems_of_case.hpp"
#include "cases/program/results/study_output.hpp"
#include "cases/program/sweeps/support_report.hpp"
#include "cases/program/terminal/interrupt.hpp"
#include "cases/program/terminal/progress.hpp"
#include "plots/drawing/text.hpp"

#include <iterator>

namespace delabole {

namespace {

SensitivityResult study_with_progress(const SensitivityProblem& problem, const Options& options) {
    Progress progress(options.quiet);
    return sensitivity(
        problem, [&](const FitProgress& state) { progress.report(state.fraction, std::string(state.stage)); },
        &interrupt_flag());
}

// The reason why a result is not a reliable answer; empty if it is.
std::string reservation(SensitivityStatus status) {
    return words_for(status,
                     {"", "interrupted: the study was stopped early; what it had finished is shown",
                      "not converged: a method found no value of the quantity anywhere; the causes are in the report",
                      "not converged: the search for the design point ended before its tolerance; try "
                      "sensitivity.reliability.step and .tolerance"});
}

// Appends the slope itself, below the head card. Blocks in motion are left out: their picture requires a run.
void append_slope(const CaseModel& model, const Sheet& sheet) {
    if (std::holds_alternative<RelaxationStudy>(model)) {
        return;
    }
    const CaseAnswer answer = analyse_case(model);
    if (!std::visit([](const auto& own) { return failure_in(own); }, answer).empty()) {
        return;
    }
    std::vector<ReportBlock> blocks{Heading{"The slope with the values of the case"}};
    blocks.emplace_back(Paragraph{separated(head_card(model, answer).sentences, " ")});
    if (const auto picture = first_case_figure(model, answer)) {
        blocks.emplace_back(sheet.folder.draw(picture->figure, "section", picture->caption));
    }
    sheet.report.blocks.insert(sheet.report.blocks.begin() + 1, std::move_iterator(blocks.begin()),
                               std::move_iterator(blocks.end()));
}

}  // namespace

ExitCode sensitivity_command(const std::filesystem::path& path, const Options& options) {
    const Stopwatch watch;
    CaseFile file = read_case(path, settings_of(options));
    show_units_of(file);
    require_section(file.sensitivity.has_value(), file, "sensitivity");
    const std::optional<DesignedSupport> support = design_support_of(file, [](double) { return !interrupt_flag(); });
    stop_if_interrupted();
    SensitivityProblem problem = sensitivity_problem_of(file, options.threads, options.seed);
    const ResultFolder folder(options, stem_of(file) + "_sensitivity", OnInterrupt::finish);
    KeptEvaluations kept(options, folder);
    kept.keep(problem.model, file.model, stem_of(file));
    problem.ranks = options.ranks;
    const SensitivityResult result = study_with_progress(problem, options);
    answer_interrupt();
    kept.collect();
    if (!leads(options)) {
        return ExitCode::ok;
    }

    Report report{title_of(file, options), file.description, {}};
    const std::string reserved = reservation(result.status);
    add_reservation(reserved, result.status == SensitivityStatus::interrupted, report);
    StudyDocuments documents = document_sensitivity(file, problem, result, {folder, report});
    Json json;
    json["status"] = word_of(result.status);
    json.update(documents.json);
    append_slope(file.model, {folder, report});
    if (support) {
        for (ReportBlock& block : report.blocks) {
            if (auto* head = std::get_if<HeadCard>(&block)) {
                add_to_head(*support, *head);
            }
        }
        json["support_design"] = document_support(*support, {folder, report});
        documents.screen = support->sentence + "\n" + documents.screen;
    }
    Json source = provenance(file, "sensitivity", options, watch.seconds());
    source["study_seconds"] = result.wall_seconds;
    source["seed"] = problem.study.seed;
    kept.write_runs(folder);
    kept.enter(source);
    json["provenance"] = source;
    append_inputs(file, report);
    const ExitCode code =
        write_study({file, json, documents.screen + kept.summary(), reserved}, folder, options, report);
    if (result.status == SensitivityStatus::interrupted) {
        kept.say_how_to_go_on();
    }
    return code;
}

}  // namespace delabole
