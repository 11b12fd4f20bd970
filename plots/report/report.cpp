#include "plots/report/report.hpp"

#include "plots/drawing/atomic_file.hpp"
#include "plots/drawing/svg.hpp"
#include "plots/report/page.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>

namespace delabole {

namespace {

std::string element(const std::string& name, std::string_view text) {
    return "<" + name + ">" + escape_html(text) + "</" + name + ">\n";
}

// Names such as "water.water_elevation" may be broken after a point or an underscore if a column is narrow.
std::string breakable(const std::string& html) {
    const auto is_letter = [](char character) { return character >= 'a' && character <= 'z'; };
    std::string text;
    for (std::size_t index = 0; index < html.size(); ++index) {
        text += html[index];
        const bool joint = html[index] == '_' || html[index] == '.';
        if (joint && index > 0 && index + 1 < html.size() && is_letter(html[index - 1]) && is_letter(html[index + 1])) {
            text += "<wbr>";
        }
    }
    return text;
}

class Page {
  public:
    std::string take() { return std::move(html_); }

    void begin(const Report& report) {
        html_ +=
            "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
            "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
            // Without this, browsers ask the server or the disk for an icon.
            "<link rel=\"icon\" href=\"data:,\">\n";
        html_ += element("title", report.title);
        html_ += "<style>\n";
        html_ += report_style;
        if (holds_animation(report.blocks)) {
            html_ += animation_style;
        }
        html_ += "</style>\n</head>\n<body>\n<main>\n<header>\n";
        html_ += element("h1", report.title);
        html_ += "</header>\n";
    }

    void add_subtitle(const Report& report) {
        if (!report.subtitle.empty()) {
            html_ += "<p class=\"subtitle\">" + escape_html(report.subtitle) + "</p>\n";
        }
    }

    void add_blocks(const std::vector<ReportBlock>& blocks) {
        for (std::size_t index = 0; index < blocks.size(); ++index) {
            if (!std::holds_alternative<FigureInReport>(blocks[index])) {
                std::visit([&](const auto& content) { add(content); }, blocks[index]);
                continue;
            }
            html_ += "<div class=\"figures\">\n";
            for (; index < blocks.size() && std::holds_alternative<FigureInReport>(blocks[index]); ++index) {
                add(std::get<FigureInReport>(blocks[index]));
            }
            --index;
            html_ += "</div>\n";
        }
    }

    // Links to all parts of the report that have headings, in order.
    void gather_contents(const std::vector<ReportBlock>& blocks) {
        std::string links;
        int sections = 0;
        for (const ReportBlock& block : blocks) {
            const auto* heading = std::get_if<Heading>(&block);
            if (heading != nullptr && heading->level <= 2) {
                links += "<li><a href=\"#section-" + std::to_string(++sections) + "\">" + escape_html(heading->text) +
                         "</a></li>\n";
            }
        }
        constexpr int enough = 3;
        if (sections >= enough) {
            contents_ = "<nav class=\"contents\" aria-label=\"Contents\">\n<ol>\n" + links + "</ol>\n</nav>\n";
        }
    }

    void add_contents() { html_ += std::exchange(contents_, {}); }

    void end(const Report& report) {
        html_ += "</main>\n";
        if (holds_animation(report.blocks)) {
            html_ += "<script>\n";
            html_ += animation_script;
            html_ += "</script>\n";
        }
        html_ += "</body>\n</html>\n";
    }

    void add(const HeadCard& head) {
        constexpr std::array<std::string_view, 3> tones{"good", "bad", "open"};
        html_ += "<section class=\"head ";
        html_ += tones.at(static_cast<std::size_t>(head.tone));
        html_ += "\">\n<div class=\"answer\">\n";
        for (const std::string& sentence : head.sentences) {
            html_ += element("p", sentence);
        }
        add_contents();
        html_ += "</div>\n";
        if (const auto* figure = std::get_if<FigureInReport>(&head.picture)) {
            add(*figure);
        } else if (const auto* animation = std::get_if<BlockAnimation>(&head.picture)) {
            add(*animation);
        }
        html_ += "</section>\n";
    }

    void add(const Folded& folded) {
        html_ += "<details>\n<summary>" + escape_html(folded.title) + "</summary>\n";
        ++depth_;
        add_blocks(folded.blocks);
        --depth_;
        html_ += "</details>\n";
    }

    void add(const Heading& heading) {
        const bool section = heading.level <= 2;
        html_ += section ? "<h2" + next_section() + ">" : "<h3>";
        html_ += escape_html(heading.text) + (section ? "</h2>\n" : "</h3>\n");
    }

    void add(const Paragraph& paragraph) { html_ += element("p", paragraph.text); }

    void add(const BulletList& list) {
        if (list.items.empty()) {
            return;
        }
        html_ += "<ul>\n";
        for (const std::string& item : list.items) {
            html_ += element("li", item);
        }
        html_ += "</ul>\n";
    }

    void add(const Notice& notice) {
        const bool warning = notice.kind == NoticeKind::warning;
        html_ += std::string("<div class=\"notice ") + (warning ? "warning" : "verdict") + "\" role=\"note\">\n";
        html_ += "<p class=\"notice-title\">" +
                 escape_html(notice.title.empty() ? (warning ? "Warning" : "Verdict") : notice.title) + "</p>\n";
        for (const std::string& paragraph : notice.paragraphs) {
            html_ += element("p", paragraph);
        }
        html_ += "</div>\n";
    }

    // A column whose cells are empty in all rows is left out.
    void add(const Table& table) {
        const std::vector<std::size_t> columns = columns_with_content(table);
        // tabindex lets readers without a touch screen scroll a wide table with the arrow keys.
        constexpr std::size_t many = 8;  // number of columns above which print needs smaller letters
        html_ += "<div class=\"table\" tabindex=\"0\">\n";
        html_ += columns.size() > many          ? "<table class=\"wide\">\n"
                 : is_described(table, columns) ? "<table class=\"described\">\n"
                                                : "<table>\n";
        if (!table.caption.empty()) {
            html_ += element("caption", table.caption);
        }
        html_ += "<thead>\n<tr>";
        for (const std::size_t index : columns) {
            const TableColumn column = index < table.columns.size() ? table.columns[index] : TableColumn("");
            html_ += std::string("<th scope=\"col\"") + (column.number ? " class=\"number\">" : ">") +
                     breakable(escape_html(column.title)) + "</th>";
        }
        html_ += "</tr>\n</thead>\n<tbody>\n";
        for (const std::vector<std::string>& row : table.rows) {
            html_ += "<tr>";
            for (const std::size_t index : columns) {
                add_cell(index < row.size() ? row[index] : "",
                         index < table.columns.size() && table.columns[index].number);
            }
            html_ += "</tr>\n";
        }
        if (table.rows.empty()) {
            html_ += "<tr><td colspan=\"" + std::to_string(columns.size()) + "\">none</td></tr>\n";
        }
        html_ += "</tbody>\n</table>\n</div>\n";
    }

    void add(const FigureInReport& figure) {
        ++figures_;
        const std::string prefix = "figure" + std::to_string(figures_) + "-";
        std::string svg;
        if (figure.files.status == FigureStatus::ok) {
            std::ifstream file(figure.files.svg, std::ios::binary);
            const std::string content{std::istreambuf_iterator<char>(file), {}};
            svg = inline_svg(content, prefix, figure.caption);
        }
        html_ += figure.wide ? "<figure class=\"wide\">\n" : "<figure>\n";
        if (!svg.empty()) {
            html_ += svg + "\n";
        } else {
            const std::string reason = figure.files.status != FigureStatus::ok
                                           ? figure.files.message
                                           : "cannot read " + figure.files.svg.filename().string();
            html_ += "<div class=\"missing\">Figure missing: " + escape_html(reason) + "</div>\n";
        }
        end_figure(figure.caption);
    }

    void add(const FigureRow& row) {
        html_ += "<div class=\"figures small\">\n";
        for (const FigureInReport& figure : row.figures) {
            add(figure);
        }
        html_ += "</div>\n";
    }

    void add(const BlockAnimation& animation) {
        ++figures_;
        html_ += "<figure>\n" + animation_html(animation);
        end_figure(animation.caption);
    }

    void add(const Provenance& provenance) {
        html_ += "<dl class=\"provenance\">\n";
        for (const auto& [name, value] : provenance.entries) {
            html_ += element("dt", name) + element("dd", value);
        }
        html_ += "</dl>\n";
    }

  private:
    static bool holds_animation(const std::vector<ReportBlock>& blocks) {
        return std::ranges::any_of(blocks, [](const ReportBlock& block) {
            const auto* head = std::get_if<HeadCard>(&block);
            const auto* folded = std::get_if<Folded>(&block);
            return std::holds_alternative<BlockAnimation>(block) ||
                   (head != nullptr && std::holds_alternative<BlockAnimation>(head->picture)) ||
                   (folded != nullptr && holds_animation(folded->blocks));
        });
    }

    static std::vector<std::size_t> columns_with_content(const Table& table) {
        std::size_t widest = table.columns.size();
        for (const std::vector<std::string>& row : table.rows) {
            widest = std::max(widest, row.size());
        }
        std::vector<std::size_t> columns;
        for (std::size_t index = 0; index < widest; ++index) {
            const bool content = std::ranges::any_of(
                table.rows, [&](const auto& row) { return index < row.size() && !row[index].empty(); });
            if (content || table.rows.empty()) {
                columns.push_back(index);
            }
        }
        return columns;
    }

    // Whether the columns are names, numbers and what these mean, which a phone shows below them.
    static bool is_described(const Table& table, const std::vector<std::size_t>& columns) {
        return columns.size() == 3 && table.columns.size() == 3 && !table.columns[0].number &&
               table.columns[1].number && !table.columns[2].number;
    }

    // A number and its unit stay on one line; longer texts may be broken.
    void add_cell(const std::string& text, bool number) {
        constexpr std::size_t longest_number = 24;  // letters, with its unit
        const bool is_long = text.size() > longest_number;
        constexpr std::array<std::string_view, 4> classes{"", " class=\"long\"", " class=\"number\"",
                                                          " class=\"number long\""};
        html_ += "<td";
        html_ += classes.at((number ? 2U : 0U) + (is_long ? 1U : 0U));
        html_ += ">" + breakable(escape_html(text)) + "</td>";
    }

    // The anchor that the table of contents links to. Inside folded parts there are none.
    std::string next_section() { return depth_ > 0 ? "" : " id=\"section-" + std::to_string(++sections_) + "\""; }

    void end_figure(const std::string& caption) {
        html_ += "<figcaption><b>Figure " + std::to_string(figures_) + ".</b> " + escape_html(caption) +
                 "</figcaption>\n</figure>\n";
    }

    std::string html_;
    std::string contents_;
    int figures_ = 0;
    int sections_ = 0;
    int depth_ = 0;  // depth of nested folded parts
};

}  // namespace

void take_picture(std::vector<ReportBlock>& blocks, HeadCard& head) {
    const auto picture = std::ranges::find_if(blocks, [](const ReportBlock& block) {
        return std::holds_alternative<FigureInReport>(block) || std::holds_alternative<BlockAnimation>(block);
    });
    if (picture == blocks.end()) {
        return;
    }
    if (auto* figure = std::get_if<FigureInReport>(&*picture)) {
        head.picture = std::move(*figure);
    } else {
        head.picture = std::move(std::get<BlockAnimation>(*picture));
    }
    blocks.erase(picture);
}

std::string report_page(const Report& report) {
    Page page;
    page.begin(report);
    page.gather_contents(report.blocks);
    // The answer stands before everything that takes longer to read, the table of contents included.
    const bool has_head = !report.blocks.empty() && std::holds_alternative<HeadCard>(report.blocks.front());
    const auto rest = report.blocks.begin() + (has_head ? 1 : 0);
    page.add_blocks({report.blocks.begin(), rest});
    page.add_subtitle(report);
    page.add_contents();
    page.add_blocks({rest, report.blocks.end()});
    page.end(report);
    return page.take();
}

void write_report(const Report& report, const std::filesystem::path& path) {
    write_file_atomically(path, report_page(report));
}

}  // namespace delabole
