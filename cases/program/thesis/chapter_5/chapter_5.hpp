// The items of the thesis's chapter 5, dynamic relaxation. What their reports say, in which order, is data:
// cases/thesis/chapter_5/report.csv. What is computed for single items is declared at the end.
#pragma once

#include "cases/program/thesis/chapter_5/clean_chapter_5.hpp"
#include "cases/program/thesis/reproduction.hpp"

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace delabole {

// "stands", "blows out at cycle 680".
std::string outcome_in_words(const HockingResult& result);
// "of 20: 3 stand and 17 fail".
std::string in_words(const std::vector<HockingResult>& results);
// The cycle or "never".
std::string in_words(const std::optional<int>& cycle);
// Cycles after which the first block rests, "800 / 900", or how the run ends otherwise.
std::string settled_in_words(const HockingResult& result);

// Degrees.
double rotation_at_end(const HockingResult& result, std::size_t column);

// Least and greatest number over many starts.
struct CountRange {
    int least = 0;
    int greatest = 0;
    int count = 0;  // of the numbers

    void include(int value);
    bool holds(int value) const { return count > 0 && value >= least && value <= greatest; }
    std::string words(const std::string& to) const;  // "3 to 8"
};

// Narrows the bracket of a value below which something holds and above which it does not, to an accuracy.
std::pair<double, double> bisect(double low, double high, double accuracy, const std::function<bool(double)>& holds);

// The re-created program on another machine, or with its data in another order: its words hold fewer bits, or the
// blocks are listed from the last to the first. The results name the blocks as the run does.
struct OtherListing {
    std::string name;  // "24 bits"
    HockingResult result;
};
std::vector<OtherListing> compute_otherwise(const Chapter5Run& run);

// Draws CX over the cycles, also by the clean engine if its block does not fail, with the printed cycles until rest.
Figure swings_figure(const std::string& title, const std::vector<Chapter5Run>& runs, int cycles);

// The first function describes the columns at the end, "1 slides, 2-5 topple and 6-8 stay"; the second tells whether
// that is as printed.
std::string behaviour_in_words(const Chapter5Run& run, const HockingResult& result);
bool behaves_as_printed(const Chapter5Run& run, const HockingResult& result);

// An item under way. A computation finds its runs here, puts rows into the table, whose caption and columns are those
// of report.csv, and draws what comes below it.
struct Chapter5Item {
    const ResultFolder& folder;
    Reproduction result = {};
    std::vector<Chapter5Run> runs = {};
    int starts = 0;  // of each run, shifted at random
    Table table = {};
    Report below = {};

    void draw(const Figure& figure, const std::string& name, const std::string& caption);
};

using Computation = void(Chapter5Item& item);

Computation laws_of_contact;
Computation tilting_from_the_horizontal;
Computation first_swings;
Computation last_digits;
Computation starts_of_two_blocks;
Computation closed_gap;
Computation one_input_changed;
Computation backward_sliding;
Computation blow_out;
Computation blow_outs_of_shifted_starts;
Computation blow_outs_of_random_starts;
Computation same_displacement;
Computation observations;
Computation thresholds_by_stiffness;
Computation thresholds_by_step_and_damping;
Computation senses_of_three_blocks;
Computation histories_of_four_blocks;
Computation crack_of_the_tilting_frame;
Computation tension_cracks;
Computation onset_of_the_stepped_base;

}  // namespace delabole
