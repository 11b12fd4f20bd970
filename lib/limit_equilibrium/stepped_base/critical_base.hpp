// The least stable stepped base through the toe: its inclination, its extent, or both.
#pragma once

#include "limit_equilibrium/columns/make_columns.hpp"
#include "parameters/lengths.hpp"
#include "plane_failure/study.hpp"

#include <functional>

namespace delabole {

enum class CriticalBaseFeature { base_inclination, extent, both };

// Search for the base of least factor of safety, which replaces the base inclination and/or the height at which the
// base ends.
template <class T = double>
struct CriticalBaseSearch {
    CriticalBaseFeature find;
    SearchCondition under;
    std::optional<T> lower_inclination;
    std::optional<T> upper_inclination;
    std::optional<T> lower_end_height;
    std::optional<T> upper_end_height;
    static constexpr auto fields() {
        return FieldTable{
            section<&CriticalBaseSearch::find>("what is searched for"),
            section<&CriticalBaseSearch::under>("water while the search is made"),
            number<&CriticalBaseSearch::lower_inclination>(Dimension::angle, within(0, degrees(90)),
                                                           "flattest base considered; absent: no steps"),
            number<&CriticalBaseSearch::upper_inclination>(Dimension::angle, within(0, degrees(90)),
                                                           "steepest base considered; absent: the face"),
            number<&CriticalBaseSearch::lower_end_height>(
                Dimension::length, extent_range(),
                "lowest end of the base considered, above the toe; absent: a hundredth of the slope height"),
            number<&CriticalBaseSearch::upper_end_height>(
                Dimension::length, extent_range(),
                "highest end of the base considered, above the toe; absent: where the base meets the ground, or twice "
                "the slope height where it does not")};
    }
};

struct CriticalBase {
    ColumnCheck check = ColumnCheck::no_columns;  // of the critical scene, or the reason why the search could not begin
    ColumnScene<> scene{};                        // the input with the critical base in place
    double factor_of_safety = 0;                  // under the condition of the search
    bool at_boundary = false;                     // the minimum lies at an end of a searched range
    int evaluations = 0;
};

using ColumnSafety = std::function<double(const ColumnScene<>&)>;

// Scan of 16 inclinations and of four extents per column (16 to 64), then Brent's method on the difference quotient
// around the lowest value, taken over 1e-7 of the range: positions are no more accurate than that. `factor_of_safety`
// gives a non-finite value for a scene that has none; such scenes are skipped. The minimum is global only as far as the
// scan resolves it. If the extent has no influence (all columns slide), any extent is returned. Joints are counted from
// the end of the base: moving it moves them. Needs a continuous or classical layout. With a slide head, the wedge moves
// with the end of the base.
CriticalBase find_critical_base(const ColumnScene<>& scene, const CriticalBaseSearch<>& request,
                                const ColumnSafety& factor_of_safety);

}  // namespace delabole
