// Error against cost of many settings, both axes logarithmic, with the front that no setting passes.
#pragma once

#include "plots/drawing/figure.hpp"

#include <string>
#include <vector>

namespace delabole {

// Settings that differ from the case in the same way.
struct TradeCloud {
    std::string legend = {};
    Polyline points = {};  // cost, error; both more than 0
};

struct TradeDrawing {
    std::string title = {};
    std::string cost = {};
    std::string error = {};
    std::string error_unit = {};
    std::vector<TradeCloud> clouds = {};
    Polyline front = {};    // from the cheapest on
    double resolution = 0;  // least error that a setting can show; 0: none
    std::vector<Label> labels = {};
};

Figure trade_figure(const TradeDrawing& drawing);

}  // namespace delabole
