#include "cases/program/reader/data_table.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace delabole {
namespace {

enum class Verdict { no, yes };

constexpr std::array<std::string_view, 2> enum_names(Verdict) {
    return {"no", "yes"};
}

struct Row {
    std::string name;
    double slope_angle;
    std::optional<double> height;
    double height_ratio;
    Verdict verdict;
    static constexpr auto fields() {
        return FieldTable{
            section("name", &Row::name, "its name"),
            number("slope_angle", &Row::slope_angle, Dimension::angle, left_open(0, degrees(90)), "angle"),
            number("height", &Row::height, Dimension::length, more_than(0), "height; absent: unknown"),
            number("height_ratio", &Row::height_ratio, Dimension::ratio, at_least(0), "height over spacing"),
            section("verdict", &Row::verdict, "what happened")};
    }
};

constexpr std::string_view header = "name,slope_angle_deg,height_in,height_ratio,verdict\n";

std::vector<Row> parse(const std::string& rows) {
    return parse_table<Row>(std::string(header) + rows, "slopes.csv");
}

std::string complaint_of_table(const std::string& text) {
    try {
        parse_table<Row>(text, "slopes.csv");
    } catch (const CaseError& error) {
        return error.what();
    }
    return "no complaint";
}

std::string complaint_of_row(const std::string& row) {
    return complaint_of_table(std::string(header) + row);
}

TEST(DataTable, ReadsEveryKindOfCell) {
    const std::vector<Row> rows = parse("# a comment\n1(R),60,12,12,yes\n\n\"a, \"\"b\"\"\",80.5,,0.5,no\n");
    ASSERT_EQ(rows.size(), 2U);
    EXPECT_EQ(rows[0].name, "1(R)");
    EXPECT_EQ(rows[0].slope_angle, degrees(60));
    ASSERT_TRUE(rows[0].height);
    // The 12 inches are rounded once.
    EXPECT_NEAR(*rows[0].height, 0.3048, 1e-15);
    EXPECT_EQ(rows[0].height_ratio, 12);
    EXPECT_EQ(rows[0].verdict, Verdict::yes);
    EXPECT_EQ(rows[1].name, "a, \"b\"");
    EXPECT_FALSE(rows[1].height);
    EXPECT_EQ(rows[1].verdict, Verdict::no);
}

TEST(DataTable, OrderOfColumnsUnitsAndLineEndsAreFree) {
    const std::vector<Row> rows =
        parse_table<Row>("\xEF\xBB\xBFverdict,height_ratio,slope_angle_rad,name\r\nyes,2,1.5,x\r\n", "slopes.csv");
    ASSERT_EQ(rows.size(), 1U);
    EXPECT_EQ(rows[0].slope_angle, 1.5);
    EXPECT_EQ(rows[0].name, "x");
    EXPECT_FALSE(rows[0].height);
}

TEST(DataTable, ComplaintsNameLineColumnAndValue) {
    EXPECT_EQ(complaint_of_row("a,60,12,12,yes\nb,95,12,12,yes\n"),
              "slopes.csv:3:3: slope_angle = \"95 deg\": must be more than 0 and at most 90 deg");
    // Columns count characters, not bytes.
    EXPECT_TRUE(complaint_of_row("Größe,95,12,12,yes\n").starts_with("slopes.csv:2:7: slope_angle"))
        << complaint_of_row("Größe,95,12,12,yes\n");
    EXPECT_TRUE(complaint_of_row("\"a, b\",95,12,12,yes\n").starts_with("slopes.csv:2:8: slope_angle"))
        << complaint_of_row("\"a, b\",95,12,12,yes\n");
    EXPECT_EQ(complaint_of_row("a,60,12,12,yess\n"),
              "slopes.csv:2:12: verdict = \"yess\": must be no or yes (did you mean yes?)");
    EXPECT_TRUE(complaint_of_row("a,sixty,12,12,yes\n")
                    .starts_with("slopes.csv:2:3: slope_angle = \"sixty deg\": is not a number"))
        << complaint_of_row("a,sixty,12,12,yes\n");
    EXPECT_TRUE(complaint_of_row("a,60,12,many,yes\n").starts_with("slopes.csv:2:9: height_ratio = \"many\": "))
        << complaint_of_row("a,60,12,many,yes\n");
    EXPECT_TRUE(complaint_of_row("a,,12,12,yes\n").starts_with("slopes.csv:2:1: slope_angle: is required"))
        << complaint_of_row("a,,12,12,yes\n");
}

TEST(DataTable, AllComplaintsAtOnceInTheOrderOfTheFile) {
    const std::string text = complaint_of_row("a,60,-1,12,yes\nb,60,12,12\nc,60,12,nan,maybe\n");
    const std::size_t first = text.find("slopes.csv:2:6: height");
    const std::size_t second = text.find("slopes.csv:3:1: has 4 cells where the header has 5");
    const std::size_t third = text.find("slopes.csv:4:9: height_ratio");
    const std::size_t fourth = text.find("slopes.csv:4:13: verdict");
    EXPECT_LT(first, second) << text;
    EXPECT_LT(second, third) << text;
    EXPECT_LT(third, fourth) << text;
    EXPECT_NE(fourth, std::string::npos) << text;
}

TEST(DataTable, ComplainsAboutColumns) {
    EXPECT_TRUE(complaint_of_table("name,slope_angle_deg,height_ratio,verdct\n")
                    .starts_with("slopes.csv:1:35: verdct: is not a column of this table (did you mean verdict?)"));
    EXPECT_TRUE(complaint_of_table("name,slope_angle,height_ratio,verdict\n")
                    .starts_with("slopes.csv:1:6: slope_angle: has no unit, e.g. slope_angle_deg"));
    EXPECT_TRUE(complaint_of_table("name,slope_angle_kPa,height_ratio,verdict\n")
                    .starts_with("slopes.csv:1:6: slope_angle_kPa:"));
    EXPECT_TRUE(complaint_of_table("name,slope_angle_deg,height_ratio,height_ratio,verdict\n")
                    .starts_with("slopes.csv:1:35: height_ratio: is given twice"));
    EXPECT_EQ(complaint_of_table("name,slope_angle_deg,verdict\n"),
              "slopes.csv:1:1: height_ratio: is missing: a column height_ratio");
    EXPECT_EQ(complaint_of_table("# nothing but this\n"),
              "slopes.csv:1:1: holds no table: its first line names the columns");
}

// A case from somebody else may name a private file, of which no content may be shown.
TEST(DataTable, ShowsNothingOfAFileThatIsNoTable) {
    EXPECT_EQ(complaint_of_table("root:secret:1,2\nmore\n"),
              "slopes.csv:1:1: names none of the columns of this table: name, slope_angle_deg, height_m, height_ratio, "
              "verdict");
}

TEST(DataTable, ComplainsAboutQuotes) {
    EXPECT_EQ(complaint_of_row("\"a,60,12,12,yes\n"),
              "slopes.csv:2:1: quotes are opened here and not closed on this line");
    EXPECT_EQ(complaint_of_row("\"a\"b,60,12,12,yes\n"), "slopes.csv:2:4: a comma has to follow the closing quotes");
}

// Any table brings back either an answer or a complaint.
TEST(DataTable, AnyTextIsReadOrRefused) {
    const std::string whole = std::string(header) + "\"a, \"\"b\"\"\",80.5,,0.5,no\n#\n,,,,\n";
    for (std::size_t length = 0; length <= whole.size(); ++length) {
        for (const char replaced : {'"', ',', '\n', '\0', '\xFF', '-'}) {
            std::string text = whole.substr(0, length);
            if (!text.empty()) {
                text[length / 2] = replaced;
            }
            EXPECT_FALSE(complaint_of_table(text).empty());
        }
    }
}

}  // namespace
}  // namespace delabole
