// Common interface of all models for the loops (fit, sensitivity, verify): named numbers in, named numbers out.
#pragma once

#include "geometry/polyline.hpp"
#include "parameters/field_text.hpp"
#include "parameters/fields.hpp"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace delabole {

struct Quantity {
    std::string name;  // "strength.friction_angle", "factor_of_safety"
    Dimension dimension = Dimension::ratio;
    std::string meaning;
    Interval range = {};  // allowed values of an input; unbounded for an output
    double value = 0;     // base value of an input; 0 for an output
};

// Place and value of the quantity of that name; nothing if there is none.
inline std::optional<std::size_t> place_of(const std::vector<Quantity>& quantities, std::string_view name) {
    const auto found = std::ranges::find(quantities, name, &Quantity::name);
    return found == quantities.end() ? std::nullopt
                                     : std::optional(static_cast<std::size_t>(found - quantities.begin()));
}
inline const Quantity* find_quantity(const std::vector<Quantity>& quantities, std::string_view name) {
    const auto place = place_of(quantities, name);
    return place ? &quantities[*place] : nullptr;
}

// If an output has a partner whose name has one of these prefixes, it stands for several cases of which the real slope
// is one, and the partner is their standard deviation from it: slopes of an ensemble, which differ by chance alone and
// of which it is the mean, or loading paths. The profile has a deviation between slopes in the same way.
inline constexpr std::string_view deviation_prefix = "ensemble_deviation.";
inline constexpr std::string_view path_deviation_prefix = "path_deviation.";
inline constexpr std::string_view deviation_of_profile = "ensemble_deviation.profile";

// One input set to a value other than its base value.
struct Assignment {
    std::size_t input;  // index into ModelInterface::inputs
    double value;       // SI
};

// The same, by the input's name.
struct Condition {
    std::string input;
    double value;                            // SI
    Dimension dimension = Dimension::ratio;  // of the value, for writers
};

struct Prediction {
    std::string_view failure;     // why the model has no answer, e.g. "crack_below_plane"; empty if it has one
    std::vector<double> outputs;  // in the order of ModelInterface::outputs; empty if it failed
    Polyline profile;             // ground left standing after the failure, from the toe into the slope; may be empty
};

// A prediction without an answer still bounds an output if a search ended at a bound: the value lies beyond it.
struct OutputBound {
    std::string_view failure;  // of Prediction
    std::size_t output;        // index into ModelInterface::outputs
    Interval within;           // does not depend on the inputs of the model
};

// An output that may be known as a bound alone, such as a mean of which some values lie beyond the end of a search.
struct BoundedOutput {
    std::size_t output;                   // index into ModelInterface::outputs
    std::optional<std::size_t> at_most;   // of an output that is not 0 where the value is at most what is given
    std::optional<std::size_t> at_least;  // likewise where it is at least that

    // The interval in which the value lies according to a prediction that has not failed.
    Interval range(const Prediction& prediction) const {
        const auto is_set = [&](const std::optional<std::size_t>& flag) {
            return flag && prediction.outputs[*flag] != 0;
        };
        Interval value;
        if (!is_set(at_most)) {
            value.lower = prediction.outputs[output];
        }
        if (!is_set(at_least)) {
            value.upper = prediction.outputs[output];
        }
        return value;
    }
};

// Instead of a value of which only a bound is known, where what is asked about lies beyond that bound.
inline constexpr std::string_view known_as_bound = "known_as_bound";

struct ModelInterface {
    std::vector<Quantity> inputs;
    std::vector<Quantity> outputs;
    std::vector<OutputBound> bounds;
    // A pure function that may be called from several threads. Values outside an input's range give a failure, not an
    // exception.
    std::function<Prediction(std::span<const Assignment>)> predict;
    // A prediction takes longer than a millisecond, many times the time to store it on the disk and to find it again:
    // loops store what they have computed.
    bool costly = false;
    std::vector<BoundedOutput> bounded_outputs = {};
};

// Every number of a described parameter struct, as inputs.
template <Described Parameters>
std::vector<Quantity> inputs_of(const Parameters& parameters) {
    std::vector<Quantity> inputs;
    for_each_named_number(parameters, [&](const std::string& path, const FieldInfo& info, double value) {
        inputs.push_back({path, info.dimension, text_of(info), info.range, value});
    });
    return inputs;
}

// Every number of a described result struct, as outputs.
template <Described Result>
std::vector<Quantity> outputs_of(const Result& result) {
    std::vector<Quantity> outputs;
    for_each_named_number(result, [&](const std::string& path, const FieldInfo& info, double) {
        outputs.push_back({path, info.dimension, std::string(info.meaning)});
    });
    return outputs;
}

// Values of the outputs, in the order of outputs_of.
template <Described Result>
std::vector<double> output_values(const Result& result) {
    std::vector<double> values;
    for_each_number(result, [&](double value, const FieldInfo&) { values.push_back(value); });
    return values;
}

// Sets inputs by their index in the order of inputs_of.
template <Described Parameters>
void assign(Parameters& parameters, std::span<const Assignment> assignments) {
    std::size_t input = 0;
    for_each_number(parameters, [&](double& value, const FieldInfo&) {
        for (const Assignment& assignment : assignments) {
            value = assignment.input == input ? assignment.value : value;
        }
        ++input;
    });
}

// The outputs of a result whose check is valid; otherwise the word for the check that failed.
template <Described Result>
Prediction prediction_of(const Result& result) {
    using Check = decltype(result.check);
    return result.check == Check::valid ? Prediction{{}, output_values(result), {}}
                                        : Prediction{word_of(result.check), {}, {}};
}

// A model whose inputs are all its parameters, and whose outputs are those of a result like `shape`; `predict` takes
// parameters.
template <Described Parameters, Described Result, class Predict>
ModelInterface interface_of_function(const Parameters& parameters, const Result& shape, Predict predict) {
    ModelInterface model{inputs_of(parameters), outputs_of(shape), {}, {}};
    model.predict = [parameters, predict](std::span<const Assignment> assignments) -> Prediction {
        Parameters varied = parameters;
        assign(varied, assignments);
        return predict(varied);
    };
    return model;
}

}  // namespace delabole
