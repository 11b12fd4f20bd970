// One convention for all models: every quantity of a model keeps its name whether or not it has a value, and no length
// beyond what the models are sound for is read.
#include "cases/program/case/starting_cases.hpp"
#include "cases/program/results/analysis.hpp"
#include "cases/program/results/model_reports.hpp"
#include "cases/program/results/result_folder.hpp"
#include "limit_equilibrium/block_row/block_row.hpp"
#include "parameters/lengths.hpp"

#include "tests/cases/example_case.hpp"

#include <gtest/gtest.h>

#include <random>
#include <set>
#include <string>
#include <vector>

namespace delabole {
namespace {

std::set<std::string> keys_of(const CaseModel& model) {
    const Analysis analysis = analyse_model(model);
    EXPECT_EQ(analysis.failure, "");
    std::set<std::string> keys;
    for (const NamedOutput& output : analysis.outputs) {
        keys.insert(output.name);
        // A missing number is reported by a word, and no text is empty.
        if (const auto* text = std::get_if<std::string>(&output.value)) {
            EXPECT_FALSE(text->empty()) << output.name;
        }
    }
    // JSON holds the same keys, with units.
    EXPECT_EQ(json_of(analysis.outputs).size(), analysis.outputs.size());
    return keys;
}

std::string word(const CaseModel& model, const std::string& name) {
    const Analysis analysis = analyse_model(model);
    const NamedOutput* output = analysis.find(name);
    if (output == nullptr) {
        return "no such key";
    }
    const auto* text = std::get_if<std::string>(&output->value);
    return text != nullptr ? *text : json_number(std::get<double>(output->value)).dump();
}

template <class Model>
Model example() {
    return std::get<Model>(parse_case(template_case(Model::kind), "template").model);
}

// A check that no sentence explains would be reported as a number out of its range.
template <class Check, class Model>
void expect_words_for_checks() {
    const std::string out_of_range = stated_impossibility(Model::kind, "input_out_of_range").words;
    for (const std::string_view check : enum_names(Check{})) {
        const bool in_range = check == "valid" || check == "input_out_of_range";
        EXPECT_EQ(impossibility(example<Model>(), check).words == out_of_range, in_range)
            << Model::kind << ": " << check;
    }
}

TEST(Impossibility, EveryCheckSaysWhatIsWrong) {
    expect_words_for_checks<PlaneFailureCheck, PlaneFailureStudy<>>();
    expect_words_for_checks<WedgeFailureCheck, WedgeFailureStudy>();
    expect_words_for_checks<ColumnCheck, SteppedBaseStudy<>>();
    expect_words_for_checks<SteppedPathCheck, SteppedPath>();
    expect_words_for_checks<BlockRowCheck, BlockRow>();
    expect_words_for_checks<SingleBlockCheck, SingleBlock>();
    expect_words_for_checks<FlexuralCheck, FlexuralSlope>();
    expect_words_for_checks<KinematicsCheck, KinematicsStudy>();
}

TEST(ResultKeys, PlaneFailure) {
    auto study = example<PlaneFailureStudy<>>();
    study.critical.reset();
    study.required.clear();
    study.model.bolt = {{100e3, 0, 1, BoltAction::active}};
    PlaneFailureStudy<> held = study;
    held.model.bolt[0].force = 1e9;  // nothing drives the mass, at whatever plunge
    EXPECT_EQ(keys_of(study), keys_of(held));
    EXPECT_EQ(word(held, "factor_of_safety"), "\"infinite\"");
    EXPECT_TRUE(keys_of(study).contains("optimum_bolt_plunge"));
    study.required = {{"strength.friction_angle", 1e6, {}}};
    EXPECT_EQ(word(study, "required.strength.friction_angle"), "never_reached");
}

TEST(ResultKeys, SteppedBase) {
    auto study = example<SteppedBaseStudy<>>();
    study.critical.reset();
    study.required.clear();
    study.required_cable.clear();
    BlockColumns<> columns{degrees(70), {}};
    for (const double height : {2.0, 5.0, 3.0}) {
        columns.block.push_back({height, 1, 0, {}});
    }
    study.model.scene = ColumnScene<>{};
    study.model.scene.columns = columns;
    study.model.scene.rock = {25e3};
    study.model.scene.water = Dry{};
    study.linear_programming_bound = LinearProgrammingBound{1, {}};
    SteppedBaseStudy<> too_many = study;
    BlockColumns<> many = columns;
    many.block.assign(static_cast<std::size_t>(most_bound_columns) + 1, {2, 1, 0, {}});
    too_many.model.scene.columns = many;
    const auto of_the_slope = [](std::set<std::string> keys) {
        std::erase_if(keys, [](const std::string& key) { return key.starts_with("column["); });
        return keys;
    };
    EXPECT_EQ(of_the_slope(keys_of(study)), of_the_slope(keys_of(too_many)));
    EXPECT_EQ(word(too_many, "bound.factor_of_safety"), "none");
    EXPECT_EQ(word(study, "slide_head"), "none");
    std::get<BlockColumns<>>(study.model.scene.columns).block[1].width = 1e6;
    std::get<BlockColumns<>>(study.model.scene.columns).block[1].height = 1e6;
    EXPECT_EQ(word(study, "bound.status"), "invalid_assembly");
    EXPECT_EQ(word(study, "bound.check"), "weights_too_different");
    EXPECT_EQ(word(study, "bound.factor_of_safety"), "none");
}

TEST(ResultKeys, BlockRow) {
    BlockRow answered{};
    answered.base = {degrees(15), degrees(30)};
    answered.interface = {degrees(20)};
    answered.block.assign(3, {3, 1, UnitWeightOfBlock{26e3}, {}, {}});
    BlockRow locked = answered;  // phi + psi beyond 90 deg: most modes have no tilt
    locked.base.friction_angle = degrees(60);
    locked.interface.friction_angle = degrees(60);
    EXPECT_EQ(keys_of(answered), keys_of(locked));
    EXPECT_EQ(word(locked, "mode.SSP.critical_tilt"), "none");
    // Among rows of three unequal blocks one in fifty has no admissible mode.
    BlockRow without_mode = answered;
    std::mt19937_64 random(5);
    const auto between = [&](double lower, double upper) {
        return lower + (upper - lower) * static_cast<double>(random() >> 11) * 0x1p-53;
    };
    bool found = false;
    for (int trial = 0; trial < 2000 && !found; ++trial) {
        without_mode.base.friction_angle = degrees(between(10, 44));
        without_mode.interface.friction_angle = degrees(between(10, 44));
        for (RowBlock& block : without_mode.block) {
            block.width = between(1, 3);
            block.height = block.width * between(1, 10);
        }
        found = analyse(without_mode).answer.search == RowSearchKind::upper_bound;
    }
    ASSERT_TRUE(found);
    EXPECT_EQ(keys_of(answered), keys_of(without_mode));
    EXPECT_EQ(word(without_mode, "mode"), "none");
    EXPECT_EQ(word(without_mode, "block[2].thrust"), "none");
}

TEST(ResultKeys, SingleBlock) {
    auto problem = example<SingleBlock>();
    SingleBlock afloat = problem;
    afloat.block.unit_weight = 1e3;
    afloat.water = BlockWater{10e3, afloat.block.height, afloat.block.height};
    EXPECT_EQ(keys_of(problem), keys_of(afloat));
}

TEST(ResultKeys, Kinematics) {
    auto study = example<KinematicsStudy>();
    study.sampling = OrientationSampling{.sample_count = 10, .seed = 1};
    study.model.joint_set = {{"first", MeanOrientation{degrees(50), degrees(100), 100.0}},
                             {"second", MeanOrientation{degrees(60), degrees(170), 100.0}}};
    KinematicsStudy parallel = study;
    parallel.model.joint_set[1].orientation = parallel.model.joint_set[0].orientation;
    EXPECT_EQ(keys_of(study), keys_of(parallel));
    EXPECT_EQ(word(parallel, "pair[1].intersection.plunge"), "none");
    EXPECT_EQ(word(parallel, "pair[1].toppling_base"), "none");
}

TEST(ResultKeys, SteppedPath) {
    const auto path = example<SteppedPath>();
    SteppedPath held = path;
    held.search.mechanism = SteppedPathMechanism::sliding;
    held.steps.dip = degrees(-10);
    held.water = Dry{};
    EXPECT_EQ(keys_of(path), keys_of(held));
    EXPECT_EQ(word(held, "factor_of_safety"), "\"infinite\"");
    EXPECT_EQ(word(held, "failed_area"), "none");
}

TEST(ResultKeys, FlexuralToppling) {
    auto slope = example<FlexuralSlope>();
    FlexuralSlope flat = slope;
    flat.base_dip = degrees(1);
    EXPECT_EQ(keys_of(slope), keys_of(flat));
}

TEST(ResultKeys, TiltedColumn) {
    EXPECT_EQ(keys_of(TiltedColumn<>{degrees(70), degrees(47.5), 0.5}),
              keys_of(TiltedColumn<>{degrees(70), degrees(47.5), 0}));
}

TEST(ResultKeys, Wedge) {
    const auto study = example<WedgeFailureStudy>();
    WedgeFailureStudy lifted = study;
    lifted.model.water = MeanPressures{1e6, 1e6, {}};
    EXPECT_EQ(keys_of(study), keys_of(lifted));
    EXPECT_EQ(word(study, "contact"), "both_planes");
    EXPECT_EQ(word(lifted, "contact"), "none");
}

TEST(ResultKeys, Relaxation) {
    auto study = example<RelaxationStudy>();
    ReductionSearch search{};
    search.paths = PathChoice::all;
    study.critical = search;
    RelaxationStudy stands_everywhere = study;
    search.upper = 1.1;
    stands_everywhere.critical = search;
    EXPECT_EQ(keys_of(study), keys_of(stands_everywhere));
    EXPECT_EQ(word(stands_everywhere, "critical.failing_blocks"), "none");
    EXPECT_EQ(word(stands_everywhere, "factor_of_safety_spread"), "none");
    EXPECT_NE(word(study, "factor_of_safety_spread"), "none");
}

// --- Lengths ---

template <class Model>
void expect_lengths_bounded(Model model) {
    int lengths = 0;
    for_each_number(model, [&](double&, const FieldInfo& info) {
        if (info.dimension == Dimension::length) {
            ++lengths;
            EXPECT_LE(info.range.upper, longest_length) << info.key;
            EXPECT_GE(info.range.lower, -longest_length) << info.key;
        }
    });
    EXPECT_GT(lengths, 0);
}

TEST(Lengths, AreBoundedInEveryModelOfLimitEquilibrium) {
    expect_lengths_bounded(example<PlaneFailureStudy<>>());
    expect_lengths_bounded(example<SteppedBaseStudy<>>());
    expect_lengths_bounded(example<BlockRow>());
    expect_lengths_bounded(example<SingleBlock>());
    expect_lengths_bounded(example<FlexuralSlope>());
    expect_lengths_bounded(example<SteppedPath>());
}

TEST(Lengths, BeyondTheRangeAreRefusedByName) {
    using testing::complaint_after;
    const std::string said = complaint_after("height = \"225 ft\"", "height = \"4.3e9 m\"");
    EXPECT_NE(said.find("slope.height"), std::string::npos) << said;
    EXPECT_NE(said.find("4.3e9 m"), std::string::npos) << said;
    EXPECT_NE(said.find("at most 1000000 m"), std::string::npos) << said;
}

}  // namespace
}  // namespace delabole
