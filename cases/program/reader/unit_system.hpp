// The units of udunits2, restricted to linear factors to SI.
#pragma once

#include "parameters/fields.hpp"

#include <optional>
#include <string_view>

namespace delabole {

struct UnitFactor {
    bool known = false;                 // whether the text is a unit
    std::optional<double> si_per_unit;  // set if the unit has the dimension asked for
};

// For any dimension except an angle. The text must consist of named units with exponents only. Throws
// std::runtime_error if the unit database is missing.
UnitFactor unit_factor(std::string_view unit, Dimension dimension);

struct DimensionWords {
    std::string_view si_symbol;  // in usual notation, "N/m3"; empty for a ratio
    std::string_view phrase;     // "a unit weight"
    std::string_view example;    // as written in a case file, "\"26 kN/m3\""; 0.5 for a ratio
};

const DimensionWords& dimension_words(Dimension dimension);

}  // namespace delabole
