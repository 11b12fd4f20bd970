#include "kinematics/kinematics.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

namespace delabole {

namespace {

OrientationSampling sampling_of(const KinematicsStudy& study) {
    const OrientationSampling given = study.sampling.value_or(OrientationSampling{});
    return {given.sample_count.value_or(OrientationSampling::default_sample_count),
            given.seed.value_or(OrientationSampling::default_seed)};
}

bool dips_in_order(const JointSet& set) {
    const auto* range = std::get_if<OrientationRange>(&set.orientation);
    return range == nullptr || range->lower_dip <= range->upper_dip;
}

bool name_repeated(const std::vector<JointSet>& sets) {
    for (std::size_t index = 0; index < sets.size(); ++index) {
        for (std::size_t other = 0; other < index; ++other) {
            if (sets[index].name == sets[other].name) {
                return true;
            }
        }
    }
    return false;
}

template <class Items, class Predicate>
double share_of(const Items& items, Predicate&& predicate) {
    return static_cast<double>(std::ranges::count_if(items, predicate)) / static_cast<double>(items.size());
}

// Samples of all sets and what direct toppling needs to know of each plane of theirs.
struct Samples {
    std::vector<std::vector<Orientation>> planes;  // planes[set][sample]
    std::vector<std::vector<bool>> can_be_base;    // as above
    std::vector<Orientation> means;                // means[set]
    std::vector<Feasibility> base_at_mean;         // base_at_mean[set]
    std::size_t count() const { return planes.front().size(); }
};

std::vector<std::vector<Orientation>> sampled_sets(const KinematicsStudy& study) {
    const OrientationSampling sampling = sampling_of(study);
    std::vector<std::vector<Orientation>> planes;
    for (const JointSet& set : study.model.joint_set) {
        planes.push_back(sampled_planes(set, static_cast<std::size_t>(*sampling.sample_count),
                                        static_cast<std::uint64_t>(*sampling.seed), planes.size()));
    }
    return planes;
}

Samples samples_of(const KinematicsStudy& study) {
    const Kinematics& model = study.model;
    const auto base = [&](const Orientation& plane) {
        return toppling_base(model.slope, plane, model.strength.friction_angle, model.lateral_limit.direct_toppling);
    };
    Samples samples{.planes = sampled_sets(study), .can_be_base = {}, .means = {}, .base_at_mean = {}};
    for (std::size_t set = 0; set < model.joint_set.size(); ++set) {
        samples.means.push_back(mean_orientation(model.joint_set[set]));
        samples.base_at_mean.push_back(base(samples.means.back()));
        std::vector<bool>& can_be_base = samples.can_be_base.emplace_back();
        for (const Orientation& plane : samples.planes[set]) {
            can_be_base.push_back(base(plane) == Feasibility::feasible);
        }
    }
    return samples;
}

JointSetFeasibility set_feasibility(const Kinematics& model, const Samples& samples, std::size_t set) {
    const double friction = model.strength.friction_angle;
    const auto mechanism = [&](auto&& criterion) {
        const FeasibilityVerdict mean = criterion(samples.means[set]);
        const double share = share_of(samples.planes[set], [&](const Orientation& plane) {
            return criterion(plane).feasibility == Feasibility::feasible;
        });
        return MechanismFeasibility{mean.feasibility, mean.critical_friction_angle, share};
    };
    return {.name = model.joint_set[set].name,
            .mean = samples.means[set],
            .apparent_dip = apparent_dip(samples.means[set], model.slope.face_dip_direction),
            .angular_standard_deviation = orientation_statistics(samples.planes[set]).angular_standard_deviation,
            .planar_sliding = mechanism([&](const Orientation& plane) {
                return planar_sliding(model.slope, plane, friction, model.lateral_limit.planar_sliding);
            }),
            .flexural_toppling = mechanism([&](const Orientation& plane) {
                return flexural_toppling(model.slope, plane, friction, model.lateral_limit.flexural_toppling);
            }),
            .toppling_base = samples.base_at_mean[set],
            .toppling_base_share = share_of(samples.can_be_base[set], [](bool base) { return base; })};
}

Feasibility axis_between(const Kinematics& model, const Orientation& first, const Orientation& second) {
    const std::optional<LineOrientation> axis = intersection(first, second);
    return axis ? toppling_axis(model.slope, *axis, model.strength.friction_angle, model.lateral_limit.direct_toppling)
                : Feasibility::planes_parallel;
}

// The other set whose mean plane can be a base, the flattest if there are several.
std::optional<std::size_t> base_at_mean(const Samples& samples, std::size_t first, std::size_t second) {
    std::optional<std::size_t> flattest;
    for (std::size_t set = 0; set < samples.means.size(); ++set) {
        const bool other = set != first && set != second;
        if (other && samples.base_at_mean[set] == Feasibility::feasible &&
            (!flattest || samples.means[set].dip < samples.means[*flattest].dip)) {
            flattest = set;
        }
    }
    return flattest;
}

bool has_base(const Samples& samples, std::size_t sample, std::size_t first, std::size_t second) {
    for (std::size_t set = 0; set < samples.planes.size(); ++set) {
        if (set != first && set != second && samples.can_be_base[set][sample]) {
            return true;
        }
    }
    return false;
}

PairFeasibility pair_feasibility(const Kinematics& model, const Samples& samples, std::size_t first,
                                 std::size_t second) {
    const double friction = model.strength.friction_angle;
    std::size_t wedges = 0;
    std::size_t columns = 0;
    for (std::size_t sample = 0; sample < samples.count(); ++sample) {
        const Orientation& first_plane = samples.planes[first][sample];
        const Orientation& second_plane = samples.planes[second][sample];
        wedges += wedge_sliding(model.slope, first_plane, second_plane, friction).feasibility == Feasibility::feasible
                      ? 1U
                      : 0U;
        columns += has_base(samples, sample, first, second) &&
                           axis_between(model, first_plane, second_plane) == Feasibility::feasible
                       ? 1U
                       : 0U;
    }
    const auto count = static_cast<double>(samples.count());
    const Orientation& first_mean = samples.means[first];
    const Orientation& second_mean = samples.means[second];
    const WedgeVerdict wedge = wedge_sliding(model.slope, first_mean, second_mean, friction);
    const Feasibility axis = axis_between(model, first_mean, second_mean);
    const std::optional<std::size_t> base = base_at_mean(samples, first, second);
    return {.first = model.joint_set[first].name,
            .second = model.joint_set[second].name,
            .intersection = intersection(first_mean, second_mean).value_or(LineOrientation{0, 0}),
            .wedge_sliding = {wedge.feasibility, wedge.critical_friction_angle, static_cast<double>(wedges) / count},
            .wedge_contact = wedge.contact,
            .wedge_limiting_friction_angle = wedge.limiting_friction_angle,
            .direct_toppling = axis == Feasibility::feasible && !base ? Feasibility::no_base_plane : axis,
            .direct_toppling_share = static_cast<double>(columns) / count,
            .toppling_base = base ? model.joint_set[*base].name : std::string{}};
}

Prediction predict(KinematicsStudy study, std::span<const Assignment> assignments) {
    assign(study.model, assignments);
    const KinematicsResult result = analyse(study);
    if (result.check != KinematicsCheck::valid) {
        return {word_of(result.check), {}, {}};
    }
    return {{}, output_values(result), {}};
}

}  // namespace

KinematicsCheck check_input(const KinematicsStudy& study) {
    const std::vector<JointSet>& sets = study.model.joint_set;
    if (!in_range(study)) {
        return KinematicsCheck::input_out_of_range;
    }
    if (sets.empty()) {
        return KinematicsCheck::no_joint_set;
    }
    if (sets.size() > most_joint_sets) {
        return KinematicsCheck::too_many_joint_sets;
    }
    if (std::ranges::any_of(sets, [](const JointSet& set) { return set.name.empty(); })) {
        return KinematicsCheck::joint_set_without_name;
    }
    if (name_repeated(sets)) {
        return KinematicsCheck::joint_set_name_repeated;
    }
    if (!std::ranges::all_of(sets, dips_in_order)) {
        return KinematicsCheck::lower_dip_above_upper_dip;
    }
    const OrientationSampling sampling = sampling_of(study);
    if (std::floor(*sampling.sample_count) != *sampling.sample_count || std::floor(*sampling.seed) != *sampling.seed) {
        return KinematicsCheck::setting_not_whole;
    }
    return KinematicsCheck::valid;
}

KinematicsResult analyse(const KinematicsStudy& study) {
    KinematicsResult result{.check = check_input(study)};
    if (result.check != KinematicsCheck::valid) {
        return result;
    }
    Samples samples = samples_of(study);
    const std::size_t sets = study.model.joint_set.size();
    for (std::size_t set = 0; set < sets; ++set) {
        result.joint_set.push_back(set_feasibility(study.model, samples, set));
    }
    for (std::size_t first = 0; first < sets; ++first) {
        for (std::size_t second = first + 1; second < sets; ++second) {
            result.pair.push_back(pair_feasibility(study.model, samples, first, second));
        }
    }
    result.sampled = std::move(samples.planes);
    return result;
}

ModelInterface model_interface(const KinematicsStudy& study) {
    ModelInterface model;
    model.inputs = inputs_of(study.model);
    // The number of outputs depends on the number of sets alone: an invalid study, which has none, predicts none
    // either.
    KinematicsStudy cheapest = study;
    cheapest.sampling = OrientationSampling{.sample_count = 1, .seed = {}};
    model.outputs = outputs_of(analyse(cheapest));
    model.predict = [study](std::span<const Assignment> assignments) { return predict(study, assignments); };
    return model;
}

}  // namespace delabole
