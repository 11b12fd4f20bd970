#include "cases/model_outputs.hpp"

#include "plane_failure/plane_failure.hpp"
#include "water/column_tilt.hpp"

namespace delabole {

std::vector<Quantity> known_outputs(std::string_view model) {
    if (model == PlaneFailureStudy<>::kind) {
        PlaneFailureStudy<> with_datum{};
        with_datum.model.slope.toe_elevation = 0;
        return model_interface(with_datum).outputs;
    }
    if (model == TiltedColumn<>::kind) {
        return model_interface(TiltedColumn<>{}).outputs;
    }
    return {};
}

}  // namespace delabole
