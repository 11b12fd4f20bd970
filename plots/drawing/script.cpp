#include "plots/drawing/extent.hpp"
#include "plots/drawing/figure.hpp"
#include "plots/drawing/gnuplot_words.hpp"
#include "plots/drawing/text.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <locale>
#include <sstream>

namespace delabole {

namespace {

constexpr double text_height = 19;  // px
constexpr double mean_letter_width = 0.56 * text_height;

bool finite(const Point& point) {
    return std::isfinite(point.x()) && std::isfinite(point.y());
}

Rows rows_of(const Polyline& points, bool keep_gaps) {
    constexpr double gap = std::numeric_limits<double>::quiet_NaN();
    Rows rows;
    for (const Point& point : points) {
        if (finite(point)) {
            rows.push_back({point.x(), point.y()});
        } else if (keep_gaps && !rows.empty()) {
            rows.push_back({gap, gap});
        }
    }
    return rows;
}

class ScriptWriter {
  public:
    ScriptWriter(const Figure& figure, std::string_view name) : figure_(figure), name_(name) {
        for (std::ostringstream* stream : {&script_, &data_, &plot_}) {
            stream->imbue(std::locale::classic());
            stream->precision(12);
        }
    }

    std::string write() {
        for (const Series& series : figure_.series) {
            std::visit([this](const auto& content) { add(content); }, series);
        }
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

    std::string add_data(const Rows& rows) {
        std::string block = "$series_" + std::to_string(++blocks_);
        data_ << block << " << EOD\n" << data_lines(rows) << "EOD\n";
        return block;
    }

    std::ostringstream& next_plot() {
        plot_ << (plot_.tellp() > 0 ? ", \\\n     " : "");
        return plot_;
    }

    void note_legend(std::string_view legend) {
        if (!legend.empty()) {
            longest_legend_ = std::max(longest_legend_, letter_count(legend));
            ++legends_;
        }
    }

    // Two entries to a row where there is room: gnuplot's own choice of columns differs between terminals.
    int legend_rows() const {
        constexpr int few = 3;
        // px, as gnuplot's SVG reckons it, which is the wider of the two terminals.
        const double column = 0.66 * text_height * static_cast<double>(longest_legend_) + 110;
        return legends_ > few && 2 * column <= figure_.width ? (legends_ + 1) / 2 : legends_;
    }

    int legend_height() const {
        if (figure_.legend != LegendPlace::below || legends_ == 0) {
            return 0;
        }
        return static_cast<int>(std::ceil(legend_rows() * 1.4 * text_height)) + 8;
    }

    // The canvas grows with a legend below, so that the plot keeps its size.
    int canvas_height() const { return figure_.height + legend_height(); }

    // gnuplot's own "below" centres the legend under the axes, where it may reach over the edge of the canvas.
    void write_legend_below() {
        if (legends_ == 0) {
            script_ << "unset key\n";
            return;
        }
        const double axis_height = figure_.frame ? 86 : 12;  // px, numbers and title of the x axis
        script_ << "set key at screen 0.5," << 4.0 / canvas_height() << " center bottom vertical maxrows "
                << legend_rows() << " Left reverse samplen 2 width 1";
        // A long legend in smaller letters rather than over the edge.
        const double share = figure_.width / (0.62 * text_height * static_cast<double>(longest_legend_) + 90);
        if (share < 1) {
            script_ << " font '," << std::max(11.0, std::floor(share * text_height)) << "'";
        }
        script_ << "\nset bmargin at screen " << (legend_height() + axis_height) / canvas_height() << "\n";
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
        note_legend(line.legend);
        const std::string block = add_data(rows);
        next_plot() << block << " using 1:2 with lines linewidth " << line.width << " dashtype " << dash_type(line.dash)
                    << " linecolor rgb " << rgb(line.colour) << ' ' << legend_of(line.legend);
    }

    void add(const Points& points) {
        const Rows rows = rows_of(points.points, false);
        if (rows.empty()) {
            return;
        }
        include(rows);
        note_legend(points.legend);
        const std::string block = add_data(rows);
        next_plot() << block << " using 1:2 with points pointtype " << point_type(points.marker) << " pointsize marker*"
                    << points.size << " linewidth 2 linecolor rgb " << rgb(points.colour) << ' '
                    << legend_of(points.legend);
    }

    void add(const Region& region) {
        const Rows rows = rows_of(region.outline, false);
        if (rows.size() < 3) {
            return;
        }
        include(rows);
        note_legend(region.legend);
        const std::string block = add_data(rows);
        next_plot() << block << " using 1:2 with filledcurves closed fillcolor rgb " << rgb(region.colour)
                    << " fillstyle transparent solid " << region.opacity << " noborder " << legend_of(region.legend);
    }

    void add(const Boxes& boxes) {
        Rows rows;
        for (const Boxes::Box& box : boxes.boxes) {
            if (finite(box.lower_left) && finite(box.upper_right)) {
                rows.push_back({box.lower_left.x(), box.lower_left.y(), box.upper_right.x(), box.upper_right.y()});
                include({{box.upper_right.x(), box.upper_right.y()}});
            }
        }
        if (rows.empty()) {
            return;
        }
        include(rows);
        note_legend(boxes.legend);
        const std::string block = add_data(rows);
        next_plot() << block << " using (0.5*($1+$3)):(0.5*($2+$4)):1:3:2:4 with boxxyerror fillcolor rgb "
                    << rgb(boxes.colour) << " fillstyle solid noborder " << legend_of(boxes.legend);
    }

    void add(const Arrows& arrows) {
        Rows rows;
        for (const Arrows::Shaft& shaft : arrows.shafts) {
            if (finite(shaft.from) && finite(shaft.to)) {
                rows.push_back({shaft.from.x(), shaft.from.y(), shaft.to.x(), shaft.to.y()});
                include({{shaft.to.x(), shaft.to.y()}});
            }
        }
        if (rows.empty()) {
            return;
        }
        include(rows);
        note_legend(arrows.legend);
        const std::string block = add_data(rows);
        next_plot() << block << " using 1:2:($3-$1):($4-$2) with vectors head filled size screen 0.013,20 linewidth "
                    << arrows.width << " linecolor rgb " << rgb(arrows.colour) << ' ' << legend_of(arrows.legend);
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
        // YlGnBu of Brewer's colour schemes: light to dark for every kind of colour vision, and in black and white
        // print.
        script_ << "set palette defined (0 '#ffffd9', 1 '#edf8b1', 2 '#c7e9b4', 3 '#7fcdbb', 4 '#41b6c4', 5 '#1d91c0', "
                   "6 '#225ea8')\nset cbrange [0:"
                << map.ceiling << "]\nset cbtics " << tick_step(map.ceiling, 6) << "\nset cblabel "
                << quote(map.scale_title) << "\n";
        const std::string block = add_data(rows);
        if (gaps) {
            // The image is transparent where it has no value.
            script_ << "set object 1 rectangle from graph 0,0 to graph 1,1 behind fillcolor rgb "
                    << rgb(Colour::light_grey) << " fillstyle solid noborder\n";
            if (!map.no_answer_legend.empty()) {
                note_legend(map.no_answer_legend);
                next_plot() << "keyentry with boxes fillcolor rgb " << rgb(Colour::light_grey)
                            << " fillstyle solid noborder " << legend_of(map.no_answer_legend);
            }
        }
        next_plot() << block << " using 1:2:($3>" << map.ceiling << "?" << map.ceiling << ":$3) with image notitle";
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
        switch (figure_.legend) {
        case LegendPlace::none:
            script_ << "unset key\n";
            return;
        case LegendPlace::below:
            write_legend_below();
            return;
        case LegendPlace::top_left:
            script_ << "set key inside top left opaque";
            break;
        case LegendPlace::top_right:
            script_ << "set key inside top right opaque";
            break;
        case LegendPlace::bottom_left:
            script_ << "set key inside bottom left opaque";
            break;
        case LegendPlace::bottom_right:
            script_ << "set key inside bottom right opaque";
            break;
        }
        script_ << " Left reverse samplen 2 width 1\n";
    }

    // Lines of about equal length, as many as the width asks for.
    std::string title_lines() const {
        const auto across = static_cast<std::size_t>(std::max(10.0, (figure_.width - 60) / mean_letter_width));
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
            if (!finite(label.at)) {
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
            if (finite(arrow.from) && finite(arrow.to)) {
                script_ << "set arrow from " << arrow.from.x() << ',' << arrow.from.y() << " to " << arrow.to.x() << ','
                        << arrow.to.y() << (arrow.both_heads ? " heads" : " head")
                        << " filled size screen 0.02,18 front linewidth 1.5 linecolor rgb " << rgb(arrow.colour)
                        << "\n";
            }
        }
    }

    std::string key_spacing(double spacing) const {
        std::ostringstream text;
        text.imbue(std::locale::classic());
        text << "set key spacing " << spacing << "\n";
        return figure_.legend == LegendPlace::none || legends_ == 0 ? "" : text.str();
    }

    void write_drawing() {
        const auto terminal = [this](std::string_view kind, int scale) {
            script_ << "set terminal " << kind << " size " << scale * figure_.width << ',' << scale * canvas_height();
        };
        // The terminals differ in the size of their markers and in the height of a line of text.
        terminal("svg", 1);
        script_ << " dynamic noenhanced font 'sans-serif," << text_height << "' background rgb 'white'\n"
                << "set output '" << name_ << ".svg'\nmarker = 0.6\n"
                << key_spacing(0.92) << "plot " << (plot_.tellp() == 0 ? "NaN notitle" : plot_.str()) << "\n";
        // Twice the size, for print. Its letters are measured in points of 4/3 px.
        terminal("pngcairo", 2);
        script_ << " noenhanced font 'sans," << text_height
                << "' fontscale 1.5 linewidth 2 pointscale 2 background rgb 'white'\n"
                << "set output '" << name_ << ".png'\nmarker = 1\n"
                << key_spacing(1.1) << "replot\nset output\n";
    }

    const Figure& figure_;
    std::string_view name_;
    std::ostringstream script_;
    std::ostringstream data_;
    std::ostringstream plot_;
    Extent x_extent_;
    Extent y_extent_;
    std::size_t longest_legend_ = 0;
    int legends_ = 0;
    int blocks_ = 0;
};

}  // namespace

std::string gnuplot_script(const Figure& figure, std::string_view name) {
    return ScriptWriter(figure, name).write();
}

}  // namespace delabole
