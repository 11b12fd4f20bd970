#include "cases/program/live/study.hpp"

#include "cases/program/reports/fit_parts.hpp"
#include "cases/program/reports/study_reports.hpp"
#include "cases/program/results/analysis.hpp"
#include "cases/program/results/problems_of_case.hpp"
#include "cases/program/results/result_folder.hpp"
#include "fitting/back_analysis/back_analysis.hpp"
#include "fitting/sensitivity/sensitivity.hpp"

#include <atomic>
#include <chrono>
#include <sstream>

namespace delabole {

namespace {

bool has_samples(const CaseFile& file) {
    return file.sensitivity && file.sensitivity->propagation && !interface_of(file.model).costly;
}

// A stop flag that its progress listener raises when the time is over.
struct Deadline {
    std::chrono::steady_clock::time_point end = std::chrono::steady_clock::now() + std::chrono::seconds(4);
    std::atomic<bool> over = false;
    FitProgressCallback listener() {
        return [this](const FitProgress&) { over = over || std::chrono::steady_clock::now() > end; };
    }
    void say_if_over(const std::string& command, std::vector<std::string>& sentences) const {
        if (over) {
            sentences.push_back("Stopped after 4 s, with what was finished by then: delabole " + command +
                                " takes its time.");
        }
    }
};

void add_samples(CaseFile file, std::vector<std::string>& sentences) {
    SensitivityStudy& study = *file.sensitivity;
    study.tornado.reset();
    study.sweep.reset();
    study.morris.reset();
    study.sobol_indices.reset();
    study.reliability.reset();
    const SensitivityProblem problem = sensitivity_problem_of(file, 1, std::nullopt);
    Deadline deadline;
    const SensitivityResult result = sensitivity(problem, deadline.listener(), &deadline.over);
    Report report;
    std::istringstream screen(document_sensitivity(file, problem, result, {ResultFolder(), report}).screen);
    for (std::string sentence; std::getline(screen, sentence);) {
        sentences.push_back(sentence);
    }
    deadline.say_if_over("sensitivity", sentences);
}

}  // namespace

bool has_study(const CaseFile& file, const std::optional<FitProblem>& fit) {
    return has_samples(file) || fit.has_value();
}

std::vector<std::string> studied(const CaseFile& file, const std::optional<FitProblem>& fit) {
    std::vector<std::string> sentences;
    if (has_samples(file)) {
        add_samples(file, sentences);
    }
    if (fit) {
        FitProblem problem = *fit;
        problem.posterior.reset();
        problem.mechanisms.front().model = interface_of(file.model);
        Deadline deadline;
        const FitResult result = delabole::fit(problem, deadline.listener(), &deadline.over);
        const HeadCard head = head_card(result);
        sentences.insert(sentences.end(), head.sentences.begin(), head.sentences.end());
        deadline.say_if_over("fit", sentences);
    }
    return sentences;
}

}  // namespace delabole
