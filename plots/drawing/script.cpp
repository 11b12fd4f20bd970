#include "plots/drawing/extent.hpp"
#include "plots/drawing/figure.hpp"
#include "plots/drawing/gnuplot_words.hpp"
#include "plots/drawing/polygon.hpp"
#include "plots/drawing/text.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <locale>
#include <sstream>

namespace delabole {

namespace {

constexpr double mean_letter_width = 0.56 * text_height;
constexpr double legend_sample = 44;                // px, with the space before its text
constexpr double legend_gap = 22;                   // px, between entries
constexpr double legend_line = 1.35 * text_height;  // px
constexpr int digits_of_data = 12;
constexpr int digits_of_pixels = 6;  // as in the pictures

Rows rows_of(const Polyline& points, bool keep_gaps) {
    constexpr double gap = std::numeric_limits<double>::quiet_NaN();
    Rows rows;
    for (const Point& point : points) {
        if (point.allFinite()) {
            rows.push_back({point.x(), point.y()});
        } else if (keep_gaps && !rows.empty()) {
            rows.push_back({gap, gap});
        }
    }
    return rows;
}

std::ostringstream classic_stream(int digits) {
    std::ostringstream stream;
    stream.imbue(std::locale::classic());
    stream.precision(digits);
    return stream;
}

class ScriptWriter {
  public:
    ScriptWriter(const Figure& figure, std::string_view name) : figure_(figure), name_(name) {}

    std::string write() {
        for (const Series& series : figure_.series) {
            std::visit([this](const auto& content) { add(content); }, series);
        }
        lay_out_legend();
        script_ << "# " << single_line(figure_.title) << "\n# Draw again, in this folder: gnuplot " << name_
                << ".gp\nset encoding utf8\nset minussign\n";
        write_settings();
        write_axis("x", figure_.x, x_extent_);
        write_axis("y", figure_.y, y_extent_);
        write_labels();
        write_arrows();
        script_ << data_.str();
        write_drawing();
        return script_.str();
    }

  private:
    static std::string single_line(std::string text) {
        std::replace_if(
            text.begin(), text.end(), [](char letter) { return static_cast<unsigned char>(letter) < 0x20; }, ' ');
        return text;
    }

    template <class... Parts>
    static std::string words(const Parts&... parts) {
        std::ostringstream text = classic_stream(digits_of_data);
        (text << ... << parts);
        return text.str();
    }

    void plot(const Rows& rows, const std::string& how) {
        data_ << "$series_" << ++blocks_ << " << EOD\n" << data_lines(rows) << "EOD\n";
        plot_ << (plot_.tellp() > 0 ? ", \\\n     " : "") << "$series_" << blocks_ << ' ' << how;
    }

    // A series as it is shown and named in the legend below the plot.
    struct LegendEntry {
        enum class Sample { line, arrow, marker, area } sample;
        std::string text;
        std::string style;
        double left = 0;  // px; the row is counted from above
        int row = 0;
    };

    void note_legend(LegendEntry::Sample sample, const std::string& text, std::string style) {
        if (!text.empty()) {
            legend_.push_back({sample, text, std::move(style)});
        }
    }

    // Entries follow each other like words, each as wide as its text. gnuplot's own key is not used: its columns are
    // all as wide as the longest text and differ between terminals.
    void lay_out_legend() {
        std::size_t longest = 0;
        for (const LegendEntry& entry : legend_) {
            longest = std::max(longest, letter_count(entry.text));
        }
        constexpr double letter = 0.6;  // of the height, in the terminal with the wider letters
        const double room = figure_.width - 2 * legend_gap;
        // A long text is written in smaller letters, so that it does not extend beyond the edge.
        legend_height_ = std::clamp((room - legend_sample - legend_gap) / (letter * static_cast<double>(longest)), 11.0,
                                    text_height);
        double left = 0;
        double widest = 0;
        for (LegendEntry& entry : legend_) {
            const double width =
                legend_sample + letter * legend_height_ * static_cast<double>(letter_count(entry.text));
            if (left > 0 && left + width > room) {
                left = 0;
                ++legend_rows_;
            }
            entry.left = left;
            entry.row = legend_rows_;
            widest = std::max(widest, left + width);
            left += width + legend_gap;
        }
        legend_rows_ += legend_.empty() ? 0 : 1;
        for (LegendEntry& entry : legend_) {
            entry.left += std::max(legend_gap, 0.5 * (figure_.width - widest));
        }
    }

    int legend_space() const {
        return legend_.empty() ? 0 : static_cast<int>(std::ceil(legend_rows_ * legend_line)) + 8;
    }

    // The canvas grows with the legend, so that the plot keeps its size.
    int canvas_height() const { return figure_.height + legend_space(); }

    // Written anew for each terminal, because their markers differ in size.
    std::string legend_commands() const {
        std::ostringstream commands = classic_stream(digits_of_pixels);
        int tag = 1000;  // distinct from the labels and arrows of the figure
        for (const LegendEntry& entry : legend_) {
            const auto at = [&](double right, double up) {
                const double y = legend_space() - (entry.row + 0.5) * legend_line + up;
                std::ostringstream place = classic_stream(digits_of_pixels);
                place << "screen " << (entry.left + right) / figure_.width << ",screen " << y / canvas_height();
                return place.str();
            };
            constexpr double end = legend_sample - 10;  // px
            ++tag;
            switch (entry.sample) {
            case LegendEntry::Sample::line:
            case LegendEntry::Sample::arrow:
                commands << "set arrow " << tag << " from " << at(0, 0) << " to " << at(end, 0) << ' ' << entry.style;
                break;
            case LegendEntry::Sample::marker:
                commands << "set label " << 1000 + tag << " '' at " << at(0.5 * end, 0) << " point " << entry.style;
                break;
            case LegendEntry::Sample::area:
                commands << "set object " << tag << " rectangle from " << at(0, -7) << " to " << at(end, 7) << ' '
                         << entry.style;
                break;
            }
            commands << "\nset label " << tag << ' ' << quote(entry.text) << " at " << at(legend_sample, 0)
                     << " left font '," << legend_height_ << "'\n";
        }
        return commands.str();
    }

    void include(const Rows& rows) {
        for (const std::vector<double>& row : rows) {
            x_extent_.include(row[0]);
            y_extent_.include(row[1]);
        }
    }

    void add(const Line& line) {
        const Rows rows = rows_of(line.points, true);
        if (rows.empty()) {
            return;
        }
        include(rows);
        const std::string look = words(" dashtype ", dash_type(line.dash), " linecolor rgb ", rgb(line.colour));
        // gnuplot draws samples of equal width and colour as one path of an SVG, with the dashes of the first. A
        // difference in width that cannot be seen keeps them separate.
        constexpr double apart = 0.001;
        const double sample_width = line.width + apart * static_cast<double>(legend_.size() + 1);
        note_legend(LegendEntry::Sample::line, line.legend, "nohead " + words("linewidth ", sample_width) + look);
        plot(rows, "using 1:2 with lines " + words("linewidth ", line.width) + look);
    }

    void add(const Points& points) {
        const Rows rows = rows_of(points.points, false);
        if (rows.empty()) {
            return;
        }
        include(rows);
        const std::string style = words("pointtype ", point_type(points.marker), " pointsize marker*", points.size,
                                        " linewidth 2 linecolor rgb ", rgb(points.colour));
        note_legend(LegendEntry::Sample::marker, points.legend, style);
        plot(rows, "using 1:2 with points " + style);
    }

    void add(const Region& region) {
        Polyline outline = region.outline;
        std::erase_if(outline, [](const Point& point) { return !point.allFinite(); });
        if (outline.size() < 3) {
            return;
        }
        const std::string style =
            words("fillcolor rgb ", rgb(region.colour), " fillstyle transparent solid ", region.opacity, " noborder");
        note_legend(LegendEntry::Sample::area, region.legend, style);
        // gnuplot fills the wrong side of an outline that leaves the plot by several edges.
        if (figure_.x.range && figure_.y.range) {
            const Point one(figure_.x.range->first, figure_.y.range->first);
            const Point other(figure_.x.range->second, figure_.y.range->second);
            outline = clipped(outline, {one.cwiseMin(other), one.cwiseMax(other)});
            if (outline.empty()) {
                return;
            }
        }
        const Rows rows = rows_of(outline, false);
        include(rows);
        plot(rows, "using 1:2 with filledcurves closed " + style);
    }

    void add(const Boxes& boxes) {
        Rows rows;
        for (const Boxes::Box& box : boxes.boxes) {
            if (box.lower_left.allFinite() && box.upper_right.allFinite()) {
                rows.push_back({box.lower_left.x(), box.lower_left.y(), box.upper_right.x(), box.upper_right.y()});
                include({{box.upper_right.x(), box.upper_right.y()}});
            }
        }
        if (rows.empty()) {
            return;
        }
        include(rows);
        const std::string style = words("fillcolor rgb ", rgb(boxes.colour), " fillstyle solid noborder");
        note_legend(LegendEntry::Sample::area, boxes.legend, style);
        plot(rows, "using (0.5*($1+$3)):(0.5*($2+$4)):1:3:2:4 with boxxyerror " + style);
    }

    void add(const Arrows& arrows) {
        Rows rows;
        for (const Arrows::Shaft& shaft : arrows.shafts) {
            if (shaft.from.allFinite() && shaft.to.allFinite()) {
                rows.push_back({shaft.from.x(), shaft.from.y(), shaft.to.x(), shaft.to.y()});
                include({{shaft.to.x(), shaft.to.y()}});
            }
        }
        if (rows.empty()) {
            return;
        }
        include(rows);
        const std::string style =
            words("head filled size screen 0.013,20 linewidth ", arrows.width, " linecolor rgb ", rgb(arrows.colour));
        note_legend(LegendEntry::Sample::arrow, arrows.legend, style);
        plot(rows, "using 1:2:($3-$1):($4-$2) with vectors " + style);
    }

    void add(const HeatMap& map) {
        const auto columns = static_cast<Eigen::Index>(map.x_values.size());
        const auto lines = static_cast<Eigen::Index>(map.y_values.size());
        if (columns < 2 || lines < 2 || map.values.rows() != lines || map.values.cols() != columns) {
            return;
        }
        Rows rows;
        bool gaps = false;
        for (Eigen::Index line = 0; line < lines; ++line) {
            for (Eigen::Index column = 0; column < columns; ++column) {
                const double value = map.values(line, column);
                gaps = gaps || !std::isfinite(value);
                rows.push_back({map.x_values[static_cast<std::size_t>(column)],
                                map.y_values[static_cast<std::size_t>(line)],
                                std::isfinite(value) ? value : std::numeric_limits<double>::quiet_NaN()});
            }
        }
        const double half_column = 0.5 * (map.x_values[1] - map.x_values[0]);
        const double half_line = 0.5 * (map.y_values[1] - map.y_values[0]);
        include({{map.x_values.front() - half_column, map.y_values.front() - half_line},
                 {map.x_values.back() + half_column, map.y_values.back() + half_line}});
        // YlGnBu of Brewer's colour schemes: from light to dark for every kind of colour vision, and in black and white
        // print.
        script_ << "set palette defined (0 '#ffffd9', 1 '#edf8b1', 2 '#c7e9b4', 3 '#7fcdbb', 4 '#41b6c4', 5 '#1d91c0', "
                   "6 '#225ea8')\nset cbrange [0:"
                << map.ceiling << "]\nset cbtics " << tick_step(map.ceiling, 6) << "\nset cblabel "
                << quote(map.scale_title) << "\n";
        if (gaps) {
            // The image is transparent where it has no value, so this background shows through.
            const std::string style = words("fillcolor rgb ", rgb(Colour::light_grey), " fillstyle solid noborder");
            script_ << "set object 1 rectangle from graph 0,0 to graph 1,1 behind " << style << "\n";
            note_legend(LegendEntry::Sample::area, map.no_answer_legend, style);
        }
        plot(rows, words("using 1:2:($3>", map.ceiling, "?", map.ceiling, ":$3) with image"));
    }

    void write_settings() {
        script_ << "set title " << quote(title_lines()) << "\n";
        script_ << "set border " << (figure_.frame ? 31 : 0) << " linewidth 1 linecolor rgb " << rgb(Colour::grey)
                << "\n";
        script_ << "set tics nomirror scale 0.6 textcolor rgb 'black'\n";
        script_ << "set style textbox opaque fillcolor rgb 'white' noborder margins 0.4,0.2\n";
        if (figure_.equal_scales) {
            script_ << "set size ratio -1\n";
        }
        // Lines between two points outside the plot are drawn where they cross it.
        script_ << "set clip two\nunset key\n";
        if (!legend_.empty()) {
            script_ << "set bmargin at screen " << (legend_space() + axis_height()) / canvas_height() << "\n";
        }
    }

    // Height of the x axis below the plot, px: numbers, or names of several lines, and the title.
    double axis_height() const {
        if (!figure_.frame) {
            return 12;
        }
        constexpr double of_one_line = 86;  // with a title
        constexpr double line = 22;
        std::ptrdiff_t breaks = 0;
        for (const auto& [place, name] : figure_.x.ticks) {
            breaks = std::max(breaks, std::ranges::count(name, '\n'));
        }
        const double further = line * static_cast<double>(breaks);
        return figure_.x.title.empty() ? std::max(of_one_line, 2 * line + further) : of_one_line + further;
    }

    // Breaks the title into lines of about equal length; the width of the figure sets their number.
    std::string title_lines() const {
        std::size_t names = 0;  // letters to the left of the plot, on which the title is centred
        for (const auto& [place, name] : figure_.y.ticks) {
            std::istringstream lines(name);
            for (std::string line; std::getline(lines, line);) {
                names = std::max(names, letter_count(line));
            }
        }
        const auto across = static_cast<std::size_t>(
            std::max(10.0, (figure_.width - 60) / mean_letter_width - static_cast<double>(names)));
        const std::size_t letters = letter_count(figure_.title);
        const std::size_t lines = letters / across + 1;
        return wrapped(figure_.title, lines == 1 ? across : std::min(across, letters / lines + 6));
    }

    void write_axis(std::string_view letter, const Axis& axis, const Extent& extent) {
        const auto [lowest, highest] = shown_range(axis, extent);
        script_ << "set " << letter << "range [" << lowest << ':' << highest << "]\n";
        if (!figure_.frame) {
            script_ << "unset " << letter << "tics\n";
            return;
        }
        script_ << "set " << letter << "label "
                << quote(axis.unit.empty() ? axis.title : axis.title + " (" + axis.unit + ")") << "\n";
        if (axis.grid) {
            script_ << "set grid " << letter << "tics linetype 1 linewidth 0.5 linecolor rgb '#D8D8D8'\n";
        }
        if (axis.ticks.empty()) {
            const int most = letter == "x" ? 6 : std::max(3, figure_.height / 70);
            script_ << "set " << letter << "tics " << tick_step(std::abs(highest - lowest), most) << "\n";
            return;
        }
        script_ << "set " << letter << "tics (";
        for (std::size_t index = 0; index < axis.ticks.size(); ++index) {
            script_ << (index ? ", " : "") << quote_tick(axis.ticks[index].second) << ' ' << axis.ticks[index].first;
        }
        script_ << ")\n";
    }

    std::pair<double, double> shown_range(const Axis& axis, const Extent& extent) const {
        if (axis.range && std::isfinite(axis.range->first) && std::isfinite(axis.range->second) &&
            axis.range->first != axis.range->second) {
            return *axis.range;
        }
        if (extent.empty()) {
            return {0, 1};
        }
        const double size = extent.highest - extent.lowest;
        if (!(size > 1e-9 * std::max(std::abs(extent.lowest), std::abs(extent.highest)))) {
            const double half = std::max(0.1 * std::abs(extent.lowest), 1e-6);
            return {extent.lowest - half, extent.lowest + half};
        }
        const double margin = has_map() ? 0 : 0.04 * size;
        return {extent.lowest - margin, extent.highest + margin};
    }

    bool has_map() const {
        return std::any_of(figure_.series.begin(), figure_.series.end(),
                           [](const Series& series) { return std::holds_alternative<HeatMap>(series); });
    }

    void write_labels() {
        for (const Label& label : figure_.labels) {
            if (!label.at.allFinite()) {
                continue;
            }
            const std::string_view align = label.align == Label::Align::left     ? "left"
                                           : label.align == Label::Align::centre ? "center"
                                                                                 : "right";
            script_ << "set label " << quote(label.text) << " at " << label.at.x() << ',' << label.at.y() << ' '
                    << align << " front offset character 0," << label.raise << " textcolor rgb " << rgb(label.colour);
            if (label.size != 1) {
                script_ << " font '," << label.size * text_height << "'";
            }
            script_ << (label.boxed ? " boxed" : "") << "\n";
        }
        if (plot_.tellp() == 0) {
            script_ << "set label 'no data' at graph 0.5,0.5 center front\n";
        }
    }

    void write_arrows() {
        for (const Arrow& arrow : figure_.arrows) {
            if (arrow.from.allFinite() && arrow.to.allFinite()) {
                script_ << "set arrow from " << arrow.from.x() << ',' << arrow.from.y() << " to " << arrow.to.x() << ','
                        << arrow.to.y() << (arrow.both_heads ? " heads" : " head")
                        << " filled size screen 0.02,18 front linewidth 1.5 linecolor rgb " << rgb(arrow.colour)
                        << "\n";
            }
        }
    }

    void write_drawing() {
        const auto terminal = [this](std::string_view kind, int scale) {
            script_ << "set terminal " << kind << " size " << scale * figure_.width << ',' << scale * canvas_height();
        };
        // Round joins, because gnuplot mitres the first point of a line as if it were closed.
        terminal("svg", 1);
        script_ << " dynamic rounded noenhanced font 'sans-serif," << text_height << "' background rgb 'white'\n"
                << "set output '" << name_ << ".svg'\nmarker = 0.6\n"
                << legend_commands() << "plot " << (plot_.tellp() == 0 ? "NaN" : plot_.str()) << "\n";
        // The picture has twice the size, for print. Its letters are measured in points of 4/3 px.
        terminal("pngcairo", 2);
        script_ << " rounded noenhanced font 'sans," << text_height
                << "' fontscale 1.5 linewidth 2 pointscale 2 background rgb 'white'\n"
                << "set output '" << name_ << ".png'\nmarker = 1\n"
                << legend_commands() << "replot\nset output\n";
    }

    const Figure& figure_;
    std::string_view name_;
    std::ostringstream script_ = classic_stream(digits_of_data);
    std::ostringstream data_ = classic_stream(digits_of_data);
    std::ostringstream plot_ = classic_stream(digits_of_data);
    Extent x_extent_;
    Extent y_extent_;
    std::vector<LegendEntry> legend_;
    double legend_height_ = text_height;  // px, of the letters in the legend
    int legend_rows_ = 0;
    int blocks_ = 0;
};

}  // namespace

std::string gnuplot_script(const Figure& figure, std::string_view name) {
    return ScriptWriter(figure, name).write();
}

}  // namespace delabole
