// Requests of a plane-failure case beyond the factor of safety of the given geometry.
#pragma once

#include "plane_failure/parameters.hpp"

#include <string>
#include <vector>

namespace delabole {

enum class CriticalFeature { tension_crack, failure_plane, both };

// Cracks open while the slope still stands, usually before the water rises: Hoek & Bray place the critical crack for
// the dry slope. Under the given water the least factor of safety may belong to a deep crack near the face, which the
// water pushes open.
enum class SearchCondition { dry_slope, given_water };

// Replaces the given crack position and/or plane dip by those of least factor of safety. A water level given as a depth
// or an elevation stays constant while the crack moves; a filled ratio stays a ratio.
template <class T = double>
struct CriticalSearch {
    CriticalFeature find;
    SearchCondition under;
    std::optional<T> lower_dip;
    std::optional<T> upper_dip;
    static constexpr auto fields() {
        return FieldTable{
            section<&CriticalSearch::find>("what is searched for"),
            section<&CriticalSearch::under>("water while the search is made"),
            number<&CriticalSearch::lower_dip>(Dimension::angle, within(0, degrees(90)),
                                               "flattest failure plane considered; absent: the flattest possible"),
            number<&CriticalSearch::upper_dip>(Dimension::angle, within(0, degrees(90)),
                                               "steepest failure plane considered; absent: the face")};
    }
};

// Value of one named input at which the factor of safety takes a given value, with the others unchanged.
template <class T = double>
struct RequiredValue {
    std::string parameter;
    T factor_of_safety;
    std::vector<std::string> also;
    static constexpr auto fields() {
        return FieldTable{
            section<&RequiredValue::parameter>("name of the input, e.g. strength.friction_angle"),
            section<&RequiredValue::also>("further inputs that take the same value: several cables solved together"),
            number<&RequiredValue::factor_of_safety>(more_than(0), "factor of safety to reach")};
    }
};

template <class T = double>
struct PlaneFailureStudy {
    PlaneFailure<T> model;
    std::optional<CriticalSearch<T>> critical;
    std::vector<RequiredValue<T>> required;

    static constexpr std::string_view kind = "plane_failure";
    static constexpr auto fields() {
        return FieldTable{inlined(&PlaneFailureStudy::model, "the slope and its failure plane"),
                          section<&PlaneFailureStudy::critical>("search for the least stable geometry"),
                          section<&PlaneFailureStudy::required>("inputs solved for")};
    }
};

}  // namespace delabole
