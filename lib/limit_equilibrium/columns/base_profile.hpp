// The ground that a toppling failure leaves standing, and the outlines of the columns for drawing.
#pragma once

#include "geometry/polyline.hpp"
#include "limit_equilibrium/columns/make_columns.hpp"

#include <vector>

namespace delabole {

enum class BaseOutline { steps, envelope };

// Ground left when the lowest `moving_columns` columns are gone, from the toe into the slope: their bases, with their
// steps or as the line through their toe corners; then the joint behind the last of them up to the ground, or, if all
// columns move and a wedge pushes them, the wedge's joint; then the ground. Empty if there are no columns or none
// moves.
Polyline ground_after_toppling(const ColumnScene<>& scene, std::size_t moving_columns, BaseOutline outline);

// Points where the joint above each column, from the toe up, daylights, and last that of the wedge, if there is one;
// section axes. Empty if there are no columns or no ground is given.
std::vector<Point> joint_outcrops(const ColumnScene<>& scene);

// The rows of each pattern of bolts, the lowest first; rows that meet no column are left out. Empty if there are no
// columns or no ground is given.
std::vector<std::vector<BoltRow>> support_rows(const ColumnScene<>& scene);

// Closed polygons, one per column from the toe up, in section axes; the wedge above them last, if there is one. Empty
// if there are no columns.
std::vector<Polyline> column_outlines(const ColumnScene<>& scene);

}  // namespace delabole
