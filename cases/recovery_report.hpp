// Report, tables and JSON of a synthetic recovery.
#pragma once

#include "cases/result_folder.hpp"
#include "fitting/recovery.hpp"
#include "plots/report.hpp"

#include <string>
#include <vector>

namespace delabole {

struct RecoveryDocuments {
    Json json;
    std::string screen;  // a table
};

// Appends blocks to the report and writes tables and figures into the folder. `recoveries` are those of `mechanisms`,
// in their order; `at_best`: the truth was the best fit.
RecoveryDocuments document_recovery(const std::vector<MechanismRecovery>& recoveries,
                                    const std::vector<Mechanism>& mechanisms, bool at_best, const ResultFolder& folder,
                                    Report& report);

}  // namespace delabole
