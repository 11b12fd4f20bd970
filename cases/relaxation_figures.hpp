// Figures and tables of a run of dynamic relaxation.
#pragma once

#include "cases/result_folder.hpp"
#include "dynamic_relaxation/relaxation_study.hpp"
#include "plots/report.hpp"

namespace delabole {

// Blocks at the start and at the end, velocities, contact forces, the table of blocks; nothing where there was no run.
void append_block_figures(const RelaxationRun& made, const ResultFolder& folder, Report& report);

// history.csv, movements.csv and their figures; nothing where the run kept no history.
void append_history(const HistoryRequest& request, const RelaxationRun& made, const ResultFolder& folder,
                    Report& report);

}  // namespace delabole
