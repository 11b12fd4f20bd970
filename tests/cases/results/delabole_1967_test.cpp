// The back-analysis of the 1967 failure gives what the README says of it.
#include "cases/program/case/case_writer.hpp"
#include "cases/program/reader/ordinary_file.hpp"
#include "cases/program/results/analysis.hpp"
#include "cases/program/results/problems_of_case.hpp"
#include "fitting/back_analysis/back_analysis.hpp"
#include "fitting/studies/comparison.hpp"
#include "fitting/studies/conclusions.hpp"
#include "fitting/work/run_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>

namespace delabole {
namespace {

constexpr double foot = 0.3048;

const FitProblem& problem_of_1967() {
    static const FitProblem problem = [] {
        CaseFile file = read_case(std::string(DELABOLE_CASES) + "/delabole_1967/delabole_1967.toml");
        leave_out_costly(*file.fit);
        return fit_problem_of(file, 1, std::nullopt);
    }();
    return problem;
}

const FitResult& result_of_1967() {
    static const FitResult result = fit(problem_of_1967());
    return result;
}

const MechanismFit& mechanism(const std::string& name) {
    const auto& mechanisms = result_of_1967().mechanisms;
    return *std::find_if(mechanisms.begin(), mechanisms.end(),
                         [&](const MechanismFit& fit) { return fit.name == name; });
}

const ProfileLikelihood& data_alone(const MechanismFit& fit, const std::string& parameter) {
    return *std::find_if(fit.profiles.begin(), fit.profiles.end(), [&](const ProfileLikelihood& profile) {
        return !profile.with_priors && profile.parameter == parameter;
    });
}

bool leaves_unexplained(const MechanismFit& fit, const std::string& word) {
    return std::any_of(fit.unexplained.begin(), fit.unexplained.end(),
                       [&](const std::string& sentence) { return sentence.find(word) != std::string::npos; });
}

TEST(Delabole1967, FrictionAndWaterAreNotDeterminedSeparately) {
    const MechanismFit& fit = mechanism("stepped_sliding");
    ASSERT_EQ(fit.status, FitStatus::converged);
    EXPECT_EQ(fit.identifiability.rank, 2);
    EXPECT_NE(fit.identifiability.verdict.find("slope.face_dip: determined"), std::string::npos);
    EXPECT_NE(fit.identifiability.verdict.find("only one combination is determined"), std::string::npos);
    EXPECT_NE(data_alone(fit, "steps.friction_angle").determination, Determination::determined);
    EXPECT_NE(data_alone(fit, "water.water_elevation").determination, Determination::determined);
}

// Water alone drives a mass on steps into the slope, so that the lightest one fails first: the smallest that counts.
TEST(Delabole1967, SlidingOnCleavageNeedsHighWater) {
    const MechanismFit& fit = mechanism("stepped_sliding");
    // This pins the compromise between data and priors to the three digits that the README shows.
    EXPECT_NEAR(fit.best[0], degrees(18.0), degrees(0.1));
    EXPECT_NEAR(fit.best[1], 146, 0.5);
    EXPECT_GT(fit.best[1], 475 * foot);  // two standard deviations of the prior above the average
    EXPECT_TRUE(leaves_unexplained(fit, "water.water_elevation"));
}

// The values are results, not inputs: 14.4 m behind the crest and 899 m2 were observed.
TEST(Delabole1967, ColumnsAndWedgeLeaveNearlyTheSurfaceObserved) {
    const MechanismFit& fit = mechanism("stepped_toppling");
    const auto& outputs = problem_of_1967().mechanisms.front().model.outputs;
    const auto output = [&](const std::string& name) {
        return fit.prediction.outputs[place_of(outputs, name).value()];
    };
    EXPECT_NEAR(output("retreat"), 12.6, 0.05);
    EXPECT_NEAR(output("failed_area"), 1003, 5);
    EXPECT_NEAR(output("knee_height"), 5.6, 0.1);
    EXPECT_FALSE(leaves_unexplained(fit, "post-failure profile"));
    EXPECT_TRUE(leaves_unexplained(fit, "lower_steps is 1"));
}

// The fit depends on the angle of the face. Held at 70 deg, the only angle printed for this slope, it leaves the
// critical plane 3.8 m off the observed profile; but the thesis calls that angle undefined, and the fit finds a flatter
// face.
TEST(Delabole1967, CriticalSlidingLeavesTheSurfaceObservedBehindAFlatterFace) {
    const MechanismFit& fit = mechanism("critical_sliding");
    ASSERT_EQ(fit.status, FitStatus::converged);
    EXPECT_EQ(fit.identifiability.rank, 3);
    // The mass lifts off under high water, and great friction would need such water: the data exclude both.
    EXPECT_EQ(data_alone(fit, "water.water_elevation").determination, Determination::bounded_above);
    EXPECT_EQ(data_alone(fit, "strength.friction_angle").determination, Determination::bounded_above);
    EXPECT_EQ(data_alone(fit, "slope.face_dip").determination, Determination::determined);
    // These pin computed values to the three digits that the README shows.
    EXPECT_NEAR(fit.best[0], degrees(25.3), degrees(0.1));
    EXPECT_NEAR(fit.best[1], 130, 0.5);
    EXPECT_NEAR(fit.best[2], 214e3, 1e3);
    EXPECT_NEAR(fit.best[3], degrees(67.8), degrees(0.1));
    ASSERT_GE(fit.prediction.profile.size(), 2U);
    // The bottom of the crack was seen at 425 ft, 75 ft above the toe; 3 m are the standard deviation of the profile.
    EXPECT_NEAR(fit.prediction.profile[1].y(), 75 * foot, 3);
}

TEST(Delabole1967, SlidingExplainsNoneOfTheMovementsAtTheCrest) {
    for (const std::string name : {"stepped_sliding", "critical_sliding"}) {
        const MechanismFit& fit = mechanism(name);
        EXPECT_TRUE(leaves_unexplained(fit, "parallel_crest_cracks")) << name;
        EXPECT_TRUE(leaves_unexplained(fit, "crest_block_rotation")) << name;
    }
}

// A mechanism is credited with the field evidence that it predicts: all open a crack at the crest, none in limiting
// equilibrium turns blocks there, and only the joint of the wedge moves behind it. The upper surface follows one joint
// where the surface consists of joints.
TEST(Delabole1967, LimitEquilibriumPredictsOneCrackAtTheCrestAndNoMore) {
    for (const MechanismFit& fit : result_of_1967().mechanisms) {
        const std::vector<std::string> of_joints{"planar_upper_surface", "tension_crack_at_crest"};
        const std::vector<std::string> of_rock{"tension_crack_at_crest"};
        EXPECT_EQ(fit.explained, fit.name == "critical_sliding" ? of_rock : of_joints) << fit.name;
    }
    EXPECT_TRUE(leaves_unexplained(mechanism("stepped_toppling"), "crest_cracks is 1"));
}

// The thesis concludes otherwise (2.4.2): here toppling driven by wedges comes second.
TEST(Delabole1967, SlidingOnTheCriticalPlaneRanksFirstAndTopplingNeedsNoHighWater) {
    ASSERT_EQ(result_of_1967().mechanisms.size(), 3U);
    EXPECT_EQ(result_of_1967().mechanisms[0].name, "critical_sliding");
    EXPECT_EQ(result_of_1967().mechanisms[1].name, "stepped_toppling");
    const MechanismFit& fit = mechanism("stepped_toppling");
    ASSERT_EQ(fit.status, FitStatus::converged);
    EXPECT_FALSE(leaves_unexplained(fit, "water.water_elevation"));
    // These pin the compromise between data and priors to the three digits that the README shows.
    EXPECT_NEAR(fit.best[0], degrees(25.6), degrees(0.1));
    EXPECT_NEAR(fit.best[1], 130, 0.5);
    EXPECT_NEAR(fit.best[2], 9.08, 0.05);
    EXPECT_NEAR(fit.best[4], 163e3, 1e3);
    EXPECT_NEAR(fit.best[5], degrees(70), degrees(0.1));
    EXPECT_LT(fit.best[1], 475 * foot);  // the upper seepage level
    EXPECT_LT(fit.identifiability.rank, 6);
    for (const std::string parameter : {"water.water_elevation", "columns.spacing", "steps.friction_angle"}) {
        EXPECT_NE(data_alone(fit, parameter).determination, Determination::determined) << parameter;
    }
}

// These are the probabilities in the README of the case. With the angle of the face fitted the order of the mechanisms
// does not depend on the priors; with 70 deg held it did.
TEST(Delabole1967, WhichMechanismIsFirstDoesNotHangOnThePriors) {
    const auto& mechanisms = result_of_1967().mechanisms;
    for (const MechanismFit& fit : mechanisms) {
        ASSERT_TRUE(fit.posterior) << fit.name;
        EXPECT_EQ(fit.posterior->posterior.status, PosteriorStatus::converged) << fit.name;
        // The columns have more parameters than data, and a warning says so.
        EXPECT_EQ(fit.posterior->warnings.size(), fit.name == "stepped_toppling" ? 1U : 0U) << fit.name;
        EXPECT_LT(fit.posterior->evidence().standard_error, 0.02) << fit.name;
        EXPECT_EQ(fit.posterior->evidences.size(), 8U) << fit.name;
    }
    for (const bool field : {true, false}) {
        std::vector<LogEvidence> evidences;
        for (const MechanismFit& fit : mechanisms) {
            evidences.push_back({fit.posterior->log_evidence(fit.posterior->evidence(), field),
                                 fit.posterior->evidence().standard_error});
        }
        // Three standard errors of the computation.
        EXPECT_NEAR(weigh(evidences)[0].probability, field ? 0.71 : 0.948, 0.01) << field;
    }
    for (std::size_t index = 0; index < mechanisms[0].posterior->evidences.size(); ++index) {
        const auto log_evidence = [&](std::size_t mechanism) {
            const MechanismPosterior& posterior = *mechanisms[mechanism].posterior;
            return posterior.log_evidence(posterior.evidences[index].evidence, true);
        };
        const EvidenceVariant variant = mechanisms[0].posterior->evidences[index].variant;
        // Errors of the evidences are below 0.05, but 0.14 where priors are doubled or flat.
        EXPECT_GT(log_evidence(0), log_evidence(1)) << word_of(variant);
        EXPECT_GT(log_evidence(0) - log_evidence(2), variant == EvidenceVariant::priors_flat ? 0 : 1)
            << word_of(variant);
    }
}

// Half of the conclusions of 2.4.2 are for the slope in motion to decide.
TEST(Delabole1967, TheConclusionsOfTheThesisAsFarAsLimitEquilibriumHasASay) {
    const std::vector<ConclusionFinding> findings = judge_conclusions(problem_of_1967(), result_of_1967());
    const auto finding = [&](const std::string& label) {
        const auto& conclusions = problem_of_1967().conclusions;
        const auto found = std::ranges::find(conclusions, label, &Conclusion::label);
        EXPECT_NE(found, conclusions.end()) << label;
        return findings[static_cast<std::size_t>(found - conclusions.begin())];
    };
    // The wedge drives; toppling is less probable than asked for, and the share of what moves that topples is more than
    // half at some draws and less at others. By energy nothing topples by itself: as they turn,
    // columns as wide as these rise at first.
    EXPECT_EQ(finding("(i)").verdict, ConclusionVerdict::partly);
    EXPECT_EQ(finding("(i)").tests[2].verdict, ConclusionVerdict::contradicted);
    EXPECT_EQ(finding("(i)").tests.back().verdict, ConclusionVerdict::confirmed);
    EXPECT_EQ(finding("(ii)").verdict, ConclusionVerdict::undecided);
    // Sliding opens one crack at the crest, but so do columns that a wedge pushes.
    EXPECT_EQ(finding("(vi)").verdict, ConclusionVerdict::partly);
    EXPECT_EQ(finding("(iii) joint set B").tests.back().verdict, ConclusionVerdict::confirmed);
    EXPECT_EQ(finding("(iii) joint set A").tests.back().verdict, ConclusionVerdict::undecided);
    const std::vector<TestFinding> water = finding("(iv)").tests;
    ASSERT_EQ(water.size(), 3U);
    // 2.4.1 finds toppling independent of water: here it takes off less than half of what it takes off sliding.
    EXPECT_EQ(water[0].verdict, ConclusionVerdict::confirmed);
    EXPECT_EQ(water[1].verdict, ConclusionVerdict::undecided);
    EXPECT_GT(water[1].value, water[0].value / 2);
    EXPECT_EQ(water[2].verdict, ConclusionVerdict::not_tested);
}

// Tables of runs outlast the program that made them, which is why a few of their rows are run again. Where they differ,
// the runs beside the case have to be made anew: `delabole fit --with-costly --runs` and `sensitivity --runs` with a
// folder that has no tables, and the tables moved from the result folder.
TEST(Delabole1967, TabledRunsAreWhatTheProgramPredicts) {
    const std::string folder = std::string(DELABOLE_CASES) + "/delabole_1967/";
    const auto expect_alike = [&](const CaseModel& of, const std::string& name) {
        const std::string path = folder + "runs/" + name + "_predictions.csv";
        const FileContent content = read_ordinary_file(path, "a table of runs", 1U << 26U);
        ASSERT_EQ(content.fault, "") << path;
        const ModelInterface model = interface_of(of);
        RunTable table(model, resolved_model(of));
        table.read(content.bytes);
        constexpr std::size_t rows = 3;
        ASSERT_GE(table.runs().size(), rows) << path;
        for (std::size_t row = 0; row < rows; ++row) {
            const auto& [key, kept] =
                *std::next(table.runs().begin(), static_cast<std::ptrdiff_t>(row * table.runs().size() / rows));
            std::vector<Assignment> assignments;
            for (const auto& [input, value] : key) {
                assignments.push_back({input, value});
            }
            const Prediction made = model.predict(assignments);
            EXPECT_EQ(made.failure, kept.failure) << path << ", row " << row;
            ASSERT_EQ(made.outputs.size(), kept.outputs.size());
            for (std::size_t output = 0; output < kept.outputs.size(); ++output) {
                // Nine digits are kept; elementary functions differ between processors, and a run may amplify that.
                const double tolerance = 1e-5 * std::max(1e-3, std::abs(kept.outputs[output]));
                EXPECT_TRUE(std::isnan(made.outputs[output])
                                ? std::isnan(kept.outputs[output])
                                : made.outputs[output] == kept.outputs[output] ||
                                      std::abs(made.outputs[output] - kept.outputs[output]) <= tolerance)
                    << path << ", row " << row << ", " << model.outputs[output].name << ": " << made.outputs[output]
                    << ", " << kept.outputs[output];
            }
        }
    };
    const CaseFile fitted = read_case(folder + "delabole_1967.toml");
    for (const FitMechanism& mechanism : fitted.fit->mechanisms) {
        if (interface_of(mechanism.model).costly) {
            expect_alike(mechanism.model, mechanism.name);
        }
    }
    expect_alike(read_case(folder + "sensitivity_blocks.toml").model, "sensitivity_blocks");
}

// The interval of the profile likelihood and that of the draws measure the same uncertainty.
TEST(Delabole1967, PosteriorAgreesWithTheProfileLikelihood) {
    for (const MechanismFit& fit : result_of_1967().mechanisms) {
        if (fit.name == "stepped_toppling") {
            continue;  // its misfit jumps where another surface fails first, and profiles stop at the jumps
        }
        for (std::size_t index = 0; index < fit.parameters.size(); ++index) {
            const ParameterPosterior& posterior = fit.posterior->posterior.parameters[index];
            const auto profile = std::find_if(fit.profiles.begin(), fit.profiles.end(), [&](const auto& one) {
                return one.with_priors && one.parameter == posterior.name;
            });
            ASSERT_NE(profile, fit.profiles.end());
            // Equal for a normal posterior. That of sliding on cleavage has a second range of faces, steeper than 71
            // deg, that few draws are in: there the profile ends, which shifts its ends by up to a standard deviation.
            const double shift = (fit.name == "stepped_sliding" ? 1 : 0.75) * posterior.standard_deviation;
            EXPECT_NEAR(posterior.interval_95.lower, profile->interval_95.lower, shift)
                << fit.name << ' ' << posterior.name;
            EXPECT_NEAR(posterior.interval_95.upper, profile->interval_95.upper, shift)
                << fit.name << ' ' << posterior.name;
        }
    }
}

}  // namespace
}  // namespace delabole
