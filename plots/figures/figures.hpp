// The figures of a plane-failure analysis, drawn from plain numbers.
//
// Lengths in metres; values that have a Dimension are given in SI base units and drawn in its display unit.
#pragma once

#include "parameters/fields.hpp"
#include "plots/drawing/figure.hpp"
#include "plots/drawing/free_place.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace delabole {

// A dashed line at a height.
Line level_line(double from, double to, double height, std::string legend, Colour colour);

// Sets the vertical axis for that many rows of bars, the lowest at 1, and the height of the figure, px.
void set_rows(Figure& figure, std::size_t rows, int around, int height_of_row);

// "strength.friction_angle" and an angle give the axis "strength: friction angle (deg)".
Axis axis_of(std::string_view name, Dimension dimension);

struct NamedCurve {
    std::string legend = {};
    Polyline points = {};
};

// Pressure normal to a surface, drawn as a shaded diagram on the right-hand side of the surface in the direction from
// its first to its last point; that is below a failure plane given upwards from the toe.
struct PressureDiagram {
    Polyline surface = {};
    std::vector<double> pressure = {};  // Pa, >= 0, one per point of the surface
};

struct LevelMark {
    double height;  // m above the toe
    std::string text = {};
};

// An arrow with its text at the tip. The greatest force of a section has the longest arrow; forces of less than a third
// of it have an arrow of a third of that length.
struct SectionForce {
    Point at;         // the arrow's tail
    Point direction;  // of unit length
    double force;     // N/m; not drawn unless positive
    std::string text = {};
};

// A dimension line between two points.
struct Measure {
    Point from;
    Point to;
    std::string text = {};
};

void add_measure(const Measure& measure, Figure& figure);

// A text, put at the first of its places where it hides nothing.
struct SectionNote {
    std::vector<LabelPlace> places = {};
    std::string text = {};
};

// A section: origin at the toe, x into the slope, y up, m. Empty members are not drawn.
struct SectionDrawing {
    std::string title = {};
    Polyline ground = {};          // before the failure, from in front of the toe to behind the crest
    Polyline failure_plane = {};   // from where it daylights to the bottom of the crack
    Polyline tension_crack = {};   // from its bottom to the ground
    Polyline water_in_crack = {};  // the part of the crack that holds water, from its bottom up
    std::vector<PressureDiagram> water_pressure = {};
    Polyline observed_profile = {};   // ground left standing
    Polyline predicted_profile = {};  // ground left standing
    std::vector<LevelMark> levels = {};
    std::vector<SectionForce> forces = {};
    std::vector<Polyline> bolts = {};  // each from its head to its end
    std::vector<Measure> measures = {};
    std::vector<SectionNote> notes = {};
    double toe_elevation = 0;  // m; added to heights on the vertical axis
};

Figure section_figure(const SectionDrawing& drawing);

// A printed statement, marked by a letter in the figure and spelled out in the legend.
struct PrintedStatement {
    std::string text = {};
    Point at;
};

// `x_unit` and `y_unit` are the SI values of one unit of the figure's axes, whose ranges must be given. The letters
// stand beside their marks where they hide least of the series that the figure has by then.
void mark_statements(const std::vector<PrintedStatement>& statements, double x_unit, double y_unit, Figure& figure);

// Factor of safety against depth of water over depth of crack, one curve for each cohesion.
struct WaterDepthCurves {
    std::string title = {};
    std::string ratio = "filled ratio of the water level";  // title of the x axis
    std::vector<NamedCurve> curves = {};                    // x: that ratio, from 0 to 1; y: factor of safety
    std::vector<PrintedStatement> statements = {};          // in the same axes
};

Figure factor_of_safety_against_water(const WaterDepthCurves& data);

// The range measured in a laboratory; a parameter without a range is not limited.
struct LaboratoryRange {
    std::string legend = {};
    std::optional<Interval> friction_angle = {};  // rad
    std::optional<Interval> cohesion = {};        // Pa
};

// Pairs of friction angle and cohesion with which the slope just fails, one locus for each water level.
struct FailureLoci {
    std::string title = {};
    std::vector<NamedCurve> loci = {};  // x: friction angle, rad; y: cohesion, Pa
    std::vector<LaboratoryRange> laboratory = {};
    std::optional<Point> given = {};  // of the slope itself, in the same axes
};

Figure failure_locus_figure(const FailureLoci& data);

struct SensitivityBar {
    std::string name = {};    // of the input
    std::string change = {};  // the change of the input: "+1 deg"
    double effect;            // signed change of the factor of safety
    bool pale = false;
};

// The eight longest bars, the longest on top. Bars without a finite effect are left out.
Figure tornado_figure(std::string_view title, std::vector<SensitivityBar> bars);

// Factor of safety against one quantity of the geometry, with the least one marked.
struct CriticalSearchDrawing {
    std::string title = {};
    std::string quantity = {};  // "failure_plane.dip"
    Dimension dimension;
    std::vector<NamedCurve> curves = {};  // x: the quantity, SI; y: factor of safety
    Point critical;                       // in the same axes; not finite if none was found
};

Figure critical_figure(const CriticalSearchDrawing& drawing);

}  // namespace delabole
