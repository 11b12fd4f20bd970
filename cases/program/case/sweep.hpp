// [[sweep]]: outputs of the case over one or two of its inputs, drawn and tabulated, and printed values to compare
// with.
#pragma once

#include "cases/program/reader/document.hpp"
#include "fitting/posterior/fit_problem.hpp"
#include "fitting/work/spaced_values.hpp"
#include "geometry/polyline.hpp"
#include "parameters/fields.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace delabole {

// An input that takes several values, SI.
struct SweptInput {
    std::string input;
    std::vector<std::string> also;  // further inputs of its dimension that take its value
    std::optional<double> from;     // first of the equally spaced values
    std::optional<double> to;
    std::optional<std::int64_t> points;
    static constexpr std::int64_t standard_points = 101;
    std::vector<double> listed;  // replaces from, to and points
    std::string axis;            // title of its axis with the unit; empty: its name and display unit
    std::string unit;            // unit of the axis; empty: the display unit
    Dimension dimension = Dimension::ratio;
    std::vector<double> values = {};  // all of them, increasing, at least two
    double si_per_unit = 1;

    bool equally_spaced() const { return listed.empty(); }
    double shown(double value) const { return value / si_per_unit; }
    static constexpr auto fields() {
        using I = SweptInput;
        constexpr Dimension named = Dimension::named;
        return FieldTable{
            refers_to(NameOf::input, section<&I::input>("the input that varies, e.g. strength.friction_angle")),
            refers_to(NameOf::input, section<&I::also>("further inputs that take the same value")),
            number<&I::from>(named, "first value of the input"),
            number<&I::to>(named, "last value of the input"),
            absent_is(standard_points, number<&I::points>(within(2, 10001), "number of its values")),
            number("values", &I::listed, named, any_number(), "its values, in place of from, to and points"),
            with_default(section<&I::axis>("title of its axis, with the unit")),
            with_default(section<&I::unit>("in which the axis counts"))};
    }
};

// A dashed curve has the colour of the solid curve before it; a dotted curve is a grey reference.
enum class CurveDash { solid, dashed, dotted };

struct SweepCurve {
    std::string label;
    std::string output;
    CurveDash dash = CurveDash::solid;
    std::vector<Condition> conditions;  // inputs that differ from the case's
    static constexpr auto fields() {
        return FieldTable{section<&SweepCurve::label>("the curve in words"),
                          with_default(section<&SweepCurve::output>("name of an output of the model")),
                          with_default(section<&SweepCurve::dash>("how it is drawn")),
                          section("with", &SweepCurve::conditions, "inputs that differ from the case's")};
    }
};

// Points as they are printed, in the units of the axes. Points that stand for a curve are joined by a line.
struct PrintedPoints {
    std::string label;
    std::string source;
    bool line = false;
    Polyline points;
    static constexpr auto fields() {
        return FieldTable{section<&PrintedPoints::label>("what is printed, in words"),
                          with_default(section<&PrintedPoints::source>("where it is printed")),
                          with_default(section<&PrintedPoints::line>("whether the points stand for a curve")),
                          number<&PrintedPoints::points>("points in the units of the axes, [[x, y], ...]")};
    }
};

// A printed remark on curves, which is tested.
struct CurveRemark {
    std::string label;
    std::string curve;
    std::string other;
    std::string source;
    std::string note;
    std::optional<std::string> unreachable;  // why the remark cannot be met: then it is shown but does not fail
    static constexpr auto fields() {
        return FieldTable{section<&CurveRemark::label>("what is compared, in words"),
                          section<&CurveRemark::curve>("label of a curve"),
                          with_default(section<&CurveRemark::other>("label of the other curve")),
                          with_default(section<&CurveRemark::source>("where it is printed")),
                          with_default(section<&CurveRemark::note>("what a reader should know of it")),
                          section<&CurveRemark::unreachable>("why what is printed cannot be reached")};
    }
};

// The first point where two curves meet, and the printed one; SI.
struct CurveCrossing : CurveRemark {
    std::optional<double> printed;    // of the input
    std::optional<double> tolerance;  // needed for a printed value that can be reached
    static constexpr auto fields() {
        using C = CurveCrossing;
        return joined(CurveRemark::fields(),
                      FieldTable{number<&C::printed>(Dimension::named, "where it is printed to be"),
                                 number<&C::tolerance>(Dimension::named, at_least(0), "of what is printed")});
    }
};

enum class CurveRelation { falls, rises, below, above };

// A printed statement that holds at all points of a curve with values, or for crossings over `each`: the curve falls or
// rises, or lies below or above another curve.
struct CurveStatement : CurveRemark {
    CurveRelation relation = CurveRelation::falls;
    static constexpr auto fields() {
        return joined(CurveRemark::fields(),
                      FieldTable{section("is", &CurveStatement::relation, "what is stated of the curve")});
    }
};

// Which figures of a sweep with `each` are drawn.
enum class SweepDrawing { all, crossings };

struct SweepInputs {
    std::string name;  // of the sweep's files
    std::string title;
    std::string caption;
    std::string output_axis;           // title of the axis of outputs; empty: the output's name
    std::optional<SweepDrawing> draw;  // absent: all
    std::vector<SweptInput> vary;  // the first is the axis; a second one gives a curve for each of its values, or a map
    std::optional<SweptInput> each;  // gives a figure for each of its values, and one of the crossings over them
    static constexpr auto fields() {
        return FieldTable{section<&SweepInputs::name>("name of its files"),
                          with_default(section<&SweepInputs::title>("title of its figures")),
                          with_default(section<&SweepInputs::caption>("caption of its figures")),
                          with_default(section<&SweepInputs::output_axis>("title of the axis of outputs")),
                          section<&SweepInputs::draw>("which figures are drawn"),
                          section<&SweepInputs::vary>("the inputs that vary"),
                          section<&SweepInputs::each>("an input of which each value has a figure")};
    }
};

struct SweepCurves {
    std::vector<SweepCurve> curves;  // at least one
    std::vector<PrintedPoints> printed;
    std::vector<CurveCrossing> crossings;
    std::vector<CurveStatement> statements;
    Dimension dimension = Dimension::ratio;  // of the input along the axis
    static constexpr auto fields() {
        using C = SweepCurves;
        return FieldTable{section("curve", &C::curves, "what is drawn"), section<&C::printed>("what is printed of it"),
                          section("crossing", &C::crossings, "where two curves meet"),
                          section("statement", &C::statements, "what is stated of the curves")};
    }
};

struct CaseSweep : SweepInputs, SweepCurves {
    Place place = {};
};

}  // namespace delabole
