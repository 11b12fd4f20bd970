// A figure as a value, and its output: first a gnuplot script that holds everything, then pictures made from the
// script.
//
// Coordinates are in the units that the axes name. Numbers that are not finite interrupt a line and are left out of
// everything else. Texts are plain UTF-8 without markup, so that factor_of_safety keeps its underscores.
#pragma once

#include "geometry/polyline.hpp"
#include "plots/drawing/atomic_file.hpp"

#include <Eigen/Core>

#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace delabole {

// Colours in an order in which readers with any common colour-vision deficiency can distinguish them (Okabe & Ito
// 2008).
enum class Colour {
    black,
    blue,
    vermilion,
    green,
    orange,
    purple,
    sky,
    grey,
    light_grey,
    rock,
    white,
    pale_blue,
    pale_vermilion
};

enum class Dash { solid, dashed, dotted };

enum class Marker { circle, filled_circle, filled_square, filled_triangle, filled_diamond, cross };

// An empty legend keeps a series out of the legend.
struct Line {
    Polyline points = {};
    std::string legend = {};
    Colour colour = Colour::black;
    Dash dash = Dash::solid;
    double width = 2.5;  // px
};

struct Points {
    Polyline points = {};
    std::string legend = {};
    Colour colour = Colour::black;
    Marker marker = Marker::filled_circle;
    double size = 1.2;  // of gnuplot's standard size
};

// A filled polygon; the outline need not repeat its first point.
struct Region {
    Polyline outline = {};
    std::string legend = {};
    Colour colour = Colour::grey;
    double opacity = 0.3;
};

// Filled rectangles, such as vertical or horizontal bars.
struct Boxes {
    struct Box {
        Point lower_left;
        Point upper_right;
    };
    std::vector<Box> boxes = {};
    std::string legend = {};
    Colour colour = Colour::blue;
};

// Values over a grid, light for low and dark for high values, with a colour scale beside the figure.
struct HeatMap {
    std::vector<double> x_values = {};  // equally spaced, at least two
    std::vector<double> y_values = {};  // equally spaced, at least two
    Eigen::MatrixXd values = {};        // values(row, column) at y(row), x(column); not finite: no answer, drawn grey
    std::string scale_title = {};
    double ceiling = 1;                 // end of the colour scale; higher values are drawn in the last colour
    std::string no_answer_legend = {};  // appears when a value is not finite
};

// Arrows that share a legend.
struct Arrows {
    struct Shaft {
        Point from;
        Point to;
    };
    std::vector<Shaft> shafts = {};
    std::string legend = {};
    Colour colour = Colour::black;
    double width = 2.2;  // px
};

using Series = std::variant<Line, Points, Region, Boxes, HeatMap, Arrows>;

constexpr double text_height = 19;  // px; legible on a phone that shows the figure at half its width

struct Label {
    enum class Align { left, centre, right };
    Point at;
    std::string text = {};
    Align align = Align::left;
    Colour colour = Colour::black;
    double raise = 0;   // moves the text up by this many letter heights
    bool boxed = true;  // on a white background, where lines cross behind it
    double size = 1;    // relative to the figure's text
};

struct Arrow {
    Point from;
    Point to;
    Colour colour = Colour::black;
    bool both_heads = false;
};

struct Axis {
    std::string title = {};
    std::string unit = {};                                   // empty for a ratio
    std::optional<std::pair<double, double>> range = {};     // absent: set by the data
    std::vector<std::pair<double, std::string>> ticks = {};  // absent: set by gnuplot
    bool grid = true;
};

struct Figure {
    std::string title = {};
    Axis x = {};
    Axis y = {};
    std::vector<Series> series = {};  // drawn in this order
    std::vector<Label> labels = {};
    std::vector<Arrow> arrows = {};
    bool equal_scales = false;  // one metre is as long vertically as horizontally
    bool frame = true;          // false: neither border nor axes, for drawings that have their own
    int width = 640;            // px
    int height = 450;           // px, without the legend, which is added below
};

// Adds the line if it has points.
void add_line(Figure& figure, Line line);

// The gnuplot script: settings, data and plot command, drawn to <name>.svg and <name>.png in the working folder. It
// does not depend on the locale. A figure without any finite number becomes an empty frame that says so.
std::string gnuplot_script(const Figure& figure, std::string_view name);

enum class FigureStatus {
    ok,
    gnuplot_missing,  // no gnuplot in PATH; the script was written
    gnuplot_failed,   // gnuplot rejected the script or left unusable pictures; the script was written
    cannot_write,     // the folder or a file in it could not be written
};

struct FigureFiles {
    FigureStatus status = FigureStatus::cannot_write;
    std::string message = {};  // one line for the reader; empty if ok and gnuplot gave no message
    std::filesystem::path script = {};
    std::filesystem::path svg = {};
    std::filesystem::path png = {};
    std::optional<OutputError> write_error = {};  // if the status is cannot_write
};

// Writes <name>.gp into `folder` (created if missing) and runs gnuplot to draw <name>.svg and <name>.png from it.
// Failures of the system and of gnuplot are statuses, because an analysis must never fail for a figure. Pictures of an
// earlier run are removed if they cannot be replaced. `name` consists of letters, digits, '_' and '-'; otherwise
// std::invalid_argument is thrown.
FigureFiles write_figure(const Figure& figure, const std::filesystem::path& folder, const std::string& name);

// Removes the files that processes killed during a run of gnuplot have left in a folder of figures. No other process
// may draw there at the same time.
void remove_abandoned_drawings(const std::filesystem::path& folder);

// Shared by the runs of gnuplot of one command. After one that did not end in time the next figures only get scripts,
// since a command with dozens of figures would otherwise wait for each of them.
struct GnuplotRuns {
    std::chrono::seconds time_limit{60};  // of one run, which usually takes a fraction of a second
    std::string none_because = {};        // the reason why gnuplot is not run any more; empty: it is run
    std::function<bool()> give_up = {};   // whether the figure being drawn is not wanted any more
};

FigureFiles write_figure(const Figure& figure, const std::filesystem::path& folder, const std::string& name,
                         GnuplotRuns& runs);

// Writes and draws a script made elsewhere; it has to draw <name>.svg and <name>.png in its working folder.
FigureFiles write_script_and_draw(const std::string& script, const std::filesystem::path& folder,
                                  const std::string& name, GnuplotRuns& runs);

}  // namespace delabole
