#include "fitting/studies/conclusions.hpp"

#include "fitting/mechanism/costly_runs.hpp"
#include "fitting/mechanism/input_binding.hpp"
#include "fitting/probability/estimate.hpp"
#include "fitting/search/share.hpp"
#include "fitting/studies/comparison.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace delabole {

namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
constexpr double nearly_all = 0.95;

bool holds(double value, const ConclusionTest& test) {
    return test.relation == Relation::at_least ? value >= test.limit : value <= test.limit;
}

// The difference, or 0 if the two differ only by rounding.
double difference(double value, double less) {
    const double rounding = 64 * std::numeric_limits<double>::epsilon() * std::max(std::abs(value), std::abs(less));
    return std::abs(value - less) <= rounding ? 0 : value - less;
}

// Judges by the mechanisms that were fitted. The verdict is not_tested if none of those claimed was sampled.
TestFinding judge(const ConclusionTest& test, const ClaimOfMechanisms& claim, const FitResult& result) {
    const std::vector<MechanismWeight> weights = weigh(result);
    TestFinding finding;
    bool any = false;
    for (std::size_t index = 0; index < weights.size(); ++index) {
        const MechanismFit& fit = result.mechanisms[index];
        if (fit.posterior && std::ranges::find(claim.mechanisms, fit.name) != claim.mechanisms.end()) {
            any = true;
            finding.value += weights[index].probability;
            // The errors are added as if all had one sign, which overstates the sum.
            finding.standard_error += weights[index].standard_error;
        }
    }
    if (!any) {
        finding.value = nothing;
        return finding;
    }
    const double error = 2 * finding.standard_error;
    // The opposite is as probable as the claim if the other mechanisms together reach this limit.
    const double opposite = 1 - test.limit;
    if (test.relation == Relation::at_least) {
        finding.verdict = finding.value - error >= test.limit                      ? ConclusionVerdict::confirmed
                          : finding.value + error < std::min(test.limit, opposite) ? ConclusionVerdict::contradicted
                                                                                   : ConclusionVerdict::undecided;
    } else {
        finding.verdict = finding.value + error <= test.limit                      ? ConclusionVerdict::confirmed
                          : finding.value - error > std::max(test.limit, opposite) ? ConclusionVerdict::contradicted
                                                                                   : ConclusionVerdict::undecided;
    }
    return finding;
}

std::vector<std::vector<double>> points_of(const FitProblem& problem, const Mechanism& mechanism,
                                           const MechanismFit& fit) {
    const std::size_t most_draws = mechanism.model.costly
                                       ? static_cast<std::size_t>(problem.settings.surrogate.runs_of_claim)
                                       : most_draws_of_claim;
    std::vector<std::vector<double>> points;
    if (fit.posterior) {
        for (const Draw& draw : thinned(fit.posterior->posterior.draws, most_draws)) {
            points.push_back(draw.parameters);
        }
    }
    if (points.empty() && !fit.best.empty()) {
        points.push_back(fit.best);
    }
    return points;
}

void describe(std::vector<double> values, TestFinding& finding) {
    constexpr std::size_t few = 20;
    std::ranges::sort(values);
    finding.value = sorted_quantile(values, 0.5);
    const bool all = values.size() < few;
    constexpr double tail = (1 - probability_68) / 2;
    finding.interval_68 = within(all ? values.front() : sorted_quantile(values, tail),
                                 all ? values.back() : sorted_quantile(values, 1 - tail));
}

// Probability that a value of the one exceeds one of the other, which are sorted; equal ones count half.
double share_greater(const std::vector<double>& one, const std::vector<double>& other) {
    double pairs = 0;
    for (const double value : one) {
        const auto [first, last] = std::equal_range(other.begin(), other.end(), value);
        pairs += static_cast<double>((first - other.begin()) + (last - other.begin())) / 2;
    }
    return pairs / static_cast<double>(one.size() * other.size());
}

std::optional<Decider> decider_of(const ConclusionTest& test, const std::vector<std::vector<double>>& points,
                                  const std::vector<double>& values, const MechanismFit& fit) {
    constexpr double chance = 4;  // standard errors of the share; more than usual, because draws depend on each other
    std::optional<Decider> most;
    double greatest = 0;
    for (std::size_t index = 0; index < fit.parameters.size(); ++index) {
        std::vector<double> holding;
        std::vector<double> failing;
        for (std::size_t draw = 0; draw < values.size(); ++draw) {
            if (!std::isnan(values[draw])) {
                (holds(values[draw], test) ? holding : failing).push_back(points[draw][index]);
            }
        }
        if (holding.empty() || failing.empty()) {
            return {};
        }
        std::ranges::sort(holding);
        std::ranges::sort(failing);
        const double apart = std::abs(share_greater(holding, failing) - 0.5);
        const auto one = static_cast<double>(holding.size());
        const auto other = static_cast<double>(failing.size());
        // The standard error of Mann and Whitney.
        if (apart > std::max(greatest, chance * std::sqrt((one + other + 1) / (12 * one * other)))) {
            greatest = apart;
            most = Decider{fit.parameters[index].name, fit.dimensions[index], sorted_quantile(holding, 0.5),
                           sorted_quantile(failing, 0.5)};
        }
    }
    return most;
}

class QuantityJudge {
  public:
    QuantityJudge(const FitProblem& problem, const FitResult& result, ProgressMeter& progress, StopFlag stop)
        : problem_(problem), result_(result), weights_(weigh(result)), progress_(progress), stop_(stop) {}

    TestFinding operator()(const ConclusionTest& test, const ClaimOfQuantity& claim) const {
        TestFinding finding;
        finding.value = nothing;
        const auto fit = std::ranges::find(result_.mechanisms, claim.mechanism, &MechanismFit::name);
        const auto mechanism = std::ranges::find(problem_.mechanisms, claim.mechanism, &Mechanism::name);
        if (fit == result_.mechanisms.end() || stop_requested(stop_)) {
            return finding;
        }
        const std::span<const std::string> name(&claim.quantity, 1);
        const auto quantity = QuantityOfMechanism::of(*mechanism, name, claim.conditions);
        const auto other = claim.against ? QuantityOfMechanism::of(*mechanism, name, *claim.against) : std::nullopt;
        if (!quantity || (claim.against && !other)) {
            return finding;
        }
        const auto points = points_of(problem_, *mechanism, *fit);
        std::vector<double> values = values_of(*quantity, points, mechanism->model.costly);
        if (other) {
            const std::vector<double> less = values_of(*other, points, mechanism->model.costly);
            std::ranges::transform(values, less, values.begin(), difference);
        }
        if (stop_requested(stop_)) {
            return finding;
        }
        count(test, values, finding);
        if (finding.verdict == ConclusionVerdict::undecided) {
            finding.decider = decider_of(test, points, values, *fit);
        }
        const MechanismWeight& weight = weights_[static_cast<std::size_t>(fit - result_.mechanisms.begin())];
        if (fit->posterior && weight.probability + 2 * weight.standard_error < least_probability) {
            finding.improbable = weight.probability;
            finding.verdict = ConclusionVerdict::undecided;
        }
        return finding;
    }

  private:
    std::vector<double> values_of(const QuantityOfMechanism& quantity, const std::vector<std::vector<double>>& points,
                                  bool costly) const {
        const Workers workers{problem_.settings.threads, problem_.settings.ranks};
        return share_tasks<double>(points.size(), workers, [&](std::size_t number) {
            const double value = stop_requested(stop_) ? nothing : quantity.at(points[number]);
            progress_.count(1, costly ? weight_of_run : 1);
            return value;
        });
    }

    static void count(const ConclusionTest& test, std::vector<double> values, TestFinding& finding) {
        finding.draws = static_cast<int>(values.size());
        std::erase_if(values, [](double value) { return std::isnan(value); });
        finding.without_answer = finding.draws - static_cast<int>(values.size());
        if (values.empty()) {
            finding.verdict = finding.draws > 0 ? ConclusionVerdict::undecided : ConclusionVerdict::not_tested;
            return;
        }
        finding.holding =
            static_cast<int>(std::ranges::count_if(values, [&](double value) { return holds(value, test); }));
        const double share = static_cast<double>(finding.holding) / static_cast<double>(values.size());
        finding.verdict = share >= nearly_all       ? ConclusionVerdict::confirmed
                          : share <= 1 - nearly_all ? ConclusionVerdict::contradicted
                                                    : ConclusionVerdict::undecided;
        describe(std::move(values), finding);
    }

    const FitProblem& problem_;
    const FitResult& result_;
    std::vector<MechanismWeight> weights_;
    ProgressMeter& progress_;
    StopFlag stop_;
};

}  // namespace

ConclusionVerdict verdict_of(const std::vector<TestFinding>& tests) {
    const auto count = [&](ConclusionVerdict verdict) {
        return static_cast<std::size_t>(std::ranges::count(tests, verdict, &TestFinding::verdict));
    };
    const std::size_t confirmed = count(ConclusionVerdict::confirmed);
    const std::size_t contradicted = count(ConclusionVerdict::contradicted);
    if (count(ConclusionVerdict::not_tested) == tests.size()) {
        return ConclusionVerdict::not_tested;
    }
    if (confirmed > 0 && contradicted > 0) {
        return ConclusionVerdict::partly;
    }
    return confirmed == tests.size()      ? ConclusionVerdict::confirmed
           : contradicted == tests.size() ? ConclusionVerdict::contradicted
                                          : ConclusionVerdict::undecided;
}

std::vector<ConclusionFinding> judge_conclusions(const FitProblem& problem, const FitResult& result,
                                                 const FitProgressCallback& progress, StopFlag stop) {
    long expected = 1;
    for (const Conclusion& conclusion : problem.conclusions) {
        for (const ConclusionTest& test : conclusion.tests) {
            if (const auto* claim = std::get_if<ClaimOfQuantity>(&test.of)) {
                const auto fit = std::ranges::find(result.mechanisms, claim->mechanism, &MechanismFit::name);
                const auto mechanism = std::ranges::find(problem.mechanisms, claim->mechanism, &Mechanism::name);
                if (fit != result.mechanisms.end()) {
                    expected += static_cast<long>(points_of(problem, *mechanism, *fit).size()) *
                                (claim->against ? 2 : 1) * (mechanism->model.costly ? weight_of_run : 1);
                }
            }
        }
    }
    ProgressMeter meter(progress, expected);
    meter.begin_stage("all mechanisms", "conclusions", expected);
    const QuantityJudge judge_quantity(problem, result, meter, stop);
    std::vector<ConclusionFinding> findings;
    for (const Conclusion& conclusion : problem.conclusions) {
        ConclusionFinding& finding = findings.emplace_back();
        for (const ConclusionTest& test : conclusion.tests) {
            if (const auto* claim = std::get_if<ClaimOfMechanisms>(&test.of)) {
                finding.tests.push_back(judge(test, *claim, result));
            } else {
                finding.tests.push_back(judge_quantity(test, std::get<ClaimOfQuantity>(test.of)));
            }
        }
        finding.verdict = verdict_of(finding.tests);
    }
    meter.finish();
    return findings;
}

}  // namespace delabole
