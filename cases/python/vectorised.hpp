// A model at many points: columns of numbers in, columns of numbers out.
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
    std::size_t count = 0;                    // of points
    std::vector<std::size_t> inputs;          // that differ from point to point, as interface_of(model) counts them
    std::vector<const double*> input_values;  // SI, `count` of each
    std::vector<std::size_t> outputs;         // that are asked for, likewise
    std::vector<double*> output_values;       // SI, `count` of each; NaN where a point has no answer
    std::int16_t* failures;                   // of each point: 0, or the number of its cause, counted from 1
};

struct PointWork {
    int threads = 1;                           // >= 1; no answer depends on it
    const std::atomic<bool>* stop = nullptr;   // what is not done once it is set is left as it is
    std::function<void(double share)> tell{};  // from any thread
};

// Returns the causes of failure in alphabetical order. The numbers are those of ModelInterface::predict to the last
// bit, without what else that computes; a factor of safety of plane failure takes about 0.1 us.
std::vector<std::string> evaluate_points(const CaseModel& model, const PointColumns& columns, const PointWork& work);

}  // namespace delabole
