#include "fitting/mechanism/misfit.hpp"

#include "fitting/probability/estimate.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace delabole {

namespace {

bool satisfied(Relation relation, double residual) {
    return (relation == Relation::at_least && residual >= 0) || (relation == Relation::at_most && residual <= 0);
}

bool same(const std::vector<Condition>& left, const std::vector<Condition>& right) {
    return std::equal(left.begin(), left.end(), right.begin(), right.end(),
                      [](const Condition& a, const Condition& b) { return a.input == b.input && a.value == b.value; });
}

// The greatest residual, in standard deviations, of a prediction that satisfies an inequality: infinite ones have it,
// too, so that residuals change smoothly to it.
constexpr double far_within = 10;

double scatter_of(const std::vector<std::size_t>& outputs, const Prediction& prediction) {
    double scatter = 0;
    for (const std::size_t output : outputs) {
        scatter = std::hypot(scatter, prediction.outputs[output]);
    }
    return scatter;
}

}  // namespace

double cost_of_scatter(double scatter, double standard_deviation, double share) {
    const double ratio = scatter / standard_deviation;
    return std::sqrt(share * std::log1p(ratio * ratio));
}

double data_misfit(const Residuals& residuals) {
    double sum = 0;
    for (std::size_t index = 0; index < residuals.values.size(); ++index) {
        sum += residuals.idle[index] ? 0 : residuals.values[index] * residuals.values[index];
    }
    return sum;
}

Misfit::Misfit(const Mechanism& mechanism, const FitProblem& problem)
    : mechanism_(mechanism), problem_(problem), observations_(problem.observations) {
    for (QuantityObservation& observation : observations_) {
        const auto own = std::ranges::find(mechanism.own_observations, observation.label, &QuantityObservation::label);
        if (own != mechanism.own_observations.end()) {
            observation = *own;
        }
    }
    for (const FreeParameter& parameter : mechanism.parameters) {
        bounds_.push_back({.lower = parameter.lower, .upper = parameter.upper});
    }
    sets_.push_back({{}, InputBinding(mechanism_), {}});
    bind_observations();
    if (problem_.profile) {
        profile_samples_ = resample(problem_.profile->profile, profile_samples);
        if (const auto deviation = output(deviation_of_profile)) {
            profile_scatter_ = {*deviation};
        }
        find_out_about_profile();
    }
}

void Misfit::bind_observations() {
    for (std::size_t index = 0; index < observations_.size(); ++index) {
        const QuantityObservation& observation = observations_[index];
        const auto lacking = std::find_if(observation.conditions.begin(), observation.conditions.end(),
                                          [this](const Condition& condition) { return !input(condition.input); });
        const auto bound_output = output(observation.quantity);
        if (!bound_output) {
            unbound_.push_back({index, "does not predict " + observation.quantity});
        } else if (lacking != observation.conditions.end()) {
            unbound_.push_back({index, "has no input " + lacking->input + ", which the observation fixes"});
        } else {
            bound_.push_back({index, *bound_output, {}, observation.quantity + " is not a number"});
            const QuantityObservation& shared = problem_.observations[index];
            if (shared.quantity == observation.quantity && shared.relation == Relation::equal &&
                observation.relation == Relation::equal) {
                log_own_precision_ += std::log(shared.standard_deviation / observation.standard_deviation);
            }
            for (const std::string_view prefix : {deviation_prefix, path_deviation_prefix}) {
                if (const auto deviation = output(std::string(prefix) + observation.quantity)) {
                    bound_.back().scatter.push_back(*deviation);
                }
            }
            sets_[condition_set(observation.conditions)].observations.push_back(bound_.size() - 1);
        }
    }
}

std::size_t Misfit::condition_set(const std::vector<Condition>& conditions) {
    std::vector<Condition> sorted = conditions;
    std::sort(sorted.begin(), sorted.end(), [](const Condition& a, const Condition& b) { return a.input < b.input; });
    for (std::size_t index = 0; index < sets_.size(); ++index) {
        if (same(sets_[index].conditions, sorted)) {
            return index;
        }
    }
    InputBinding binding(mechanism_, sorted);
    sets_.push_back({std::move(sorted), std::move(binding), {}});
    return sets_.size() - 1;
}

// A mechanism that predicts a profile must be compared with the observed one even at points where it predicts none, so
// it has to be known beforehand whether it predicts any.
void Misfit::find_out_about_profile() {
    std::vector<std::vector<double>> points = sobol_points(bounds_.size(), 15);
    for (std::vector<double>& point : points) {
        for (std::size_t index = 0; index < point.size(); ++index) {
            point[index] = std::lerp(bounds_[index].lower, bounds_[index].upper, point[index]);
        }
    }
    points.insert(points.begin(), centre());
    compares_profile_ = std::any_of(points.begin(), points.end(), [this](const std::vector<double>& point) {
        const Prediction prediction = predict(point);
        return prediction.failure.empty() && length(prediction.profile) > 0;
    });
}

std::optional<std::size_t> Misfit::input(std::string_view name) const {
    return place_of(mechanism_.model.inputs, name);
}

std::optional<std::size_t> Misfit::output(std::string_view name) const {
    return place_of(mechanism_.model.outputs, name);
}

std::vector<Dimension> Misfit::dimensions() const {
    std::vector<Dimension> result;
    for (const FreeParameter& parameter : mechanism_.parameters) {
        result.push_back(find_quantity(mechanism_.model.inputs, parameter.name)->dimension);
    }
    return result;
}

std::vector<std::size_t> Misfit::free_parameters() const {
    std::vector<std::size_t> result;
    for (std::size_t index = 0; index < bounds_.size(); ++index) {
        if (bounds_[index].lower < bounds_[index].upper) {
            result.push_back(index);
        }
    }
    return result;
}

bool Misfit::has_priors() const {
    return std::any_of(mechanism_.parameters.begin(), mechanism_.parameters.end(),
                       [](const FreeParameter& parameter) { return parameter.prior.has_value(); });
}

std::vector<double> Misfit::centre() const {
    std::vector<double> result;
    for (const FreeParameter& parameter : mechanism_.parameters) {
        const double wanted = parameter.prior ? parameter.prior->mean : std::midpoint(parameter.lower, parameter.upper);
        result.push_back(std::clamp(wanted, parameter.lower, parameter.upper));
    }
    return result;
}

Prediction Misfit::predict(const ConditionSet& set, std::span<const double> parameters) const {
    Prediction prediction = mechanism_.model.predict(set.binding.at(parameters));
    if (prediction.failure.empty() && prediction.outputs.size() != mechanism_.model.outputs.size()) {
        prediction.failure = "outputs_missing";
    }
    return prediction;
}

Prediction Misfit::predict(std::span<const double> parameters) const {
    return predict(sets_.front(), parameters);
}

template <class Visitor>
std::string_view Misfit::visit_quantities(const ConditionSet& set, const Prediction& prediction,
                                          const Visitor& visit) const {
    for (const std::size_t index : set.observations) {
        const BoundObservation& bound = bound_[index];
        const QuantityObservation& observation = observations_[bound.observation];
        const double scatter = scatter_of(bound.scatter, prediction);
        const double deviation = std::hypot(observation.standard_deviation, scatter);
        double residual = (prediction.outputs[bound.output] - observation.value) / deviation;
        // A slope that nothing drives has an infinite factor of safety, which is at least any value.
        if (std::isfinite(scatter) && satisfied(observation.relation, residual)) {
            residual = std::clamp(residual, -far_within, far_within);
        }
        if (!std::isfinite(residual) || !std::isfinite(scatter)) {
            return bound.not_a_number;
        }
        visit(residual, satisfied(observation.relation, residual), scatter);
        if (!bound.scatter.empty() && observation.relation == Relation::equal) {
            visit(cost_of_scatter(scatter, observation.standard_deviation, 1), false, scatter);
        }
    }
    return {};
}

template <class Visitor>
std::string_view Misfit::visit_profile(const Prediction& prediction, const Visitor& visit) const {
    const ProfileObservation& observed = *problem_.profile;
    const double scatter = scatter_of(profile_scatter_, prediction);
    const auto vertices = static_cast<double>(observed.profile.size());
    const double weight = std::sqrt(vertices / static_cast<double>(profile_samples_.size())) /
                          std::hypot(observed.standard_deviation, scatter);
    for (const Point& point : profile_samples_) {
        // Positive if the prediction lies to the left of (above) the observed ground.
        const double residual = -weight * signed_distance(prediction.profile, point);
        if (!std::isfinite(residual)) {
            return "profile_missing";
        }
        visit(residual, false, scatter);
    }
    if (!profile_scatter_.empty()) {
        visit(cost_of_scatter(scatter, observed.standard_deviation, vertices), false, scatter);
    }
    return {};
}

template <class Visitor, class Enough>
std::string_view Misfit::visit_residuals(std::span<const double> parameters, const Visitor& visit,
                                         const Enough& enough) const {
    for (const ConditionSet& set : sets_) {
        const bool with_profile = compares_profile_ && &set == &sets_.front();
        if (set.observations.empty() && !with_profile) {
            continue;
        }
        if (enough()) {
            break;
        }
        const Prediction prediction = predict(set, parameters);
        if (!prediction.failure.empty()) {
            return prediction.failure;
        }
        std::string_view failure = visit_quantities(set, prediction, visit);
        if (failure.empty() && with_profile) {
            failure = visit_profile(prediction, visit);
        }
        if (!failure.empty()) {
            return failure;
        }
    }
    return {};
}

Evaluation Misfit::value_of_data(std::span<const double> parameters, double most) const {
    double sum = 0;
    const auto add = [&sum](double residual, bool idle, double) { sum += idle ? 0 : residual * residual; };
    const std::string_view failure = visit_residuals(parameters, add, [&] { return sum > most; });
    return {sum, failure};
}

MisfitParts Misfit::parts(std::span<const double> parameters) const {
    const Evaluation data = value_of_data(parameters, std::numeric_limits<double>::infinity());
    return {data.value, prior(parameters), data.failure};
}

double Misfit::prior(std::span<const double> parameters) const {
    double sum = 0;
    for (std::size_t index = 0; index < parameters.size(); ++index) {
        if (const auto& prior = mechanism_.parameters[index].prior) {
            const double residual = (parameters[index] - prior->mean) / prior->standard_deviation;
            sum += residual * residual;
        }
    }
    return sum;
}

Evaluation Misfit::value(std::span<const double> parameters, Priors priors) const {
    const MisfitParts sum = parts(parameters);
    return {sum.data + (priors == Priors::counted ? sum.prior : 0), sum.failure};
}

Residuals Misfit::residuals(std::span<const double> parameters) const {
    Residuals result;
    result.failure = visit_residuals(
        parameters,
        [&result](double residual, bool idle, double scatter) {
            result.values.push_back(residual);
            result.idle.push_back(idle);
            result.scatter.push_back(scatter);
        },
        [] { return false; });
    return result;
}

std::vector<Datum> Misfit::data() const {
    std::vector<Datum> data;
    for (const ConditionSet& set : sets_) {
        for (const std::size_t index : set.observations) {
            const QuantityObservation& observation = observations_[bound_[index].observation];
            data.push_back({observation.label, observation.relation, observation.standard_deviation, 1, false});
            if (!bound_[index].scatter.empty() && observation.relation == Relation::equal) {
                data.push_back(
                    {observation.label + ", scatter", Relation::equal, observation.standard_deviation, 1, true});
            }
        }
        if (compares_profile_ && &set == &sets_.front()) {
            const auto vertices = static_cast<double>(problem_.profile->profile.size());
            const double deviation = problem_.profile->standard_deviation;
            data.insert(data.end(), profile_samples_.size(),
                        {"post-failure profile", Relation::equal, deviation,
                         vertices / static_cast<double>(profile_samples_.size()), false});
            if (!profile_scatter_.empty()) {
                data.push_back({"post-failure profile, scatter", Relation::equal, deviation, vertices, true});
            }
        }
    }
    return data;
}

std::vector<ObservationFit> Misfit::compare(std::span<const double> parameters) const {
    std::vector<ObservationFit> table;
    for (const QuantityObservation& observation : observations_) {
        const auto index = output(observation.quantity);
        table.push_back({observation.label, observation.quantity, observation.relation,
                         index ? mechanism_.model.outputs[*index].dimension : Dimension::ratio, observation.value,
                         observation.standard_deviation, 0, std::nullopt, 0, observation.source});
    }
    for (const ConditionSet& set : sets_) {
        const Prediction prediction = set.observations.empty() ? Prediction{} : predict(set, parameters);
        if (!prediction.failure.empty()) {
            continue;
        }
        for (const std::size_t index : set.observations) {
            ObservationFit& row = table[bound_[index].observation];
            row.predicted = prediction.outputs[bound_[index].output];
            row.scatter = scatter_of(bound_[index].scatter, prediction);
            row.standard_deviation = std::hypot(row.standard_deviation, row.scatter);
            row.residual = (*row.predicted - row.observed) / row.standard_deviation;
            row.residual = satisfied(row.relation, row.residual) ? 0 : row.residual;
        }
    }
    return table;
}

std::optional<ProfileFit> Misfit::compare_profile(std::span<const double> parameters) const {
    if (!compares_profile_) {
        return std::nullopt;
    }
    const Prediction prediction = predict(parameters);
    double squares = 0;
    if (!prediction.failure.empty()) {
        return std::nullopt;
    }
    ProfileFit fit;
    fit.scatter = scatter_of(profile_scatter_, prediction);
    for (const Point& point : profile_samples_) {
        const double distance = signed_distance(prediction.profile, point);
        squares += distance * distance;
    }
    fit.rms = std::sqrt(squares / static_cast<double>(profile_samples_.size()));
    fit.standard_deviation = std::hypot(problem_.profile->standard_deviation, fit.scatter);
    return std::isfinite(fit.residual()) ? std::optional(fit) : std::nullopt;
}

double Misfit::scatter_cost(std::span<const double> parameters) const {
    const Residuals found = residuals(parameters);
    const std::vector<Datum> of = data();
    double squares = 0;
    for (std::size_t index = 0; index < found.values.size(); ++index) {
        squares += of[index].cost ? found.values[index] * found.values[index] : 0;
    }
    return squares / 2;
}

int Misfit::data_count() const {
    return static_cast<int>(bound_.size() + (compares_profile_ ? problem_.profile->profile.size() : 0));
}

int Misfit::missing_count() const {
    const bool profile_left_out = problem_.profile && !compares_profile_;
    return static_cast<int>(unbound_.size() + (profile_left_out ? problem_.profile->profile.size() : 0));
}

std::vector<std::string> Misfit::not_compared() const {
    std::vector<std::string> sentences;
    for (const Unbound& entry : unbound_) {
        sentences.push_back(observations_[entry.observation].label + ": the mechanism " + entry.reason);
    }
    if (problem_.profile && !compares_profile_) {
        sentences.emplace_back("post-failure profile: the mechanism does not predict one");
    }
    return sentences;
}

}  // namespace delabole
