#include "fitting/studies/trade.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace delabole {
namespace {

constexpr double truth = 18.4;

const std::vector<TradeParameter> parameters = {{"stiffness", {1e3, 1e4, 1e5}, 1e4, {}},
                                                {"step", {0.1, 0.2, 0.4}, 0.4, {}},
                                                {"start", {0, 1}, 0, {"preloaded", "dropped"}}};

// Compliance shifts the answer, a dropped start shifts it more at half the cost, small steps cost and gain nothing; a
// soft dropped block has no answer.
TradeAnswer shifted_answer(std::span<const double> values, const TradeWatch& watch) {
    watch(0.5);
    const bool dropped = values[2] > 0;
    const double middle = truth - (dropped ? 30 : 10) / values[0];
    TradeAnswer answer{{}, middle - 1e-4, middle + 1e-4, std::sqrt(values[0]) / values[1] / (dropped ? 2 : 1)};
    if (dropped && values[0] < 5e3) {
        answer.failure = "undecided";
    }
    return answer;
}

TradeProblem problem_of(const std::vector<TradeSetting>& settings) {
    TradeProblem problem;
    problem.parameters = parameters;
    problem.settings = settings;
    problem.truth = truth;
    problem.answer = shifted_answer;
    problem.expected_cost = [](std::span<const double> values) { return std::sqrt(values[0]) / values[1]; };
    return problem;
}

std::vector<TradeSetting> levels_alone() {
    std::vector<TradeSetting> settings = {own_setting(parameters)};
    add_levels(settings, parameters);
    return settings;
}

// Every combination of the levels.
std::vector<TradeSetting> full_grid() {
    std::vector<TradeSetting> settings;
    for (const double stiffness : parameters[0].levels) {
        for (const double step : parameters[1].levels) {
            for (const double start : parameters[2].levels) {
                settings.push_back({"grid", {stiffness, step, start}});
            }
        }
    }
    return settings;
}

const std::atomic<bool> never = false;

TEST(Trade, DesignVariesOneParameterAtATimeAndRepeatsNothing) {
    const std::vector<TradeSetting> settings = levels_alone();
    ASSERT_EQ(settings.size(), 1 + 2 + 2 + 1);
    EXPECT_EQ(settings[0].group, own_group);
    EXPECT_EQ(settings[0].values, (std::vector<double>{1e4, 0.4, 0}));
    std::set<std::vector<double>> all;
    for (const TradeSetting& setting : settings) {
        EXPECT_TRUE(all.insert(setting.values).second);
        std::size_t changed = 0;
        for (std::size_t parameter = 0; parameter < parameters.size(); ++parameter) {
            const bool own = setting.values[parameter] == parameters[parameter].own;
            changed += own ? 0 : 1;
            EXPECT_TRUE(own || setting.group == parameters[parameter].name);
        }
        EXPECT_EQ(changed, setting.group == own_group ? 0 : 1);
    }
}

TEST(Trade, SettingThatIsThereIsFoundAgain) {
    std::vector<TradeSetting> settings = levels_alone();
    const std::size_t count = settings.size();
    EXPECT_EQ(add_setting(settings, parameters, "corner", {{"stiffness", 1e4}, {"no such parameter", 7}}), 0);
    EXPECT_EQ(settings.size(), count);
    EXPECT_EQ(add_setting(settings, parameters, "corner", {{"stiffness", 1e5}, {"step", 0.1}}), count);
    EXPECT_EQ(settings.back().values, (std::vector<double>{1e5, 0.1, 0}));
}

TEST(Trade, FrontIsWhatNothingBeats) {
    const TradeResult result = trade(problem_of(full_grid()), {}, never);
    EXPECT_EQ(result.status, TradeStatus::finished);
    ASSERT_EQ(result.rows.size(), full_grid().size());
    for (const TradeRow& row : result.rows) {
        if (!row.answer.failure.empty()) {
            EXPECT_FALSE(row.error);
            EXPECT_FALSE(row.on_front);
            continue;
        }
        const bool beaten = std::any_of(result.rows.begin(), result.rows.end(), [&](const TradeRow& other) {
            return other.error && other.answer.cost <= row.answer.cost && other.error_bound <= row.error_bound &&
                   (other.answer.cost < row.answer.cost || other.error_bound < row.error_bound);
        });
        EXPECT_EQ(row.on_front, !beaten);
    }
    const std::vector<std::size_t> front = front_of(result);
    ASSERT_GE(front.size(), 3);
    for (std::size_t index = 1; index < front.size(); ++index) {
        EXPECT_LT(result.rows[front[index - 1]].answer.cost, result.rows[front[index]].answer.cost);
        EXPECT_GT(result.rows[front[index - 1]].error_bound, result.rows[front[index]].error_bound);
    }
}

TEST(Trade, ErrorBoundReachesToTheFarEndOfTheBracket) {
    const TradeResult result = trade(problem_of(levels_alone()), {}, never);
    const TradeRow& own = result.rows.front();
    // The middle is 10 / 1e4 below the truth, the bracket reaches 1e-4 farther; 18.4 is held to 4e-15.
    EXPECT_NEAR(own.error.value_or(0), -1e-3, 1e-14);
    EXPECT_NEAR(own.error_bound, 1.1e-3, 1e-14);
}

TEST(Trade, WithoutATruthTheFinestSettingIsTheYardstickAndNotJudged) {
    TradeProblem problem = problem_of(levels_alone());
    problem.truth.reset();
    problem.finest = add_setting(problem.settings, parameters, "corner", {{"stiffness", 1e5}, {"step", 0.1}});
    const TradeResult result = trade(problem, {}, never);
    ASSERT_TRUE(result.truth);
    EXPECT_NEAR(*result.truth, truth - 1e-4, 1e-14);
    EXPECT_FALSE(result.rows[problem.finest].error);
    EXPECT_FALSE(result.rows[problem.finest].on_front);
    EXPECT_NEAR(result.rows.front().error.value_or(0), -9e-4, 1e-14);

    problem.answer = [](std::span<const double>, const TradeWatch&) { return TradeAnswer{"undecided"}; };
    const TradeResult none = trade(problem, {}, never);
    EXPECT_EQ(none.status, TradeStatus::nothing_to_compare);
    EXPECT_FALSE(none.truth);
    EXPECT_EQ(none.rows.size(), problem.settings.size());
}

TEST(Trade, ThreadsChangeNothing) {
    TradeProblem problem = problem_of(full_grid());
    const TradeResult one = trade(problem, {}, never);
    problem.threads = 3;
    const TradeResult three = trade(problem, {}, never);
    ASSERT_EQ(one.rows.size(), three.rows.size());
    for (std::size_t row = 0; row < one.rows.size(); ++row) {
        EXPECT_EQ(one.rows[row].setting.values, three.rows[row].setting.values);
        EXPECT_EQ(one.rows[row].error, three.rows[row].error);
        EXPECT_EQ(one.rows[row].on_front, three.rows[row].on_front);
    }
}

TEST(Trade, InterruptKeepsWhatIsFinished) {
    std::atomic<bool> interrupted = false;
    TradeProblem problem = problem_of(levels_alone());
    int begun = 0;
    problem.answer = [&](std::span<const double> values, const TradeWatch& watch) {
        interrupted = ++begun == 3;
        return watch(0.5) ? shifted_answer(values, watch) : TradeAnswer{"interrupted"};
    };
    const TradeResult result = trade(problem, {}, interrupted);
    EXPECT_EQ(result.status, TradeStatus::interrupted);
    EXPECT_EQ(begun, 3);
    EXPECT_EQ(result.rows.size(), 2);
}

TEST(Trade, ProgressNeverFallsAndEndsWithEverything) {
    const TradeProblem problem = problem_of(levels_alone());
    double last = 0;
    std::size_t last_finished = 0;
    trade(
        problem,
        [&](double share, std::size_t finished) {
            EXPECT_GE(share, last);
            last = share;
            last_finished = finished;
        },
        never);
    EXPECT_NEAR(last, 1, 1e-12);  // a sum of rounded shares
    EXPECT_EQ(last_finished, problem.settings.size());
}

TEST(Trade, BestOfEachDecadeIsTheMostAccurate) {
    const TradeResult result = trade(problem_of(full_grid()), {}, never);
    const std::vector<std::size_t> best = best_of_each_decade(result);
    std::set<double> decades;
    for (const std::size_t index : best) {
        const double decade = std::floor(std::log10(result.rows[index].answer.cost));
        EXPECT_TRUE(decades.insert(decade).second);
        for (const TradeRow& row : result.rows) {
            if (row.error && std::floor(std::log10(row.answer.cost)) == decade) {
                EXPECT_GE(row.error_bound, result.rows[index].error_bound);
            }
        }
    }
    // Costs go from sqrt(1e3) / 0.4 to sqrt(1e5) / 0.1.
    EXPECT_EQ(decades, (std::set<double>{1, 2, 3}));
}

TEST(Trade, ChangesAreNamedInWords) {
    EXPECT_EQ(change_in_words(parameters, {"own", {1e4, 0.4, 0}}), "");
    EXPECT_EQ(change_in_words(parameters, {"corner", {3e7, 0.4, 1}}), "stiffness 3e7, start dropped");
    EXPECT_EQ(level_in_words(parameters[1], 1e-5), "1e-5");
    EXPECT_EQ(level_in_words(parameters[1], 0.05), "0.05");
}

}  // namespace
}  // namespace delabole
