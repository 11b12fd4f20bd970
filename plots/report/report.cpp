#include "plots/report/report.hpp"

#include "plots/drawing/atomic_file.hpp"
#include "plots/drawing/svg.hpp"
#include "plots/report/animation_script.hpp"
#include "plots/report/report_style.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>

namespace delabole {

namespace {

std::string element(const std::string& name, std::string_view text) {
    return "<" + name + ">" + escape_html(text) + "</" + name + ">\n";
}

// Names such as "water.water_elevation" may be broken after a point or an underscore, where a column is narrow.
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
            // Without it browsers ask the server, or the disk, for an icon.
            "<link rel=\"icon\" href=\"data:,\">\n";
        html_ += element("title", report.title);
        html_ += "<style>\n";
        html_ += report_style;
        if (is_animated(report)) {
            html_ += animation_style;
        }
        html_ += "</style>\n</head>\n<body>\n<main>\n<header>\n";
        html_ += element("h1", report.title);
        if (!report.subtitle.empty()) {
            html_ += "<p class=\"subtitle\">" + escape_html(report.subtitle) + "</p>\n";
        }
        html_ += "</header>\n";
    }

    void end(const Report& report) {
        html_ += "</main>\n";
        if (is_animated(report)) {
            html_ += "<script>\n";
            html_ += animation_script;
            html_ += "</script>\n";
        }
        html_ += "</body>\n</html>\n";
    }

    void add(const Heading& heading) { html_ += element(heading.level <= 2 ? "h2" : "h3", heading.text); }

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

    void add(const Table& table) {
        // tabindex: whoever has no touch screen scrolls a wide table by the arrow keys.
        html_ += "<div class=\"table\" tabindex=\"0\">\n<table>\n";
        if (!table.caption.empty()) {
            html_ += element("caption", table.caption);
        }
        html_ += "<thead>\n<tr>";
        for (const TableColumn& column : table.columns) {
            html_ += std::string("<th scope=\"col\"") + (column.number ? " class=\"number\">" : ">") +
                     escape_html(column.title) + "</th>";
        }
        html_ += "</tr>\n</thead>\n<tbody>\n";
        for (const std::vector<std::string>& row : table.rows) {
            html_ += "<tr>";
            for (std::size_t index = 0; index < std::max(table.columns.size(), row.size()); ++index) {
                const bool number = index < table.columns.size() && table.columns[index].number;
                html_ += number ? "<td class=\"number\">" : "<td>";
                if (index < row.size()) {
                    const std::string text = escape_html(row[index]);
                    html_ += number ? text : breakable(text);
                }
                html_ += "</td>";
            }
            html_ += "</tr>\n";
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
        html_ += "<figure>\n";
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
    static bool is_animated(const Report& report) {
        return std::any_of(report.blocks.begin(), report.blocks.end(),
                           [](const ReportBlock& block) { return std::holds_alternative<BlockAnimation>(block); });
    }

    void end_figure(const std::string& caption) {
        html_ += "<figcaption><b>Figure " + std::to_string(figures_) + ".</b> " + escape_html(caption) +
                 "</figcaption>\n</figure>\n";
    }

    std::string html_;
    int figures_ = 0;
};

}  // namespace

std::string report_page(const Report& report) {
    Page page;
    page.begin(report);
    for (const ReportBlock& block : report.blocks) {
        std::visit([&](const auto& content) { page.add(content); }, block);
    }
    page.end(report);
    return page.take();
}

void write_report(const Report& report, const std::filesystem::path& path) {
    write_file_atomically(path, report_page(report));
}

}  // namespace delabole
