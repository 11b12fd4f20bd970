// One item of `delabole reproduce`: what a chapter prints, computed again and set beside the printed.
#pragma once

#include "cases/program/results/result_folder.hpp"

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace delabole {

// Whether a printed statement holds; `none` if a number is only compared with the printed one, or nothing is printed.
enum class RowVerdict { none, met, not_met };

// A row's verdict, and why or by how much.
struct Remark {
    RowVerdict verdict = RowVerdict::none;
    std::string text = {};  // after a verdict it begins with a mark or a blank: ": rank correlation 0.9"

    Remark() = default;
    Remark(std::string said) : text(std::move(said)) {}
    Remark(const char* said) : text(said) {}
    explicit Remark(RowVerdict is) : verdict(is) {}
    Remark& operator+=(std::string_view more) {
        text += more;
        return *this;
    }
};

// Starts a remark with the verdict, to which words are added.
Remark statement(bool met);
Remark operator+(Remark remark, std::string_view more);
// "statement NOT met: within a degree of the limit".
std::string in_words(const Remark& remark);

// A printed number or statement beside the computed one.
struct PrintedRow {
    std::string what;
    std::string printed;
    std::string computed;
    std::string difference;
    Remark remark;
    std::string clean = {};  // by the clean engine, where `computed` is by the re-created program of chapter 5
    std::string place = {};  // in the thesis, that of its item
};

struct Reproduction {
    Json json;
    std::vector<PrintedRow> rows;

    void add(PrintedRow row) { rows.push_back(std::move(row)); }
    // A row without a difference.
    void add(const std::string& what, const std::string& printed, const std::string& computed, const Remark& remark,
             const std::string& clean = {}) {
        rows.push_back({what, printed, computed, "", remark, clean});
    }
};

// An item that takes minutes is computed where it or its chapter is named, not with all of the thesis.
enum class ReproductionCost { seconds, minutes };

struct ReproductionItem {
    std::string name;     // "fig2.8"
    std::string place;    // section, figure or table of the thesis
    std::string meaning;  // one line
    // Appends to the report, writes figures and tables into the folder.
    std::function<Reproduction(const Sheet&)> reproduce;
    ReproductionCost cost = ReproductionCost::seconds;
};

struct ReproductionChapter {
    std::string name;     // "chapter2": all of its items
    std::string meaning;  // one line
    std::string title;    // of its report
    std::vector<ReproductionItem> items;
};

ReproductionChapter chapter_2();
ReproductionChapter chapter_3();
ReproductionChapter chapter_4();
ReproductionChapter chapter_5();
ReproductionChapter appendix_a_chapter();
ReproductionChapter published_problems();

// A part of an item's work, in words, with the shares of the whole at which it begins and ends, 0 to 1.
struct PartOfWork {
    std::string what;
    double begin = 0;
    double end = 1;
};

// Runs task(0) ... task(count - 1) on the threads of the folder, which gets the progress. Throws Interrupted once the
// flag of cases/program/terminal/interrupt.hpp is set: tasks under way may check it and end sooner.
void run_part(const ResultFolder& folder, const PartOfWork& part, std::size_t count,
              const std::function<void(std::size_t)>& task);

// "1 slides, 2-5 topple and 6-8 stay": what each column does.
std::string columns_in_words(const std::vector<std::string_view>& does);
// In words; differences below 1e-9 are rounding and shown as 0.
std::string difference_in_words(double difference);
Table printed_table(const std::string& caption, const std::vector<PrintedRow>& rows);
// Table for a terminal of 120 columns: rows below their place in the thesis, with the remark on each below it.
std::string screen_table(const std::vector<PrintedRow>& rows);

// How many rows meet what is printed: statements do or do not, and a number stands beside the printed one with its
// difference.
struct RowCounts {
    int met = 0;
    int not_met = 0;
    int beside = 0;
    int not_printed = 0;
};

RowCounts count_rows(const std::vector<PrintedRow>& rows);
std::string in_words(const RowCounts& counts);

// Compares cases with what is printed by their [[expect]] and [[sweep]], between their texts and their figures. Without
// a sweep these are the figures of `delabole run`. `cases` are built-in ones of a folder (thesis_tables.hpp), in the
// order of the report. Figures of `delabole run` do not know what they stand for: their titles begin with `place`,
// "Fig 4.1".
Reproduction reproduce_cases(const std::string& folder, const std::vector<std::string>& cases, const std::string& place,
                             const Sheet& sheet);

// An item that is data alone.
ReproductionItem data_item(const std::string& name, const std::string& place, const std::string& meaning,
                           const std::string& folder, const std::vector<std::string>& cases,
                           ReproductionCost cost = ReproductionCost::seconds);

}  // namespace delabole
