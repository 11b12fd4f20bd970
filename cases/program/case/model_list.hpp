// The models that a case may name. To add one, list it here and give it a models/<model>/case.cpp and report.cpp with
// the functions in model_cases.hpp and model_reports.hpp.
#pragma once

#include "dynamic_relaxation/study/relaxation_study.hpp"
#include "kinematics/parameters.hpp"
#include "limit_equilibrium/block_row/block_row_parameters.hpp"
#include "limit_equilibrium/block_row/single_block.hpp"
#include "limit_equilibrium/columns/flexural_toppling.hpp"
#include "limit_equilibrium/stepped_base/stepped_base_study.hpp"
#include "limit_equilibrium/stepped_path/stepped_path_parameters.hpp"
#include "plane_failure/study.hpp"
#include "water/column_tilt.hpp"
#include "wedge_failure/parameters.hpp"

#include <variant>

namespace delabole {

using Models = std::variant<PlaneFailureStudy<>, SteppedBaseStudy<>, SingleBlock, BlockRow, TiltedColumn<>,
                            KinematicsStudy, RelaxationStudy, FlexuralSlope, SteppedPath, WedgeFailureStudy>;

// Copied, moved and destroyed in one source: the models are large, and many sources do so.
struct CaseModel : Models {
    using Models::Models;
    CaseModel();
    CaseModel(const CaseModel&);
    CaseModel(CaseModel&&) noexcept;
    CaseModel& operator=(const CaseModel&);
    CaseModel& operator=(CaseModel&&) noexcept;
    ~CaseModel();
};

}  // namespace delabole
