// The report, tables and JSON of accuracy against cost.
#pragma once

#include "cases/program/results/result_folder.hpp"
#include "fitting/studies/trade.hpp"

#include <string>
#include <vector>

namespace delabole {

// The quantity whose error is told, and its accurate value.
struct TradeTruth {
    std::string quantity;     // "critical_tilt"
    Dimension dimension;      // of it
    std::string where_from;   // for a sentence
    double half_bracket = 0;  // SI; no setting can show a smaller error
};

struct TradeDocuments {
    Json json;           // everything but provenance
    std::string screen;  // the best of each decade of cost
};

// The figure and trade.csv are written into the folder, blocks are appended to the report.
TradeDocuments document_trade(const std::vector<TradeKnob>& knobs, const TradeResult& result, const TradeTruth& truth,
                              const ResultFolder& folder, Report& report);

}  // namespace delabole
