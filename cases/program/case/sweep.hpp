// [[sweep]]: outputs of the case over one or two of its inputs, drawn and tabulated, and what is printed of them.
#pragma once

#include "cases/program/reader/document.hpp"
#include "fitting/posterior/fit_problem.hpp"
#include "geometry/polyline.hpp"
#include "parameters/fields.hpp"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace delabole {

// An input that takes several values, SI.
struct SweptInput {
    std::string input;
    std::vector<std::string> also;  // further inputs of its dimension that take its value
    Dimension dimension = Dimension::ratio;
    std::vector<double> values;   // increasing, at least two
    bool equally_spaced = false;  // given by its ends
    std::string axis;             // title of its axis with the unit; empty: its name and display unit
    std::string unit;             // in which the axis counts; empty: the display unit
    double si_per_unit = 1;

    double shown(double value) const { return value / si_per_unit; }
};

// A dashed curve has the colour of the solid one before it, a dotted one is a reference in grey.
enum class CurveDash { solid, dashed, dotted };

constexpr std::array<std::string_view, 3> enum_names(CurveDash) {
    return {"solid", "dashed", "dotted"};
}

struct SweepCurve {
    std::string label;
    std::string output;
    CurveDash dash = CurveDash::solid;
    std::vector<Condition> conditions;  // inputs that differ from the case's
};

// Points as they are printed, in the units of the axes; of few points that stand for a curve, a line.
struct PrintedPoints {
    std::string label;
    Polyline points;
    bool line = false;
    std::string source;
};

enum class CurveRelation { falls, rises, below, above };

constexpr std::array<std::string_view, 4> enum_names(CurveRelation) {
    return {"falls", "rises", "below", "above"};
}

// A printed statement on a curve, wherever there are values; or on crossings over `each`.
struct CurveStatement {
    std::string label;
    std::string curve;
    CurveRelation relation = CurveRelation::falls;
    std::string other;  // the curve that `curve` is below or above
    std::string source;
    std::string note;
    std::optional<std::string> unreachable;  // why it is not met: shown, not failed
};

// Where two curves meet first, and where they are printed to meet; SI.
struct CurveCrossing {
    std::string label;
    std::string curve;
    std::string other;
    std::optional<double> printed;    // of the input
    std::optional<double> tolerance;  // there where something is printed that can be reached
    std::string source;
    std::string note;
    std::optional<std::string> unreachable;
};

// What is drawn of a sweep with `each`.
enum class SweepDrawing { all, crossings };

constexpr std::array<std::string_view, 2> enum_names(SweepDrawing) {
    return {"all", "crossings"};
}

struct CaseSweep {
    std::string name;  // of its files
    std::string title;
    std::string caption;
    std::string output_axis;         // title of the axis of outputs; empty: the output's name
    std::vector<SweptInput> vary;    // the first along the axis; of a second one a curve for each value, or a map
    std::optional<SweptInput> each;  // a figure for each of its values, and one of the crossings over them
    SweepDrawing draw = SweepDrawing::all;
    std::vector<SweepCurve> curves;  // at least one
    std::vector<PrintedPoints> printed;
    std::vector<CurveCrossing> crossings;
    std::vector<CurveStatement> statements;
    Place place = {};
};

// Ends where an input is meant to end, and equal steps between.
std::vector<double> spaced_values(double from, double to, int points);

}  // namespace delabole
