// Report, tables and JSON of what others concluded, held against a back-analysis.
#pragma once

#include "cases/program/results/result_folder.hpp"
#include "fitting/studies/conclusions.hpp"
#include "plots/report/report.hpp"

#include <string>
#include <vector>

namespace delabole {

struct ConclusionDocuments {
    Json json;
    std::string screen;  // a table, with its heading
};

// Appends blocks to the report and writes conclusions.csv into the folder. `findings` are those of `conclusions`.
ConclusionDocuments document_conclusions(const std::vector<Conclusion>& conclusions,
                                         const std::vector<ConclusionFinding>& findings, const ResultFolder& folder,
                                         Report& report);

}  // namespace delabole
