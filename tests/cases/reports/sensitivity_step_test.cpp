// The bars of a run: inputs are changed by what the case says of their uncertainty, and the others by a usual step.
#include "cases/program/reports/sensitivity_step.hpp"

#include "cases/program/case/case_file.hpp"
#include "cases/program/results/model_reports.hpp"
#include "cases/program/results/result_folder.hpp"

#include <gtest/gtest.h>

namespace delabole {
namespace {

struct Drawn {
    Figure figure;
    std::string caption;
};

Drawn tornado_of(const std::string& name) {
    const CaseFile file = read_case(std::string(DELABOLE_CASES) + "/" + name, {});
    Drawn last;
    const ResultFolder folder([&](const Figure& figure, const std::string& caption) {
        if (figure.title.starts_with("Change of the factor of safety")) {
            last = {figure, caption};
        }
    });
    Report ignored;
    append_case_figures(file.model, analyse_case(file.model), {folder, ignored}, deviations_of(file));
    return last;
}

bool has_bar(const Drawn& drawn, std::string_view begin) {
    return std::ranges::any_of(drawn.figure.y.ticks,
                               [&](const auto& tick) { return tick.second.find(begin) != std::string::npos; });
}

std::size_t bars_in(const Drawn& drawn, Colour colour) {
    std::size_t count = 0;
    for (const Series& series : drawn.figure.series) {
        if (const auto* boxes = std::get_if<Boxes>(&series); boxes != nullptr && boxes->colour == colour) {
            count += boxes->boxes.size();
        }
    }
    return count;
}

TEST(SensitivityStep, IsTheDeviationThatTheCaseGives) {
    const Drawn drawn = tornado_of("starting/support.toml");
    // The step is 3 deg less what the bounds of 25 and 50 deg cut off, to four digits.
    EXPECT_TRUE(has_bar(drawn, "+3\u00a0deg") || has_bar(drawn, "+2.99")) << drawn.figure.y.ticks[0].second;
    EXPECT_FALSE(has_bar(drawn, "support[1].spacing") || has_bar(drawn, "spacing,")) << "it is chosen";
    EXPECT_EQ(bars_in(drawn, Colour::blue), 2U);  // friction angle and cohesion
    EXPECT_GT(bars_in(drawn, Colour::pale_blue) + bars_in(drawn, Colour::pale_vermilion), 2U);
    EXPECT_NE(drawn.caption.find("pale ones"), std::string::npos);
}

TEST(SensitivityStep, IsTheUsualOneForACaseThatGivesNone) {
    const Drawn drawn = tornado_of("starting/plane_failure.toml");
    EXPECT_TRUE(has_bar(drawn, "+1\u00a0deg"));
    EXPECT_EQ(bars_in(drawn, Colour::pale_blue) + bars_in(drawn, Colour::pale_vermilion), 0U);
    EXPECT_EQ(drawn.caption.find("pale"), std::string::npos);
}

}  // namespace
}  // namespace delabole
