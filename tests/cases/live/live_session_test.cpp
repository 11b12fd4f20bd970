// What the page of `delabole live` may be asked: any JSON is answered or refused in words, and what is saved is a case
// with the values that were asked for.
#include "cases/program/live/session.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

namespace delabole {
namespace {

std::string text_of(const std::string& name) {
    std::ifstream file(DELABOLE_CASES "/" + name, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

LiveSession session_of(const std::string& name) {
    const std::string path = DELABOLE_CASES "/" + name;
    return {read_case(path), text_of(name), [](const std::vector<std::string>&) { return "results"; }};
}

// Requests as the page makes them, with one or two of their parts replaced.
class Requests {
  public:
    Requests(const Json& opened, const Json& answered, unsigned seed) : random_(seed) {
        for (const Json& group : opened["groups"]) {
            for (const Json& input : group["inputs"]) {
                inputs_.push_back(input);
            }
        }
        for (const Json& handle : answered["handles"]) {
            handles_.push_back(handle["name"]);
        }
    }

    Json next() {
        Json request{{"values", values()},
                     {"figures", below(4) == 0 ? "all" : "first"},
                     {"handle", handles_.empty() ? Json("crest") : handles_[below(handles_.size())]},
                     {"to", {uniform(-100, 100), uniform(-100, 100)}},
                     {"x", axis()},
                     {"y", axis()},
                     {"output", "factor_of_safety"},
                     {"columns", 3},
                     {"rows", 2},
                     {"milliseconds", 1},
                     {"steps", 3}};
        for (std::size_t changes = below(3); changes > 0; --changes) {
            spoil(request);
        }
        return below(50) == 0 ? wrong() : request;
    }

  private:
    std::size_t below(std::size_t count) { return random_() % count; }
    double uniform(double lower, double upper) { return std::uniform_real_distribution(lower, upper)(random_); }

    Json values() {
        Json values = Json::object();
        for (std::size_t number = below(4); number > 0; --number) {
            const Json& input = inputs_[below(inputs_.size())];
            constexpr std::array<double, 6> factors{0, -1, 0.5, 1.1, 10, 1e9};
            values[input["name"].get<std::string>()] = input["value"].get<double>() * factors[below(factors.size())];
        }
        return values;
    }

    Json axis() {
        const Json& input = inputs_[below(inputs_.size())];
        const double value = input["value"];
        return {{"name", input["name"]}, {"lower", 0.5 * value}, {"upper", 2 * value}};
    }

    Json wrong() {
        const std::vector<Json> all{nullptr,
                                    true,
                                    "",
                                    "\n",
                                    -1,
                                    0,
                                    1e300,
                                    -1e-300,
                                    std::int64_t{1} << 62U,
                                    Json::array(),
                                    Json::object(),
                                    Json::array({1}),
                                    Json::array({"x", nullptr}),
                                    Json::object({{"name", 3}}),
                                    Json::object({{"", 1}})};
        return all[below(all.size())];
    }

    // A member, or one within it.
    void spoil(Json& request) {
        Json* place = &*std::next(request.begin(), static_cast<std::ptrdiff_t>(below(request.size())));
        if (place->is_structured() && !place->empty() && below(2) == 0) {
            place = &*std::next(place->begin(), static_cast<std::ptrdiff_t>(below(place->size())));
        }
        *place = wrong();
    }

    std::minstd_rand random_;
    std::vector<Json> inputs_;
    std::vector<Json> handles_;
};

struct Counts {
    int answered = 0;
    int refused = 0;
};

// Anything else that is thrown fails the test.
template <class Ask>
void ask(Counts& counts, const Json& request, Ask&& function) {
    SCOPED_TRACE(request.dump());
    try {
        function();
        ++counts.answered;
    } catch (const LiveRefusal& error) {
        EXPECT_STRNE(error.what(), "");
        ++counts.refused;
    }
}

void expect_saved(const LiveSession& session, const std::string& name, const Json& request) {
    const Json saved = session.save(request);
    const CaseFile file = parse_case(saved["toml"].get<std::string>(), DELABOLE_CASES "/" + name);
    const std::vector<Quantity> inputs = named_inputs(file.model);
    for (const auto& [input, value] : request["values"].items()) {
        const Quantity* found = find_quantity(inputs, input);
        ASSERT_NE(found, nullptr);
        EXPECT_DOUBLE_EQ(found->value / display_unit(found->dimension).si_per_unit, value.get<double>());
    }
}

class AnyRequest : public ::testing::TestWithParam<const char*> {};

TEST_P(AnyRequest, IsAnsweredOrRefusedInWords) {
    LiveSession session = session_of(GetParam());
    const Json opened = session.open();
    constexpr unsigned seed = 23;
    Requests requests(opened, session.answer(Json::object()), seed);
    Counts counts;
    constexpr int number = 60;
    for (int turn = 0; turn < number; ++turn) {
        const Json request = requests.next();
        ask(counts, request, [&] { session.answer(request); });
        ask(counts, request, [&] { session.drag(request); });
        ask(counts, request, [&] { session.map(request); });
        ask(counts, request, [&] { session.fit(request); });
        ask(counts, request, [&] { session.report(request); });
        ask(counts, request, [&] {
            session.save(request);
            expect_saved(
                session, GetParam(),
                request.is_object() && request.contains("values") ? request : Json{{"values", Json::object()}});
        });
        ask(counts, request, [&] { session.start_motion(request); });
        ask(counts, request, [&] { session.step_motion(request); });
        ask(counts, request, [&] { session.change_motion(request); });
    }
    // Of both kinds there are many.
    EXPECT_GT(counts.answered, number);
    EXPECT_GT(counts.refused, number);
}

INSTANTIATE_TEST_SUITE_P(OfCases, AnyRequest,
                         ::testing::Values("plane_failure/fig_2_8.toml", "starting/fit.toml",
                                           "wedge/hoek_bray_complete.toml", "kinematics/road_cut_poles.toml",
                                           "stepped_base/appendix_a.toml", "stepped_path/columns_and_wedge.toml",
                                           "relaxation/two_blocks_3.toml", "relaxation/newmark_block.toml"));

Json inputs_of_map(const LiveSession& session, int columns, int rows) {
    const Json map = session.open()["map"];
    return {{"x", {{"name", map["x"]}, {"lower", 20}, {"upper", 50}}},
            {"y", {{"name", map["y"]}, {"lower", 0}, {"upper", 40}}},
            {"output", map["output"]},
            {"columns", columns},
            {"rows", rows}};
}

TEST(LiveSession, GroupsOfInputsHaveTheirNames) {
    const Json opened = session_of("starting/kinematics.toml").open();
    std::vector<std::string> labels;
    for (const Json& group : opened["groups"]) {
        labels.push_back(group["label"]);
    }
    EXPECT_EQ(labels, (std::vector<std::string>{"slope", "strength", "lateral limit", "joint set[1]: bedding",
                                                "joint set[2]: joints", "joint set[3]: cross joints"}));
}

// The valley runs where the factor of safety is 1, but for the prior of the friction angle.
TEST(LiveSession, MisfitOfACaseWithFitIsThatOfItsObservations) {
    const LiveSession session = session_of("starting/fit.toml");
    const Json request = inputs_of_map(session, 13, 9);
    EXPECT_EQ(request["x"]["name"], "strength.friction_angle");
    EXPECT_EQ(request["y"]["name"], "strength.cohesion");
    EXPECT_EQ(session.open()["fit"]["strength.cohesion"], Json::array({0.0, 80.0})) << "kPa";
    const Json fit = session.fit(request);
    const Json map = session.map(request);
    for (std::size_t row = 0; row < 9; ++row) {
        for (std::size_t column = 0; column < 13; ++column) {
            const double factor = map["values"][row][column];
            const double friction = fit["x"][column];
            const double expected = std::pow((factor - 1) / 0.1, 2) + std::pow((friction - 37) / 3, 2);
            EXPECT_NEAR(fit["values"][row][column], expected, 1e-9 * expected);  // rounding of degrees
        }
    }
    ASSERT_EQ(fit["observations"].size(), 1U);
    EXPECT_EQ(fit["observations"][0]["label"], "it failed");
    EXPECT_EQ(fit["observations"][0]["predicted"], "1.54");
}

// The same sentences as the commands print, of the slope as the page has it.
TEST(LiveSession, StudiesTheSlopeAsItIs) {
    const auto has = [](const Json& answer, std::string_view text) {
        return std::ranges::any_of(answer["sentences"], [&](const Json& sentence) {
            return sentence.get<std::string>().find(text) != std::string::npos;
        });
    };
    const LiveSession samples = session_of("starting/sensitivity.toml");
    EXPECT_EQ(samples.open()["studies"], true);
    const Json as_given = samples.study(Json::object());
    EXPECT_TRUE(has(as_given, "Probability of failure 0.11 %")) << as_given;
    const Json higher = samples.study({{"values", {{"slope.height", 25}}}});
    EXPECT_TRUE(has(higher, "Probability of failure ")) << higher;
    EXPECT_FALSE(has(higher, "Probability of failure 0.11 %")) << higher;
    EXPECT_THROW(samples.study({{"values", {{"tension_crack.distance_behind_crest", 100}}}}), LiveRefusal);

    const Json fitted = session_of("starting/fit.toml").study(Json::object());
    EXPECT_TRUE(has(fitted, "friction angle 35.9 deg (30.9 deg to 39.6 deg with 95 %)")) << fitted;
    EXPECT_EQ(session_of("starting/plane_failure.toml").open()["studies"], false);
}

// The uphill top corner of each block follows, to the point where the pointer is.
TEST(LiveSession, BlocksOfARowAreDragged) {
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
            // Within the picture, where the corner is drawn.
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
TEST(LiveSession, TheToeLeavesTheCrest) {
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

TEST(LiveSession, TheVerdictIsFollowedByTheRestOfTheAnswer) {
    const Json answer = session_of("stepped_base/cables_together.toml").answer(Json::object());
    ASSERT_FALSE(answer["sentences"].empty());
    EXPECT_NE(answer["sentences"][0].get<std::string>().find("kN/m"), std::string::npos) << answer["sentences"];
}

// Measured poles are many sliders: they stand in one group, and each says which pole it is of.
TEST(LiveSession, MeasuredPolesAreOneGroup) {
    const Json groups = session_of("kinematics/road_cut_poles.toml").open()["groups"];
    const auto poles = std::ranges::find(groups, "poles[1].plane", [](const Json& one) { return one["name"]; });
    ASSERT_NE(poles, groups.end());
    EXPECT_GT((*poles)["inputs"].size(), 24U);
    EXPECT_EQ((*poles)["inputs"][0]["label"], "plane[1]: dip");
}

TEST(LiveSession, JointSetsAndOutlineOfASectionAreDragged) {
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
            // From the middle of the outline towards the pointer: 10 m across, 6 m up.
            EXPECT_NEAR(std::tan(degrees(dip)), (y + 0.1 - 6) / (x - 0.2 - 10), 1e-6) << name;
        }
    }
    EXPECT_EQ(sets, (std::vector<std::string>{"joint set bedding", "joint set columns"}));
}

TEST(LiveSession, EveryPointOfASectionIsDragged) {
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
        // A point on a line that it cannot leave goes as near as the line comes: of a slanting, level or upright line,
        // at most 0.1 m away, of 0.14 m before.
        EXPECT_LT(std::hypot(moved["at"][0].get<double>() - x, moved["at"][1].get<double>() - y), 0.1 + 1e-6)
            << handle["name"];
    }
    EXPECT_EQ(names, (std::vector<std::string>{"toe", "crest", "end of the bench", "failure plane",
                                               "where the plane daylights", "tension crack", "water level"}));
}

// What is dragged over north goes on behind it.
TEST(LiveSession, PolesOfAStereonetAreDragged) {
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
