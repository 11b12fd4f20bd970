// Figures of the thesis's dynamic relaxation runs: the blocks at some cycles side by side, and histories over cycles.
// Lengths in inches, as in the thesis.
#pragma once

#include "cases/program/thesis/hocking/chapter_5.hpp"
#include "plots/figures/block_figures.hpp"

#include <functional>
#include <string>
#include <vector>

namespace delabole {

// The mode of a column by a print: it topples where it has turned by more than a degree, else slides where it has
// moved by more than a fiftieth of its width, else stays.
DrawnMode behaviour(const Chapter5Run& run, const HockingResult& result, const HockingPrint& print, std::size_t column);

// The greatest distance between the facing sides of two neighbouring columns.
struct JointOpening {
    std::size_t column = 0;  // the downhill one of the two
    double width = 0;        // m; negative: they overlap
};

// The widest joint between two of at least two columns.
JointOpening widest_opening(const Chapter5Run& run, const HockingPrint& print);

// Returns the last print that is not after a cycle.
const HockingPrint& print_at(const HockingResult& result, int cycle);

// Draws the blocks at these cycles, from left to right.
Figure frames_figure(const std::string& title, const Chapter5Run& run, const HockingResult& result,
                     const std::vector<int>& cycles);

// Gives drawings that are to be compared the ranges that hold all of them.
void set_one_scale(std::vector<Figure>& figures);

struct HistoryOf {
    std::string legend = {};
    const HockingResult* result = nullptr;
    std::function<double(const HockingPrint&)> value = {};
    // Histories of the clean engine are dashed, in the colour of the history before them.
    bool clean = false;
};

Figure history_figure(const std::string& title, const std::string& y_title, const std::string& y_unit,
                      const std::vector<HistoryOf>& histories);

}  // namespace delabole
