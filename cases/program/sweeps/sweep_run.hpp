// [[sweep]] computed: outputs of a case over its inputs, where curves cross, and whether printed statements on them
// hold.
#pragma once

#include "cases/program/case/case_file.hpp"
#include "cases/program/results/comparison.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace delabole {

// Values of one curve, first input fastest. Where there is no number, NaN and the word that stands for it: the output's
// own, as "none", or the check that failed.
struct SweptCurve {
    std::string label;
    Dimension dimension = Dimension::ratio;
    std::vector<double> values;
    std::vector<std::string> words;
};

// One value of `each`; the only one where there is none.
struct SweptFigure {
    std::optional<double> each;
    std::vector<SweptCurve> curves;
    std::vector<std::optional<double>> crossings;  // SI, in the order of the sweep's
};

struct SweepRun {
    CaseSweep sweep;
    std::vector<SweptFigure> figures;  // in the order of `each`
};

struct SweepWork {
    int threads = 1;
    std::function<void(double share)> progress = {};  // from one thread at a time
};

// Crossings are found between the points by bisection (GSL) to full double precision; the first one counts. Interrupted
// once the flag of cases/program/terminal/interrupt.hpp is set; CaseError for an output that the model never has.
SweepRun run_sweep(const CaseFile& file, const CaseSweep& sweep, const SweepWork& work);

// "a / b = 3"
std::string each_in_words(const SweptInput& each, double value);

// The crossings of a sweep with `each`, as curves over the values of that.
std::vector<SweptCurve> crossing_curves(const SweepRun& run);

// Printed crossings and statements beside the computed ones.
std::vector<Comparison> compare_sweep(const SweepRun& run);

// All that is printed of the sweeps of a case; those of which nothing is are not run.
std::vector<Comparison> compare_sweeps(const CaseFile& file, const SweepWork& work);

}  // namespace delabole
