#include "cases/program/case/case_file.hpp"
#include "cases/program/case/case_writer.hpp"

#include "tests/cases/example_case.hpp"

#include <gtest/gtest.h>

namespace delabole {
namespace {

using testing::changed;
using testing::complaint;
using testing::example_text;

const std::string study_text = std::string(example_text) + R"(
[sensitivity]
quantity = "factor_of_safety"
seed = 7
[sensitivity.failure]
limit = 1
failing_words = ["crack_below_plane"]
[[sensitivity.parameter]]
name = "strength.cohesion"
distribution = "lognormal"
mean = "200 kPa"
standard_deviation = "60 kPa"
upper = "0.5 MPa"
[[sensitivity.parameter]]
name = "strength.friction_angle"
distribution = "beta"
mean = "30 deg"
standard_deviation = "3 deg"
lower = "20 deg"
upper = "40 deg"
source = "laboratory"
[[sensitivity.parameter]]
name = "water.water_depth"
distribution = "triangular"
lower = "0 m"
mode = "10 m"
upper = "40 m"
[[sensitivity.correlation]]
between = ["strength.cohesion", "strength.friction_angle"]
coefficient = -0.4
measure = "rank"
[sensitivity.tornado]
lower_probability = 0.1
[sensitivity.sweep]
points = 7
scatter = 0.02
[[sensitivity.sweep.quantity]]
name = "section_area"
scatter = "3 m2"
[[sensitivity.sweep.quantity]]
name = "weight"
[sensitivity.morris]
levels = 6
[sensitivity.propagation]
method = "sobol_sequence"
samples = 1000
[sensitivity.reliability]
step = 0.01
)";

TEST(SensitivityReader, ReadsValuesInTheirUnits) {
    const CaseFile file = parse_case(study_text, "slope.toml");
    ASSERT_TRUE(file.sensitivity);
    const SensitivityStudy& study = *file.sensitivity;
    EXPECT_EQ(study.quantity, "factor_of_safety");
    EXPECT_EQ(study.seed, 7U);
    EXPECT_EQ(study.failure->limit, 1);
    EXPECT_EQ(study.failure->side, FailureSide::below);
    EXPECT_EQ(study.failure->failing_words, std::vector<std::string>{"crack_below_plane"});
    ASSERT_EQ(study.parameters.size(), 3U);
    EXPECT_EQ(std::get<Lognormal>(study.parameters[0].distribution.law).standard_deviation, 60e3);
    EXPECT_EQ(study.parameters[0].distribution.upper, 0.5e6);
    EXPECT_FALSE(study.parameters[0].distribution.lower);
    EXPECT_EQ(std::get<Beta>(study.parameters[1].distribution.law).upper, degrees(40));
    EXPECT_FALSE(study.parameters[1].distribution.upper);  // its own limit, no truncation
    EXPECT_EQ(std::get<Triangular>(study.parameters[2].distribution.law).mode, 10);
    EXPECT_EQ(study.correlations.front().measure, CorrelationMeasure::rank);
    EXPECT_EQ(study.tornado->lower_probability, 0.1);
    EXPECT_EQ(study.tornado->upper_probability, TornadoSettings{}.upper_probability);
    EXPECT_EQ(study.sweep->points, 7);
    EXPECT_EQ(study.sweep->samples, 0);
    EXPECT_EQ(study.sweep->scatter, 0.02);
    ASSERT_EQ(study.sweep->further.size(), 2U);
    EXPECT_EQ(study.sweep->further[0].name, "section_area");
    EXPECT_EQ(study.sweep->further[0].scatter, 3);
    EXPECT_EQ(study.sweep->further[1].scatter, 0);
    EXPECT_EQ(study.morris->levels, 6);
    EXPECT_FALSE(study.sobol_indices);
    EXPECT_EQ(study.propagation->method, SamplingMethod::sobol_sequence);
    EXPECT_EQ(study.propagation->samples, 1000);
    EXPECT_EQ(study.reliability->step, 0.01);
}

TEST(SensitivityReader, ResolvedCaseReadsBackTheSame) {
    const std::string once = resolved_toml(parse_case(study_text, "slope.toml"));
    EXPECT_EQ(resolved_toml(parse_case(once, "again.toml")), once);
    EXPECT_NE(once.find("[sensitivity.reliability]"), std::string::npos);
}

TEST(SensitivityReader, InputsThatMoveTogetherHaveOneDimension) {
    const auto with = [](const std::string& others) {
        return changed(study_text, "source = \"laboratory\"", "also = " + others);
    };
    const CaseFile file = parse_case(with("[\"slope.face_dip\"]"), "slope.toml");
    EXPECT_EQ(file.sensitivity->parameters[1].also, std::vector<std::string>{"slope.face_dip"});
    EXPECT_NE(resolved_toml(file).find("also = [\"slope.face_dip\"]"), std::string::npos);
    EXPECT_NE(complaint(with("[\"slope.height\"]")).find("has another dimension"), std::string::npos);
    EXPECT_NE(complaint(with("[\"slope.fase_dip\"]")).find("did you mean slope.face_dip?"), std::string::npos);
}

TEST(SensitivityReader, AngleOfALimitHasTheUnitOfItsQuantity) {
    const std::string text = changed(study_text, "quantity = \"factor_of_safety\"", "quantity = \"plane_dip\"");
    EXPECT_NE(complaint(text).find("sensitivity.failure.limit = 1"), std::string::npos);
    const CaseFile file =
        parse_case(changed(changed(text, "limit = 1", "limit = \"30 deg\""), "scatter = 0.02", "scatter = \"1 deg\""),
                   "slope.toml");
    EXPECT_EQ(file.sensitivity->failure->limit, degrees(30));
    EXPECT_EQ(file.sensitivity->sweep->scatter, degrees(1));
}

TEST(SensitivityReader, MistakesAreNamedAtTheirPlace) {
    struct Mistake {
        std::string from;
        std::string to;
        std::string message;
    };
    for (const Mistake& mistake : {
             Mistake{"\"factor_of_safety\"", "\"factor_of_safty\"",
                     "slope.toml:31:12: sensitivity.quantity = \"factor_of_safty\": is not a number that this model "
                     "answers (did you mean factor_of_safety?)"},
             Mistake{"\"strength.cohesion\"\ndistribution", "\"strength.cohesoin\"\ndistribution",
                     "slope.toml:37:8: sensitivity.parameter[1].name = \"strength.cohesoin\": is not an input of this "
                     "case (did you mean strength.cohesion?)"},
             Mistake{"\"lognormal\"", "\"log-normal\"", "(did you mean lognormal?)"},
             Mistake{"\"60 kPa\"", "\"0 kPa\"",
                     "slope.toml:40:22: sensitivity.parameter[1].standard_deviation = \"0 kPa\": must be more than 0 "
                     "kPa"},
             Mistake{"\"60 kPa\"", "60", "sensitivity.parameter[1].standard_deviation = 60"},
             Mistake{"mode = \"10 m\"", "node = \"10 m\"", "sensitivity.parameter[3].mode: is required"},
             Mistake{"\"strength.friction_angle\"]", "\"rock.unit_weight\"]", "is not among the uncertain parameters"},
             Mistake{"coefficient = -0.4", "coefficient = -1",
                     "sensitivity.correlation[1].coefficient = -1: must be between -1 and 1 (ends excluded)"},
             Mistake{"\"rank\"", "\"kendall\"", "must be linear or rank"},
             Mistake{"points = 7", "points = 20", "must be a whole number from 3 to 19"},
             Mistake{"\"section_area\"", "\"section_aera\"", "(did you mean section_area?)"},
             Mistake{"\"3 m2\"", "\"3 m\"", "sensitivity.sweep.quantity[1].scatter"},
             Mistake{"levels = 6", "levels = 1", "must be a whole number from 2"},
             Mistake{"samples = 1000", "samples = 1e9", "sensitivity.propagation.samples"},
             Mistake{"lower_probability = 0.1", "lower_probability = 0.9", "sensitivity.tornado.lower_probability"},
         }) {
        EXPECT_NE(complaint(changed(study_text, mistake.from, mistake.to)).find(mistake.message), std::string::npos)
            << mistake.to << ":\n"
            << complaint(changed(study_text, mistake.from, mistake.to));
    }
    const std::string nothing = std::string(example_text) + "[sensitivity]\nquantity = \"factor_of_safety\"\n";
    EXPECT_NE(complaint(nothing).find("[[sensitivity.parameter]] is required"), std::string::npos);
}

}  // namespace
}  // namespace delabole
