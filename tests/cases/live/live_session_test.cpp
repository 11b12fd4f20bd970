// Any JSON that the page of `delabole live` sends is answered or refused in words, and what is saved is a case with the
// values that were asked for.
#include "tests/cases/live/live_case.hpp"

#include "cases/program/results/analysis.hpp"
#include "cases/program/results/model_reports.hpp"
#include "cases/program/sweeps/support_report.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

namespace delabole {
namespace {

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

    // Replaces a member of the request, or a part of one, by something wrong.
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

// An exception of any other type fails the test.
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
        ask(counts, request, [&] { session.verdict_of_motion(request); });
    }
    // Both answers and refusals are frequent.
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

// The valley of the misfit follows a factor of safety of 1, but for the prior of the friction angle.
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

// The page has the same sentences as the commands print, for the slope as it stands on the page.
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

TEST(LiveSession, TheVerdictIsFollowedByTheRestOfTheAnswer) {
    const Json answer = session_of("stepped_base/cables_together.toml").answer(Json::object());
    ASSERT_FALSE(answer["sentences"].empty());
    EXPECT_NE(answer["sentences"][0].get<std::string>().find("kN/m"), std::string::npos) << answer["sentences"];
}

TEST(LiveSession, RoundNumbersAreSavedAsPeopleWriteThem) {
    const std::string saved = session_of("starting/fit.toml")
                                  .save({{"values",
                                          {{"slope.height", 20},
                                           {"slope.face_dip", 50},
                                           {"strength.cohesion", 100},
                                           {"rock.unit_weight", 25.5}}}})["toml"];
    for (const char* const line :
         {"height = \"20 m\"", "face_dip = \"50 deg\"", "cohesion = \"100 kPa\"", "unit_weight = \"25.5 kN/m3\""}) {
        EXPECT_NE(saved.find(line), std::string::npos) << line << " in\n" << saved;
    }
}

// Once a corner of an outline from a file has been dragged, the case holds the corners and not the file's name.
TEST(LiveSession, AnOutlineFromAFileIsSavedWithItsPoints) {
    const std::filesystem::path folder = std::filesystem::path(::testing::TempDir()) / "live_outline";
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "section.csv") << "x_m,y_m\n0,0\n20,0\n20,12\n6,12\n";
    std::string text = text_of("starting/jointed_slope.toml");
    const std::size_t begin = text.find("outline = [");
    text.replace(begin, text.find("\n]\n", begin) + 2 - begin, "outline_file = \"section.csv\"  # surveyed");
    const std::string path = (folder / "case.toml").string();
    std::ofstream(path) << text;
    const LiveSession session(read_case(path), text, [](const std::vector<std::string>&) { return ""; });
    EXPECT_EQ(session.save({{"values", {{"scene.joint[1].friction_angle", 30}}}})["toml"].get<std::string>().find(
                  "outline = ["),
              std::string::npos);
    const Json saved = session.save({{"values", {{"scene.outline[3].y", 13}, {"scene.outline[4].x", 7}}}});
    const std::string toml = saved["toml"];
    EXPECT_EQ(toml.find("section.csv"), std::string::npos) << toml;
    EXPECT_NE(toml.find("]  # surveyed"), std::string::npos) << toml;
    const std::vector<Quantity> inputs = named_inputs(parse_case(toml, path).model);
    EXPECT_EQ(find_quantity(inputs, "scene.outline[2].x")->value, 20);
    EXPECT_EQ(find_quantity(inputs, "scene.outline[3].y")->value, 13);
    EXPECT_EQ(find_quantity(inputs, "scene.outline[4].x")->value, 7);
    EXPECT_EQ(find_quantity(inputs, "scene.outline[4].y")->value, 12);
}

// Verdict and sentences are those of the report of a run, which designs the support first; its settings leave the
// design to the run, unless the support was chosen by hand.
TEST(LiveSession, SupportIsDesignedAsARunDesignsIt) {
    for (const char* const name :
         {"starting/support.toml", "plane_failure/bolted_road_cut.toml", "stepped_base/bolted_columns.toml"}) {
        std::vector<std::string> settings;
        CaseFile file = read_case(DELABOLE_CASES "/" + std::string(name));
        LiveSession session(file, text_of(name), [&](const std::vector<std::string>& given) {
            settings = given;
            return "results";
        });
        EXPECT_EQ(session.open()["designs_support"], true);
        const Json design = session.support(Json::object());
        const Json answer = session.answer({{"values", design["values"]}});
        const std::optional<DesignedSupport> designed = design_support_of(file, [](double) { return true; });
        ASSERT_TRUE(designed);
        HeadCard head = head_card(file.model, analyse_case(file.model));
        add_to_head(*designed, head);
        // On the live page the pattern stands beside the verdict.
        std::vector<std::string> said{"With these bolts " + answer["verdict"].get<std::string>(), design["sentence"]};
        for (const Json& sentence : answer["sentences"]) {
            said.push_back(sentence);
        }
        said.resize(head.sentences.size());
        EXPECT_EQ(said, head.sentences) << name;

        session.report({{"values", design["values"]}});
        EXPECT_TRUE(settings.empty()) << name << ": " << settings.front();
        Json by_hand = design["values"];
        by_hand["support[1].rows"] = by_hand["support[1].rows"].get<double>() + 1;
        session.report({{"values", by_hand}});
        EXPECT_EQ(settings.size(), file.support_design->choices.size()) << name;
    }
    EXPECT_THROW(session_of("starting/fit.toml").support(Json::object()), LiveRefusal);
}

// Measured poles are many sliders: they stand in one group, and each says which pole it is of.
TEST(LiveSession, MeasuredPolesAreOneGroup) {
    const Json groups = session_of("kinematics/road_cut_poles.toml").open()["groups"];
    const auto poles = std::ranges::find(groups, "poles[1].plane", [](const Json& one) { return one["name"]; });
    ASSERT_NE(poles, groups.end());
    EXPECT_GT((*poles)["inputs"].size(), 24U);
    EXPECT_EQ((*poles)["inputs"][0]["label"], "plane[1]: dip");
}

// Motion continues past its end, and is described in the words of the report of a run.
TEST(LiveSession, AMotionEndsInTheWordsOfItsRun) {
    constexpr const char* name = "starting/jointed_slope.toml";
    CaseFile file = read_case(DELABOLE_CASES "/" + std::string(name));
    auto& study = std::get<RelaxationStudy>(file.model);
    study.critical.reset();  // the run alone
    LiveSession session(file, text_of(name), [](const std::vector<std::string>&) { return "results"; });
    for (const double friction : {35.0, 60.0}) {
        const Json values{{"values", {{"scene.joint[1].friction_angle", friction}}}};
        session.start_motion(values);
        EXPECT_EQ(session.verdict_of_motion(values), Json::object());
        for (int turn = 0; turn < 1000 && session.verdict_of_motion(values).empty(); ++turn) {
            session.step_motion({{"steps", 500}});
        }
        const CaseModel model = with_conditions(file.model, {{"scene.joint[1].friction_angle", degrees(friction)}});
        const HeadCard head = head_card(model, analyse_case(model));
        const Json said = session.verdict_of_motion(values);
        EXPECT_EQ(said["verdict"], head.sentences.front());
        EXPECT_EQ(said["sentences"], (std::vector<std::string>(head.sentences.begin() + 1, head.sentences.end())));
        EXPECT_EQ(said["over"], false);
        EXPECT_TRUE(head.sentences.front().starts_with(friction < 40 ? "Collapsed: " : "Stands: ")) << said;
    }
    // The motion continues from rest if the friction is reduced, and the session decides again how it ends.
    session.change_motion({{"values", {{"scene.joint[1].friction_angle", 12.0}}}});
    EXPECT_EQ(session.verdict_of_motion({}), Json::object());
    for (int turn = 0; turn < 1000 && session.verdict_of_motion({}).empty(); ++turn) {
        session.step_motion({{"steps", 500}});
    }
    EXPECT_TRUE(session.verdict_of_motion({})["verdict"].get<std::string>().starts_with("Collapsed: "))
        << session.verdict_of_motion({});
}

}  // namespace
}  // namespace delabole
