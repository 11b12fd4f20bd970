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
    for_each_named_number(column, [&](const std::string& path, const FieldInfo& info, double value) {
        model.inputs.push_back({path, info.dimension, std::string(info.meaning), info.range, value});
    });
    const ColumnTilt result{};
    for_each_named_number(result, [&](const std::string& path, const FieldInfo& info, double) {
        model.outputs.push_back({path, info.dimension, std::string(info.meaning), any_number(), 0});
    });
    model.predict = [column](std::span<const Assignment> assignments) {
        TiltedColumn<> changed = column;
        bool inside = true;
        std::size_t input = 0;
        for_each_number(changed, [&](double& value, const FieldInfo& info) {
            for (const Assignment& assignment : assignments) {
                value = assignment.input == input ? assignment.value : value;
            }
            inside = inside && info.range.contains(value);
            ++input;
        });
        if (!inside) {
            return Prediction{"input_out_of_range", {}, {}};
        }
        const ColumnTilt result_of_change = column_tilt(changed);
        return Prediction{{}, {result_of_change.tilt, result_of_change.water_force_over_weight}, {}};
    };
    return model;
}

}  // namespace delabole
