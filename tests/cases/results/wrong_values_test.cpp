// Each value of each shipped case made wrong in turn, and each section left out: check finds it in order or says what
// is wrong.
//
// One value for each key of each model, where the case that has it is shortest, takes seconds. All of them take
// minutes: DELABOLE_ALL_VALUES=1 program_parts_test --gtest_filter='WrongValues.*'.
#include "cases/program/results/analysis.hpp"
#include "cases/program/results/problems_of_case.hpp"
#include "dynamic_relaxation/study/relaxation_study.hpp"

#include "tests/support/case_values.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <set>

namespace delabole {
namespace {

using testing::CaseValue;
using testing::CaseValues;

struct ShippedCase {
    std::string name;
    std::string text;
};

std::vector<ShippedCase> shipped_cases() {
    std::vector<ShippedCase> cases;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(DELABOLE_CASES)) {
        if (entry.path().extension() == ".toml") {
            std::ifstream file(entry.path(), std::ios::binary);
            cases.push_back({entry.path().string(), std::string(std::istreambuf_iterator<char>(file), {})});
        }
    }
    std::ranges::sort(cases, {}, [](const ShippedCase& one) { return std::pair(one.text.size(), one.name); });
    return cases;
}

std::string put(const std::string& text, const CaseValue& value, const std::string& by) {
    return std::string(text).replace(value.begin, value.end - value.begin, by);
}

// Returns the case with the value in another unit, as a name, NaN, an empty list, without its key and with the other
// sign; on demand a thousandth and a thousand times as large, which may be a case with much work.
std::vector<std::string> spoilt(const std::string& text, const CaseValue& value, bool of_any_size) {
    std::vector<std::string> made{put(text, value, "\"7 V\""), put(text, value, "\"no_such_name\""),
                                  put(text, value, "nan"), put(text, value, "[]"),
                                  std::string(text).insert(value.key_begin, value.has_line ? "#" : "x")};
    const std::string written = text.substr(value.begin, value.end - value.begin);
    const std::size_t digit = written.find_first_of("0123456789");
    if (!value.is_list && digit <= 2 && !written.starts_with('{')) {
        std::string turned = written;
        if (digit > 0 && written[digit - 1] == '-') {
            turned.erase(digit - 1, 1);
        } else {
            turned.insert(digit, "-");
        }
        made.push_back(put(text, value, turned));
        const std::size_t end = std::min(written.find_first_not_of("0123456789.", digit), written.size());
        if (of_any_size && (end == written.size() || (written[end] != 'e' && written[end] != '_'))) {
            for (const char* const power : {"e-3", "e3"}) {
                made.push_back(put(text, value, std::string(written).insert(end, power)));
            }
        }
    }
    return made;
}

// The headers of the case's sections, "[[scene.block]]" among them.
std::set<std::string> headers(const std::string& text) {
    std::set<std::string> found;
    for (std::size_t at = text.find("\n["); at != std::string::npos; at = text.find("\n[", at + 1)) {
        found.insert(text.substr(at + 1, text.find_first_of("\n#", at + 1) - at - 1));
    }
    return found;
}

// Removes the sections with that header.
std::string without(std::string text, const std::string& header) {
    for (std::size_t at = text.find('\n' + header); at != std::string::npos; at = text.find('\n' + header, at)) {
        const std::size_t next = text.find("\n[", at + 1);
        text.erase(at, next == std::string::npos ? next : next - at);
    }
    return text;
}

// Checks every answer that needs no time stepping.
void expect_numbers(const CaseModel& model, const std::string& about) {
    for (const Quantity& input : named_inputs(model)) {
        EXPECT_TRUE(std::isfinite(input.value)) << about << ": " << input.name;
    }
    if (std::holds_alternative<RelaxationStudy>(model)) {
        return;
    }
    for (const NamedOutput& output : analyse_model(model).outputs) {
        const auto* number = std::get_if<double>(&output.value);
        EXPECT_FALSE(number != nullptr && std::isnan(*number)) << about << ": " << output.name;
    }
}

struct Slowest {
    double seconds = 0;  // processor time
    std::string about = {};
};

void check(const std::string& text, const std::string& name, const std::string& about, Slowest& slowest) {
    const std::clock_t begin = std::clock();
    try {
        const CaseFile file = parse_case(text, name);
        refuse_impossible(file);
        expect_numbers(file.model, about);
    } catch (const CaseError& error) {
        ASSERT_FALSE(error.problems().empty()) << about;
        for (const Problem& problem : error.problems()) {
            EXPECT_NE(problem.message, "") << about;
        }
    } catch (const std::exception& error) {
        FAIL() << about << ": " << error.what();
    }
    const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    if (seconds > slowest.seconds) {
        slowest = {seconds, about};
    }
}

// Sections that are read alike for all models have one value checked for all of them.
bool of_any_model(const std::string& path) {
    return std::ranges::any_of(std::array{"expect", "sources", "fit", "sensitivity", "title", "description", "schema"},
                               [&](std::string_view begin) { return path.starts_with(begin); });
}

// Fuzzing changes cases that it has changed before; a bracket of the other kind in a list once made the search endless.
TEST(WrongValues, AreFoundInWhatIsNoTomlAsFarAsItCanBeFollowed) {
    EXPECT_EQ(CaseValues("a = [1, }\nb = 2\n").found().size(), 3U);
    EXPECT_EQ(CaseValues("a = {b = ]}\n").found().size(), 2U);
    EXPECT_LE(CaseValues("a = " + std::string(100'000, '[')).found().size(), 100U);
}

TEST(WrongValues, AreRefusedInWordsOrAnsweredInNumbers) {
    const bool all = std::getenv("DELABOLE_ALL_VALUES") != nullptr;
    std::set<std::string> seen;
    std::size_t checked = 0;
    Slowest slowest;
    for (const ShippedCase& shipped : shipped_cases()) {
        const CaseValues values(shipped.text);
        ASSERT_GT(values.found().size(), 5U) << shipped.name;
        const std::size_t model_begin = shipped.text.find("model = ");
        const std::string model = shipped.text.substr(model_begin, shipped.text.find('\n', model_begin) - model_begin);
        for (const std::string& header : headers(shipped.text)) {
            if (seen.insert(model + header).second || all) {
                check(without(shipped.text, header), shipped.name, shipped.name + " without " + header, slowest);
                ++checked;
            }
        }
        for (const CaseValue& value : values.found()) {
            if (!seen.insert(of_any_model(value.path) ? value.path : model + value.path).second && !all) {
                continue;
            }
            const std::vector<std::string> texts = spoilt(shipped.text, value, all);
            for (std::size_t index = 0; index < texts.size(); ++index) {
                check(texts[index], shipped.name,
                      shipped.name + ", " + value.path + ", change " + std::to_string(index + 1), slowest);
                ++checked;
            }
        }
    }
    std::cout << checked << " cases with a wrong value; the slowest took " << slowest.seconds << " s: " << slowest.about
              << '\n';
    EXPECT_GT(checked, 1500U);
    // Processor time: a case takes less even under sanitizers, and an engineer would not wait longer for a refusal.
    EXPECT_LT(slowest.seconds, 10);
}

// A slope that cannot be cut has no blocks, but its bonds were once looked up all the same.
TEST(WrongValues, OfASlopeWithBondsAreMistakesOfTheCase) {
    const std::filesystem::path path = std::filesystem::path(DELABOLE_CASES) / "relaxation/base_friction_slope.toml";
    for (const auto& [key, value] :
         {std::pair("scene.frame.joint", "foo"), std::pair("scene.cut[1].trace.spacing", "0.5 kPa")}) {
        try {
            read_case(path, {{key, value}});
            FAIL() << key;
        } catch (const CaseError& error) {
            ASSERT_EQ(error.problems().size(), 1U);
            EXPECT_EQ(error.problems()[0].key, key);
        }
    }
}

}  // namespace
}  // namespace delabole
