#include "cases/program/thesis/physical_models.hpp"

#include "cases/program/reader/data_table.hpp"
#include "cases/program/thesis/thesis_tables.hpp"

namespace delabole {

std::vector<BaseFrictionState> base_friction_states() {
    return parse_table<BaseFrictionState>(thesis_table_3_2, "cases/thesis/chapter_3/table_3_2.csv");
}

std::vector<SlopeHeightVariation> slope_height_variations() {
    return parse_table<SlopeHeightVariation>(thesis_table_3_3, "cases/thesis/chapter_3/table_3_3.csv");
}

std::vector<TiltingFrameAngle> tilting_frame_angles() {
    return parse_table<TiltingFrameAngle>(thesis_tilting_frame, "cases/thesis/chapter_3/tilting_frame.csv");
}

std::vector<MechanismVerdict> mechanism_verdicts() {
    return parse_table<MechanismVerdict>(thesis_mechanisms, "cases/thesis/chapter_2/mechanisms.csv");
}

std::vector<PrintedTrend> printed_trends() {
    return parse_table<PrintedTrend>(thesis_trends, "cases/thesis/chapter_2/trends.csv");
}

std::vector<GroundwaterTest> groundwater_tests() {
    return parse_table<GroundwaterTest>(thesis_groundwater_tests, "cases/thesis/chapter_2/groundwater_tests.csv");
}

}  // namespace delabole
