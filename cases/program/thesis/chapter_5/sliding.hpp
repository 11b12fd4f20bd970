// The sense in which blocks slide on their base, recorded at print edits: as totals over a run and as histories by
// cycle, of one run and of many starts.
#pragma once

#include "cases/program/thesis/chapter_5/chapter_5.hpp"

#include <array>
#include <map>
#include <string>
#include <vector>

namespace delabole {

constexpr std::array counted{&SlidingTotals::forward, &SlidingTotals::backward, &SlidingTotals::none};

std::string in_words(const SlidingTotals& totals);

// The range of each count over the starts.
using TotalsRange = std::array<CountRange, counted.size()>;

std::string in_words(const TotalsRange& range);

std::vector<SlidingTotals> totals_of(const Chapter5Run& run, const HockingResult& result);

// Returns the ranges by column; runs that blow out are left out.
std::vector<TotalsRange> spread_of_totals(const Chapter5Run& run, const std::vector<HockingResult>& starts);

// Tells whether forward or backward sliding prevails, which is how the thesis states the senses.
bool forward_prevails(const SlidingTotals& totals);

// A history says what each block does, by cycle, at the print edits of a table. `both` says nothing: the thesis's "?".
using SlidingHistory = std::map<int, std::vector<BaseSliding>>;

// Edits that the table leaves out are those at which no block slides.
SlidingHistory printed_history(const Chapter5Run& run);
SlidingHistory history_of(const Chapter5Run& run, const HockingResult& result);

// "F", "B", "-", "?".
std::string letter_of(BaseSliding sliding);

// Share of the blocks and edits at which two histories say the same.
double agreement(const SlidingHistory& one, const SlidingHistory& other);

// A history beside those of many starts.
struct HistoryAgreement {
    double mean = 0;       // of its agreement with each of them
    double nearest = 0;    // the greatest of them
    double least = 0;      // of their means of the agreement with one another
    double greatest = 0;   // likewise
    double by_chance = 0;  // where only the totals are alike
};

HistoryAgreement agreement_of(const SlidingHistory& history, const std::vector<SlidingHistory>& starts);

}  // namespace delabole
