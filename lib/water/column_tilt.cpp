#include "water/column_tilt.hpp"

#include <cmath>

namespace delabole {

ColumnTilt analyse(const TiltedColumn<>& column) {
    const double sine = std::sin(column.joint_dip);
    const double cosine = std::cos(column.joint_dip);
    const double tangent = std::tan(column.saturated_tilt);
    const double ratio = column.filled_ratio * column.filled_ratio * tangent / (sine + tangent * cosine);
    return {std::atan2(ratio * sine, 1 - ratio * cosine), ratio};
}

ModelInterface model_interface(const TiltedColumn<>& column) {
    return interface_of_function(column, ColumnTilt{}, [](const TiltedColumn<>& varied) {
        return in_range(varied) ? Prediction{{}, output_values(analyse(varied)), {}}
                                : Prediction{"input_out_of_range", {}, {}};
    });
}

}  // namespace delabole
