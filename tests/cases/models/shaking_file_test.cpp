// A record of shaking in a file beside the case is read once, written out, or refused with its line.
#include "cases/program/models/relaxation/shaking_file.hpp"

#include "cases/program/case/case_writer.hpp"
#include "dynamic_relaxation/checkpoint/study_checkpoint.hpp"
#include "tests/plots/scratch_folder.hpp"

#include "tests/cases/example_case.hpp"

#include <gtest/gtest.h>

#include <fstream>

namespace delabole {
namespace {

using testing::changed;

constexpr std::string_view first_line = "time_s,horizontal_m_per_s2,vertical_m_per_s2\n";

constexpr std::string_view case_text = R"(schema = 1
model = "relaxation"
shaking_file = "record.csv"
[scene]
kind = "row"
tilt = "10 deg"
density = "2700 kg/m3"
[scene.interface]
friction_angle = "30 deg"
[scene.base]
friction_angle = "30 deg"
[[scene.block]]
width = "1 m"
height = "1 m"
)";

std::string problem_of_record(const std::string& text) {
    try {
        shaking_of_csv(text, "record.csv");
    } catch (const CaseError& error) {
        return error.what();
    }
    return "";
}

class ShakingFile : public ::testing::Test {
  protected:
    void write(std::string_view rows) const { std::ofstream(folder.path() / "record.csv") << first_line << rows; }
    CaseFile read(const std::string& text) const { return parse_case(text, (folder.path() / "case.toml").string()); }
    std::vector<ShakingPoint> record(const std::string& text) const {
        return std::get<RelaxationStudy>(read(text).model).model.shaking;
    }
    std::string problem(const std::string& text) const {
        try {
            read(text);
        } catch (const CaseError& error) {
            return error.what();
        }
        return "";
    }

    const ScratchFolder folder;
};

TEST(ShakingRecord, HasUnitsInItsColumns) {
    const std::vector<ShakingPoint> record = shaking_of_csv(
        "# station 3\nvertical_cm_per_s2,time_ms,horizontal_m_per_s2\n\n-20,5,1\n30,10,-2e-1\n", "record");
    ASSERT_EQ(record.size(), 2U);
    // The conversion of units rounds.
    EXPECT_DOUBLE_EQ(record[0].time, 0.005);
    EXPECT_DOUBLE_EQ(record[0].horizontal, 1);
    EXPECT_DOUBLE_EQ(record[0].vertical, -0.2);
    EXPECT_DOUBLE_EQ(record[1].horizontal, -0.2);
}

TEST(ShakingRecord, SaysWhatIsWrongAndWhere) {
    const std::string columns(first_line);
    EXPECT_EQ(problem_of_record(columns + "0,0,0\n0.1,1,0\n0.1,2,0\n"),
              "record.csv:4:1: time = 0.1 s: must be more than that of the line before, 0.1 s");
    EXPECT_EQ(problem_of_record(columns + "-1,0,0\n"), "record.csv:2:1: time = \"-1 s\": must be at least 0 s");
    EXPECT_EQ(problem_of_record(columns + "0,0,0\n0.1,x,0\n").substr(0, 16), "record.csv:3:5: ");
    EXPECT_EQ(problem_of_record(columns + "0,0,0\n0.1,0\n"), "record.csv:3:1: has 2 cells where the header has 3");
    EXPECT_EQ(problem_of_record("time_s,horizontal_m_per_s2\n0,0\n"),
              "record.csv:1:1: vertical: is missing: a column vertical_m_per_s2");
    EXPECT_EQ(problem_of_record(columns), "record.csv:1:1: has no entries below the names of its columns");
    std::string long_record = columns;
    for (int entry = 0; entry < 20'000; ++entry) {
        long_record += std::to_string(entry) + ",0,0\n";
    }
    EXPECT_EQ(problem_of_record(long_record), "");
    EXPECT_EQ(problem_of_record(long_record + "20000,0,0\n"),
              "record.csv:20002:1: is the first line beyond 20000 entries: more are not read");
}

TEST_F(ShakingFile, TakesThePlaceOfEntries) {
    write("0,1,0\n0.5,-2,0.25\n");
    const CaseFile direct = read(changed(case_text, "shaking_file = \"record.csv\"",
                                         R"(shaking = [{ time = "0 s", horizontal = "1 m/s2", vertical = "0 m/s2" },
                      { time = "0.5 s", horizontal = "-2 m/s2", vertical = "0.25 m/s2" }])"));
    const CaseFile from_file = read(std::string(case_text));
    EXPECT_EQ(resolved_toml(from_file), resolved_toml(direct));
    EXPECT_EQ(case_hash(from_file), case_hash(direct));
    // The case that is written out does not need the file.
    const std::string resolved = resolved_toml(from_file);
    EXPECT_EQ(resolved.find("shaking_file"), std::string::npos);
    EXPECT_EQ(resolved_toml(parse_case(resolved, "elsewhere.toml")), resolved);
}

TEST_F(ShakingFile, ProblemsHaveTheirFileAndLine) {
    const std::string path = (folder.path() / "record.csv").string();
    EXPECT_EQ(problem(std::string(case_text)), (folder.path() / "case.toml").string() +
                                                   ":3:16: shaking_file = \"record.csv\": " + path +
                                                   " there is no such file");
    write("0,1,0\n0,-2,0\n");
    EXPECT_EQ(problem(std::string(case_text)),
              path + ":3:1: time = 0 s: must be more than that of the line before, 0 s");
    write("0,1,0\n");
    EXPECT_NE(problem(std::string(case_text) +
                      "[[shaking]]\ntime = \"0 s\"\nhorizontal = \"0 m/s2\"\nvertical = \"0 m/s2\"\n")
                  .find("shaking_file = \"record.csv\": and shaking exclude each other"),
              std::string::npos);
}

// A mechanism of a fit may be shaken differently from the case, and then does not keep the record of the case.
TEST_F(ShakingFile, OfAMechanismReplacesThatOfTheCase) {
    write("0,1,0\n0.5,-2,0.25\n");
    std::ofstream(folder.path() / "other.csv") << first_line << "1,3,0\n";
    const std::string text = std::string(case_text) + R"(
[[fit.observation]]
label = "slip"
quantity = "block[1].base_slip"
value = "1 cm"
standard_deviation = "1 mm"
[fit.surrogate]
[[fit.mechanism]]
name = "other"
shaking_file = "other.csv"
[fit.mechanism.coarse]
shaking_file = "record.csv"
[[fit.mechanism.parameter]]
name = "scene.base.friction_angle"
lower = "20 deg"
upper = "40 deg"
)";
    const CaseFile file = read(text);
    const FitMechanism& mechanism = file.fit->mechanisms.at(0);
    const auto shaking_of = [](const CaseModel& model) { return std::get<RelaxationStudy>(model).model.shaking; };
    ASSERT_EQ(shaking_of(file.model).size(), 2U);
    ASSERT_EQ(shaking_of(mechanism.model).size(), 1U);
    EXPECT_EQ(shaking_of(mechanism.model)[0].horizontal, 3);
    EXPECT_EQ(shaking_of(mechanism.coarse.value()).size(), 2U);
}

TEST_F(ShakingFile, ARunIsNotTakenUpUnderAnotherRecord) {
    const auto study = [&] { return std::get<RelaxationStudy>(read(std::string(case_text)).model); };
    write("0,1,0\n0.5,-2,0.25\n");
    StudyProgress progress;
    RelaxationStudy shaken = study();
    shaken.settings = RelaxationNumerics{};
    shaken.settings->duration = 0.01;
    run(shaken, {}, progress);
    const std::string kept = checkpoint_of(shaken, KeepFrames::no, progress);
    EXPECT_EQ(restore_checkpoint(kept, shaken, KeepFrames::no).check, CheckpointCheck::ok);
    write("0,1,0\n0.5,-2,0.26\n");
    RelaxationStudy other = study();
    other.settings = shaken.settings;
    EXPECT_EQ(restore_checkpoint(kept, other, KeepFrames::no).check, CheckpointCheck::other_scene);
}

}  // namespace
}  // namespace delabole
