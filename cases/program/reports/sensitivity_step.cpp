#include "cases/program/reports/sensitivity_step.hpp"

#include "fitting/work/words.hpp"

namespace delabole {

SensitivityStep sensitivity_step(const std::string& input, const InputDeviations& known, Dimension dimension,
                                 double value, double slope_height, double overburden) {
    const auto step = [&](double size, bool by_rule = true) {
        return SensitivityStep{size, "+" + value_in_words(size, dimension), by_rule};
    };
    if (const auto deviation = known.find(input); deviation != known.end()) {
        return step(deviation->second, false);
    }
    switch (dimension) {
    case Dimension::angle:
        return step(degrees(1));
    case Dimension::ratio:
        return step(0.05);
    case Dimension::length:
        return step(0.02 * slope_height);
    case Dimension::stress:
        return step(0.02 * overburden);
    default:
        return {0.02 * std::abs(value), "+2 %", true};
    }
}

InputDeviations deviations_of(const std::vector<FreeParameter>& fitted) {
    InputDeviations known;
    for (const FreeParameter& parameter : fitted) {
        if (parameter.prior) {
            known[parameter.name] = parameter.prior->standard_deviation;
        }
    }
    return known;
}

InputDeviations deviations_of(const CaseFile& file) {
    InputDeviations known;
    for (const FitMechanism& mechanism : file.fit ? file.fit->mechanisms : std::vector<FitMechanism>{}) {
        known.merge(deviations_of(mechanism.parameters));
    }
    if (file.sensitivity) {
        for (const UncertainParameter& parameter : file.sensitivity->parameters) {
            if (check(parameter.distribution).empty()) {
                known[parameter.name] = Marginal(parameter.distribution).standard_deviation();
            }
        }
    }
    if (file.support_design) {
        for (const SupportChoice& choice : file.support_design->choices) {
            known[choice.input] = 0;
        }
    }
    return known;
}

std::string deviations_in_words(const InputDeviations& known) {
    return known.empty()
               ? ""
               : " Full colours: by one standard deviation, as the case gives it; pale ones: by a usual step.";
}

}  // namespace delabole
