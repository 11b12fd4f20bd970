#include "cases/python/fit_object.hpp"

#include "cases/program/reports/study_reports.hpp"
#include "cases/program/results/problems_of_case.hpp"
#include "cases/program/results/result_folder.hpp"
#include "cases/program/sweeps/support_report.hpp"
#include "cases/python/arrays.hpp"
#include "cases/python/background.hpp"
#include "fitting/back_analysis/back_analysis.hpp"
#include "fitting/sensitivity/sensitivity.hpp"
#include "fitting/studies/candidate_draws.hpp"
#include "fitting/studies/comparison.hpp"
#include "fitting/studies/conclusions.hpp"

#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <utility>

namespace delabole {

namespace py = pybind11;

namespace {

py::tuple pair_of(const Interval& interval) {
    return py::make_tuple(interval.lower, interval.upper);
}

py::dict dict_of(const ProfileLikelihood& profile) {
    py::dict dict;
    dict["parameter"] = profile.parameter;
    dict["with_priors"] = profile.with_priors;
    dict["values"] = array_of(profile.values);
    dict["misfits"] = array_of(profile.misfits);
    dict["interval_68"] = pair_of(profile.interval_68);
    dict["interval_95"] = pair_of(profile.interval_95);
    dict["determination"] = word_of(profile.determination);
    dict["lower_bounded_by"] = profile.lower_bounded_by;
    dict["upper_bounded_by"] = profile.upper_bounded_by;
    return dict;
}

py::dict dict_of(const FailureLocus& locus) {
    py::dict dict;
    dict["x"] = locus.x;
    dict["y"] = locus.y;
    dict["points"] = array_of(locus.points);
    dict["branches"] = py::array_t<int>(static_cast<py::ssize_t>(locus.branch.size()), locus.branch.data());
    return dict;
}

py::dict dict_of(const MisfitMap& map) {
    py::dict dict;
    dict["x"] = map.x;
    dict["y"] = map.y;
    dict["x_values"] = array_of(map.x_values);
    dict["y_values"] = array_of(map.y_values);
    dict["misfit"] = py::cast(map.misfit);
    dict["level_68"] = map.level_68;
    dict["level_95"] = map.level_95;
    return dict;
}

// Draws of each parameter as an array of chains by draws; all chains are cut to the length of the shortest.
py::dict chains_of(const Posterior& posterior, const std::vector<FreeParameter>& parameters) {
    std::vector<std::vector<const Draw*>> chains;
    for (const Draw& draw : posterior.draws) {
        chains.resize(std::max(chains.size(), static_cast<std::size_t>(draw.chain) + 1));
        chains[static_cast<std::size_t>(draw.chain)].push_back(&draw);
    }
    std::size_t shortest = chains.empty() ? 0 : chains.front().size();
    for (const auto& chain : chains) {
        shortest = std::min(shortest, chain.size());
    }
    const auto array = [&](const auto& value_of) {
        py::array_t<double> made({static_cast<py::ssize_t>(chains.size()), static_cast<py::ssize_t>(shortest)});
        auto rows = made.mutable_unchecked<2>();
        for (std::size_t chain = 0; chain < chains.size(); ++chain) {
            for (std::size_t draw = 0; draw < shortest; ++draw) {
                rows(static_cast<py::ssize_t>(chain), static_cast<py::ssize_t>(draw)) = value_of(*chains[chain][draw]);
            }
        }
        return made;
    };
    py::dict dict;
    for (std::size_t index = 0; index < parameters.size(); ++index) {
        dict[py::str(parameters[index].name)] = array([&](const Draw& draw) { return draw.parameters[index]; });
    }
    dict["misfit"] = array([](const Draw& draw) { return draw.misfit; });
    return dict;
}

py::dict dict_of(const MechanismPosterior& study, const std::vector<FreeParameter>& parameters) {
    py::dict dict;
    dict["status"] = word_of(study.posterior.status);
    dict["warnings"] = study.warnings;
    dict["chains"] = chains_of(study.posterior, parameters);
    dict["correlation"] = py::cast(study.posterior.correlation);
    dict["log_evidence"] = study.log_evidence();
    dict["log_evidence_error"] = study.evidence().standard_error;
    return dict;
}

py::dict dict_of(const MechanismFit& fit, const MechanismWeight& weight) {
    py::dict dict;
    dict["name"] = fit.name;
    dict["title"] = fit.title;
    dict["status"] = word_of(fit.status);
    dict["verdict"] = fit.identifiability.verdict;
    dict["rank"] = fit.identifiability.rank;
    py::dict best;
    for (std::size_t index = 0; index < fit.best.size(); ++index) {
        best[py::str(fit.parameters[index].name)] = fit.best[index];
    }
    dict["best"] = best;
    dict["misfit"] = fit.misfit;
    dict["data_misfit"] = fit.data_misfit;
    dict["prior_misfit"] = fit.prior_misfit;
    dict["profile"] = array_of(fit.prediction.profile);
    dict["explained"] = fit.explained;
    dict["unexplained"] = fit.unexplained;
    py::list profiles;
    for (const ProfileLikelihood& profile : fit.profiles) {
        profiles.append(dict_of(profile));
    }
    dict["profiles"] = profiles;
    py::list loci;
    for (const FailureLocus& locus : fit.loci) {
        loci.append(dict_of(locus));
    }
    dict["failure_loci"] = loci;
    dict["misfit_map"] = fit.map ? py::object(dict_of(*fit.map)) : py::none();
    dict["posterior"] = fit.posterior ? py::object(dict_of(*fit.posterior, fit.parameters)) : py::none();
    dict["probability"] = fit.posterior ? py::object(py::float_(weight.probability)) : py::none();
    return dict;
}

FitProgressCallback telling(BackgroundWatch& watch) {
    return [&watch](const FitProgress& state) {
        watch.tell(state.fraction, std::string(state.mechanism) + ": " + std::string(state.stage));
    };
}

// Adds the studies that the case asks for beyond the fit: expected information of measurements, and conclusions of
// others.
void add_studies(const FitProblem& problem, const FitResult& result, BackgroundWatch& watch, Json& json) {
    Report unused;
    const auto information = information_of(problem, result, {}, watch.stop_flag());
    if (!information.empty()) {
        json["value_of_information"] =
            document_information(problem.candidates, information, {ResultFolder(), unused}).json;
    }
    const auto findings = judge_conclusions(problem, result, telling(watch), watch.stop_flag());
    if (!findings.empty()) {
        json["conclusions"] = document_conclusions(problem.conclusions, findings, {ResultFolder(), unused}).json;
    }
}

std::vector<Point> points_of(const std::vector<std::pair<double, double>>& pairs) {
    std::vector<Point> points;
    points.reserve(pairs.size());
    for (const auto& [x, y] : pairs) {
        points.emplace_back(x, y);
    }
    return points;
}

}  // namespace

py::dict fit_of(const CaseFile& given, const py::object& progress, const FitRequest& request) {
    CaseFile file = given;
    require_section(file.fit.has_value(), file, "fit");
    std::vector<std::string> left_out;
    if (!request.mechanisms.empty()) {
        leave_mechanisms(*file.fit, request.mechanisms);
    } else if (!request.with_costly) {
        left_out = leave_out_costly(*file.fit);
    }
    const FitProblem problem = fit_problem_of(file, request.threads, request.seed);
    FitResult result;
    Json json;
    in_background(progress, [&](BackgroundWatch& watch) {
        result = fit(problem, telling(watch), watch.stop_flag());
        json = json_of_fit(file, result);
        if (!left_out.empty()) {
            json["left_out"] = left_out;
        }
        add_studies(problem, result, watch, json);
    });
    py::dict dict;
    dict["status"] = status_of_fit(result);
    dict["left_out"] = left_out;
    py::list mechanisms;
    const std::vector<MechanismWeight> weights = weigh(result);
    for (std::size_t index = 0; index < result.mechanisms.size(); ++index) {
        mechanisms.append(dict_of(result.mechanisms[index], weights[index]));
    }
    dict["mechanisms"] = mechanisms;
    dict["json"] = json_text(json);
    return dict;
}

py::dict study_of(CaseFile file, const py::object& progress, int threads, std::optional<std::uint64_t> seed) {
    std::optional<DesignedSupport> support;
    in_background(progress, [&](BackgroundWatch& watch) {
        support = design_support_of(file, telling(watch, "patterns of support"));
    });
    const SensitivityProblem problem = sensitivity_problem_of(file, threads, seed);
    SensitivityResult result;
    in_background(progress,
                  [&](BackgroundWatch& watch) { result = sensitivity(problem, telling(watch), watch.stop_flag()); });
    Report unused;
    Json json;
    json["status"] = word_of(result.status);
    json.update(document_sensitivity(file, problem, result, {ResultFolder(), unused}).json);
    if (support) {
        json["support_design"] = document_support(*support, {ResultFolder(), unused});
    }
    py::dict dict;
    dict["status"] = word_of(result.status);
    dict["json"] = json_text(json);
    dict["cumulative"] =
        result.propagation ? py::object(array_of(points_of(result.propagation->cumulative))) : py::none();
    return dict;
}

}  // namespace delabole
