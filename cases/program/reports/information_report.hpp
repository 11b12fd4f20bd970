// Report, tables and JSON of what next measurements would tell.
#pragma once

#include "cases/program/results/result_folder.hpp"
#include "fitting/studies/information.hpp"
#include "plots/report/report.hpp"

#include <string>
#include <vector>

namespace delabole {

struct InformationDocuments {
    Json json;
    std::string screen;  // a table, with its heading
};

// Appends blocks to the report and writes table and figure into the folder. `information` is that of `candidates`.
InformationDocuments document_information(const std::vector<FitCandidate>& candidates,
                                          const std::vector<CandidateInformation>& information,
                                          const ResultFolder& folder, Report& report);

}  // namespace delabole
