// The result of a search for a critical value in the report: value, bracket, path, failing blocks and how failure was
// decided.
#pragma once

#include "cases/program/results/analysis.hpp"
#include "cases/program/results/answers.hpp"
#include "cases/program/results/result_folder.hpp"
#include "dynamic_relaxation/study/relaxation_study.hpp"
#include "plots/report/report.hpp"

#include <string>

namespace delabole {

struct FailingBlocks {
    std::vector<std::size_t> block = {};
    double area = 0;  // m2
};

// The blocks that had begun to move when a run ended.
FailingBlocks failing_blocks(const RelaxationRun& failed);

void append_critical(Analysis& analysis, const RelaxationStudyAnswer& answer);

// Why the search has no answer on one of its paths; empty if it has one on each path.
std::string search_in_words(const CriticalPlan& plan, const CriticalAnswer& critical);

// The value on each path, the blocks at failure as table and figure, and failing_blocks.csv and paths.csv.
void append_critical_figures(const CriticalPlan& plan, const CriticalAnswer& critical, const Sheet& sheet);

}  // namespace delabole
