// Computes [[sweep]]: outputs of a case over its inputs, where curves cross, and whether printed statements on them
// hold.
#pragma once

#include "cases/program/case/case_file.hpp"
#include "cases/program/results/comparison.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace delabole {

// Values of one curve, with the first input varying fastest. A value without a number is NaN, with a word in its place:
// that of the output, such as "none", or the name of the check that failed.
struct SweptCurve {
    std::string label;
    Dimension dimension = Dimension::ratio;
    std::vector<double> values;
    std::vector<std::string> words;
};

// The figure for one value of `each`; without `each` there is a single one.
struct SweptFigure {
    std::optional<double> each;
    std::vector<SweptCurve> curves;
    std::vector<std::optional<double>> crossings;  // SI, in the order of the sweep's crossings
};

struct SweepRun {
    CaseSweep sweep;
    std::vector<SweptFigure> figures;  // in the order of `each`
};

struct SweepWork {
    int threads = 1;
    std::function<void(double share)> progress = {};  // called by one thread at a time
};

// Crossings between the points are found by bisection (GSL) to full double precision; the first one counts. Throws
// Interrupted once the flag of cases/program/terminal/interrupt.hpp is set, and CaseError for an output that the model
// never has.
SweepRun run_sweep(const CaseFile& file, const CaseSweep& sweep, const SweepWork& work);

// "a / b = 3"
std::string each_in_words(const SweptInput& each, double value);

// The crossings of a sweep with `each`, as curves over its values.
std::vector<SweptCurve> crossing_curves(const SweepRun& run);

// Compares printed crossings and statements with computed ones.
std::vector<Comparison> compare_sweep(const SweepRun& run);

// The comparisons of all sweeps of a case; sweeps without printed values are not run.
std::vector<Comparison> compare_sweeps(const CaseFile& file, const SweepWork& work);

}  // namespace delabole
