#include "water/column_tilt.hpp"

#include <cmath>

namespace delabole {

ColumnTilt column_tilt(const TiltedColumn<>& column) {
    const double sine = std::sin(column.joint_dip);
    const double cosine = std::cos(column.joint_dip);
    const double tangent = std::tan(column.saturated_tilt);
    const double ratio = column.filled_ratio * column.filled_ratio * tangent / (sine + tangent * cosine);
    return {std::atan2(ratio * sine, 1 - ratio * cosine), ratio};
}

ModelInterface model_interface(const TiltedColumn<>& column) {
    ModelInterface model;
    model.inputs = inputs_of(column);
    model.outputs = outputs_of(ColumnTilt{});
    model.predict = [column](std::span<const Assignment> assignments) {
        TiltedColumn<> changed = column;
        assign(changed, assignments);
        if (!in_range(changed)) {
            return Prediction{"input_out_of_range", {}, {}};
        }
        return Prediction{{}, output_values(column_tilt(changed)), {}};
    };
    return model;
}

}  // namespace delabole
