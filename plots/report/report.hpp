// A report as a value, and the one page of HTML it becomes: styles and figures inside, nothing fetched, no script but
// that of animations, so that it can be mailed, read on a phone and printed.
//
// All texts are plain; whatever they hold is shown as it stands.
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

// A box that is not to be missed.
struct Notice {
    NoticeKind kind = NoticeKind::verdict;
    std::string title = {};
    std::vector<std::string> paragraphs = {};
};

struct TableColumn {
    TableColumn(const char* words) : TableColumn(std::string(words)) {}
    TableColumn(std::string words, bool is_number = false) : title(std::move(words)), number(is_number) {}

    std::string title;
    bool number;  // aligned right, figures of equal width
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

// A drawn figure; a box with the reason where there is none.
struct FigureInReport {
    FigureFiles files = {};
    std::string caption = {};
};

// Figures of one kind side by side, small.
struct FigureRow {
    std::vector<FigureInReport> figures = {};
};

// Names and values of what the result was made from and with.
struct Provenance {
    std::vector<std::pair<std::string, std::string>> entries = {};
};

enum class AnswerTone { good, bad, open };

// The answer before everything else: at most three sentences, the first of them in bold, and the picture that shows it.
struct HeadCard {
    AnswerTone tone = AnswerTone::open;
    std::vector<std::string> sentences = {};
    std::variant<std::monostate, FigureInReport, BlockAnimation> picture = {};
};

struct Folded;

using ReportBlock = std::variant<HeadCard, Heading, Paragraph, BulletList, Notice, Table, FigureInReport, FigureRow,
                                 BlockAnimation, Provenance, Folded>;

// Details that are shown when the reader opens them. They are printed where they are open.
struct Folded {
    std::string title = {};
    std::vector<ReportBlock> blocks = {};
};

// Moves the first picture among the blocks to the head; there may be none.
void take_picture(std::vector<ReportBlock>& blocks, HeadCard& head);

struct Report {
    std::string title = {};
    std::string subtitle = {};
    std::vector<ReportBlock> blocks = {};
};

// The page. Figures and animations are numbered in their order; their SVG files are read here. Figures that follow each
// other stand side by side where the page is wide enough. A page of three headings or more has a table of contents,
// in the head card where it begins with one.
std::string report_page(const Report& report);

// Writes the page as write_file_atomically does. OutputError when that fails.
void write_report(const Report& report, const std::filesystem::path& path);

}  // namespace delabole
