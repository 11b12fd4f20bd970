#include "limit_equilibrium/stepped_base/stepped_base_study.hpp"

#include "limit_equilibrium/columns/base_profile.hpp"

#include <limits>

namespace delabole {

namespace {

constexpr std::string_view base_elevation_name = "crack_base_elevation";

bool has_datum(const SteppedBase<>& problem) {
    return problem.scene.slope && problem.scene.slope->toe_elevation;
}

// NaN if the slope has no answer.
double safety_of(const SteppedBase<>& problem) {
    const ColumnSlope<> slope = make_columns(problem.scene);
    return slope.check == ColumnCheck::valid ? factor_of_safety(slope, strength_of(problem)).value
                                             : std::numeric_limits<double>::quiet_NaN();
}

Prediction predict(SteppedBaseStudy<> study, std::span<const Assignment> assignments) {
    assign(study.model, assignments);
    const ResolvedSteppedBase resolved = resolve(study);
    if (resolved.check != ColumnCheck::valid) {
        return {word_of(resolved.check), {}, {}};
    }
    const SteppedBaseResult result = analyse(resolved.problem);
    if (result.check != ColumnCheck::valid) {
        return {word_of(result.check), {}, {}};
    }
    if (result.limit != LimitState::found) {
        return {word_of(result.limit), {}, {}};
    }
    Prediction prediction{{}, output_values(result), {}};
    if (has_datum(resolved.problem)) {
        prediction.outputs.push_back(result.crack_base_height + *resolved.problem.scene.slope->toe_elevation);
    }
    prediction.profile = profile_after_failure(resolved.problem, result);
    return prediction;
}

}  // namespace

ResolvedSteppedBase resolve(const SteppedBaseStudy<>& study) {
    if (!study.critical) {
        return {ColumnCheck::valid, study.model, false};
    }
    const CriticalBase critical =
        find_critical_base(study.model.scene, *study.critical, [&](const ColumnScene<>& scene) {
            SteppedBase<> varied{scene, study.model.joints, study.model.bases};
            return safety_of(varied);
        });
    return {critical.check, {critical.scene, study.model.joints, study.model.bases}, critical.at_boundary};
}

Required required_value(const SteppedBase<>& problem, const std::string& parameter, double target,
                        const std::vector<std::string>& also) {
    return find_required_value(problem, parameter, also, target, safety_of);
}

Polyline profile_after_failure(const SteppedBase<>& problem, const SteppedBaseResult& result) {
    return ground_after_toppling(problem.scene, static_cast<std::size_t>(result.uppermost_moving),
                                 BaseOutline::envelope);
}

ModelInterface model_interface(const SteppedBaseStudy<>& study) {
    ModelInterface model;
    model.inputs = inputs_of(study.model);
    model.outputs = outputs_of(SteppedBaseResult{});
    if (has_datum(study.model)) {
        model.outputs.push_back(
            {std::string(base_elevation_name), Dimension::length, "elevation of the crack's lower end"});
    }
    model.predict = [study](std::span<const Assignment> assignments) { return predict(study, assignments); };
    return model;
}

}  // namespace delabole
