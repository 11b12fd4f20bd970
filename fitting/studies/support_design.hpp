// The cheapest support for a factor of safety: all patterns that the given choices allow, tried in order of cost up to
// the first that reaches it.
//
// Cost per metre of slope, summed over all patterns of the model, its inputs support[n]:
//     sum of rows / spacing (cost per bolt + cost per metre length),
// in the currency of the two costs. The result is exact: every cheaper pattern of the choices has been tried and does
// not reach the factor of safety.
#pragma once

#include "parameters/model_interface.hpp"

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace delabole {

struct SupportChoice {
    std::string input;
    double from;
    double to;
    double points;
    Dimension dimension = Dimension::ratio;
    static constexpr auto fields() {
        using C = SupportChoice;
        return FieldTable{refers_to(NameOf::input, section<&C::input>("what may be chosen, e.g. support[1].spacing")),
                          number<&C::from>(Dimension::named, "the first value"),
                          number<&C::to>(Dimension::named, "the last value"),
                          number<&C::points>(within(1, 1000), "how many values, equally spaced")};
    }
};

struct SupportDesign {
    double factor_of_safety;
    double cost_per_bolt;
    double cost_per_metre;
    std::vector<SupportChoice> choices;
    static constexpr auto fields() {
        using D = SupportDesign;
        return FieldTable{number<&D::factor_of_safety>(more_than(0), "factor of safety to reach"),
                          number<&D::cost_per_bolt>(at_least(0), "of head and work, any currency"),
                          number<&D::cost_per_metre>(at_least(0), "of bolt and hole, in the same currency"),
                          section("choose", &D::choices, "an input of the support and the values it may have")};
    }
};

// Greatest number of patterns: each of them may be tried.
inline constexpr double most_support_patterns = 100'000;
double number_of_patterns(const SupportDesign& design);

struct TriedSupport {
    std::vector<double> values;  // SI, in the order of the choices
    double cost;                 // per metre of slope
    // Infinite if nothing fails at any strength, 0 if the slope fails at any strength.
    std::optional<double> factor_of_safety;  // absent where the model has no answer
    std::string failure;                     // why there is no factor of safety, e.g. "bolt_head_above_crest"
};

struct SupportDesignResult {
    std::vector<TriedSupport> tried;       // in the order of cost
    std::optional<std::size_t> cheapest;   // index of the last of them; absent if none reaches the factor of safety
    std::optional<std::size_t> strongest;  // that with the greatest factor of safety; absent if none has one
    std::size_t patterns;                  // number of patterns that the choices allow
    std::map<std::string, std::size_t> failed_by_cause;
};

// The choices name inputs of the model, which has the output factor_of_safety. `watch` is told the share done; if it
// returns false the search ends.
SupportDesignResult design_support(const ModelInterface& model, const SupportDesign& design,
                                   const std::function<bool(double share)>& watch = {});

}  // namespace delabole
