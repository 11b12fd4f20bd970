#include "fitting/work/run_table.hpp"
#include "tests/fitting/test_models.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace delabole {
namespace {

using test::answer;
using test::formula_model;

// y = x1 + x2 and z = not a number, counted; no answer for negative x1. The ground left standing rises by 1 in 2 with a
// corner in its middle that is a millionth of its length off.
ModelInterface counted_sum(int& calls) {
    return formula_model(2, {"y", "z"}, [&calls](std::span<const double> x) {
        ++calls;
        if (x[0] < 0) {
            return Prediction{"negative", {}, {}};
        }
        Prediction prediction = answer({x[0] + x[1], std::numeric_limits<double>::quiet_NaN()});
        prediction.profile = {{0, 0}, {10, 5 + 1e-5}, {20, 10}, {30, 10}};
        return prediction;
    });
}

RunTable table_of(const std::string& text) {
    int calls = 0;
    RunTable table(counted_sum(calls), "sum");
    table.read(text);
    return table;
}

std::string refusal_of(const std::string& text) {
    try {
        table_of(text);
        return {};
    } catch (const RunTableError& error) {
        return error.what();
    }
}

struct RunTableTest : testing::Test {
    int calls = 0;
    RunTable empty = RunTable(counted_sum(calls), "sum");
    TabledRuns first{empty, empty};
    std::string text;

    void SetUp() override {
        const ModelInterface model = tabled(counted_sum(calls), first);
        model.predict(std::vector<Assignment>{{1, 2.0 / 3}, {0, 1.0 / 3}});
        model.predict(std::vector<Assignment>{{0, -1.5}});
        model.predict(std::vector<Assignment>{{0, -1.5}});
        text = first.used.text();
    }
};

TEST_F(RunTableTest, IsATextForPeople) {
    const std::size_t end_of_model = text.find('\n');
    EXPECT_EQ(text.substr(0, 21), "# runs of model " + text.substr(16, 5));
    EXPECT_EQ(text.substr(end_of_model),
              "\nx1,x2,failure,y,profile\n-1.5,,negative,,\n0.333333333333,0.666666666667,,1,0 0 20 10 30 10\n");
}

TEST_F(RunTableTest, SavesEveryRunThatItHolds) {
    TabledRuns second{table_of(text), empty};
    const ModelInterface model = tabled(counted_sum(calls), second);
    calls = 0;
    // The written numbers are a third of a unit of the 12th digit off.
    const Prediction found = model.predict(std::vector<Assignment>{{0, 1.0 / 3}, {1, 2.0 / 3}});
    EXPECT_EQ(model.predict(std::vector<Assignment>{{0, -1.5}}).failure, "negative");
    EXPECT_EQ(calls, 0);
    EXPECT_EQ(second.found, 2);
    ASSERT_EQ(found.outputs.size(), 2U);
    EXPECT_EQ(found.outputs[0], 1);
    EXPECT_TRUE(std::isnan(found.outputs[1]));
    EXPECT_EQ(found.profile, Polyline({{0, 0}, {20, 10}, {30, 10}}));
    EXPECT_EQ(second.used.text(), text) << "what was used makes the same table again";
}

TEST_F(RunTableTest, OtherValuesAreComputed) {
    TabledRuns second{table_of(text), empty};
    const ModelInterface model = tabled(counted_sum(calls), second);
    calls = 0;
    model.predict(std::vector<Assignment>{{0, 1.0 / 3 + 1e-8}, {1, 2.0 / 3}});
    model.predict(std::vector<Assignment>{{0, 1.0 / 3}});
    model.predict(std::vector<Assignment>{{1, -1.5}});
    EXPECT_EQ(calls, 3);
    EXPECT_EQ(second.found, 0);
}

TEST_F(RunTableTest, SaysWhatIsWrongWithATextAndWhere) {
    int other_calls = 0;
    const std::string model = RunTable(counted_sum(other_calls), "sum").text().substr(0, 33);
    EXPECT_TRUE(
        refusal_of("# runs of model 0000000000000000\nx1,failure,profile\n").starts_with("line 1: the table was"));
    EXPECT_EQ(refusal_of(model), "line 2: the columns must be inputs, 'failure', outputs and 'profile'");
    EXPECT_EQ(refusal_of(model + "x1,y,profile\n"),
              "line 2: the columns must be inputs, 'failure', outputs and 'profile'");
    EXPECT_EQ(refusal_of(model + "x3,failure,profile\n"), "line 2: 'x3' is no input of the model");
    EXPECT_EQ(refusal_of(model + "failure,x1,profile\n"), "line 2: 'x1' is no output of the model");
    EXPECT_EQ(refusal_of(model + "x1,failure,profile\n1,,\n1,\n"), "line 4: 2 cells instead of 3");
    EXPECT_EQ(refusal_of(model + "x1,failure,profile\none,,\n"), "line 3: 'one' is no number");
    EXPECT_EQ(refusal_of(model + "x1,failure,profile\nnan,,\n"), "line 3: 'nan' is no number");
    EXPECT_EQ(refusal_of(model + "x1,failure,profile\n1,,0 0 1\n"),
              "line 3: the profile has an odd number of coordinates");
}

}  // namespace
}  // namespace delabole
