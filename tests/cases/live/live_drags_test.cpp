// Points of a section that are dragged, and the inputs that follow.
#include "tests/cases/live/live_case.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace delabole {
namespace {

// The uphill top corner of each block moves to where the pointer is.
TEST(LiveDrags, BlocksOfARowAreDragged) {
    for (const auto& [name, count] :
         std::array<std::pair<const char*, std::size_t>, 3>{{{"starting/flexural_toppling.toml", 4},
                                                             {"starting/block_row.toml", 3},
                                                             {"stepped_base/appendix_a.toml", 8}}}) {
        const LiveSession session = session_of(name);
        const Json before = session.answer(Json::object());
        ASSERT_GE(before["handles"].size(), count) << name;
        for (const Json& handle : before["handles"]) {
            if (handle["name"] == "toe") {
                continue;  // stays the origin, see TheToeLeavesTheCrest
            }
            // The handle lies within the picture, where the corner is drawn.
            const double x = handle["at"][0];
            const double y = handle["at"][1];
            const Json& figure = before["figures"][0];
            if (handle["name"] != "base") {
                bool drawn = false;
                for (const Json& series : figure["series"]) {
                    const Json& points = series.contains("points") ? series["points"] : series["outline"];
                    for (const Json& point : points.is_array() ? points : Json::array()) {
                        drawn = drawn || (point.is_array() && point[0].is_number() && point[1].is_number() &&
                                          std::hypot(point[0].get<double>() - x, point[1].get<double>() - y) < 1e-6);
                    }
                }
                EXPECT_TRUE(drawn) << name << ' ' << handle;
            }
            const Json answer = session.drag({{"handle", handle["name"]}, {"to", {x + 0.02, y + 0.03}}});
            const Json& moved =
                *std::ranges::find(answer["handles"], handle["name"], [](const Json& one) { return one["name"]; });
            EXPECT_LT(std::hypot(moved["at"][0].get<double>() - x - 0.02, moved["at"][1].get<double>() - y - 0.03),
                      handle["name"] == "base" ? 0.036 : 1e-3)
                << name << ' ' << handle;
        }
    }
}

// The picture is shifted by as much as the toe goes, so that the crest stays where it was seen.
TEST(LiveDrags, TheToeLeavesTheCrest) {
    const LiveSession session = session_of("starting/plane_failure.toml");
    const auto crest = [](const Json& answer) {
        return (*std::ranges::find(answer["handles"], "crest", [](const Json& one) { return one["name"]; }))["at"];
    };
    const Json before = crest(session.answer(Json::object()));
    const Json after = session.drag({{"handle", "toe"}, {"to", {0.7, -0.4}}});
    EXPECT_NEAR(crest(after)[0], before[0].get<double>() - 0.7, 1e-9);
    EXPECT_NEAR(crest(after)[1], before[1].get<double>() + 0.4, 1e-9);
    EXPECT_EQ(after["values"].size(), 2U);
    const Json above = session.drag({{"handle", "toe"}, {"to", {0.0, 50.0}}});  // the crest lies 12 m high
    EXPECT_EQ(crest(above), before);
}

// Dips of bases and joints follow the ends of their lines, bolts their heads and ends.
TEST(LiveDrags, LinesThatHaveADipAndBoltsAreDragged) {
    using Names = std::vector<std::string>;
    for (const auto& [name, lines] : std::array<std::pair<const char*, Names>, 3>{
             {{"starting/stepped_base.toml", {"base", "joints"}},
              {"starting/stepped_path.toml", {"steps", "risers", "columns"}},
              {"starting/jointed_slope.toml", {"joint set bedding", "joint set columns"}}}}) {
        const LiveSession session = session_of(name);
        Names found;
        const Json before = session.answer(Json::object());
        for (const Json& handle : before["handles"]) {
            if (!handle.contains("from")) {
                continue;
            }
            found.push_back(handle["name"]);
            const double x = handle["at"][0].get<double>() + 0.3;
            const double y = handle["at"][1].get<double>() + 0.2;
            const Json answer = session.drag({{"handle", handle["name"]}, {"to", {x, y}}});
            const auto dip = answer["values"][handle["inputs"][0]].get<double>();
            const double slope = (y - handle["from"][1].get<double>()) / (x - handle["from"][0].get<double>());
            // The joints of a stepped base dip into the slope if their dip is positive.
            EXPECT_NEAR(std::tan(degrees(dip)), handle["name"] == "joints" ? -slope : slope, 1e-5) << handle["name"];
        }
        EXPECT_EQ(found, lines) << name;
    }
    for (const char* const name :
         {"starting/support.toml", "stepped_base/bolted_columns.toml", "starting/single_block.toml"}) {
        const LiveSession session = session_of(name);
        int followed = 0;
        const Json before = session.answer(Json::object());
        for (const Json& handle : before["handles"]) {
            const std::string input = handle["inputs"].back();
            if (handle["inputs"].size() == 2 && (input.starts_with("support[") || input.starts_with("block."))) {
                const Json to{handle["at"][0].get<double>() + 0.2, handle["at"][1].get<double>() - 0.1};
                const Json answer = session.drag({{"handle", handle["name"]}, {"to", to}});
                const Json& moved =
                    *std::ranges::find(answer["handles"], handle["name"], [](const Json& one) { return one["name"]; });
                EXPECT_NEAR(moved["at"][0], to[0], 1e-5) << name << handle;
                EXPECT_NEAR(moved["at"][1], to[1], 1e-5) << name << handle;
                ++followed;
            }
        }
        EXPECT_EQ(followed, 1) << name;
    }
}

TEST(LiveDrags, JointSetsAndOutlineOfASectionAreDragged) {
    const LiveSession session = session_of("starting/jointed_slope.toml");
    const Json before = session.answer(Json::object());
    std::vector<std::string> sets;
    for (const Json& handle : before["handles"]) {
        const std::string name = handle["name"];
        const double x = handle["at"][0];
        const double y = handle["at"][1];
        const Json answer = session.drag({{"handle", name}, {"to", {x - 0.2, y + 0.1}}});
        EXPECT_EQ(answer["values"].size(), handle["inputs"].size()) << name;
        if (name.starts_with("joint set ")) {
            sets.push_back(name);
            const auto dip = answer["values"][handle["inputs"][0]].get<double>();
            // The line goes from the middle of the outline, 10 m across and 6 m up, towards the pointer.
            EXPECT_NEAR(std::tan(degrees(dip)), (y + 0.1 - 6) / (x - 0.2 - 10), 1e-6) << name;
        }
    }
    EXPECT_EQ(sets, (std::vector<std::string>{"joint set bedding", "joint set columns"}));
}

TEST(LiveDrags, EveryPointOfASectionIsDragged) {
    std::string text = text_of("starting/full/plane_failure.toml");
    for (const auto& [key, further] : std::array<std::array<std::string, 2>, 2>{
             {{"upper_surface_dip", "toe_elevation = \"100 m\"\nbench = { width = \"2 m\", dip = \"3 deg\" }\n"},
              {"dip = \"35 deg\"", "daylight_height = \"1 m\"\n"}}}) {
        text.insert(text.find(key), further);
    }
    const LiveSession session(parse_case(text, "slope.toml"), text, [](const std::vector<std::string>&) { return ""; });
    std::vector<std::string> names;
    const Json before = session.answer(Json::object());
    for (const Json& handle : before["handles"]) {
        names.push_back(handle["name"]);
        const double x = handle["at"][0].get<double>() + 0.1;
        const double y = handle["at"][1].get<double>() + 0.1;
        const Json answer = session.drag({{"handle", handle["name"]}, {"to", {x, y}}});
        const Json& moved =
            *std::ranges::find(answer["handles"], handle["name"], [](const Json& one) { return one["name"]; });
        // The pointer moves by 0.14 m. A point that cannot leave its line follows to where the line comes nearest, at
        // most 0.1 m away for a slanting, level or upright line.
        EXPECT_LT(std::hypot(moved["at"][0].get<double>() - x, moved["at"][1].get<double>() - y), 0.1 + 1e-6)
            << handle["name"];
    }
    EXPECT_EQ(names, (std::vector<std::string>{"toe", "crest", "end of the bench", "failure plane",
                                               "where the plane daylights", "tension crack", "water level"}));
}

// A pole that is dragged across north continues on the other side.
TEST(LiveDrags, PolesOfAStereonetAreDragged) {
    const LiveSession session = session_of("starting/kinematics.toml");
    const Json answer = session.answer(Json::object());
    for (const Json& handle : answer["handles"]) {
        for (const double east : {-0.3, 0.3}) {
            const Json dragged = session.drag({{"handle", handle["name"]}, {"to", {east, -0.4}}});
            const Json& moved = *std::ranges::find_if(dragged["handles"],
                                                      [&](const Json& one) { return one["name"] == handle["name"]; });
            EXPECT_EQ(dragged["values"].size(), handle["inputs"].size());
            if (handle["inputs"].size() == 2) {
                EXPECT_NEAR(moved["at"][0], east, 1e-5) << handle["name"];  // a few steps of Gauss and Newton
                EXPECT_NEAR(moved["at"][1], -0.4, 1e-5) << handle["name"];
            }
        }
    }
    EXPECT_GT(answer["handles"].size(), 3U);
}

}  // namespace
}  // namespace delabole
