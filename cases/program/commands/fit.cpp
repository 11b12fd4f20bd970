// delabole fit
#include "cases/program/commands/commands.hpp"
#include "cases/program/reports/study_reports.hpp"
#include "cases/program/results/kept_evaluations.hpp"
#include "cases/program/results/problems_of_case.hpp"
#include "cases/program/results/study_output.hpp"
#include "cases/program/terminal/interrupt.hpp"
#include "cases/program/terminal/progress.hpp"
#include "fitting/back_analysis/back_analysis.hpp"
#include "fitting/studies/candidate_draws.hpp"

#include <algorithm>
#include <iterator>

namespace delabole {

namespace {

template <class Work>
auto with_progress(const Options& options, Work&& work) {
    Progress progress(options.quiet);
    return work(told_to(progress));
}

// The reason why a result is not a reliable answer; empty if it is.
std::string reservation_of_fit(const std::string& status) {
    if (status == "interrupted") {
        return "interrupted: the back-analysis was stopped early; what it had found is shown";
    }
    if (status == "evaluation_limit") {
        return "not converged: the best search of a mechanism ended at its limit of evaluations before its tolerance; "
               "fit.evaluations_per_start sets the limit";
    }
    if (status == "posterior_not_converged") {
        return "not converged: a mechanism's posterior was not sampled until its chains agreed; "
               "fit.posterior.evaluations_per_chain sets the limit";
    }
    if (status == "no_valid_point") {
        return "not converged: a mechanism has no valid geometry anywhere between the bounds of its parameters";
    }
    return {};
}

// Keeps the mechanisms that are asked for. Returns the names of costly ones that were left out.
std::vector<std::string> choose_mechanisms(CaseFit& fit, const Options& options) {
    if (options.mechanisms.empty()) {
        return options.with_costly ? std::vector<std::string>() : leave_out_costly(fit);
    }
    leave_mechanisms(fit, options.mechanisms);
    return {};
}

}  // namespace

ExitCode fit_command(const std::filesystem::path& path, const Options& options) {
    const Stopwatch watch;
    CaseFile file = read_case(path, settings_of(options));
    show_units_of(file);
    require_section(file.fit.has_value(), file, "fit");
    const std::vector<std::string> left_out = choose_mechanisms(*file.fit, options);
    FitProblem problem = fit_problem_of(file, options.threads, options.seed);
    const ResultFolder folder(options, stem_of(file) + "_fit", OnInterrupt::finish);
    KeptEvaluations kept(options, folder);
    for (std::size_t index = 0; index < problem.mechanisms.size(); ++index) {
        const FitMechanism& mechanism = file.fit->mechanisms[index];
        kept.keep(problem.mechanisms[index].model, mechanism.model, mechanism.name);
        if (mechanism.coarse) {
            kept.keep(*problem.mechanisms[index].coarse, *mechanism.coarse, mechanism.name + "_coarse");
        }
    }
    problem.settings.ranks = options.ranks;
    const FitResult result = with_progress(
        options, [&](const FitProgressCallback& progress) { return fit(problem, progress, &interrupt_flag()); });
    const std::vector<CandidateInformation> information = information_of(problem, result, {}, &interrupt_flag());
    const std::vector<ConclusionFinding> findings = with_progress(options, [&](const FitProgressCallback& progress) {
        return judge_conclusions(problem, result, progress, &interrupt_flag());
    });
    kept.collect();
    if (!leads(options)) {
        return ExitCode::ok;
    }

    Report report{title_of(file, options), file.description, {}};
    const std::string status = status_of_fit(result);
    const std::string reserved = reservation_of_fit(status);
    add_reservation(reserved, status == "interrupted", report);
    StudyDocuments documents = document_fit(file, problem, result, {folder, report});
    say_left_out(left_out, "; --with-costly fits such mechanisms too, in minutes.", documents.json, documents.screen,
                 report);
    if (!information.empty()) {
        const StudyDocuments next = document_information(problem.candidates, information, {folder, report});
        documents.json["value_of_information"] = next.json;
        documents.screen += next.screen;
    }
    if (!findings.empty()) {
        const StudyDocuments held = document_conclusions(problem.conclusions, findings, {folder, report});
        documents.json["conclusions"] = held.json;
        documents.screen += held.screen;
    }
    std::ranges::move(documents.details, std::back_inserter(report.blocks));
    Json source = provenance(file, "fit", options, watch.seconds());
    source["fit_seconds"] = result.wall_seconds;
    source["algorithm"] = std::string(word_of(problem.settings.algorithm));
    source["starts"] = problem.settings.starts;
    source["evaluations_per_start"] = problem.settings.evaluations_per_start;
    source["seed"] = problem.settings.seed;
    kept.enter(source);
    kept.write_runs(folder);
    documents.json["provenance"] = source;
    append_inputs(file, report);
    report.add(evidence_table(problem));
    const ExitCode code = write_study({file, documents.json, '\n' + documents.screen + kept.summary(), reserved},
                                      folder, options, report);
    if (status == "interrupted") {
        kept.say_how_to_go_on();
    }
    return code;
}

}  // namespace delabole
