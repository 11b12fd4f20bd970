// A figure as JSON, for a page that draws it itself.
#pragma once

#include "cases/program/results/result_folder.hpp"
#include "plots/drawing/figure.hpp"

namespace delabole {

// Members have the names of Figure and its series, each series with its `kind`: "line", "points", "region", "boxes",
// "heat_map" or "arrows". Colours, dashes and markers are words, points are pairs; numbers that are not finite are
// null.
Json json_of(const Figure& figure);

}  // namespace delabole
