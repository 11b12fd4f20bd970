#include "cases/analysis.hpp"

#include "fitting/words.hpp"
#include "plane_failure/plane_failure.hpp"
#include "plane_failure/required.hpp"
#include "water/column_tilt.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

namespace delabole {

namespace {

template <class Result>
void append_outputs(Analysis& analysis, const Result& result) {
    visit_fields(result, [&](const FieldInfo& info, const auto& member) {
        using Member = std::remove_cvref_t<decltype(member)>;
        if constexpr (std::is_enum_v<Member>) {
            const std::string word(word_of(member));
            analysis.outputs.push_back({std::string(info.key), std::string(info.meaning), Dimension::ratio, word});
        } else {
            analysis.outputs.push_back({std::string(info.key), std::string(info.meaning), info.dimension, member});
        }
    });
}

void append_required(Analysis& analysis, const PlaneFailure<>& problem, const std::vector<RequiredValue<>>& requests) {
    for (const RequiredValue<>& request : requests) {
        const Required required = required_value(problem, request.parameter, request.factor_of_safety);
        const std::string name = "required." + request.parameter;
        const std::string meaning =
            request.parameter + " at a factor of safety of " + number_in_words(request.factor_of_safety);
        switch (required.status) {
        case RequiredStatus::several:
            analysis.warnings.push_back(name + ": several values give this factor of safety; the smallest is shown");
            [[fallthrough]];
        case RequiredStatus::found:
            analysis.outputs.push_back({name, meaning, required.dimension, required.value});
            break;
        case RequiredStatus::never_reached:
            analysis.outputs.push_back({name, meaning, required.dimension, std::string("never_reached")});
            analysis.warnings.push_back(name + ": the factor of safety stays between " +
                                        number_in_words(required.lowest_factor_of_safety) + " and " +
                                        number_in_words(required.highest_factor_of_safety));
            break;
        case RequiredStatus::unknown_parameter:
            throw std::invalid_argument("required: the case has no input '" + request.parameter + "'");
        }
    }
}

void append_optimum_bolt(Analysis& analysis, const PlaneFailure<>& problem) {
    if (problem.bolt.empty()) {
        return;
    }
    const OptimumBolt optimum = optimum_bolt_plunge(problem);
    if (!(optimum.factor_of_safety > 0)) {
        return;
    }
    analysis.outputs.push_back({"optimum_bolt_plunge", "plunge of bolt[1] that makes the factor of safety largest",
                                Dimension::angle, optimum.plunge});
    analysis.outputs.push_back({"optimum_bolt_factor_of_safety", "factor of safety at that plunge", Dimension::ratio,
                                optimum.factor_of_safety});
}

void warn(Analysis& analysis, const PlaneFailureResult& result, bool critical_at_boundary) {
    if (critical_at_boundary) {
        analysis.warnings.emplace_back(
            "the least factor of safety lies at the edge of the searched range: a limit, not a balance");
    }
    if (result.overturning_factor < 1 && result.factor_of_safety >= 1) {
        analysis.warnings.emplace_back("the mass overturns about the toe before it slides");
    }
    if (result.normal_force < 0) {
        analysis.warnings.emplace_back("the loads lift the mass off its base: the normal force is negative");
    } else if (result.normal_force_position < 0 || result.normal_force_position > 1) {
        analysis.warnings.emplace_back(
            "no pressure on the base balances the moments: the normal force would act beyond its " +
            std::string(result.normal_force_position < 0 ? "lower" : "upper") +
            " end. The mass must rotate, or lean on the crack, which a balance of forces does not see");
    } else if (result.normal_force_position < 1.0 / 3 || result.normal_force_position > 2.0 / 3) {
        analysis.warnings.emplace_back(
            "the normal force acts outside the middle third of the base: part of the base is in tension");
    }
    if (std::isinf(result.factor_of_safety)) {
        analysis.warnings.emplace_back("nothing drives the mass down the plane: the factor of safety is infinite");
    }
}

Analysis analyse_study(const PlaneFailureStudy<>& study) {
    Analysis analysis;
    const ResolvedStudy resolved = resolve(study);
    const PlaneFailureResult result =
        resolved.check == PlaneFailureCheck::valid ? analyse(resolved.problem) : PlaneFailureResult{};
    const PlaneFailureCheck check = resolved.check == PlaneFailureCheck::valid ? result.check : resolved.check;
    if (check != PlaneFailureCheck::valid) {
        analysis.failure = word_of(check);
        return analysis;
    }
    append_outputs(analysis, result);
    append_required(analysis, resolved.problem, study.required);
    append_optimum_bolt(analysis, resolved.problem);
    warn(analysis, result, resolved.critical_at_boundary);
    return analysis;
}

Analysis analyse_column(const TiltedColumn<>& column) {
    Analysis analysis;
    append_outputs(analysis, column_tilt(column));
    return analysis;
}

}  // namespace

const NamedOutput* Analysis::find(std::string_view name) const {
    const auto found =
        std::find_if(outputs.begin(), outputs.end(), [&](const NamedOutput& output) { return output.name == name; });
    return found == outputs.end() ? nullptr : &*found;
}

CaseModel with_conditions(const CaseModel& model, const std::vector<Condition>& conditions) {
    CaseModel changed = model;
    for (const Condition& condition : conditions) {
        bool found = false;
        std::visit(
            [&](auto& parameters) {
                for_each_named_number(parameters, [&](const std::string& path, const FieldInfo&, double& value) {
                    if (path == condition.input) {
                        value = condition.value;
                        found = true;
                    }
                });
            },
            changed);
        if (!found) {
            throw std::invalid_argument("the case has no input '" + condition.input + "'");
        }
    }
    return changed;
}

ModelInterface interface_of(const CaseModel& model) {
    struct Visitor {
        ModelInterface operator()(const PlaneFailureStudy<>& study) const { return model_interface(study); }
        ModelInterface operator()(const TiltedColumn<>& column) const { return model_interface(column); }
    };
    return std::visit(Visitor{}, model);
}

Analysis analyse_model(const CaseModel& model) {
    struct Visitor {
        Analysis operator()(const PlaneFailureStudy<>& study) const { return analyse_study(study); }
        Analysis operator()(const TiltedColumn<>& column) const { return analyse_column(column); }
    };
    return std::visit(Visitor{}, model);
}

std::string explain_failure(std::string_view failure) {
    static const std::map<std::string_view, std::string_view> explanations = {
        {"plane_does_not_daylight",
         "the failure plane is as steep as the face or steeper: failure_plane.dip must be less "
         "than slope.face_dip"},
        {"plane_daylights_above_crest", "failure_plane.daylight_height must be less than slope.height"},
        {"plane_never_surfaces",
         "the ground behind the crest is as steep as the failure plane, so the plane never meets "
         "it: give a tension crack or a flatter upper surface"},
        {"crack_flatter_than_plane", "tension_crack.dip must be more than failure_plane.dip"},
        {"crack_below_plane", "the tension crack lies behind the point where the failure plane meets the ground"},
        {"crack_base_below_daylight", "the bottom of the tension crack lies below the point where the plane daylights"},
        {"crack_deeper_than_mass",
         "nowhere behind the crest is the rock above the failure plane as thick as "
         "tension_crack.depth"},
        {"crack_never_surfaces", "the tension crack does not reach the ground"},
        {"mass_vanishes", "nothing lies between failure plane, crack and ground"},
        {"water_needs_crack", "this water form fills a tension crack, but the case has none"},
        {"water_above_crack", "the water stands above the top of the tension crack (or of the base)"},
        {"water_points_not_increasing",
         "the points of the water form must increase along the line, two at least for a "
         "piezometric line"},
        {"pond_above_crest", "pond.depth must not exceed slope.height"},
        {"elevation_without_datum", "an elevation is given, so slope.toe_elevation is needed"},
        {"friction_not_below_90_deg", "friction_angle plus roughness_angle must not exceed 89.9 deg"},
        {"bolt_head_above_crest", "a bolt's head_height must not exceed slope.height"},
        {"input_out_of_range", "a number is outside its allowed range"},
    };
    const auto found = explanations.find(failure);
    return found == explanations.end() ? std::string(failure) : std::string(found->second);
}

}  // namespace delabole
