// Measured planes in a file beside the case are read in three notations, or refused with their line.
#include "cases/program/models/kinematics/pole_file.hpp"

#include "cases/program/case/case_file.hpp"
#include "cases/program/case/case_writer.hpp"
#include "tests/plots/scratch_folder.hpp"

#include "tests/cases/example_case.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <string>

namespace delabole {
namespace {

constexpr std::string_view case_text = R"(schema = 1
model = "kinematics"
[slope]
face_dip = "70 deg"
face_dip_direction = "95 deg"
[strength]
friction_angle = "30 deg"
[lateral_limit]
planar_sliding = "20 deg"
flexural_toppling = "30 deg"
direct_toppling = "20 deg"
[[poles]]
file = "poles.csv"
)";

std::string problem_of(std::string_view text) {
    try {
        planes_of_csv(text, "poles.csv");
    } catch (const CaseError& error) {
        return error.what();
    }
    return "";
}

void expect_plane(const std::vector<Orientation>& planes, double dip, double dip_direction) {
    ASSERT_EQ(planes.size(), 1U);
    EXPECT_NEAR(planes[0].dip, degrees(dip), 1e-12);
    EXPECT_NEAR(planes[0].dip_direction, degrees(dip_direction), 1e-12);
}

TEST(PoleFile, ReadsThreeNotationsOfOnePlane) {
    expect_plane(planes_of_csv("dip,dip_direction\n40,95\n", "poles"), 40, 95);
    expect_plane(planes_of_csv("ID;Dip Direction (deg);Dip (deg);Set\n1;95;40;bedding\n", "poles"), 40, 95);
    expect_plane(planes_of_csv("# tape 3\nStrike (Right)\tDip\r\n\r\n5\t40\r\n", "poles"), 40, 95);
    expect_plane(planes_of_csv("trend,plunge\n275,50\n", "poles"), 40, 95);
    expect_plane(planes_of_csv("\xEF\xBB\xBF\"dip_deg\",\"dip_dir_deg\"\n\"40\",\"-265\"\n", "poles"), 40, 95);
    expect_plane(planes_of_csv("dip,strike\n40,-355\n", "poles"), 40, 95);
}

TEST(PoleFile, CountsAPlaneAsManyTimesAsItsQuantity) {
    const std::vector<Orientation> planes = planes_of_csv("Dip,Dip Direction,Quantity\n40,95,3\n50,105,1\n", "poles");
    ASSERT_EQ(planes.size(), 4U);
    EXPECT_NEAR(planes[2].dip, degrees(40), 1e-12);
    EXPECT_NEAR(planes[3].dip, degrees(50), 1e-12);
}

TEST(PoleFile, SaysWhatIsWrongAndWhere) {
    EXPECT_EQ(problem_of("dip,azimuth\n40,95\n"),
              "poles.csv:1:1: must name the columns dip and dip_direction, strike and dip, or trend and plunge");
    EXPECT_EQ(problem_of("dip,dip_direction\n40,95\n95,40\n"),
              "poles.csv:3:1: dip = \"95\": must be a number of degrees from 0 to 90");
    EXPECT_EQ(problem_of("dip,dip_direction\n40,N95E\n"),
              "poles.csv:2:4: dip_direction = \"N95E\": must be a number of degrees from -360 to 360");
    EXPECT_LT(problem_of("dip,dip_direction\n" + std::string(1'000'000, '1') + ",40\n").size(), 200U);
    EXPECT_EQ(problem_of("dip,dip_direction\n40\n"), "poles.csv:2:1: has no dip_direction: too few columns");
    EXPECT_EQ(problem_of("dip,dip_direction\n"), "poles.csv:1:1: has no planes below the names of its columns");
    EXPECT_EQ(problem_of("ID,Dip (deg),Dip Direction,Quantity\n1,95,40,0\n2,40,95,1.5\n"),
              "poles.csv:2:3: Dip (deg) = \"95\": must be a number of degrees from 0 to 90\n"
              "poles.csv:2:9: Quantity = \"0\": must be a whole number of poles from 1 to 10000\n"
              "poles.csv:3:9: Quantity = \"1.5\": must be a whole number of poles from 1 to 10000");
    EXPECT_EQ(problem_of("dip,dip_direction,quantity\n40,95,9999\n50,95,2\n"),
              "poles.csv:3:1: is the first line beyond 10000 planes: more are not read");
    std::string many = "dip,dip_direction\n";
    for (int row = 0; row <= 10'000; ++row) {
        many += "1,1\n";
    }
    EXPECT_EQ(problem_of(many), "poles.csv:10002:1: is the first line beyond 10000 planes: more are not read");
}

TEST(PoleFile, StandsInThePlaceOfItsName) {
    const ScratchFolder folder;
    std::ofstream(folder.path() / "poles.csv") << "dip,dip_direction\n40,95\n50,105\n";
    const CaseFile file = parse_case(case_text, (folder.path() / "case.toml").string());
    const std::vector<PoleSurvey>& poles = std::get<KinematicsStudy>(file.model).model.poles;
    ASSERT_EQ(poles.size(), 1U);
    EXPECT_EQ(poles[0].plane.size(), 2U);
    EXPECT_FALSE(poles[0].file);
    // The case that was written out does not need the file.
    const CaseFile again = parse_case(resolved_toml(file), "elsewhere.toml");
    EXPECT_EQ(std::get<KinematicsStudy>(again.model).model.poles[0].plane.size(), 2U);
}

TEST(PoleFile, CasesThatContradictThemselvesAreRefused) {
    const ScratchFolder folder;
    std::ofstream(folder.path() / "poles.csv") << "dip,dip_direction\n40,95\n";
    const auto problem = [&](const std::string& more) -> std::string {
        try {
            parse_case(std::string(case_text) + more, (folder.path() / "case.toml").string());
        } catch (const CaseError& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_EQ(problem(""), "");
    EXPECT_NE(problem("plane = [{ dip = \"40 deg\", dip_direction = \"95 deg\" }]\n").find("exclude each other"),
              std::string::npos);
    EXPECT_NE(problem("[set_search]\nmost_sets = 2.5\n").find("must be a whole number"), std::string::npos);
    EXPECT_NE(problem("[[poles]]\n").find("needs a file or at least one plane"), std::string::npos);
    std::string lost(case_text);
    lost.replace(lost.find("poles.csv"), 9, "nowhere.c");
    try {
        parse_case(lost, (folder.path() / "case.toml").string());
        ADD_FAILURE() << "a missing file was read";
    } catch (const CaseError& error) {
        EXPECT_NE(std::string(error.what()).find("poles[1].file"), std::string::npos) << error.what();
    }
}

}  // namespace
}  // namespace delabole
