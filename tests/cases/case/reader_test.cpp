#include "cases/program/case/case_file.hpp"

#include "cases/program/reader/names.hpp"
#include "tests/cases/example_case.hpp"

#include <gtest/gtest.h>

#include <ctime>
#include <filesystem>
#include <fstream>

namespace delabole {
namespace {

using testing::changed;
using testing::complaint;
using testing::complaint_after;
using testing::example_text;
using testing::plane_failure;

TEST(Reader, ReadsEveryKindOfMember) {
    const std::string text = std::string(example_text) + R"(
[[bolt]]
force = "400 kN/m"
plunge = "10 deg"
head_height = "5 m"
action = "passive"

[critical]
find = "both"
under = "given_water"

[[required]]
parameter = "strength.cohesion"
factor_of_safety = 1.0

[sources]
"slope.height" = "section 2.2.3"
bolt = "drawing 4"

[[expect]]
quantity = "weight"
value = "1.2 MN/m"
relative_tolerance = 0.01
with = { "water.water_depth" = "5 m" }
)";
    const CaseFile file = parse_case(text, "slope.toml");
    const PlaneFailure<>& model = plane_failure(file);
    EXPECT_DOUBLE_EQ(model.slope.height, 68.58);
    EXPECT_EQ(model.failure_plane.dip, degrees(40));
    ASSERT_TRUE(model.tension_crack);
    EXPECT_EQ(std::get<CrackOfDepth<>>(model.tension_crack->position).depth, 40);
    EXPECT_EQ(std::get<Coulomb<>>(model.strength).friction_angle, degrees(30));
    EXPECT_EQ(std::get<WaterDepth<>>(std::get<CrackAndBaseWater<>>(model.water).level).water_depth, 10);
    ASSERT_EQ(model.bolt.size(), 1U);
    EXPECT_EQ(model.bolt.front().action, BoltAction::passive);
    EXPECT_FALSE(model.pond);
    EXPECT_EQ(file.sources.at("slope.height"), "section 2.2.3");
    ASSERT_EQ(file.expectations.size(), 1U);
    EXPECT_EQ(file.expectations.front().dimension, Dimension::force_per_length);
    EXPECT_EQ(file.expectations.front().conditions.front().value, 5);
    EXPECT_EQ(problem_at(file, "slope.height", "too high").line, 6);
    EXPECT_EQ(to_string(problem_at(file, "slope.height", "too high")),
              "slope.toml:6:10: slope.height = \"225 ft\": too high");
}

TEST(Reader, ValuesAreToldWithPlaceKeyAndRange) {
    EXPECT_EQ(complaint_after("\"225 ft\"", "\"-3 m\""),
              "slope.toml:6:10: slope.height = \"-3 m\": must be more than 0 and at most 1000000 m");
    EXPECT_EQ(complaint_after("\"225 ft\"", "\"0 m\""),
              "slope.toml:6:10: slope.height = \"0 m\": must be more than 0 and at most 1000000 m");
    EXPECT_EQ(complaint_after("\"225 ft\"", "225"),
              "slope.toml:6:10: slope.height = 225: has no unit: a length is expected, e.g. \"10 m\"");
    EXPECT_EQ(complaint_after("\"225 ft\"", "\"225\""),
              "slope.toml:6:10: slope.height = \"225\": has no unit: a length is expected, e.g. \"10 m\"");
    EXPECT_EQ(complaint_after("\"225 ft\"", "\"225 s\""),
              "slope.toml:6:10: slope.height = \"225 s\": \"s\" is the wrong kind of unit: a length is expected, e.g. "
              "\"10 m\"");
    EXPECT_EQ(complaint_after("\"225 ft\"", "nan"),
              "slope.toml:6:10: slope.height = nan: must be a finite number that a double can hold");
    EXPECT_EQ(complaint_after("\"225 ft\"", "true"),
              "slope.toml:6:10: slope.height = true: must be a length, e.g. \"10 m\"");
    EXPECT_EQ(complaint_after("dip = \"40 deg\"", "dip = \"90 deg\""),
              "slope.toml:11:7: failure_plane.dip = \"90 deg\": must be between 0 and 90 deg (ends excluded)");
    EXPECT_EQ(complaint_after("water_depth = \"10 m\"", "filled_ratio = 1.5"),
              "slope.toml:28:16: water.filled_ratio = 1.5: must be from 0 to 1");
}

TEST(Reader, MissingAndUnknownKeys) {
    EXPECT_EQ(
        complaint_after("height = \"225 ft\"\n", ""),
        "slope.toml:5:1: slope.height: is required: vertical height, toe to crest (more than 0 and at most 1000000 m)");
    EXPECT_EQ(
        complaint_after("height", "hieght"),
        "slope.toml:5:1: slope.height: is required: vertical height, toe to crest (more than 0 and at most 1000000 m)\n"
        "slope.toml:6:1: slope.hieght: is not a key of slope (did you mean height?)");
    EXPECT_EQ(complaint_after("[tension_crack]", "[tensioncrack]"),
              "slope.toml:13:2: tensioncrack: is not a key of a case of this model (did you mean tension_crack?)");
    EXPECT_EQ(complaint_after("[tension_crack]", "[columns]\n[tension_crack]"),
              "slope.toml:13:2: columns: is not a key of a case of this model; it belongs to stepped_base "
              "and stepped_path");
    EXPECT_EQ(complaint_after("friction_angle", "roughness_angle = \"5 deg\"\nfriction_angle"),
              "slope.toml:23:1: strength.roughness_angle: is not a key of strength of kind coulomb, but of kind "
              "stepped_surface or patton_bilinear");
    EXPECT_EQ(complaint_after("schema = 1\n", ""),
              "slope.toml:1:1: schema: is required: the version of the case format, schema = 1");
    EXPECT_EQ(complaint_after("schema = 1", "schema = 2"),
              "slope.toml:1:10: schema = 2: must be 1, the only version of the case format");
}

TEST(Reader, Choices) {
    EXPECT_EQ(complaint_after("\"coulomb\"", "\"coulom\""),
              "slope.toml:21:8: strength.kind = \"coulom\": must be coulomb, stepped_surface, patton_bilinear, "
              "barton_bandis or power_curve (did you mean coulomb?)");
    EXPECT_EQ(complaint_after("depth = \"40 m\"\n", ""),
              "slope.toml:13:1: tension_crack: needs one of distance_behind_crest, depth, base_below_crest or "
              "base_elevation: where the crack is");
    EXPECT_EQ(complaint_after("water_depth", "filled_ratio = 0.5\nwater_depth"),
              "slope.toml:25:1: water: takes only one of water_depth, filled_ratio or water_elevation: level above the "
              "bottom of the crack (given: water_depth or filled_ratio)");
    EXPECT_EQ(complaint_after("\"plane_failure\"", "\"plane_failures\""),
              "slope.toml:3:9: model = \"plane_failures\": must be " + choices(model_names()) +
                  " (did you mean plane_failure?)");
    EXPECT_EQ(complaint_after("\"plane_failure\"", "\"avalanche\""),
              "slope.toml:3:9: model = \"avalanche\": must be " + choices(model_names()));
}

TEST(Reader, AllProblemsTogetherInOrder) {
    std::string text = changed(example_text, "\"225 ft\"", "\"-3 m\"");
    text = changed(text, "\"26 kN/m3\"", "26");
    text = changed(text, "\"30 deg\"", "\"95 deg\"");
    try {
        parse_case(text, "slope.toml");
        FAIL();
    } catch (const CaseError& error) {
        ASSERT_EQ(error.problems().size(), 3U);
        EXPECT_EQ(error.problems()[0].key, "slope.height");
        EXPECT_EQ(error.problems()[1].key, "rock.unit_weight");
        EXPECT_EQ(error.problems()[2].key, "strength.friction_angle");
    }
}

TEST(Reader, WhatConcernsSeveralKeys) {
    EXPECT_EQ(complaint_after("kind = \"coulomb\"", "kind = \"stepped_surface\"\nroughness_angle = \"60 deg\""),
              "slope.toml:22:19: strength.roughness_angle = \"60 deg\": friction_angle + roughness_angle must not "
              "exceed 89.9 deg");
    EXPECT_EQ(complaint_after("water_depth = \"10 m\"", "water_elevation = \"425 ft\""),
              "slope.toml:28:19: water.water_elevation = \"425 ft\": is an elevation, so slope.toe_elevation is "
              "required too");
    const std::string required =
        std::string(example_text) + "[[required]]\nparameter = \"strength.cohesoin\"\nfactor_of_safety = 1\n";
    EXPECT_EQ(complaint(required),
              "slope.toml:30:13: required[1].parameter = \"strength.cohesoin\": is not an input of this case (did you "
              "mean strength.cohesion?)");
    const std::string together = changed(required, "strength.cohesoin\"", "strength.cohesion\"\nalso = [\"X\"]");
    EXPECT_NE(complaint(changed(together, "X", "strength.cohesion"))
                  .find("required[1].also = [ ... ]: \"strength.cohesion\" is named twice"),
              std::string::npos)
        << complaint(changed(together, "X", "strength.cohesion"));
    EXPECT_NE(complaint(changed(together, "X", "slope.height"))
                  .find("\"slope.height\" has another dimension than strength.cohesion"),
              std::string::npos);
    const std::string critical =
        std::string(example_text) +
        "[critical]\nfind = \"both\"\nunder = \"dry_slope\"\nlower_dip = \"50 deg\"\nupper_dip = \"40 deg\"\n";
    EXPECT_EQ(complaint(critical),
              "slope.toml:32:13: critical.lower_dip = \"50 deg\": bounds are reversed: must be less than "
              "critical.upper_dip");
}

TEST(Reader, SourcesAndExpectations) {
    EXPECT_EQ(complaint(std::string(example_text) + "[sources]\n\"slope.heigth\" = \"map\"\n"),
              "slope.toml:30:18: sources.slope.heigth = \"map\": names a key that the case does not have (did you mean "
              "slope.height?)");
    const std::string expect = std::string(example_text) + "[[expect]]\nquantity = \"crack_depth\"\n";
    EXPECT_EQ(complaint(expect + "value = 40\ntolerance = \"1 m\"\n"),
              "slope.toml:31:9: expect[1].value = 40: has no unit: a length is expected, e.g. \"10 m\"");
    EXPECT_EQ(complaint(expect + "value = \"40 m\"\n"),
              "slope.toml:29:1: expect[1]: needs a tolerance (absolute) or a relative_tolerance");
    EXPECT_EQ(
        complaint(expect + "value = \"40 m\"\ntolerance = \"1 m\"\nwith = { \"slope.hight\" = \"1 m\" }\n"),
        "slope.toml:33:10: expect[1].with.slope.hight: is not an input of this case (did you mean slope.height?)");
    const CaseFile word =
        parse_case(std::string(example_text) + "[[expect]]\nquantity = \"outcome\"\nvalue = \"slides\"\n", "word");
    EXPECT_TRUE(word.expectations.front().is_word());
    EXPECT_FALSE(word.expectations.front().dimension);
}

TEST(Reader, Settings) {
    const auto height = [](const std::string& setting) {
        return plane_failure(parse_case(example_text, "slope.toml", {parse_setting(setting)})).slope.height;
    };
    EXPECT_EQ(height("slope.height=\"40 m\""), 40);
    EXPECT_EQ(height("slope.height=40 m"), 40);
    EXPECT_EQ(height(" slope.height = 40 m "), 40);
    const CaseFile filled = parse_case(example_text, "slope.toml", {{"water.filled_ratio", "0.5"}});
    EXPECT_EQ(std::get<FilledRatio<>>(std::get<CrackAndBaseWater<>>(plane_failure(filled).water).level).filled_ratio,
              0.5);
    EXPECT_EQ(complaint(example_text, {{"slope.height", "-3 m"}}),
              "--set: slope.height = \"-3 m\": must be more than 0 and at most 1000000 m");
    EXPECT_EQ(complaint(example_text, {{"slope.hight", "3 m"}}),
              "--set: slope.hight: is not a key of slope (did you mean height?)");
    EXPECT_EQ(complaint(example_text, {{"bolt[1].force", "3 kN/m"}}),
              "--set: bolt[1].force = 3 kN/m: has no element 1 in the case");
    EXPECT_EQ(complaint(example_text, {{"slope..height", "3 m"}}),
              "--set: slope..height = 3 m: is not a key such as slope.height or bolt[1].force");
    EXPECT_THROW(parse_setting("slope.height"), CaseError);
}

TEST(Reader, TextThatIsNoCase) {
    EXPECT_EQ(complaint("schema = \n").substr(0, 13), "slope.toml:1:");
    EXPECT_EQ(complaint("title = \"\xFF\"\n").substr(0, 13), "slope.toml:1:");
    EXPECT_NE(complaint(std::string(example_text) + "[slope]\n").find("slope.toml:29:"), std::string::npos);
    EXPECT_NE(complaint("a = " + std::string(100'000, '[')).find("nested more than 32 levels"), std::string::npos);
    std::string dotted = "[";
    for (int count = 0; count < 100'000; ++count) {
        dotted += "a.";
    }
    EXPECT_EQ(complaint(dotted + "a]\n"), "slope.toml:1:67: is nested more than 32 levels deep");
    EXPECT_EQ(complaint(std::string(largest_case_bytes + 1, ' ')),
              "slope.toml: is larger than 4 MiB, the limit for a case file");
    std::string crowd = "a = [";
    for (int count = 0; count < 300'000; ++count) {
        crowd += "1,";
    }
    EXPECT_NE(complaint(crowd + "]\n").find("holds more than 200000 values"), std::string::npos);
    std::string unknown(example_text);
    for (int count = 0; count < 1000; ++count) {
        unknown += "key_" + std::to_string(count) + " = 1\n";
    }
    EXPECT_NE(complaint(unknown).find("\nand 900 more"), std::string::npos);
}

// The whole section was once searched for each key, to see if it belongs to a kind that --set replaced: 24 s.
TEST(Reader, TimeGrowsWithTheKeysThatAreNone) {
    std::string unknown;
    for (int count = 0; count < 150'000; ++count) {
        unknown += "key_" + std::to_string(count) + " = 1\n";
    }
    unknown += example_text;
    const std::clock_t begin = std::clock();
    EXPECT_NE(complaint(unknown).find("\nand 149900 more"), std::string::npos);
    // It takes 1 s in a release build, and some four times that with sanitizers.
    EXPECT_LT(static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC, 10);
}

TEST(Reader, FilesThatCannotBeRead) {
    const auto message = [](const std::filesystem::path& path) {
        try {
            read_case(path);
        } catch (const CaseError& error) {
            return std::string(error.what());
        }
        return std::string("no complaint");
    };
    const std::filesystem::path folder = std::filesystem::temp_directory_path() / "delabole_reader_test";
    std::filesystem::create_directories(folder);
    const std::filesystem::path huge = folder / "huge.toml";
    std::ofstream(huge).put(' ');
    std::filesystem::resize_file(huge, std::uintmax_t{1} << 33U);
    EXPECT_EQ(message(folder / "none.toml"), (folder / "none.toml").string() + ": there is no such file");
    EXPECT_EQ(message(folder), folder.string() + ": is a folder, not a case file");
    EXPECT_EQ(message("/dev/zero"), "/dev/zero: is not an ordinary file");
    EXPECT_EQ(message(huge), huge.string() + ": is larger than 4 MiB, the limit for a case file");
    std::filesystem::remove_all(folder);
}

TEST(Spelling, Distance) {
    EXPECT_EQ(edit_distance("height", "height"), 0U);
    EXPECT_EQ(edit_distance("hieght", "height"), 1U);
    EXPECT_EQ(edit_distance("", "abc"), 3U);
    EXPECT_EQ(nearest_word("friction_angel", {"cohesion", "friction_angle"}), "friction_angle");
    EXPECT_EQ(nearest_word("cohesion", {"strength.cohesion"}), "strength.cohesion");
    EXPECT_EQ(nearest_word("xyz", {"dip"}), "");
}

}  // namespace
}  // namespace delabole
