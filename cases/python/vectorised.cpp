#include "cases/python/vectorised.hpp"

#include "cases/program/results/analysis.hpp"
#include "fitting/work/parallel.hpp"
#include "plane_failure/plane_failure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <string_view>

namespace delabole {

namespace {

// Sets the inputs to the values and computes the outputs. Returns the cause if there are none, otherwise an empty text.
using PointModel = std::function<std::string_view(std::span<const double> values, std::span<double> outputs)>;
// Makes the model for one thread; it may keep a state between points.
using PointModelMaker = std::function<PointModel()>;

PointModelMaker any_model(const CaseModel& model, const PointColumns& columns) {
    const auto shared = std::make_shared<const ModelInterface>(interface_of(model));
    return [shared, inputs = columns.inputs, asked = columns.outputs]() -> PointModel {
        std::vector<Assignment> assignments;
        for (const std::size_t input : inputs) {
            assignments.push_back({input, 0});
        }
        return [shared, asked, assignments](std::span<const double> values, std::span<double> outputs) mutable {
            for (std::size_t index = 0; index < values.size(); ++index) {
                assignments[index].value = values[index];
            }
            const Prediction prediction = shared->predict(assignments);
            if (prediction.failure.empty()) {
                for (std::size_t index = 0; index < outputs.size(); ++index) {
                    outputs[index] = prediction.outputs[asked[index]];
                }
            }
            return prediction.failure;
        };
    };
}

// Plane failure of given geometry. The numbers of the problem are changed in place, so that no lists are made for a
// point.
class PlanePoints {
  public:
    PlanePoints(const PlaneFailure<>& problem, const PointColumns& columns)
        : problem_(problem), outputs_(columns.outputs) {
        std::vector<std::pair<double*, Interval>> numbers;
        for_each_number(problem_,
                        [&](double& number, const FieldInfo& info) { numbers.emplace_back(&number, info.range); });
        for (const std::size_t input : columns.inputs) {
            inputs_.push_back(numbers[input]);
        }
        const std::vector<Quantity> outputs = outputs_of(PlaneFailureResult{});
        factor_alone_ = std::ranges::all_of(
            outputs_, [&](std::size_t output) { return outputs[output].name == "factor_of_safety"; });
    }
    PlanePoints(const PlanePoints&) = delete;
    PlanePoints& operator=(const PlanePoints&) = delete;

    std::string_view operator()(std::span<const double> values, std::span<double> outputs) {
        for (std::size_t index = 0; index < values.size(); ++index) {
            const auto& [number, range] = inputs_[index];
            *number = values[index];
            if (!std::isfinite(*number) || !range.contains(*number)) {
                return word_of(PlaneFailureCheck::input_out_of_range);
            }
        }
        return factor_alone_ ? factor(outputs) : all(outputs);
    }

  private:
    std::string_view factor(std::span<double> outputs) const {
        const FactorOfSafety found = factor_of_safety(problem_);
        std::ranges::fill(outputs, found.value);
        return found.check == PlaneFailureCheck::valid ? std::string_view{} : word_of(found.check);
    }

    std::string_view all(std::span<double> outputs) const {
        const PlaneFailureResult result = analyse(problem_);
        if (result.check != PlaneFailureCheck::valid) {
            return word_of(result.check);
        }
        std::array<double, decltype(PlaneFailureResult::fields())::size> numbers{};
        std::size_t count = 0;
        for_each_number(result, [&](double value, const FieldInfo&) { numbers[count++] = value; });
        for (std::size_t index = 0; index < outputs.size(); ++index) {
            outputs[index] = numbers[outputs_[index]];
        }
        return {};
    }

    PlaneFailure<> problem_;
    std::vector<std::size_t> outputs_;
    std::vector<std::pair<double*, Interval>> inputs_;
    bool factor_alone_ = false;
};

PointModelMaker model_of(const CaseModel& model, const PointColumns& columns) {
    const auto* study = std::get_if<PlaneFailureStudy<>>(&model);
    // A search changes the geometry, and a datum adds elevations to the outputs: both need the general model.
    const std::size_t outputs_of_result = outputs_of(PlaneFailureResult{}).size();
    const auto is_added = [&](std::size_t output) { return output >= outputs_of_result; };
    if (study == nullptr || study->critical || std::ranges::any_of(columns.outputs, is_added)) {
        return any_model(model, columns);
    }
    return [study, &columns]() -> PointModel {
        const auto points = std::make_shared<PlanePoints>(study->model, columns);
        return
            [points](std::span<const double> values, std::span<double> outputs) { return (*points)(values, outputs); };
    };
}

// Numbers of causes in the order in which the threads find them.
class Causes {
  public:
    std::int16_t number_of(std::string_view cause) {
        const std::lock_guard lock(finding_);
        const auto found = numbers_.find(cause);
        if (found != numbers_.end()) {
            return found->second;
        }
        return numbers_.emplace(cause, static_cast<std::int16_t>(numbers_.size() + 1)).first->second;
    }

    // Renumbers the causes alphabetically, so that the result does not depend on the threads.
    std::vector<std::string> put_in_order(std::span<std::int16_t> failures) const {
        std::vector<std::string> names;
        std::vector<std::int16_t> after(numbers_.size() + 1);
        for (const auto& [name, number] : numbers_) {
            names.push_back(name);
            after[static_cast<std::size_t>(number)] = static_cast<std::int16_t>(names.size());
        }
        if (!names.empty()) {
            std::ranges::for_each(failures, [&](std::int16_t& one) { one = after[static_cast<std::size_t>(one)]; });
        }
        return names;
    }

  private:
    std::mutex finding_;
    std::map<std::string, std::int16_t, std::less<>> numbers_;
};

}  // namespace

std::vector<std::string> evaluate_points(const CaseModel& model, const PointColumns& columns, const PointWork& work) {
    constexpr std::size_t most_at_a_time = 4096;
    // Costly models are given to the threads one point at a time, so that each point is reported and can be stopped.
    const std::size_t at_a_time = interface_of(model).costly ? 1 : most_at_a_time;
    const std::size_t tasks = (columns.count + at_a_time - 1) / at_a_time;
    const PointModelMaker make = model_of(model, columns);
    Causes causes;
    std::atomic<std::size_t> done = 0;
    run_tasks(tasks, work.threads, [&](std::size_t task) {
        if (work.stop != nullptr && *work.stop) {
            return;
        }
        const PointModel evaluate = make();
        std::vector<double> values(columns.inputs.size());
        std::vector<double> outputs(columns.outputs.size());
        const std::size_t end = std::min(columns.count, (task + 1) * at_a_time);
        for (std::size_t point = task * at_a_time; point < end; ++point) {
            for (std::size_t index = 0; index < values.size(); ++index) {
                values[index] = columns.input_values[index][point];
            }
            const std::string_view failure = evaluate(values, outputs);
            columns.failures[point] = failure.empty() ? std::int16_t{0} : causes.number_of(failure);
            for (std::size_t index = 0; index < outputs.size(); ++index) {
                columns.output_values[index][point] =
                    failure.empty() ? outputs[index] : std::numeric_limits<double>::quiet_NaN();
            }
        }
        if (work.tell) {
            work.tell(static_cast<double>(++done) / static_cast<double>(tasks));
        }
    });
    return causes.put_in_order({columns.failures, columns.count});
}

}  // namespace delabole
