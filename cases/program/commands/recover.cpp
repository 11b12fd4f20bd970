// delabole recover
#include "cases/program/commands/commands.hpp"
#include "cases/program/reader/case_error.hpp"
#include "cases/program/reports/study_reports.hpp"
#include "cases/program/results/kept_evaluations.hpp"
#include "cases/program/results/problems_of_case.hpp"
#include "cases/program/results/study_output.hpp"
#include "cases/program/terminal/interrupt.hpp"
#include "cases/program/terminal/progress.hpp"
#include "fitting/back_analysis/steps.hpp"
#include "fitting/mechanism/misfit.hpp"

#include <algorithm>

namespace delabole {

namespace {

// Evaluations of one repetition, used only for the progress report.
constexpr long usual_evaluations = 20'000;

RecoverySettings settings_for(const FitProblem& problem, const Options& options) {
    RecoverySettings settings;
    settings.repetitions = options.repetitions;
    // A few hundred independent draws determine an interval; as many as for a single fit would only take longer.
    settings.posterior.chains = 4;
    settings.posterior.draws = 1000;
    settings.posterior.seed = problem.settings.seed;
    settings.threads = options.threads;
    settings.ranks = options.ranks;
    return settings;
}

// Parameters of the best fit; empty if there is none.
std::vector<double> best_of(const Mechanism& mechanism, const FitProblem& problem, ProgressMeter& meter) {
    meter.begin_stage(mechanism.name, "best fit", usual_evaluations);
    const Misfit misfit(mechanism, problem);
    return search_from_many_starts({misfit, meter, &interrupt_flag()}, Priors::counted).best.point;
}

std::vector<MechanismRecovery> recover_all(const FitProblem& problem, const Options& options) {
    Progress progress(options.quiet);
    const auto per_mechanism = usual_evaluations * (options.repetitions + (options.at_best ? 1L : 0L));
    ProgressMeter meter(told_to(progress), per_mechanism * static_cast<long>(problem.mechanisms.size()));
    std::vector<MechanismRecovery> recoveries;
    for (const Mechanism& mechanism : problem.mechanisms) {
        RecoverySettings settings = settings_for(problem, options);
        if (options.at_best) {
            settings.truth = best_of(mechanism, problem, meter);
            if (settings.truth.empty()) {
                recoveries.emplace_back().name = mechanism.name;
                continue;
            }
        }
        meter.begin_stage(mechanism.name, "recovery", usual_evaluations * options.repetitions);
        recoveries.push_back(recover(mechanism, problem, settings, meter, &interrupt_flag()));
    }
    meter.finish();
    return recoveries;
}

std::string status_of(const std::vector<MechanismRecovery>& recoveries) {
    if (std::ranges::any_of(recoveries, &MechanismRecovery::interrupted) || interrupt_flag()) {
        return "interrupted";
    }
    const bool none = std::ranges::any_of(recoveries, [](const MechanismRecovery& one) { return one.counted == 0; });
    return none ? "no_answer" : "finished";
}

std::string reservation_of_recovery(const std::string& status) {
    if (status == "interrupted") {
        return "interrupted: the recovery was stopped early; the repetitions that were finished are shown";
    }
    return status == "finished" ? ""
                                : "not converged: of a mechanism no repetition counts; the causes are in the report";
}

}  // namespace

ExitCode recover_command(const std::filesystem::path& path, const Options& options) {
    const Stopwatch watch;
    CaseFile file = read_case(path, settings_of(options));
    show_units_of(file);
    require_section(file.fit.has_value(), file, "fit");
    const std::vector<std::string> left_out = leave_out_costly(*file.fit);
    FitProblem problem = fit_problem_of(file, options.threads, options.seed);
    if (problem.observations.empty()) {
        throw CaseError({problem_at(file, "fit",
                                    "recover needs an [[fit.observation]]: a profile alone has no errors "
                                    "that could be drawn")});
    }
    const ResultFolder folder(options, stem_of(file) + "_recovery", OnInterrupt::finish);
    KeptEvaluations kept(options, folder);
    for (std::size_t index = 0; index < problem.mechanisms.size(); ++index) {
        kept.keep(problem.mechanisms[index].model, file.fit->mechanisms[index].model, file.fit->mechanisms[index].name);
    }
    problem.settings.ranks = options.ranks;
    const std::vector<MechanismRecovery> recoveries = recover_all(problem, options);
    answer_interrupt();
    kept.collect();
    if (!leads(options)) {
        return ExitCode::ok;
    }

    Report report{title_of(file, options), file.description, {}};
    const std::string status = status_of(recoveries);
    const std::string reserved = reservation_of_recovery(status);
    add_reservation(reserved, status == "interrupted", report);
    StudyDocuments documents = document_recovery(recoveries, options.at_best, {folder, report});
    Json json;
    json["status"] = status;
    json.update(documents.json);
    say_left_out(left_out, ", and every repetition a whole fit.", json, documents.screen, report);
    Json source = provenance(file, "recover", options, watch.seconds());
    source["repetitions"] = options.repetitions;
    source["at"] = options.at_best ? "best" : "prior";
    source["seed"] = problem.settings.seed;
    kept.enter(source);
    kept.write_runs(folder);
    json["provenance"] = source;
    append_inputs(file, report);
    return write_study({file, json, documents.screen + kept.summary(), reserved}, folder, options, report);
}

}  // namespace delabole
