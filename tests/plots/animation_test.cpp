// Tests the animation of a report: its data, and the drawing that stands there without its script.
#include "plots/report/animation.hpp"

#include "plots/report/report.hpp"
#include "samples.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

namespace delabole {
namespace {

using Json = nlohmann::json;

constexpr double degree = std::numbers::pi / 180;

std::size_t count(const std::string& text, const std::string& word) {
    std::size_t found = 0;
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + word.size())) {
        ++found;
    }
    return found;
}

std::string between(const std::string& text, const std::string& opening, const std::string& closing) {
    const std::size_t begin = text.find(opening);
    if (begin == std::string::npos) {
        return {};
    }
    return text.substr(begin + opening.size(), text.find(closing, begin + opening.size()) - begin - opening.size());
}

Json data_of(const std::string& html) {
    return Json::parse(between(html, "<script type=\"application/json\">", "</script>"));
}

// Decodes the numbers, each of which is stored as its difference from that of the frame before.
std::vector<int> numbers_of(const std::string& text, std::size_t stride) {
    const std::string alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::vector<int> result;
    unsigned value = 0;
    unsigned shift = 0;
    for (const char letter : text) {
        const auto digit = static_cast<unsigned>(alphabet.find(letter));
        value |= (digit & 31U) << shift;
        shift += 5;
        if ((digit & 32U) == 0) {
            const int number = static_cast<int>(value >> 1U);
            result.push_back((value & 1U) != 0 ? -number : number);
            if (result.size() > stride) {
                result.back() += result[result.size() - 1 - stride];
            }
            value = shift = 0;
        }
    }
    return result;
}

// Returns x, y and angle of each moving block, frame after frame.
std::vector<int> poses_of(const Json& data) {
    const std::size_t stride = 3 * data["moving"].size();
    std::vector<int> poses = numbers_of(data["poses"].get<std::string>(), stride);
    EXPECT_EQ(poses.size(), stride * data["times"].size());
    return poses;
}

// Returns the transform of each block's group in the drawing.
std::vector<std::string> transforms(const std::string& html) {
    std::vector<std::string> result;
    const std::string opening = "<g transform=\"";
    for (std::size_t at = html.find(opening); at != std::string::npos; at = html.find(opening, at)) {
        at += opening.size();
        result.push_back(html.substr(at, html.find('"', at) - at));
    }
    return result;
}

AnimatedBlock square(double x, double y, std::string label = {}, bool fixed = false) {
    return {{{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}}, std::move(label), fixed};
}

TEST(Animation, PosesComeBack) {
    const BlockAnimation animation = samples::animation();
    const std::string html = animation_html(animation);
    const Json data = data_of(html);
    const std::size_t frames = animation.frames.size();
    ASSERT_EQ(data["times"].size(), frames);
    ASSERT_EQ(data["tilts"].size(), frames);
    const std::size_t moving = data["moving"].size();
    ASSERT_EQ(data["at"].size(), 2 * moving);
    ASSERT_EQ(data["levels"].get<std::string>().size(), moving * frames);
    const std::vector<int> poses = poses_of(data);
    // px per metre, from two blocks whose centroids the drawing places.
    const double scale = (data["at"][2].get<double>() - data["at"][0].get<double>()) /
                         ((animation.blocks[1].outline[0] + animation.blocks[1].outline[2] -
                           animation.blocks[0].outline[0] - animation.blocks[0].outline[2])
                              .x() /
                          2);
    const double pixel = data["length"].get<double>();
    ASSERT_GT(pixel, 0);
    for (std::size_t frame = 0; frame < frames; ++frame) {
        EXPECT_NEAR(data["times"][frame].get<double>(), animation.frames[frame].time, 1e-6);
        EXPECT_NEAR(data["tilts"][frame].get<double>(), animation.frames[frame].tilt / degree, 1e-4);
        for (std::size_t index = 0; index < moving; ++index) {
            const BlockPose& pose = animation.frames[frame].poses[data["moving"][index].get<std::size_t>()];
            const int* back = &poses[3 * (moving * frame + index)];
            // Numbers are kept to half a unit, and places are given to 0.01 px.
            EXPECT_NEAR(back[0] * pixel, pose.displacement.x() * scale, 0.51 * pixel + 0.02);
            EXPECT_NEAR(back[1] * pixel, pose.displacement.y() * scale, 0.51 * pixel + 0.02);
            EXPECT_NEAR(back[2] * data["angle"].get<double>() * degree, pose.rotation, 0.51e-4);
        }
    }
}

TEST(Animation, TheDrawingIsTheLastFrame) {
    const BlockAnimation animation = samples::animation();
    const std::string html = animation_html(animation);
    const Json data = data_of(html);
    const std::vector<std::string> drawn = transforms(html);
    ASSERT_EQ(drawn.size(), animation.blocks.size());
    const std::vector<int> poses = poses_of(data);
    const std::size_t moving = data["moving"].size();
    ASSERT_GT(moving, 1U);
    for (std::size_t index = 0; index < moving; ++index) {
        const int* pose = &poses[poses.size() - 3 * (moving - index)];
        double x = 0;
        double y = 0;
        double turn = 0;
        const std::string& text = drawn[data["moving"][index].get<std::size_t>()];
        ASSERT_EQ(std::sscanf(text.c_str(), "translate(%lf %lf) rotate(%lf)", &x, &y, &turn), 3) << text;
        const double unit = data["length"].get<double>();
        // Two values are rounded to 0.01 px.
        EXPECT_NEAR(x, data["at"][2 * index].get<double>() + pose[0] * unit, 0.011);
        EXPECT_NEAR(y, data["at"][2 * index + 1].get<double>() - pose[1] * unit, 0.011);
        EXPECT_NEAR(turn, -pose[2] * data["angle"].get<double>(), 6e-4);
    }
    EXPECT_NE(html.find("time 2.95 s, tilt 21.8°, frame 60 of 60"), std::string::npos);
    BlockAnimation level = animation;
    for (AnimationFrame& frame : level.frames) {
        frame.tilt = 0;
    }
    EXPECT_NE(animation_html(level).find("time 2.95 s, frame 60 of 60"), std::string::npos) << "where nothing tilts";
    EXPECT_NE(html.find("Outcome: collapse"), std::string::npos);
    EXPECT_NE(html.find("class=\"controls\" hidden>"), std::string::npos);
    EXPECT_EQ(count(html, "<path d="), animation.blocks.size());
    EXPECT_EQ(count(html, ">F</text>"), 1U);
}

// A crack moves with its block; the page shows those of the last frame, the script the others.
TEST(Animation, CracksAppearWithTheirFrame) {
    BlockAnimation animation{.blocks = {square(0, 0), square(1, 0)}};
    animation.blocks[1].cracks = {{{1, 0}, {1, 1}, 1}, {{2, 0}, {2, 1}, 2}};
    animation.frames = {{0, 0, {{}, {}}}, {1, 0, {{}, {}}}};
    const std::string html = animation_html(animation);
    ASSERT_EQ(count(html, "class=\"crack\""), 2U);
    const std::string second = html.substr(html.rfind("<g transform"));
    EXPECT_EQ(count(second, "class=\"crack\""), 2U);
    EXPECT_EQ(count(second, "data-from=\"1\" d="), 1U);
    // The second crack is not yet there in the last frame.
    EXPECT_EQ(count(between(html, "data-from=\"2\"", ">"), "display=\"none\""), 1U);
    EXPECT_EQ(count(between(html, "data-from=\"1\"", ">"), "display=\"none\""), 0U);
}

// The page shows the last frame's bars with their forces, the data have those of all.
TEST(Animation, BarsHaveTheirForceInEachFrame) {
    BlockAnimation animation{.blocks = {square(0, 0), square(4, 0, "", true)}, .bar_unit = "kN/m"};
    animation.frames = {{0, 0, {{}, {}}, {{{0, 0.5}, {4.5, 0.5}, 10}, {{0, 0.8}, {4.5, 0.8}, 0}}},
                        {1, 0, {{}, {}}, {{{-1, 0.5}, {4.5, 0.5}, 25, true}, {{0, 0.8}, {4.5, 0.8}, 0, false, false}}}};
    const std::string html = animation_html(animation);
    EXPECT_EQ(count(html, "class=\"bar yielded\""), 1U);
    EXPECT_EQ(count(html, ">25 kN/m, yielded</text>"), 1U);
    EXPECT_EQ(count(between(html, "class=\"bar\"", ">"), "display=\"none\""), 1U) << "the one that is gone";
    const Json data = data_of(html);
    const std::vector<int> states = numbers_of(data["bars"].get<std::string>(), 12);
    ASSERT_EQ(states.size(), 24U);
    EXPECT_NEAR(states[4] * data["force"].get<double>(), 10, 0.5 * 25 / 10'000);  // ten thousandths of the greatest
    EXPECT_EQ(states[5], 0);
    EXPECT_NEAR(states[16] * data["force"].get<double>(), 25, 1e-6);  // digits of the unit
    EXPECT_EQ(states[17], 1);
    EXPECT_EQ(states[23], 2);
    EXPECT_LT(states[12], states[0]) << "its head has moved to the left";
}

TEST(Animation, IsTurnedUntilGravityPointsDown) {
    BlockAnimation animation{.blocks = {square(-3, -1, "", true), square(-3, 0)}};
    animation.frames = {{0, 30 * degree, {{}, {}}}};
    // Anticlockwise is negative in SVG: the side at -x comes down.
    EXPECT_NE(animation_html(animation).find("transform=\"rotate(-30 "), std::string::npos);
}

TEST(Animation, EscapesEveryText) {
    const std::string bad = "</script><b>&\"'";
    BlockAnimation animation{.blocks = {square(0, 0, bad)},
                             .frames = {{0, 0, {{}}}, {1, 0, {{{1, 0}, 0, 1}}}},
                             .outcome = bad,
                             .colour = bad,
                             .unit = bad,
                             .caption = bad};
    animation.blocks[0].outline = {{0, 0}, {99, 0}, {99, 9}, {0, 9}};  // room for the label
    const std::string page = report_page({.title = "title", .subtitle = "", .blocks = {animation}});
    EXPECT_EQ(page.find("<b>&"), std::string::npos);
    // The text occurs as label, colour, unit, outcome (twice: name and text of the drawing) and caption.
    EXPECT_EQ(count(page, "&lt;/script&gt;&lt;b&gt;&amp;&quot;&#39;"), 6U);
    EXPECT_EQ(count(page, "<script"), 2U);
    EXPECT_EQ(count(page, "</script>"), 2U);
}

TEST(Animation, PagesWithoutOneRunNothing) {
    const std::string page = report_page({.title = "title", .subtitle = "", .blocks = {Paragraph{"text"}}});
    EXPECT_EQ(page.find("script"), std::string::npos);
    EXPECT_EQ(page.find(".animation"), std::string::npos);
}

TEST(Animation, IsNumberedAmongTheFiguresAndSharesTheScript) {
    const FigureFiles missing{.status = FigureStatus::gnuplot_missing, .message = "none"};
    const std::string page =
        report_page({.title = "title",
                     .subtitle = "",
                     .blocks = {FigureInReport{missing, "one"}, samples::animation(), samples::animation()}});
    EXPECT_EQ(count(page, "<figure>"), 3U);
    EXPECT_NE(page.find("<b>Figure 3.</b> Columns"), std::string::npos);
    EXPECT_EQ(count(page, "<script>"), 1U);
    EXPECT_LT(page.rfind("application/json"), page.find("<script>"));
    for (const char* outside : {"http:", "https:", "src=", "@import", "url("}) {
        EXPECT_EQ(page.find(outside), std::string::npos) << outside;
    }
}

TEST(Animation, WithNothingToShowSaysSo) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const BlockAnimation no_frames{.blocks = {square(0, 0)}};
    const BlockAnimation no_blocks{.frames = {{0, 0, {}}}};
    const BlockAnimation nowhere{.blocks = {square(0, 0)}, .frames = {{0, 0, {{{nan, 0}}}}}};
    const BlockAnimation point{.blocks = {{{{1, 1}, {1, 1}, {1, 1}}}}, .frames = {{0, 0, {{}}}}};
    for (const BlockAnimation& animation : {no_frames, no_blocks, nowhere, point, BlockAnimation{}}) {
        const std::string html = animation_html(animation);
        EXPECT_NE(html.find("Animation missing"), std::string::npos);
        EXPECT_EQ(html.find("<script"), std::string::npos);
    }
}

// A run that diverged leaves such numbers.
TEST(Animation, WhatIsNotFiniteIsNotShown) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinite = std::numeric_limits<double>::infinity();
    BlockAnimation animation{.blocks = {square(0, 0, "1"), square(2, 0, "2"), square(4, 0, "3"), square(6, nan, "4")},
                             .frames = {},
                             .outcome = "",
                             .colour = "speed",
                             .unit = "m/s",
                             .caption = ""};
    animation.frames = {{0, 0, {{}, {}, {}, {}}},
                        {0.5, nan, {{{nan, 0}}, {{0, 0}, infinite}, {{1e300, -1e300}, 1e300, infinite}, {}}},
                        {infinite, infinite, {{{0, 0}, 0, -1}, {{1, 0}, 0, nan}, {{1, 0}, 0, 2}}}};
    const std::string html = animation_html(animation);
    const std::string data = between(html, "<script type=\"application/json\">", "</script>");
    EXPECT_TRUE(Json::accept(data));
    for (const char* word : {"nan", "NaN", "inf\"", "inf,", "inf ", "e+"}) {
        EXPECT_EQ(data.find(word), std::string::npos) << word;
        EXPECT_EQ(between(html, "<svg", "</svg>").find(word), std::string::npos) << word;
    }
    EXPECT_EQ(data_of(html)["levels"], std::string("000") + "--0" + "00f");
}

TEST(Animation, RemovedBlocksVanish) {
    BlockAnimation animation{.blocks = {square(0, 0), square(1, 0), square(2, 0)}};
    animation.frames = {
        {0, 0, {{}, {}, {}}}, {1, 0, {{}, {{0, 0}, 0, 0, false}, {}}}, {2, 0, {{}, {{0, 0}, 0, 0, false}}}};
    const std::string html = animation_html(animation);
    const Json data = data_of(html);
    EXPECT_EQ(data["moving"], Json::parse("[1,2]"));
    EXPECT_EQ(data["levels"], "00-0--");
    EXPECT_EQ(count(html, "display=\"none\""), 2U);
}

TEST(Animation, OneThatFliesOffDoesNotMakeTheOthersSpecks) {
    BlockAnimation animation{.blocks = {square(0, 0), square(1, 0)}};
    animation.frames = {{0, 0, {{}, {}}}, {1, 0, {{{-1e6, -1e6}, 50}, {}}}};
    const std::string html = animation_html(animation);
    // Two squares side by side have half their size around them and a margin: each is more than 100 px wide.
    double x = 0;
    ASSERT_EQ(std::sscanf(between(html, "<path d=\"", "\"").c_str(), "M%lf", &x), 1);
    EXPECT_LT(x, -50);
}

BlockAnimation busy(std::size_t blocks, std::size_t frames, std::size_t at_rest) {
    BlockAnimation animation;
    const std::size_t columns = 40;
    for (std::size_t block = 0; block < blocks; ++block) {
        const std::size_t row = block / columns;
        animation.blocks.push_back(square(static_cast<double>(block % columns), static_cast<double>(row)));
    }
    for (std::size_t index = 0; index < frames; ++index) {
        const double share = static_cast<double>(index) / static_cast<double>(frames);
        AnimationFrame frame{static_cast<double>(index) * 0.01, 0.3, {}};
        for (std::size_t block = 0; block < blocks; ++block) {
            const double way = block < at_rest ? 0 : share * share * (1 + static_cast<double>(block % 7));
            frame.poses.push_back({{-way, -way / 2}, way / 3, way});
        }
        animation.frames.push_back(std::move(frame));
    }
    return animation;
}

TEST(Animation, IsSmall) {
    EXPECT_LT(animation_html(busy(8, 300, 0)).size(), 100'000U);
    const std::size_t all_move = animation_html(busy(1000, 200, 0)).size();
    EXPECT_LT(all_move, 2'500'000U);
    // Blocks that never move are only in the drawing.
    EXPECT_LT(animation_html(busy(1000, 200, 900)).size(), all_move / 4);
}

}  // namespace
}  // namespace delabole
