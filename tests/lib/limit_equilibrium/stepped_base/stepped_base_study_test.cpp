// The stepped base as the loops see it: named numbers in and out, inputs solved for, the ground left standing.
#include "limit_equilibrium/stepped_base/stepped_base_study.hpp"
#include "limit_equilibrium/columns/base_profile.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace delabole {
namespace {

// West face of Old Delabole, 1967: toe at 350 ft, stepped base to 425 ft, crest at 575 ft; columns 85 deg into the
// slope, the wedge above them on joint A.
SteppedBaseStudy<> delabole_face() {
    SteppedBaseStudy<> study{};
    ColumnScene<>& scene = study.model.scene;
    scene.slope = SlopeSection<>{68.58, degrees(70), 0, {}, 106.68};
    scene.columns = ContinuousColumns<>{degrees(85), 2, degrees(42), 22.86};
    scene.rock.unit_weight = 27e3;
    scene.water = Dry{};
    scene.slide_head = SlideHead<>{degrees(72), degrees(30), 0, {}};
    study.model.joints.friction_angle = degrees(30);
    study.model.bases = {degrees(30), 0};
    return study;
}

std::size_t index_of(const std::vector<Quantity>& quantities, std::string_view name) {
    const auto place =
        std::find_if(quantities.begin(), quantities.end(), [&](const Quantity& each) { return each.name == name; });
    EXPECT_NE(place, quantities.end()) << name;
    return static_cast<std::size_t>(place - quantities.begin());
}

TEST(SteppedBaseStudy, PredictsWhatTheAnalysisFinds) {
    const SteppedBaseStudy<> study = delabole_face();
    const ModelInterface model = model_interface(study);
    const Prediction prediction = model.predict({});
    ASSERT_EQ(prediction.failure, "");
    ASSERT_EQ(prediction.outputs.size(), model.outputs.size());
    const SteppedBaseResult result = analyse(study.model);
    EXPECT_EQ(prediction.outputs[index_of(model.outputs, "factor_of_safety")], result.factor_of_safety);
    EXPECT_EQ(prediction.outputs[index_of(model.outputs, "crack_base_elevation")], result.crack_base_height + 106.68);
    // An assignment is the same as another case.
    SteppedBaseStudy<> other = study;
    other.model.bases.friction_angle = degrees(25);
    std::get<ContinuousColumns<>>(other.model.scene.columns).spacing = 3;
    const std::vector<Assignment> assignments = {{index_of(model.inputs, "bases.friction_angle"), degrees(25)},
                                                 {index_of(model.inputs, "columns.spacing"), 3}};
    EXPECT_EQ(model.predict(assignments).outputs, model_interface(other).predict({}).outputs);
    EXPECT_NE(model.predict(assignments).outputs, prediction.outputs);
}

TEST(SteppedBaseStudy, NamesWhyThereIsNoPrediction) {
    const ModelInterface model = model_interface(delabole_face());
    const auto failure = [&](std::string_view input, double value) {
        const std::vector<Assignment> assignments = {{index_of(model.inputs, input), value}};
        const Prediction prediction = model.predict(assignments);
        EXPECT_TRUE(prediction.outputs.empty()) << input;
        return prediction.failure;
    };
    EXPECT_EQ(failure("joints.friction_angle", degrees(95)), "input_out_of_range");
    EXPECT_EQ(failure("columns.base_inclination", degrees(3)), "base_flatter_than_joints_allow");
    EXPECT_EQ(failure("columns.base_inclination", degrees(71)), "base_does_not_daylight");
    EXPECT_EQ(failure("columns.base_end_height", 100), "base_end_outside_slope");
    EXPECT_EQ(failure("slope.height", std::numeric_limits<double>::quiet_NaN()), "input_out_of_range");
}

TEST(SteppedBaseStudy, TheGroundLeftIsTheBaseAndTheJointOfTheWedge) {
    const SteppedBaseStudy<> study = delabole_face();
    SteppedBaseStudy<> steep = study;
    steep.model.scene.slide_head->friction_angle = degrees(10);  // the wedge pushes all the way down
    const SteppedBaseResult result = analyse(steep.model);
    ASSERT_EQ(result.limit, LimitState::found);
    ASSERT_EQ(result.uppermost_moving, result.column_count);
    const Polyline profile = profile_after_failure(steep.model, result);
    ASSERT_GE(profile.size(), 3U);
    const auto inclination = [&](std::size_t from) {
        return std::atan2(profile[from + 1].y() - profile[from].y(), profile[from + 1].x() - profile[from].x());
    };
    EXPECT_NEAR(profile[1].y(), 22.86, 1e-9);  // roundings of lengths of 100 m
    EXPECT_NEAR(inclination(0), degrees(42), 1e-12);
    EXPECT_NEAR(inclination(1), degrees(72), 1e-12);
    EXPECT_NEAR(profile[2].y(), 68.58, 1e-9);
}

TEST(SteppedBaseStudy, CracksAtTheCrestAreJointsThatPartThere) {
    SteppedBaseStudy<> study = delabole_face();
    const double crest = 68.58 / std::tan(degrees(70));
    const SteppedBaseResult pushed = analyse(study.model);
    ASSERT_EQ(pushed.limit, LimitState::found);
    // The base ends below the face: only the wedge's joint comes out behind the crest.
    EXPECT_EQ(pushed.crest_cracks, 1);
    const std::vector<Point> outcrops = joint_outcrops(study.model.scene);
    ASSERT_EQ(outcrops.size(), pushed.column_count + 1);
    EXPECT_LT(outcrops[outcrops.size() - 2].x(), crest);
    EXPECT_NEAR(outcrops.back().y(), 68.58, 1e-9);
    EXPECT_GT(outcrops.back().x(), crest);

    // Up to the ground behind the crest, without a wedge, all columns topple: as many cracks as joints there.
    study.model.scene.slide_head.reset();
    study.model.scene.columns = ContinuousColumns<>{degrees(85), 2, degrees(42), {}};
    const SteppedBaseResult toppling = analyse(study.model);
    ASSERT_EQ(toppling.limit, LimitState::found);
    double behind = 0;
    const std::vector<Point> all = joint_outcrops(study.model.scene);
    for (std::size_t index = 0; index < all.size(); ++index) {
        behind += static_cast<double>(index) < toppling.uppermost_moving && all[index].x() > crest ? 1 : 0;
    }
    EXPECT_GT(behind, 1);
    EXPECT_LE(toppling.crest_cracks, behind);
    // Columns that slide beside each other move as one.
    EXPECT_GE(toppling.crest_cracks, behind - toppling.sliding_count);

    study.model.scene.slope.reset();
    study.model.scene.columns = BlockColumns<>{};
    EXPECT_TRUE(joint_outcrops(study.model.scene).empty());
}

TEST(SteppedBaseStudy, SharesOfWhatMovesAreThoseOfItsArea) {
    const SteppedBaseStudy<> study = delabole_face();
    const SteppedBaseResult result = analyse(study.model);
    EXPECT_NEAR(result.toppling_share + result.sliding_share + result.slide_head_share, 1, 1e-14);
    const std::vector<ColumnResult> columns =
        column_results(make_columns(study.model.scene), strength_of(study.model), result.factor_of_safety);
    const std::vector<Polyline> outlines = column_outlines(study.model.scene);
    double topples = 0;
    double moves = 0;
    for (std::size_t index = 0; index < outlines.size(); ++index) {
        double area = 0;
        for (std::size_t corner = 1; corner < outlines[index].size(); ++corner) {
            const Point& from = outlines[index][corner - 1];
            const Point& to = outlines[index][corner];
            area += (from.x() * to.y() - from.y() * to.x()) / 2;
        }
        area = std::abs(area);
        const bool wedge = index == columns.size();
        moves += wedge || columns[index].mode != ColumnMode::stays ? area : 0;
        topples += !wedge && columns[index].mode == ColumnMode::topples ? area : 0;
    }
    // The rock is the same everywhere, so that weights are in proportion to areas, but for rounding of sums of 100 m.
    EXPECT_NEAR(result.toppling_share, topples / moves, 1e-12);
    EXPECT_NEAR(result.moving_area, moves, 1e-12 * moves);
    EXPECT_EQ(result.moving_count, result.toppling_count + result.sliding_count);
}

TEST(SteppedBaseStudy, RequiredValuesReachTheirFactorOfSafety) {
    const SteppedBase<> problem = delabole_face().model;
    const auto factor_with = [&](const std::string& parameter, double value) {
        SteppedBase<> varied = problem;
        for_each_named_number(varied, [&](const std::string& path, const FieldInfo&, double& number) {
            number = path == parameter ? value : number;
        });
        return analyse(varied).factor_of_safety;
    };
    const double present = analyse(problem).factor_of_safety;
    for (const std::string parameter :
         {"joints.friction_angle", "slide_head.friction_angle", "columns.base_end_height"}) {
        const Required required = required_value(problem, parameter, present * 1.02);
        ASSERT_EQ(required.status, RequiredStatus::found) << parameter;
        EXPECT_NEAR(factor_with(parameter, required.value), present * 1.02, 1e-9) << parameter;
    }
    // All columns topple: no friction of the bases makes them safer.
    const Required bases = required_value(problem, "bases.friction_angle", present * 1.02);
    EXPECT_EQ(bases.status, RequiredStatus::never_reached);
    EXPECT_NEAR(bases.highest_factor_of_safety, present, 1e-12);
    EXPECT_EQ(required_value(problem, "joints.cohesion", 1).status, RequiredStatus::unknown_parameter);
    EXPECT_EQ(required_value(problem, "joints.friction_angle", 1e9).status, RequiredStatus::never_reached);
}

TEST(SteppedBaseStudy, CriticalBaseReplacesTheGivenOne) {
    SteppedBaseStudy<> study = delabole_face();
    study.model.scene.slide_head.reset();
    const double given = analyse(study.model).factor_of_safety;
    study.critical = CriticalBaseSearch<>{
        CriticalBaseFeature::base_inclination, SearchCondition::given_water, degrees(30), degrees(60), {}, {}};
    const ResolvedSteppedBase resolved = resolve(study);
    ASSERT_EQ(resolved.check, ColumnCheck::valid);
    const double least = analyse(resolved.problem).factor_of_safety;
    EXPECT_LE(least, given);
    const ModelInterface model = model_interface(study);
    const Prediction prediction = model.predict({});
    ASSERT_EQ(prediction.failure, "");
    EXPECT_EQ(prediction.outputs[index_of(model.outputs, "factor_of_safety")], least);
    // The given inclination does not matter any more, other inputs do.
    const std::vector<Assignment> ignored = {{index_of(model.inputs, "columns.base_inclination"), degrees(50)}};
    EXPECT_EQ(model.predict(ignored).outputs, prediction.outputs);
    const std::vector<Assignment> used = {{index_of(model.inputs, "slope.face_dip"), degrees(68)}};
    EXPECT_NE(model.predict(used).outputs, prediction.outputs);
}

}  // namespace
}  // namespace delabole
