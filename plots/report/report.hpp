// A report as a value, and the one page of HTML it becomes: styles and figures inside, nothing fetched, no script but
// that of animations, so that it can be mailed, read on a phone and printed.
//
// All texts are plain; whatever they hold is shown as it stands.
#pragma once

#include "plots/drawing/figure.hpp"
#include "plots/report/animation.hpp"

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
    std::string title = {};
    bool number = false;  // aligned right, figures of equal width
};

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

// What the result was made from and with: names and values.
struct Provenance {
    std::vector<std::pair<std::string, std::string>> entries = {};
};

using ReportBlock =
    std::variant<Heading, Paragraph, BulletList, Notice, Table, FigureInReport, BlockAnimation, Provenance>;

struct Report {
    std::string title = {};
    std::string subtitle = {};
    std::vector<ReportBlock> blocks = {};
};

// The page. Figures and animations are numbered in their order; their SVG files are read here.
std::string report_page(const Report& report);

// Writes the page as write_file_atomically does. OutputError when that fails.
void write_report(const Report& report, const std::filesystem::path& path);

}  // namespace delabole
