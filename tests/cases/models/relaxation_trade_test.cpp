#include "cases/program/case/case_file.hpp"
#include "cases/program/models/relaxation/trade.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace delabole {
namespace {

CaseFile single_block(const std::vector<Setting>& settings = {}) {
    return read_case(std::string(DELABOLE_CASES) + "/relaxation/single_block.toml", settings);
}

RelaxationStudy study_of(const CaseFile& file) {
    return std::get<RelaxationStudy>(file.model);
}

double value_of(const std::vector<TradeParameter>& parameters, const TradeSetting& setting, const std::string& name) {
    for (std::size_t index = 0; index < parameters.size(); ++index) {
        if (parameters[index].name == name) {
            return setting.values[index];
        }
    }
    throw std::invalid_argument(name);
}

const auto go_on = [](double) { return true; };
const std::atomic<bool> never = false;

TEST(RelaxationTrade, OwnSettingIsTheCaseItself) {
    const RelaxationStudy study = study_of(single_block());
    const TradeProblem problem = trade_problem(study, {}, 1);
    const TradeAnswer answer = problem.answer(problem.settings.front().values, go_on);
    const CriticalValue own = find_critical(study);
    EXPECT_EQ(answer.failure, "");
    EXPECT_EQ(answer.stands, own.stands);
    EXPECT_EQ(answer.fails, own.fails);
    EXPECT_EQ(answer.steps, static_cast<double>(own.steps));
    EXPECT_EQ(answer.cost, static_cast<double>(own.contacts_evaluated));
    EXPECT_GT(answer.cost, answer.steps);  // at least one contact in each step
}

TEST(RelaxationTrade, EverySettingIsOneThatACaseMaySay) {
    const RelaxationStudy study = study_of(single_block());
    const TradeProblem problem = trade_problem(study, {}, 1);
    EXPECT_GE(problem.settings.size(), 30U);
    EXPECT_LE(problem.settings.size(), 65U);
    for (const TradeSetting& setting : problem.settings) {
        const RelaxationStudy changed = with_parameters(study, problem.parameters, setting.values);
        EXPECT_TRUE(in_range(*changed.settings)) << change_in_words(problem.parameters, setting);
        EXPECT_EQ(changed.settings->start == RelaxationStart::ramped, changed.settings->ramp_time > 0.0);
        EXPECT_GT(problem.expected_cost(setting.values), 0);
        const RelaxationSettings settings = relaxation_settings(changed);
        EXPECT_EQ(settings.step_fraction, value_of(problem.parameters, setting, "step_fraction"));
        EXPECT_EQ(settings.onset_rotation, value_of(problem.parameters, setting, "onset_threshold"));
        // The case's own thresholds are both 0.01.
        EXPECT_NEAR(settings.onset_slide, settings.onset_rotation, 1e-16);
        EXPECT_LT(settings.onset_rotation, settings.collapse_rotation);
        EXPECT_EQ(stiffness_ratio_of(changed), value_of(problem.parameters, setting, "stiffness_ratio"));
    }
}

// The law of a preloaded block, tan(tilt) = b/a - W/(k b) sqrt(1 + (b/a)^2), at each stiffness of the sweep.
TEST(RelaxationTrade, SingleBlockFollowsItsLawOverTheStiffness) {
    CaseFile file = single_block({parse_setting("critical.tolerance=0.0005 deg")});
    const RelaxationStudy study = study_of(file);
    TradeProblem problem = trade_problem(study, std::atan(1.0 / 3), 1);
    std::erase_if(problem.settings, [](const TradeSetting& setting) { return setting.group != "stiffness_ratio"; });
    ASSERT_GE(problem.settings.size(), 4U);
    problem.finest = 0;
    const TradeResult result = trade(problem, {}, never);
    ASSERT_EQ(result.status, TradeStatus::finished);
    for (const TradeRow& row : result.rows) {
        const double ratio = value_of(problem.parameters, row.setting, "stiffness_ratio");
        const double law = std::atan(1.0 / 3 - std::sqrt(1 + 1.0 / 9) / ratio);
        ASSERT_TRUE(row.error);
        // The search errs by half its bracket, and by a tenth of the shift since the block moves before it is judged.
        const double tolerance = degrees(0.00025) + 0.1 * (std::atan(1.0 / 3) - law);
        EXPECT_NEAR(std::atan(1.0 / 3) + *row.error, law, tolerance) << "at " << ratio;
    }
    EXPECT_FALSE(front_of(result).empty());
}

TEST(RelaxationTrade, StiffnessOfJointsThatGiveTheirOwnIsLeftAlone) {
    const RelaxationStudy study = study_of(single_block({parse_setting("scene.base.normal_stiffness=1e10 N/m/m")}));
    const TradeProblem problem = trade_problem(study, {}, 1);
    for (const TradeParameter& parameter : problem.parameters) {
        EXPECT_NE(parameter.name, "stiffness_ratio");
    }
    EXPECT_EQ(trade_remarks(study).size(), 1U);
    EXPECT_TRUE(trade_remarks(study_of(single_block())).empty());
    const TradeAnswer answer = problem.answer(problem.settings.front().values, go_on);
    EXPECT_EQ(answer.stands, find_critical(study).stands);
}

TEST(RelaxationTrade, SearchThatIsToldToStopHasNoAnswer) {
    const TradeProblem problem = trade_problem(study_of(single_block()), {}, 1);
    EXPECT_EQ(problem.answer(problem.settings.front().values, [](double) { return false; }).failure, "interrupted");
}

}  // namespace
}  // namespace delabole
