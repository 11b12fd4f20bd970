#include "fitting/studies/information.hpp"

#include "fitting/probability/counted_random.hpp"
#include "fitting/probability/moments.hpp"
#include "fitting/probability/normal_integral.hpp"
#include "fitting/work/parallel.hpp"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace delabole {

namespace {

constexpr double least_effective_draws = 50;
constexpr double least_share_of_answers = 0.5;

// The draws of one mechanism at which the model predicts one candidate.
struct Answered {
    std::vector<double> predicted;
    std::vector<int> chain;
    std::vector<std::vector<double>> values;       // of each parameter
    std::vector<std::vector<std::size_t>> ranked;  // for each parameter, the draws by increasing value
    int chains = 0;

    Answered(const MechanismDraws& draws, std::size_t candidate) {
        values.resize(draws.values.size());
        for (std::size_t draw = 0; draw < draws.chain.size(); ++draw) {
            if (!std::isfinite(draws.predicted[candidate][draw])) {
                continue;
            }
            predicted.push_back(draws.predicted[candidate][draw]);
            chain.push_back(draws.chain[draw]);
            for (std::size_t parameter = 0; parameter < values.size(); ++parameter) {
                values[parameter].push_back(draws.values[parameter][draw]);
            }
        }
        for (const int number : draws.chain) {
            chains = std::max(chains, number + 1);
        }
        for (const std::vector<double>& column : values) {
            std::vector<std::size_t>& order = ranked.emplace_back(column.size());
            std::iota(order.begin(), order.end(), std::size_t{0});
            std::stable_sort(order.begin(), order.end(),
                             [&](std::size_t one, std::size_t other) { return column[one] < column[other]; });
        }
    }

    std::size_t size() const { return predicted.size(); }
};

struct Spread {
    double deviation = 0;
    double width = 0;
};

// Spreads of one parameter with the given weights: entry 0 is over all draws, entry c + 1 over all except those of
// chain c.
class Spreads {
  public:
    Spreads(const Answered& draws, std::size_t parameter, std::span<const double> weights)
        : draws_(draws), parameter_(parameter), weights_(weights) {}

    std::vector<Spread> all() const {
        std::vector<Spread> spreads(static_cast<std::size_t>(draws_.chains) + 1);
        std::vector<double> sums(spreads.size(), 0);
        deviations(spreads, sums);
        for (std::size_t left_out = 0; left_out < spreads.size(); ++left_out) {
            spreads[left_out].width = width(static_cast<int>(left_out) - 1, sums[left_out]);
        }
        return spreads;
    }

  private:
    void deviations(std::vector<Spread>& spreads, std::vector<double>& sums) const {
        const std::vector<double>& values = draws_.values[parameter_];
        const double offset = values[draws_.ranked[parameter_][draws_.size() / 2]];
        std::vector<std::array<double, 3>> moments(spreads.size(), {0, 0, 0});  // by chain, from entry 1 on
        for (std::size_t draw = 0; draw < draws_.size(); ++draw) {
            const double value = values[draw] - offset;
            const double weight = weights_[draw];
            for (auto* moment : {&moments[0], &moments[static_cast<std::size_t>(draws_.chain[draw]) + 1]}) {
                (*moment)[0] += weight;
                (*moment)[1] += weight * value;
                (*moment)[2] += weight * value * value;
            }
        }
        for (std::size_t entry = 0; entry < spreads.size(); ++entry) {
            std::array<double, 3> left = moments[0];
            for (std::size_t power = 0; entry > 0 && power < left.size(); ++power) {
                left[power] -= moments[entry][power];
            }
            sums[entry] = left[0];
            const double mean = left[1] / left[0];
            spreads[entry].deviation = std::sqrt(std::max(left[2] / left[0] - mean * mean, 0.0));
        }
    }

    // Distance between the 2.5 and 97.5 % quantiles over all draws except those of one chain.
    double width(int left_out, double sum) const {
        const std::vector<double>& values = draws_.values[parameter_];
        std::array<double, 2> ends{};
        std::size_t found = 0;
        double below = 0;
        constexpr std::array shares{0.025, 0.975};
        for (const std::size_t draw : draws_.ranked[parameter_]) {
            if (draws_.chain[draw] == left_out) {
                continue;
            }
            below += weights_[draw];
            for (; found < shares.size() && below >= shares[found] * sum; ++found) {
                ends[found] = values[draw];
            }
        }
        return found == shares.size() ? ends[1] - ends[0] : 0;
    }

    const Answered& draws_;
    std::size_t parameter_;
    std::span<const double> weights_;
};

struct Outcome {
    std::size_t draw;  // from which it was simulated
    double value;
};

std::vector<Outcome> outcomes_of(const Answered& draws, double deviation, std::size_t wanted,
                                 const CountedRandom& random, std::uint32_t stream) {
    const std::size_t count = std::min(wanted, draws.size());
    std::vector<Outcome> outcomes;
    for (std::size_t number = 0; number < count; ++number) {
        const std::size_t draw = number * draws.size() / count;
        const double noise = gsl_cdf_ugaussian_Pinv(random.unit(number, stream));
        outcomes.push_back({draw, draws.predicted[draw] + deviation * noise});
    }
    return outcomes;
}

// Relative weights of the draws given an outcome: the greatest is about 1, that of the outcome's own draw is 0.
std::vector<double> weights_given(const Answered& draws, const Outcome& outcome, double deviation) {
    std::vector<double> weights(draws.size());
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t draw = 0; draw < draws.size(); ++draw) {
        const double residual = (outcome.value - draws.predicted[draw]) / deviation;
        weights[draw] = residual * residual;
        least = draw == outcome.draw ? least : std::min(least, weights[draw]);
    }
    for (double& weight : weights) {
        weight = std::exp(-0.5 * (weight - least));
    }
    weights[outcome.draw] = 0;
    return weights;
}

// One row of the jackknife: sums of spreads over outcomes, with one chain left out.
struct Averages {
    std::vector<Spread> sum;  // of each parameter
    std::vector<Spread> now;  // without any measurement
    double outcomes = 0;
};

ExpectedReduction reduction_of(const std::vector<Averages>& lines, std::size_t parameter, double Spread::*spread) {
    const auto of_line = [&](const Averages& line) {
        const double now = line.now[parameter].*spread;
        return now > 0 && line.outcomes > 0 ? 1 - line.sum[parameter].*spread / line.outcomes / now : 0.0;
    };
    const auto chains = static_cast<double>(lines.size() - 1);
    double mean = 0;
    for (std::size_t line = 1; line < lines.size(); ++line) {
        mean += of_line(lines[line]) / chains;
    }
    double squares = 0;
    for (std::size_t line = 1; line < lines.size(); ++line) {
        squares += (of_line(lines[line]) - mean) * (of_line(lines[line]) - mean);
    }
    return {of_line(lines[0]), std::sqrt(squares * (chains - 1) / chains)};
}

struct OutcomeSpreads {
    std::vector<std::vector<Spread>> of_parameter;
    double effective_draws = 0;
};

MechanismInformation inform(const MechanismDraws& mechanism, const Answered& draws,
                            const std::vector<Outcome>& outcomes, double deviation, int threads) {
    MechanismInformation information;
    information.mechanism = mechanism.name;
    const auto spread_of_all = [&](std::span<const double> weights) {
        std::vector<std::vector<Spread>> spreads;
        for (std::size_t parameter = 0; parameter < draws.values.size(); ++parameter) {
            spreads.push_back(Spreads(draws, parameter, weights).all());
        }
        return spreads;
    };
    const auto now = spread_of_all(std::vector<double>(draws.size(), 1.0));
    std::vector<OutcomeSpreads> found(outcomes.size());
    run_tasks(outcomes.size(), threads, [&](std::size_t number) {
        const std::vector<double> weights = weights_given(draws, outcomes[number], deviation);
        double sum = 0;
        double squares = 0;
        for (const double weight : weights) {
            sum += weight;
            squares += weight * weight;
        }
        found[number] = {spread_of_all(weights), sum * sum / squares};
    });

    std::vector<Averages> lines(static_cast<std::size_t>(draws.chains) + 1);
    for (std::size_t line = 0; line < lines.size(); ++line) {
        lines[line].sum.resize(draws.values.size());
        for (const std::vector<Spread>& spreads : now) {
            lines[line].now.push_back(spreads[line]);
        }
        for (std::size_t number = 0; number < outcomes.size(); ++number) {
            if (draws.chain[outcomes[number].draw] == static_cast<int>(line) - 1) {
                continue;
            }
            ++lines[line].outcomes;
            for (std::size_t parameter = 0; parameter < draws.values.size(); ++parameter) {
                const Spread& spread = found[number].of_parameter[parameter][line];
                lines[line].sum[parameter].deviation += spread.deviation;
                lines[line].sum[parameter].width += spread.width;
            }
        }
    }
    for (const OutcomeSpreads& outcome : found) {
        information.effective_draws += outcome.effective_draws / static_cast<double>(found.size());
    }
    information.status = information.effective_draws < least_effective_draws ? InformationStatus::few_draws_alike
                                                                             : InformationStatus::found;
    for (std::size_t parameter = 0; parameter < mechanism.parameters.size(); ++parameter) {
        information.parameters.push_back({mechanism.parameters[parameter],
                                          reduction_of(lines, parameter, &Spread::deviation),
                                          reduction_of(lines, parameter, &Spread::width)});
    }
    return information;
}

// Predictions of a candidate by one mechanism.
struct Predictor {
    std::size_t mechanism;
    double probability;  // among the mechanisms that predict it
    Answered draws;
    std::vector<Outcome> outcomes;
};

// ln of the mean normal density of an outcome over the draws, up to a constant; the draw of that number, if there is
// one, is left out.
double log_density(const Answered& draws, double outcome, double deviation, std::size_t left_out) {
    double least = std::numeric_limits<double>::infinity();
    const auto square = [&](std::size_t draw) {
        const double residual = (outcome - draws.predicted[draw]) / deviation;
        return residual * residual;
    };
    for (std::size_t draw = 0; draw < draws.size(); ++draw) {
        least = draw == left_out ? least : std::min(least, square(draw));
    }
    double sum = 0;
    for (std::size_t draw = 0; draw < draws.size(); ++draw) {
        sum += draw == left_out ? 0 : std::exp(-0.5 * (square(draw) - least));
    }
    return std::log(sum / static_cast<double>(draws.size() - (left_out < draws.size() ? 1 : 0))) - 0.5 * least;
}

double entropy(std::span<const double> probabilities) {
    double sum = 0;
    for (const double probability : probabilities) {
        sum -= probability > 0 ? probability * std::log(probability) : 0;
    }
    return sum;
}

// Entropy of the probabilities of the mechanisms given an outcome of predictors[source].
double entropy_after(const std::vector<Predictor>& predictors, std::size_t source, const Outcome& outcome,
                     double deviation) {
    std::vector<double> logs;
    for (std::size_t index = 0; index < predictors.size(); ++index) {
        const std::size_t own = index == source ? outcome.draw : predictors[index].draws.size();
        logs.push_back(std::log(predictors[index].probability) +
                       log_density(predictors[index].draws, outcome.value, deviation, own));
    }
    const double greatest = *std::max_element(logs.begin(), logs.end());
    double sum = 0;
    for (double& value : logs) {
        value = std::exp(value - greatest);
        sum += value;
    }
    for (double& value : logs) {
        value /= sum;
    }
    return entropy(logs);
}

std::optional<ExpectedReduction> about_mechanism(const std::vector<Predictor>& predictors, double deviation,
                                                 int threads) {
    if (predictors.size() < 2) {
        return std::nullopt;
    }
    std::vector<double> before;
    before.reserve(predictors.size());
    for (const Predictor& predictor : predictors) {
        before.push_back(predictor.probability);
    }
    ExpectedReduction result{entropy(before), 0};
    for (std::size_t source = 0; source < predictors.size(); ++source) {
        const std::vector<Outcome>& outcomes = predictors[source].outcomes;
        std::vector<double> after(outcomes.size());
        run_tasks(outcomes.size(), threads, [&](std::size_t number) {
            after[number] = entropy_after(predictors, source, outcomes[number], deviation);
        });
        const double probability = predictors[source].probability;
        result.value -= probability * mean_of(after);
        result.error += std::pow(probability * deviation_of(after), 2) / static_cast<double>(outcomes.size());
    }
    result.error = std::sqrt(result.error);
    return result;
}

// The standard errors of the mechanisms are independent and add up by squares.
std::vector<ParameterInformation> over_mechanisms(const std::vector<MechanismDraws>& mechanisms,
                                                  const std::vector<MechanismInformation>& information) {
    std::vector<ParameterInformation> sums;
    std::vector<double> weights;
    for (std::size_t index = 0; index < mechanisms.size(); ++index) {
        const double weight = mechanisms[index].probability;
        for (std::size_t parameter = 0; parameter < mechanisms[index].parameters.size(); ++parameter) {
            const std::string& name = mechanisms[index].parameters[parameter];
            auto place = std::find_if(sums.begin(), sums.end(), [&](const auto& sum) { return sum.parameter == name; });
            if (place == sums.end()) {
                place = sums.insert(sums.end(), {name, {}, {}});
                weights.push_back(0);
            }
            weights[static_cast<std::size_t>(place - sums.begin())] += weight;
            if (information[index].parameters.empty()) {
                continue;
            }
            const ParameterInformation& own = information[index].parameters[parameter];
            for (const auto member : {&ParameterInformation::standard_deviation, &ParameterInformation::interval_95}) {
                ((*place).*member).value += weight * (own.*member).value;
                ((*place).*member).error += weight * weight * (own.*member).error * (own.*member).error;
            }
        }
    }
    for (std::size_t index = 0; index < sums.size(); ++index) {
        for (const auto member : {&ParameterInformation::standard_deviation, &ParameterInformation::interval_95}) {
            ExpectedReduction& sum = sums[index].*member;
            const bool any = weights[index] > 0;
            sum = any ? ExpectedReduction{sum.value / weights[index], std::sqrt(sum.error) / weights[index]}
                      : ExpectedReduction{};
        }
    }
    return sums;
}

void demand_consistency(const std::vector<MechanismDraws>& mechanisms, std::size_t candidates) {
    for (const MechanismDraws& mechanism : mechanisms) {
        bool fits = mechanism.predicted.size() == candidates &&
                    mechanism.values.size() == mechanism.parameters.size() && mechanism.probability >= 0;
        for (const auto* table : {&mechanism.values, &mechanism.predicted}) {
            for (const std::vector<double>& column : *table) {
                fits =
                    fits && (column.size() == mechanism.chain.size() || (table != &mechanism.values && column.empty()));
            }
        }
        if (!fits) {
            throw std::invalid_argument("value_of_information: the draws of " + mechanism.name +
                                        " do not fit together");
        }
    }
}

}  // namespace

std::vector<CandidateInformation> value_of_information(const std::vector<FitCandidate>& candidates,
                                                       const std::vector<MechanismDraws>& mechanisms,
                                                       const InformationSettings& settings) {
    demand_consistency(mechanisms, candidates.size());
    const CountedRandom random(settings.seed, RandomPurpose::outcome);
    const auto wanted = static_cast<std::size_t>(std::max(settings.outcomes, 2));
    std::vector<CandidateInformation> result;
    for (std::size_t candidate = 0; candidate < candidates.size(); ++candidate) {
        const double deviation = candidates[candidate].standard_deviation;
        CandidateInformation information;
        information.label = candidates[candidate].label;
        std::vector<Predictor> predictors;
        double probability = 0;
        for (std::size_t index = 0; index < mechanisms.size(); ++index) {
            const MechanismDraws& mechanism = mechanisms[index];
            MechanismInformation& own = information.mechanisms.emplace_back();
            own.mechanism = mechanism.name;
            if (mechanism.predicted[candidate].empty()) {
                continue;
            }
            Answered draws(mechanism, candidate);
            const double answered = static_cast<double>(draws.size()) / static_cast<double>(mechanism.chain.size());
            own.without_answer = 1 - answered;
            own.status = InformationStatus::few_answers;
            if (draws.size() < 2 || answered < least_share_of_answers) {
                continue;
            }
            const auto stream = static_cast<std::uint32_t>(candidate * mechanisms.size() + index);
            const std::vector<Outcome> outcomes = outcomes_of(draws, deviation, wanted, random, stream);
            const double without_answer = own.without_answer;
            own = inform(mechanism, draws, outcomes, deviation, settings.threads);
            own.without_answer = without_answer;
            if (mechanism.probability > 0) {
                probability += mechanism.probability;
                predictors.push_back({index, mechanism.probability, std::move(draws), outcomes});
            }
        }
        for (Predictor& predictor : predictors) {
            predictor.probability /= probability;
        }
        information.about_mechanism = about_mechanism(predictors, deviation, settings.threads);
        information.over_mechanisms = over_mechanisms(mechanisms, information.mechanisms);
        result.push_back(std::move(information));
    }
    return result;
}

}  // namespace delabole
