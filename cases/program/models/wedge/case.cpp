// Wedge failure: checks of its case for the reader.
#include "cases/program/case/model_cases.hpp"
#include "wedge_failure/wedge_failure.hpp"

namespace delabole {
void check_case(Checker& checker, const WedgeFailureStudy& study) {
    check_strength(checker, "plane_1.strength", study.model.plane_1.strength);
    check_strength(checker, "plane_2.strength", study.model.plane_2.strength);
    const auto* pressures = std::get_if<MeanPressures>(&study.model.water);
    if (pressures != nullptr && pressures->tension_crack && !study.model.tension_crack) {
        checker.complain("water.tension_crack", "is a pressure in a crack, but the case has no [tension_crack]");
    }
    check_required(checker, study.required, study);
}

}  // namespace delabole
