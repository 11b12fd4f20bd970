// Report, tables and JSON of a synthetic recovery.
#pragma once

#include "cases/program/results/result_folder.hpp"
#include "fitting/studies/recovery.hpp"
#include "plots/report/report.hpp"

#include <string>
#include <vector>

namespace delabole {

struct RecoveryDocuments {
    Json json;
    std::string screen;  // a table
};

// Appends blocks to the report and writes tables and figures into the folder. `at_best`: the truth was the best
// fit.
RecoveryDocuments document_recovery(const std::vector<MechanismRecovery>& recoveries, bool at_best,
                                    const ResultFolder& folder, Report& report);

}  // namespace delabole
