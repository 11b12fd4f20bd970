// A report as a value, and the single page of HTML made from it. Styles and figures are inside the page, nothing is
// fetched, and the only script is that of animations, so the page can be mailed, read on a phone and printed.
//
// All texts are plain: markup in them is shown, not interpreted.
#pragma once

#include "plots/drawing/figure.hpp"
#include "plots/report/animation.hpp"

#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace delabole {

struct Heading {
    std::string text = {};
    int level = 2;  // 2 or 3; the title of the report is level 1
};

struct Paragraph {
    std::string text = {};
};

struct BulletList {
    std::vector<std::string> items = {};
};

enum class NoticeKind { verdict, warning };

// A highlighted box.
struct Notice {
    NoticeKind kind = NoticeKind::verdict;
    std::string title = {};
    std::vector<std::string> paragraphs = {};
};

struct TableColumn {
    TableColumn(const char* words) : TableColumn(std::string(words)) {}
    TableColumn(std::string words, bool is_number = false) : title(std::move(words)), number(is_number) {}

    std::string title;
    bool number;  // aligned right, with digits of equal width
};

// "width, m"_number is the title of a column of numbers.
inline TableColumn operator""_number(const char* title, std::size_t length) {
    return {std::string(title, length), true};
}

// A row may be shorter than the columns; its cells are then empty.
struct Table {
    std::string caption = {};
    std::vector<TableColumn> columns = {};
    std::vector<std::vector<std::string>> rows = {};
};

// A drawn figure, or a box with the reason why it could not be drawn.
struct FigureInReport {
    FigureFiles files = {};
    std::string caption = {};
    bool wide = false;  // of many panels, which need the width of the page
};

// Small figures of one kind, side by side.
struct FigureRow {
    std::vector<FigureInReport> figures = {};
};

// Names and values that tell how the result was made, for example input file and version.
struct Provenance {
    std::vector<std::pair<std::string, std::string>> entries = {};
};

enum class AnswerTone { good, bad, open };

// The answer, placed before everything else: at most three sentences, the first of them in bold, and the picture that
// shows it.
struct HeadCard {
    AnswerTone tone = AnswerTone::open;
    std::vector<std::string> sentences = {};
    std::variant<std::monostate, FigureInReport, BlockAnimation> picture = {};
};

struct Folded;

using ReportBlock = std::variant<HeadCard, Heading, Paragraph, BulletList, Notice, Table, FigureInReport, FigureRow,
                                 BlockAnimation, Provenance, Folded>;

// Details that are shown when the reader opens them, and printed only if they are open.
struct Folded {
    std::string title = {};
    std::vector<ReportBlock> blocks = {};
};

// Moves the first picture among the blocks, if there is any, to the head.
void take_picture(std::vector<ReportBlock>& blocks, HeadCard& head);

struct Report {
    std::string title = {};
    std::string subtitle = {};
    std::vector<ReportBlock> blocks = {};

    void add(ReportBlock block) { blocks.push_back(std::move(block)); }
};

// The page. Figures and animations are numbered in order; their SVG files are read here. Consecutive figures stand side
// by side if the page is wide enough. A page of three headings or more has a table of contents, which is in the head
// card if the page begins with one.
std::string report_page(const Report& report);

// Writes the page with write_file_atomically. Throws OutputError if that fails.
void write_report(const Report& report, const std::filesystem::path& path);

}  // namespace delabole
