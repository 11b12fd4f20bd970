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

// A set in the analysis: as given in the case, or with its measured poles.
struct AnalysedSet {
    std::string name;
    Orientation mean;
    std::vector<Orientation> planes;  // sampled or measured
    std::vector<double> weights;      // one for each plane
    std::optional<FisherStatistics> measured;
};

// Poles of all surveys, and the set to which each belongs.
struct Poles {
    std::vector<Orientation> planes;
    std::vector<double> weights;
};

Poles poles_of(const Kinematics& model) {
    Poles poles{measured_planes(model), {}};
    for (const PoleSurvey& survey : model.poles) {
        for (const Orientation& plane : survey.plane) {
            poles.weights.push_back(
                survey.scanline
                    ? terzaghi_weight(plane, {survey.scanline->plunge, survey.scanline->trend},
                                      survey.scanline->least_angle.value_or(Scanline::customary_least_angle))
                    : 1.0);
        }
    }
    return poles;
}

template <class Belongs>
AnalysedSet measured_set(std::string name, const Poles& poles, Belongs&& belongs) {
    AnalysedSet set{std::move(name), {}, {}, {}, {}};
    for (std::size_t pole = 0; pole < poles.planes.size(); ++pole) {
        if (belongs(pole)) {
            set.planes.push_back(poles.planes[pole]);
            set.weights.push_back(poles.weights[pole]);
        }
    }
    if (!set.planes.empty()) {
        set.measured = fisher_statistics(set.planes, set.weights);
        set.mean = {set.measured->mean_dip, set.measured->mean_dip_direction};
    }
    return set;
}

bool in_window(const PoleWindow& window, const Orientation& plane) {
    const Direction middle = upward_normal({window.window_dip, window.window_dip_direction});
    return std::abs(middle.dot(upward_normal(plane))) >= std::cos(window.window_radius);
}

struct SetsOfStudy {
    KinematicsCheck check = KinematicsCheck::valid;
    std::vector<AnalysedSet> sets = {};
    std::vector<std::vector<std::size_t>> sets_of_pole = {};
    std::vector<double> information_criterion = {};
    std::vector<bool> too_small = {};
};

SetsOfStudy found_sets(const Kinematics& model, const Poles& poles) {
    PoleClusters clusters = find_clusters(poles.planes, poles.weights, most_sets_searched(model));
    SetsOfStudy result{.information_criterion = std::move(clusters.information_criterion),
                       .too_small = std::move(clusters.too_small)};
    for (std::size_t index = 0; index < clusters.sets.size(); ++index) {
        result.sets.push_back(measured_set("set_" + std::to_string(index + 1), poles,
                                           [&](std::size_t pole) { return clusters.of[pole] == index; }));
    }
    for (const std::optional<std::size_t>& set : clusters.of) {
        result.sets_of_pole.push_back(set ? std::vector{*set} : std::vector<std::size_t>{});
    }
    result.check = result.sets.empty() ? KinematicsCheck::no_set_found : KinematicsCheck::valid;
    return result;
}

SetsOfStudy sets_of(const KinematicsStudy& study, const Poles& poles) {
    const Kinematics& model = study.model;
    if (model.joint_set.empty()) {
        return found_sets(model, poles);
    }
    const OrientationSampling sampling = sampling_of(study);
    SetsOfStudy result{};
    result.sets_of_pole.resize(poles.planes.size());
    for (const JointSet& set : model.joint_set) {
        if (const auto* window = std::get_if<PoleWindow>(&set.orientation)) {
            result.sets.push_back(measured_set(set.name, poles, [&](std::size_t pole) {
                const bool inside = in_window(*window, poles.planes[pole]);
                if (inside) {
                    result.sets_of_pole[pole].push_back(result.sets.size());
                }
                return inside;
            }));
            if (result.sets.back().planes.empty()) {
                result.check = KinematicsCheck::window_without_poles;
            }
            continue;
        }
        std::vector<Orientation> planes =
            sampled_planes(set, static_cast<std::size_t>(*sampling.sample_count),
                           static_cast<std::uint64_t>(*sampling.seed), result.sets.size());
        std::vector<double> weights(planes.size(), 1.0);
        result.sets.push_back({set.name, mean_orientation(set), std::move(planes), std::move(weights), {}});
    }
    return result;
}

// Planes of all sets, the same number of each, and the properties of each that direct toppling needs.
struct Samples {
    std::vector<std::vector<Orientation>> planes;  // planes[set][sample]
    std::vector<std::vector<bool>> can_be_base;    // indices as for `planes`
    std::vector<Orientation> means;                // means[set]
    std::vector<Feasibility> base_at_mean;         // base_at_mean[set]
    std::size_t count() const { return planes.front().size(); }
};

Samples samples_of(const KinematicsStudy& study, const std::vector<AnalysedSet>& sets) {
    const Kinematics& model = study.model;
    const OrientationSampling sampling = sampling_of(study);
    const auto base = [&](const Orientation& plane) {
        return toppling_base(model.slope, plane, model.strength.friction_angle, model.lateral_limit.direct_toppling);
    };
    Samples samples{.planes = {}, .can_be_base = {}, .means = {}, .base_at_mean = {}};
    for (const AnalysedSet& set : sets) {
        samples.planes.push_back(
            set.measured ? drawn_planes(set.planes, set.weights, static_cast<std::size_t>(*sampling.sample_count),
                                        static_cast<std::uint64_t>(*sampling.seed), samples.planes.size())
                         : set.planes);
        samples.means.push_back(set.mean);
        samples.base_at_mean.push_back(base(set.mean));
        std::vector<bool>& can_be_base = samples.can_be_base.emplace_back();
        for (const Orientation& plane : samples.planes.back()) {
            can_be_base.push_back(base(plane) == Feasibility::feasible);
        }
    }
    return samples;
}

// Share of the planes of a set, by their weights.
template <class Predicate>
double share_of(const AnalysedSet& set, Predicate&& predicate) {
    double all = 0;
    double such = 0;
    for (std::size_t index = 0; index < set.planes.size(); ++index) {
        all += set.weights[index];
        such += predicate(set.planes[index]) ? set.weights[index] : 0;
    }
    return such / all;
}

JointSetFeasibility set_feasibility(const Kinematics& model, const AnalysedSet& set) {
    const double friction = model.strength.friction_angle;
    const auto base = [&](const Orientation& plane) {
        return toppling_base(model.slope, plane, friction, model.lateral_limit.direct_toppling);
    };
    const auto mechanism = [&](auto&& criterion) {
        const FeasibilityVerdict mean = criterion(set.mean);
        const double share = share_of(
            set, [&](const Orientation& plane) { return criterion(plane).feasibility == Feasibility::feasible; });
        return MechanismFeasibility{mean.feasibility, mean.critical_friction_angle, share};
    };
    return {.name = set.name,
            .mean = set.mean,
            .apparent_dip = apparent_dip(set.mean, model.slope.face_dip_direction),
            .angular_standard_deviation = orientation_statistics(set.planes, set.weights).angular_standard_deviation,
            .planar_sliding = mechanism([&](const Orientation& plane) {
                return planar_sliding(model.slope, plane, friction, model.lateral_limit.planar_sliding);
            }),
            .flexural_toppling = mechanism([&](const Orientation& plane) {
                return flexural_toppling(model.slope, plane, friction, model.lateral_limit.flexural_toppling);
            }),
            .toppling_base = base(set.mean),
            .toppling_base_share =
                share_of(set, [&](const Orientation& plane) { return base(plane) == Feasibility::feasible; }),
            .measured = set.measured};
}

Feasibility axis_between(const Kinematics& model, const Orientation& first, const Orientation& second) {
    const std::optional<LineOrientation> axis = intersection(first, second);
    return axis ? toppling_axis(model.slope, *axis, model.strength.friction_angle, model.lateral_limit.direct_toppling)
                : Feasibility::planes_parallel;
}

// The other set whose mean plane can be a base; if there are several, the flattest.
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

PairFeasibility pair_feasibility(const Kinematics& model, const std::vector<AnalysedSet>& sets, const Samples& samples,
                                 std::size_t first, std::size_t second) {
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
    return {.first = sets[first].name,
            .second = sets[second].name,
            .intersection = intersection(first_mean, second_mean).value_or(LineOrientation{0, 0}),
            .wedge_sliding = {wedge.feasibility, wedge.critical_friction_angle, static_cast<double>(wedges) / count},
            .wedge_contact = wedge.contact,
            .wedge_limiting_friction_angle = wedge.limiting_friction_angle,
            .direct_toppling = axis == Feasibility::feasible && !base ? Feasibility::no_base_plane : axis,
            .direct_toppling_share = static_cast<double>(columns) / count,
            .toppling_base = base ? sets[*base].name : std::string{}};
}

PoleCounts counts_of(const Kinematics& model, const std::vector<Orientation>& planes) {
    const double friction = model.strength.friction_angle;
    const auto count_if = [](const auto& items, auto&& predicate) {
        return static_cast<double>(std::ranges::count_if(items, predicate));
    };
    PoleCounts counts{};
    counts.count = static_cast<double>(planes.size());
    counts.planar_sliding = count_if(planes, [&](const Orientation& plane) {
        return planar_sliding(model.slope, plane, friction, model.lateral_limit.planar_sliding).feasibility ==
               Feasibility::feasible;
    });
    counts.flexural_toppling = count_if(planes, [&](const Orientation& plane) {
        return flexural_toppling(model.slope, plane, friction, model.lateral_limit.flexural_toppling).feasibility ==
               Feasibility::feasible;
    });
    counts.toppling_base = count_if(planes, [&](const Orientation& plane) {
        return toppling_base(model.slope, plane, friction, model.lateral_limit.direct_toppling) ==
               Feasibility::feasible;
    });
    const std::size_t chosen = std::min(planes.size(), most_poles_intersected);
    for (std::size_t first = 0; first < chosen; ++first) {
        for (std::size_t second = first + 1; second < chosen; ++second) {
            const Orientation& one = planes[first * planes.size() / chosen];
            const Orientation& other = planes[second * planes.size() / chosen];
            const Feasibility axis = axis_between(model, one, other);
            counts.intersections += axis == Feasibility::planes_parallel ? 0 : 1;
            counts.toppling_axis += axis == Feasibility::feasible ? 1 : 0;
            if (wedge_sliding(model.slope, one, other, friction).feasibility == Feasibility::feasible) {
                counts.wedge_sliding += 1;
                counts.wedge_sliding_secondary += intersection(one, other)->plunge <= friction ? 1 : 0;
            }
        }
    }
    return counts;
}

bool whole(const std::optional<SetSearch>& search) {
    return !search || std::floor(search->most_sets) == search->most_sets;
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
    if (sets.empty() && study.model.poles.empty()) {
        return KinematicsCheck::no_joint_set;
    }
    if (std::ranges::any_of(study.model.poles, [](const PoleSurvey& survey) { return survey.plane.empty(); })) {
        return KinematicsCheck::survey_without_planes;
    }
    if (measured_planes(study.model).size() > most_poles) {
        return KinematicsCheck::too_many_poles;
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
    if (!whole(study.model.set_search) || std::floor(*sampling.sample_count) != *sampling.sample_count ||
        std::floor(*sampling.seed) != *sampling.seed) {
        return KinematicsCheck::setting_not_whole;
    }
    return KinematicsCheck::valid;
}

KinematicsResult analyse(const KinematicsStudy& study) {
    KinematicsResult result{.check = check_input(study)};
    if (result.check != KinematicsCheck::valid) {
        return result;
    }
    const Kinematics& model = study.model;
    const Poles poles = poles_of(model);
    SetsOfStudy found = sets_of(study, poles);
    if (found.check != KinematicsCheck::valid) {
        result.check = found.check;
        return result;
    }
    const Samples samples = samples_of(study, found.sets);
    for (const AnalysedSet& set : found.sets) {
        result.joint_set.push_back(set_feasibility(model, set));
    }
    for (std::size_t first = 0; first < found.sets.size(); ++first) {
        for (std::size_t second = first + 1; second < found.sets.size(); ++second) {
            result.pair.push_back(pair_feasibility(model, found.sets, samples, first, second));
        }
    }
    for (AnalysedSet& set : found.sets) {
        result.sampled.push_back(std::move(set.planes));
        result.sampled_weights.push_back(std::move(set.weights));
    }
    if (!poles.planes.empty()) {
        result.poles = counts_of(model, poles.planes);
        for (std::size_t pole = 0; pole < poles.planes.size(); ++pole) {
            if (found.sets_of_pole[pole].empty()) {
                result.without_set.push_back(poles.planes[pole]);
                result.weights_without_set.push_back(poles.weights[pole]);
            }
        }
        result.poles->without_set = static_cast<double>(result.without_set.size());
    }
    result.sets_of_pole = std::move(found.sets_of_pole);
    result.information_criterion = std::move(found.information_criterion);
    result.too_small = std::move(found.too_small);
    return result;
}

std::size_t most_sets_searched(const Kinematics& model) {
    constexpr double most = 12;  // upper end of the field's range
    return model.set_search ? static_cast<std::size_t>(std::clamp(model.set_search->most_sets, 1.0, most)) : 8;
}

std::vector<Orientation> measured_planes(const Kinematics& model) {
    std::vector<Orientation> planes;
    for (const PoleSurvey& survey : model.poles) {
        planes.insert(planes.end(), survey.plane.begin(), survey.plane.end());
    }
    return planes;
}

ModelInterface model_interface(const KinematicsStudy& study) {
    ModelInterface model;
    model.inputs = inputs_of(study.model);
    // The number of outputs depends on the numbers of sets and poles alone. An invalid study has no outputs and
    // predicts none.
    KinematicsStudy cheapest = study;
    cheapest.sampling = OrientationSampling{.sample_count = 1, .seed = {}};
    model.outputs = outputs_of(analyse(cheapest));
    model.predict = [study, outputs = model.outputs.size()](std::span<const Assignment> assignments) -> Prediction {
        Prediction prediction = predict(study, assignments);
        // With other poles a different number of sets may be found.
        const bool other_sets = prediction.failure.empty() && prediction.outputs.size() != outputs;
        return other_sets ? Prediction{"other_number_of_sets", {}, {}} : prediction;
    };
    return model;
}

}  // namespace delabole
