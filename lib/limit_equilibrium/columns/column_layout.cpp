#include "limit_equilibrium/columns/column_layout.hpp"

namespace delabole {

ClassicalJump classical_jump(const SlopeSection<>& slope, const ClassicalColumns<>& layout) {
    const double base_dip = degrees(90) - layout.joint_dip;
    const double height_per_column = layout.spacing * std::sin(slope.face_dip) / std::cos(slope.face_dip - base_dip);
    const auto crest_column = static_cast<double>(detail::nearest_whole(slope.height / height_per_column));
    // Below half a column the first column remains the crest column.
    return {crest_column < 1.5 ? 0 : (crest_column - 0.5) * height_per_column,
            (crest_column + 0.5) * height_per_column};
}

}  // namespace delabole
