#include "dynamic_relaxation/study/ensemble.hpp"

#include "dynamic_relaxation/study/relaxation_study.hpp"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace delabole {

namespace {

// The positive root of x^(dimensions + 1) = x + 1.
double generalized_golden_ratio(std::size_t dimensions) {
    double root = 2;
    for (int iteration = 0; iteration < 60; ++iteration) {
        root = std::pow(1 + root, 1 / static_cast<double>(dimensions + 1));
    }
    return root;
}

// Sequence of shares from 0 to below 1; all 0 for the first member.
class Shares {
  public:
    Shares(std::size_t dimensions, std::size_t member)
        : ratio_(generalized_golden_ratio(dimensions)), member_(static_cast<double>(member)) {}

    double uniform() {
        step_ /= ratio_;
        const double share = member_ * step_;
        return share - std::floor(share);
    }
    // Standard normal deviate; 0 for the first member.
    double normal() {
        constexpr double most = 2;
        double share = uniform() + 0.5;
        share -= std::floor(share);
        return std::clamp(gsl_cdf_ugaussian_Pinv(share), -most, most);
    }

  private:
    double ratio_;
    double member_;
    double step_ = 1;
};

constexpr std::string_view without_answer_name = "ensemble_without_answer";
constexpr std::string_view failing_share_name = "ensemble_failing_share";
constexpr std::string_view at_lower_name = "ensemble_at_lower";
constexpr std::string_view at_upper_name = "ensemble_at_upper";

// Why a member has no answer, or where its search ended; empty if it has found all.
std::string_view word_of(const EnsembleMember& member) {
    return member.prediction.failure.empty() ? member.ended_at : member.prediction.failure;
}

double deviated(double friction_angle, double by) {
    return std::clamp(friction_angle + by, 0.0, degrees(89.9));
}

}  // namespace

RelaxationStudy member_of(const RelaxationStudy& study, std::size_t member) {
    RelaxationStudy made = study;
    made.ensemble.reset();
    if (member == 0) {
        return made;
    }
    auto& slope = std::get<RelaxationSlope>(made.model.scene);
    const double spacing_deviation = study.ensemble->spacing_deviation.value_or(0);
    const double friction_deviation = study.ensemble->friction_deviation.value_or(0);
    Shares shares(2 * slope.geometry.cut.size() + slope.joint.size(), member);
    for (std::size_t index = 0; index < slope.geometry.cut.size(); ++index) {
        const double shift = shares.uniform();
        const double deviate = shares.normal();
        auto* set = std::get_if<JointSetCut>(&slope.geometry.cut[index].trace);
        if (set == nullptr) {
            continue;
        }
        set->spacing *= 1 + spacing_deviation * deviate;
        set->offset = set->offset.value_or(0) + shift * set->spacing;
        if (set->scatter || set->persistence) {
            constexpr double between_members = 1000;  // more than a section has cuts
            set->seed =
                set->seed.value_or(static_cast<double>(index + 1)) + between_members * static_cast<double>(member);
        }
    }
    for (SlopeJoint& joint : slope.joint) {
        const double by = friction_deviation * shares.normal();
        joint.strength.friction_angle = deviated(joint.strength.friction_angle, by);
        if (std::optional<double>& residual = joint.strength.residual_friction_angle) {
            residual = deviated(*residual, by);
        }
    }
    return made;
}

EnsemblePrediction predict_ensemble(const RelaxationStudy& study, EnsembleMember first,
                                    const std::function<EnsembleMember(const RelaxationStudy&)>& predict,
                                    const std::function<bool(double)>& go_on) {
    const auto runs = static_cast<std::size_t>(study.ensemble->runs);
    std::vector<EnsembleMember> all{std::move(first)};
    for (std::size_t member = 1; member < runs; ++member) {
        if (go_on && !go_on(static_cast<double>(member) / static_cast<double>(runs))) {
            return {"interrupted"};
        }
        all.push_back(predict(member_of(study, member)));
    }
    EnsemblePrediction ensemble;
    if (study.critical) {
        ensemble.at_bounds.emplace();
    }
    std::vector<Prediction> members;
    for (EnsembleMember& one : all) {
        if (!one.prediction.failure.empty()) {
            ensemble.first_cause = ensemble.without_answer == 0 ? one.prediction.failure : ensemble.first_cause;
            ++ensemble.without_answer;
            continue;
        }
        ++ensemble.answered;
        ensemble.failing += one.fails ? 1 : 0;
        if (ensemble.at_bounds) {
            ensemble.at_bounds->lower += one.at_lower ? 1 : 0;
            ensemble.at_bounds->upper += one.at_upper ? 1 : 0;
        }
        members.push_back(std::move(one.prediction));
    }
    if (const std::string_view word = word_of(all.front());
        !word.empty() && std::ranges::all_of(all, [&](const EnsembleMember& one) { return word_of(one) == word; })) {
        ensemble.failure = word;
        return ensemble;
    }
    if (ensemble.without_answer > most_without_answer * static_cast<double>(runs)) {
        ensemble.failure = slopes_without_answer;
        return ensemble;
    }
    const double count = ensemble.answered;
    ensemble.mean.resize(members.front().outputs.size());
    ensemble.deviation.resize(ensemble.mean.size());
    for (std::size_t output = 0; output < ensemble.mean.size(); ++output) {
        double& mean = ensemble.mean[output];
        for (const Prediction& member : members) {
            mean += member.outputs[output] / count;
        }
        double squares = 0;
        for (const Prediction& member : members) {
            squares += (member.outputs[output] - mean) * (member.outputs[output] - mean);
        }
        // An output that is infinite in one of the members has no deviation.
        ensemble.deviation[output] = std::isfinite(mean) ? std::sqrt(squares / (count - 1)) : mean;
    }
    // The members have the same outline, so that their profiles have the same stations unless excavation leaves gaps.
    const std::size_t stations = members.front().profile.size();
    if (!std::ranges::all_of(members, [&](const Prediction& member) { return member.profile.size() == stations; })) {
        return ensemble;
    }
    ensemble.profile = members.front().profile;
    for (std::size_t station = 0; station < ensemble.profile.size(); ++station) {
        double level = 0;
        for (const Prediction& member : members) {
            level += member.profile[station].y() / count;
        }
        ensemble.profile[station].y() = level;
    }
    double squares = 0;
    for (const Prediction& member : members) {
        for (const Point& point : ensemble.profile) {
            const double distance = signed_distance(member.profile, point);
            squares += distance * distance;
        }
    }
    const double points = (count - 1) * static_cast<double>(std::max<std::size_t>(1, ensemble.profile.size()));
    ensemble.profile_deviation = std::sqrt(squares / points);
    return ensemble;
}

std::vector<Quantity> outputs_of_ensemble(std::vector<Quantity> outputs, const std::optional<CriticalPlan>& plan) {
    const std::size_t means = outputs.size();
    outputs.reserve(2 * means + 5);
    for (std::size_t index = 0; index < means; ++index) {
        const Quantity& mean = outputs[index];
        outputs.push_back({std::string(deviation_prefix) + mean.name, mean.dimension,
                           "standard deviation between the slopes of the ensemble: " + mean.meaning});
    }
    outputs.push_back({std::string(deviation_of_profile), Dimension::length,
                       "root mean square distance of their ground left standing from its mean"});
    const auto append = [&](std::string_view name, std::string meaning) {
        outputs.push_back({std::string(name), Dimension::ratio, std::move(meaning)});
    };
    append(without_answer_name, "slopes of the ensemble that are left out of the mean");
    if (plan) {
        append(failing_share_name, "share of the other slopes of the ensemble that fail at the strength as given");
        const std::string value(name_of_critical(plan->parameter));
        append(at_lower_name, "slopes of the ensemble for which " + value + " is taken at critical.lower: it is less");
        append(at_upper_name, "slopes of the ensemble for which " + value + " is taken at critical.upper: it is more");
    }
    return outputs;
}

std::vector<BoundedOutput> bounded_outputs(const CriticalPlan& plan, std::size_t critical,
                                           const std::vector<Quantity>& outputs) {
    const std::size_t below = place_of(outputs, at_lower_name).value();
    const std::size_t above = place_of(outputs, at_upper_name).value();
    std::vector<BoundedOutput> means;
    for (std::size_t path = 0; path < plan.path.size(); ++path) {
        means.push_back({critical + path, below, above});
    }
    return means;
}

Prediction prediction_of(EnsemblePrediction ensemble) {
    if (!ensemble.failure.empty()) {
        return {ensemble.failure, {}, {}};
    }
    std::vector<double> outputs = std::move(ensemble.mean);
    outputs.insert(outputs.end(), ensemble.deviation.begin(), ensemble.deviation.end());
    outputs.push_back(ensemble.profile_deviation);
    outputs.push_back(ensemble.without_answer);
    if (ensemble.at_bounds) {
        outputs.push_back(ensemble.failing / ensemble.answered);
        outputs.push_back(ensemble.at_bounds->lower);
        outputs.push_back(ensemble.at_bounds->upper);
    }
    return {{}, std::move(outputs), std::move(ensemble.profile)};
}

}  // namespace delabole
