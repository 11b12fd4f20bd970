// This fills in what the request of a search leaves out, and names the outputs of a search.
#include "dynamic_relaxation/study/relaxation_study.hpp"

#include <iterator>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace delabole {

namespace {

// The path of a search for which the case names none.
LoadingPath usual_path(const RelaxationStudy& study, CriticalParameter parameter) {
    if (dimension_of(parameter) == Dimension::ratio && !has_record_of_shaking(study)) {
        return LoadingPath::consolidated;
    }
    const RelaxationStart start = relaxation_settings(study).start;
    return has_stages(study)                     ? LoadingPath::stages
           : start == RelaxationStart::preloaded ? LoadingPath::preloaded
           : start == RelaxationStart::dropped   ? LoadingPath::sudden
                                                 : LoadingPath::gravity;
}

std::vector<LoadingPath> paths_of(const RelaxationStudy& study, LoadingPath first, PathChoice choice) {
    std::vector<LoadingPath> paths{first};
    if (choice == PathChoice::all) {
        for (std::size_t index = 0; index < enum_names(LoadingPath{}).size(); ++index) {
            const auto path = static_cast<LoadingPath>(index);
            if (path != first && (path != LoadingPath::stages || has_stages(study)) &&
                (path != LoadingPath::consolidated || !has_record_of_shaking(study))) {
                paths.push_back(path);
            }
        }
    }
    return paths;
}

}  // namespace

CriticalPlan critical_plan(const RelaxationStudy& study) {
    const CriticalRequest& request = *study.critical;
    CriticalPlan plan{};
    plan.parameter = parameter_of(request);
    plan.tolerance = plan.is_ratio() ? standard_ratio_tolerance : standard_angle_tolerance;
    std::visit(
        [&](const auto& asked) {
            using Asked = std::remove_cvref_t<decltype(asked)>;
            if constexpr (is_optional<decltype(asked.lower)>) {
                plan.lower = asked.lower.value_or(least_ratio);
                plan.upper =
                    asked.upper.value_or(std::is_same_v<Asked, WeightSearch> ? greatest_weight : greatest_reduction);
            } else {
                plan.lower = asked.lower;
                plan.upper = asked.upper;
            }
            if constexpr (std::is_same_v<Asked, ReductionSearch>) {
                plan.joint = asked.joints;
            }
            plan.tolerance = asked.tolerance.value_or(plan.tolerance);
            plan.path = paths_of(study, asked.path.value_or(usual_path(study, plan.parameter)),
                                 asked.paths.value_or(PathChoice::one));
        },
        request);
    return plan;
}

std::vector<Quantity> outputs_of_search(const CriticalPlan& plan) {
    const std::string name(name_of_critical(plan.parameter));
    const Dimension dimension = dimension_of(plan.parameter);
    std::vector<Quantity> outputs{{name, dimension, "between standing and failing"}};
    for (std::size_t index = 1; index < plan.path.size(); ++index) {
        const std::string path(word_of(plan.path[index]));
        outputs.push_back({std::string(name + '_').append(path), dimension, "likewise, on the path " + path});
    }
    if (plan.path.size() > 1) {
        outputs.push_back({name + "_spread", dimension, "greatest less least value over paths: error of the model"});
        outputs.push_back({std::string(path_deviation_prefix) + name, dimension,
                           "root mean square difference of the other paths from the first, which fits count"});
    }
    return outputs;
}

}  // namespace delabole
