// Requests of a stepped-base case beyond the factor of safety of the given geometry, and its interface for studies.
#pragma once

#include "limit_equilibrium/stepped_base/critical_base.hpp"
#include "limit_equilibrium/stepped_base/stepped_base.hpp"
#include "limit_equilibrium/stepped_base/stepped_base_bound.hpp"
#include "numerics/required_value.hpp"
#include "plane_failure/study.hpp"

#include <string>
#include <vector>

namespace delabole {

template <class T = double>
struct SteppedBaseStudy {
    SteppedBase<T> model;
    std::optional<CriticalBaseSearch<T>> critical;
    std::vector<RequiredValue<T>> required;
    std::vector<RequiredCable<T>> required_cable;
    std::optional<LinearProgrammingBound> linear_programming_bound;

    static constexpr std::string_view kind = "stepped_base";
    static constexpr auto fields() {
        return FieldTable{
            inlined(&SteppedBaseStudy::model, "slope, columns and their strength"),
            section<&SteppedBaseStudy::critical>("search for the least stable base"),
            section<&SteppedBaseStudy::required>("inputs solved for"),
            section<&SteppedBaseStudy::required_cable>("cables whose tension is solved for"),
            section<&SteppedBaseStudy::linear_programming_bound>(
                "bound on the factor of safety, from the unsafe side, by any forces that friction allows")};
    }
};

// The study's problem with the critical base in place.
struct ResolvedSteppedBase {
    ColumnCheck check;
    SteppedBase<> problem;
    bool critical_at_boundary;  // the least factor of safety lies at the edge of the searched range
};
ResolvedSteppedBase resolve(const SteppedBaseStudy<>& study);

// `target` is the factor of safety to reach.
Required required_value(const SteppedBase<>& problem, const std::string& parameter, double target,
                        const std::vector<std::string>& also = {});

// Ground left standing after failure of the columns that move in limiting equilibrium: the line through the toe corners
// of their bases, then the crack or the wedge's joint. Empty if no column moves.
Polyline profile_after_failure(const SteppedBase<>& problem, const SteppedBaseResult& result);

// Inputs: every number of the study's problem. Outputs: every number of SteppedBaseResult, and the elevation of the
// crack's base if the slope has a datum. A slope that fails or holds at any strength, or ends abruptly, is a failed
// prediction, under the name of that state. Conditions and free parameters are applied before a critical search.
ModelInterface model_interface(const SteppedBaseStudy<>& study);

}  // namespace delabole
