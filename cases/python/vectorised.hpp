// A model at many points: columns of numbers as input and as output.
#pragma once

#include "cases/program/case/model_list.hpp"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace delabole {

struct PointColumns {
    std::size_t count = 0;                    // number of points
    std::vector<std::size_t> inputs;          // those that vary, as indices of the inputs of interface_of(model)
    std::vector<const double*> input_values;  // SI, `count` of each
    std::vector<std::size_t> outputs;         // those asked for, as indices of its outputs
    std::vector<double*> output_values;       // SI, `count` of each; NaN if a point has no answer
    std::int16_t* failures;                   // for each point 0, or the number of its cause, counted from 1
};

struct PointWork {
    int threads = 1;                           // >= 1; no answer depends on it
    const std::atomic<bool>* stop = nullptr;   // once it is set, points not yet computed stay as they are
    std::function<void(double share)> tell{};  // is called from any thread
};

// Returns the causes of failure in alphabetical order. The outputs equal those of ModelInterface::predict to the last
// bit, but nothing else is computed; a factor of safety of plane failure takes about 0.1 us.
std::vector<std::string> evaluate_points(const CaseModel& model, const PointColumns& columns, const PointWork& work);

}  // namespace delabole
