#include "plots/report/report.hpp"
#include "plots/drawing/atomic_file.hpp"
#include "plots/drawing/svg.hpp"
#include "samples.hpp"
#include "scratch_folder.hpp"

#include <gtest/gtest.h>

#include <set>
#include <stack>
#include <string>
#include <utility>
#include <vector>

namespace delabole {
namespace {

std::size_t count(const std::string& text, const std::string& word) {
    std::size_t found = 0;
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + word.size())) {
        ++found;
    }
    return found;
}

std::string drawn_pageof(std::vector<ReportBlock> blocks) {
    return report_page({.title = "title", .subtitle = "", .blocks = std::move(blocks)});
}

// Returns what stands between < and > of each tag, without the style sheet.
std::vector<std::string> tags(const std::string& page) {
    std::vector<std::string> result;
    for (std::size_t at = page.find('<'); at != std::string::npos; at = page.find('<', at)) {
        char quote = 0;
        std::size_t end = at + 1;
        for (; end < page.size() && (quote != 0 || page[end] != '>'); ++end) {
            if (quote != 0) {
                quote = page[end] == quote ? '\0' : quote;
            } else if (page[end] == '"' || page[end] == '\'') {
                quote = page[end];
            }
        }
        result.push_back(page.substr(at + 1, end - at - 1));
        at = result.back() == "style" ? page.find("</style>", end) : end;
    }
    return result;
}

// Returns the texts between each `opening` and the next `closing`.
std::vector<std::string> between(const std::string& text, const std::string& opening, char closing) {
    std::vector<std::string> result;
    for (std::size_t at = text.find(opening); at != std::string::npos; at = text.find(opening, at)) {
        at += opening.size();
        result.push_back(text.substr(at, text.find(closing, at) - at));
    }
    return result;
}

// Expects that every element that is opened is closed, in order.
void expect_balanced(const std::string& page) {
    const std::set<std::string> without_end{"meta", "link", "!DOCTYPE", "wbr"};
    std::stack<std::string> open;
    for (const std::string& tag : tags(page)) {
        const std::string name = tag.substr(0, tag.find_first_of(" \n"));
        if (without_end.count(name) != 0 || tag.ends_with('/')) {
            continue;
        }
        if (!name.starts_with('/')) {
            open.push(name);
        } else {
            ASSERT_FALSE(open.empty()) << name;
            ASSERT_EQ("/" + open.top(), name);
            open.pop();
        }
    }
    EXPECT_TRUE(open.empty()) << open.top();
}

TEST(InlineSvg, MakesIdsUniqueAndTakesOutWhatRuns) {
    const std::string file =
        "<?xml version='1.0'?>\n<!DOCTYPE svg>\n<svg width='7' height=\"5\" viewBox='0 0 7 5' onload='alert(1)'>\n"
        "<title>Gnuplot</title><desc>Produced by</desc><script type='text/javascript'><![CDATA[ a < b; ]]></script>\n"
        "<!-- a comment --><defs><path id='gpPt0' d='M0,0'/><path id=\"gpPt1\"/></defs>\n"
        "<use xlink:href='#gpPt0' color='red'/><rect fill='url(#gpPt1)' onclick=\"x()\"/>\n"
        "<image xlink:href='data:image/png;base64,AA=='/><a href='https://example.org/'/><text>a &lt; b</text></svg>\n";
    EXPECT_EQ(inline_svg(file, "f1-", "a \"b\""),
              "<svg viewBox=\"0 0 7 5\" width=\"100%\" role=\"img\" aria-label=\"a &quot;b&quot;\">\n\n"
              "<defs><path id=\"f1-gpPt0\" d=\"M0,0\"/><path id=\"f1-gpPt1\"/></defs>\n"
              "<use xlink:href=\"#f1-gpPt0\" color=\"red\"/><rect fill=\"url(#f1-gpPt1)\"/>\n"
              "<image xlink:href=\"data:image/png;base64,AA==\"/><a/><text>a &lt; b</text></svg>");
}

TEST(InlineSvg, OfSomethingElseIsEmpty) {
    for (const char* file : {"", "<svg", "<svg>", "</svg><svg>", "<svg a='</svg>", "not a picture"}) {
        EXPECT_EQ(inline_svg(file, "f-", ""), "") << file;
    }
}

TEST(EscapeHtml, LeavesNoMarkupAndNoControlCharacters) {
    EXPECT_EQ(escape_html("<b a=\"1\" c='2'> & φ\n\x01"), "&lt;b a=&quot;1&quot; c=&#39;2&#39;&gt; &amp; φ\n ");
}

TEST(ReportPage, EscapesEveryText) {
    const std::string bad = "<script>&\"'";
    const FigureFiles missing{.status = FigureStatus::gnuplot_failed, .message = bad};
    const std::string page =
        report_page({.title = bad,
                     .subtitle = bad,
                     .blocks = {Heading{bad}, Heading{bad, 3}, Paragraph{bad}, BulletList{{bad}},
                                Notice{NoticeKind::warning, bad, {bad}}, Table{bad, {{bad, true}}, {{bad}}},
                                FigureInReport{missing, bad}, Provenance{{{bad, bad}}}}});
    EXPECT_EQ(page.find("<script"), std::string::npos);
    EXPECT_EQ(count(page, "&lt;script&gt;&amp;&quot;&#39;"), 16U);
    expect_balanced(page);
}

TEST(ReportPage, AlignsNumbersAndLetsWideTablesScroll) {
    const std::string page =
        drawn_pageof({Table{"",
                            {{"name"}, {"value", true}},
                            {{"a", "1"}, {"short"}, {"x", "2", "beyond"}, {"water.water_depth, 1.5 a_1"}}}});
    EXPECT_NE(page.find("<div class=\"table\" tabindex=\"0\">"), std::string::npos);
    EXPECT_NE(page.find("<tr><td>a</td><td class=\"number\">1</td><td></td></tr>"), std::string::npos);
    EXPECT_NE(page.find("<tr><td>short</td><td class=\"number\"></td><td></td></tr>"), std::string::npos);
    EXPECT_NE(page.find("<td>beyond</td>"), std::string::npos);
    EXPECT_NE(page.find(">water.<wbr>water_<wbr>depth, 1.5 a_1</td>"), std::string::npos);
}

TEST(ReportPage, LeavesOutColumnsWithoutContentAndSaysThatATableIsEmpty) {
    const std::string page = drawn_pageof({Table{"", {{"input"}, {"source"}}, {{"height", ""}, {"dip"}}},
                                           Table{"cracks", {{"where", true}, {"opening", true}}, {}}});
    EXPECT_EQ(page.find("source"), std::string::npos);
    EXPECT_NE(page.find("<tr><td>dip</td></tr>"), std::string::npos);
    EXPECT_NE(page.find("opening</th>"), std::string::npos);
    EXPECT_NE(page.find("<td colspan=\"2\">none</td>"), std::string::npos);
}

TEST(ReportPage, PutsTheAnswerFirstWithItsPictureAndTheContents) {
    const FigureFiles files{.status = FigureStatus::gnuplot_missing, .message = "no picture"};
    const std::string page =
        drawn_pageof({HeadCard{AnswerTone::bad, {"FS 0.64: fails.", "It takes <bolts>."}, FigureInReport{files, "one"}},
                      Heading{"Water"}, Heading{"Deeper", 3}, Heading{"Strength"},
                      Folded{"Chains", {Heading{"Inside"}}}, Heading{"Inputs"}});
    const std::size_t head = page.find("<section class=\"head bad\">");
    ASSERT_NE(head, std::string::npos);
    EXPECT_LT(head, page.find("<p>FS 0.64: fails.</p>"));
    EXPECT_NE(page.find("<p>It takes &lt;bolts&gt;.</p>"), std::string::npos);
    EXPECT_LT(page.find("<nav class=\"contents\""), page.find("<b>Figure 1.</b> one"));
    EXPECT_LT(page.find("<b>Figure 1.</b> one"), page.find("</section>"));
    for (const char* link : {"<a href=\"#section-1\">Water</a>", "<a href=\"#section-2\">Strength</a>",
                             "<a href=\"#section-3\">Inputs</a>"}) {
        EXPECT_NE(page.find(link), std::string::npos) << link;
    }
    EXPECT_EQ(count(page, "href=\"#section-"), 3U);
    EXPECT_NE(page.find("<details>\n<summary>Chains</summary>\n<h2>Inside</h2>"), std::string::npos);
    expect_balanced(page);
}

TEST(ReportPage, OfTwoHeadingsHasNoContents) {
    EXPECT_EQ(drawn_pageof({Heading{"one"}, Heading{"two"}}).find("<nav"), std::string::npos);
}

TEST(ReportPage, PutsFiguresThatFollowEachOtherSideBySide) {
    const FigureFiles files{.status = FigureStatus::gnuplot_missing, .message = "no picture"};
    const FigureInReport figure{files, "caption"};
    const std::string page =
        drawn_pageof({figure, figure, Paragraph{"text"}, figure, FigureRow{{figure, figure, figure}}});
    EXPECT_EQ(count(page, "<div class=\"figures\">"), 2U);
    EXPECT_EQ(count(page, "<div class=\"figures small\">"), 1U);
    EXPECT_NE(page.find("<b>Figure 6.</b>"), std::string::npos);
    expect_balanced(page);
}

TEST(TakePicture, MovesTheFirstOneToTheHead) {
    HeadCard head;
    std::vector<ReportBlock> blocks{Paragraph{"text"}};
    take_picture(blocks, head);
    EXPECT_TRUE(std::holds_alternative<std::monostate>(head.picture));
    blocks.emplace_back(FigureInReport{{}, "first"});
    blocks.emplace_back(FigureInReport{{}, "second"});
    take_picture(blocks, head);
    EXPECT_EQ(std::get<FigureInReport>(head.picture).caption, "first");
    ASSERT_EQ(blocks.size(), 2U);
    EXPECT_EQ(std::get<FigureInReport>(blocks[1]).caption, "second");
}

TEST(ReportPage, SaysWhyAFigureIsMissing) {
    const FigureFiles failed{.status = FigureStatus::gnuplot_missing, .message = "gnuplot is not installed"};
    const FigureFiles vanished{.status = FigureStatus::ok, .svg = "/nowhere/section.svg"};
    const std::string page = drawn_pageof({FigureInReport{failed, "one"}, FigureInReport{vanished, "two"}});
    EXPECT_NE(page.find("Figure missing: gnuplot is not installed"), std::string::npos);
    EXPECT_NE(page.find("Figure missing: cannot read section.svg"), std::string::npos);
    EXPECT_EQ(page.find("/nowhere"), std::string::npos);
    EXPECT_NE(page.find("<b>Figure 2.</b> two"), std::string::npos);
}

class DrawnReport : public testing::Test {
  protected:
    static void SetUpTestSuite() {
        const ScratchFolder folder;
        std::vector<FigureFiles> drawn;
        for (const auto& [name, figure] : samples::figures()) {
            drawn.push_back(write_figure(figure, folder.path(), name));
        }
        drawn_figures = drawn.size();
        drawn_page = report_page(samples::report(drawn));
    }
    static inline std::string drawn_page;
    static inline std::size_t drawn_figures = 0;
};

TEST_F(DrawnReport, HoldsEveryFigure) {
    EXPECT_EQ(count(drawn_page, "<figure>"), drawn_figures);
    EXPECT_EQ(count(drawn_page, "<svg "), drawn_figures);
    EXPECT_EQ(drawn_page.find("Figure missing"), std::string::npos);
    expect_balanced(drawn_page);
}

TEST_F(DrawnReport, HasUniqueIdsAndNoDanglingReferences) {
    std::set<std::string> ids;
    for (const std::string& id : between(drawn_page, " id=\"", '"')) {
        EXPECT_TRUE(ids.insert(id).second) << id;
    }
    EXPECT_GT(ids.size(), 50U);
    for (const auto& [opening, closing] : {std::pair{"href=\"#", '"'}, std::pair{"url(#", ')'}}) {
        for (const std::string& reference : between(drawn_page, opening, closing)) {
            EXPECT_EQ(ids.count(reference), 1U) << reference;
        }
    }
}

TEST_F(DrawnReport, RunsNothingAndFetchesNothing) {
    EXPECT_EQ(drawn_page.find("@import"), std::string::npos);
    for (const std::string& tag : tags(drawn_page)) {
        EXPECT_FALSE(tag.starts_with("script"));
        for (const char* handler : {" onload=", " onclick=", " onmousemove=", " onerror="}) {
            EXPECT_EQ(tag.find(handler), std::string::npos) << tag;
        }
        for (const char* attribute : {"src=\"", "href=\""}) {
            for (const std::string& target : between(tag, attribute, '"')) {
                EXPECT_TRUE(target.starts_with('#') || target.starts_with("data:")) << target;
            }
        }
    }
}

TEST(WriteReport, NamesWhereItCannotWrite) {
    const ScratchFolder folder;
    write_report({.title = "title", .subtitle = "", .blocks = {}}, folder.path() / "report.html");
    EXPECT_TRUE(content_of(folder.path() / "report.html").starts_with("<!DOCTYPE html>\n<html lang=\"en\">"));
    EXPECT_THROW(write_report({}, folder.path() / "missing" / "report.html"), OutputError);
}

}  // namespace
}  // namespace delabole
