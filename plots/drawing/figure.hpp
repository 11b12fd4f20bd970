// A figure as a value, and its way to the disk: first a gnuplot script that holds everything, then pictures made from
// it.
//
// Coordinates are in the units that the axes name. Numbers that are not finite break a line and are left out of
// everything else. Texts are plain UTF-8: no markup, so that factor_of_safety keeps its underscores.
#pragma once

#include "geometry/polyline.hpp"
#include "plots/drawing/atomic_file.hpp"

#include <Eigen/Core>

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace delabole {

// Told apart by readers with any of the common colour-vision deficiencies (Okabe & Ito 2008), in this order.
enum class Colour { black, blue, vermilion, green, orange, purple, sky, grey, light_grey, rock, white };

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

// Filled rectangles: bars of either direction.
struct Boxes {
    struct Box {
        Point lower_left;
        Point upper_right;
    };
    std::vector<Box> boxes = {};
    std::string legend = {};
    Colour colour = Colour::blue;
};

// Values over a grid, light for low and dark for high values, with its colour scale beside the figure.
struct HeatMap {
    std::vector<double> x_values = {};  // equally spaced, at least two
    std::vector<double> y_values = {};  // equally spaced, at least two
    Eigen::MatrixXd values = {};        // values(row, column) at y(row), x(column); not finite: no answer, drawn grey
    std::string scale_title = {};
    double ceiling = 1;                 // end of the colour scale; higher values are drawn in its last colour
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

constexpr double text_height = 19;  // px, so that it stays legible on a phone of half the width of a figure

struct Label {
    enum class Align { left, centre, right };
    Point at;
    std::string text = {};
    Align align = Align::left;
    Colour colour = Colour::black;
    double raise = 0;   // moves the text up by so many letter heights
    bool boxed = true;  // on a white ground, where lines cross behind it
    double size = 1;    // of the figure's text
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
    std::optional<std::pair<double, double>> range = {};     // absent: from the data
    std::vector<std::pair<double, std::string>> ticks = {};  // absent: gnuplot's own
    bool grid = true;
};

struct Figure {
    std::string title = {};
    Axis x = {};
    Axis y = {};
    std::vector<Series> series = {};  // drawn in this order
    std::vector<Label> labels = {};
    std::vector<Arrow> arrows = {};
    bool equal_scales = false;  // one metre is as long upwards as it is sideways
    bool frame = true;          // false: neither border nor axes, for what brings its own
    int width = 640;            // px
    int height = 450;           // px, without the legend, which is added below
};

// Adds the line if it has points.
void add_line(Figure& figure, Line line);

// The gnuplot script: settings, data and plot command, drawn to <name>.svg and <name>.png in the working folder.
// Independent of the locale. A figure without one finite number becomes an empty frame that says so.
std::string gnuplot_script(const Figure& figure, std::string_view name);

enum class FigureStatus {
    ok,
    gnuplot_missing,  // no gnuplot in PATH; the script was written
    gnuplot_failed,   // gnuplot refused the script or left unusable pictures; the script was written
    cannot_write,     // the folder or a file in it could not be written
};

struct FigureFiles {
    FigureStatus status = FigureStatus::cannot_write;
    std::string message = {};  // for a reader, one line; empty when ok and gnuplot had nothing to remark
    std::filesystem::path script = {};
    std::filesystem::path svg = {};
    std::filesystem::path png = {};
    std::optional<OutputError> write_error = {};  // where the status is cannot_write
};

// Writes <name>.gp into `folder` (created when missing) and has gnuplot draw <name>.svg and <name>.png from it. What
// can go wrong outside is a status, because a figure is never worth an analysis. Pictures of an earlier run are removed
// when they cannot be replaced. `name` consists of letters, digits, '_' and '-'; std::invalid_argument otherwise.
FigureFiles write_figure(const Figure& figure, const std::filesystem::path& folder, const std::string& name);

// Removes what processes that were killed while gnuplot drew have left in a folder of figures. Nobody else may draw
// there meanwhile.
void remove_abandoned_drawings(const std::filesystem::path& folder);

// Shared by the runs of gnuplot of one command: where one did not end in time, the next figures get their scripts only.
// A command with dozens of figures would wait for each of them.
struct GnuplotRuns {
    std::chrono::seconds time_limit{60};  // of one run, which takes a fraction of a second
    std::string none_because = {};        // gnuplot is not run any more, in words; empty: it is
};

FigureFiles write_figure(const Figure& figure, const std::filesystem::path& folder, const std::string& name,
                         GnuplotRuns& runs);

// The same for a script made elsewhere; it has to draw <name>.svg and <name>.png in its working folder.
FigureFiles write_script_and_draw(const std::string& script, const std::filesystem::path& folder,
                                  const std::string& name, GnuplotRuns& runs);

}  // namespace delabole
