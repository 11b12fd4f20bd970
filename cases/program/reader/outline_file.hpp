// The outline of a section from a drawing or a table of points.
//
// DXF: the LINE, LWPOLYLINE and POLYLINE entities of the drawing, joined at their ends, have to form one closed outline
// of straight parts; texts, points and dimensions are ignored, and so is all that lies on other layers where one is
// named. An outline of several lines is turned anticlockwise, for their directions say nothing. Lengths are in the
// drawing's unit ($INSUNITS), or metres if it has none. CSV: a line "x_m,y_m", then one corner on each line.
#pragma once

#include "jointed_slope/slope_geometry.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace delabole {

struct OutlineFile {
    std::vector<SectionPoint> outline = {};
    std::string problem = {};  // one clause about the file, for the reader; empty if there is no problem
};

OutlineFile outline_of_dxf(std::string_view text, const std::optional<std::string>& layer = std::nullopt);
OutlineFile outline_of_csv(std::string_view text);
// The ending of the file's name decides the format; only a drawing has layers.
OutlineFile read_outline_file(const std::filesystem::path& path,
                              const std::optional<std::string>& layer = std::nullopt);

}  // namespace delabole
