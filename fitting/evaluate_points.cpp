#include "fitting/evaluate_points.hpp"

#include "fitting/dependence.hpp"
#include "fitting/parallel.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <stdexcept>

namespace delabole {

std::vector<Evaluation> Evaluator::evaluate(std::size_t dimension, std::size_t count, const PointOf& point) const {
    if (dimension > most_parameters) {
        throw std::invalid_argument("Evaluator: too many parameters");
    }
    // Enough pieces that threads end together and progress moves, few enough that handing them out costs nothing.
    const std::size_t piece =
        std::clamp<std::size_t>(count / (64 * static_cast<std::size_t>(std::max(threads, 1))), 1, 1024);
    const std::size_t pieces = (count + piece - 1) / piece;
    std::vector<Evaluation> evaluations(count);
    std::vector<std::size_t> finished(pieces, 0);  // points of each piece
    run_tasks(pieces, threads, [&](std::size_t number) {
        std::array<double, most_parameters> storage{};
        const std::span<double> parameters = std::span(storage).first(dimension);
        const std::size_t first = number * piece;
        const std::size_t last = std::min(first + piece, count);
        std::size_t index = first;
        for (; index < last && !stopped(); ++index) {
            point(index, parameters);
            evaluations[index] = quantity(parameters);
        }
        finished[number] = index - first;
        progress.count(static_cast<long>(index - first));
    });
    std::size_t whole = 0;
    for (std::size_t number = 0; number < pieces; ++number) {
        whole += finished[number];
        if (finished[number] < std::min(piece, count - number * piece)) {
            break;
        }
    }
    evaluations.resize(whole);
    return evaluations;
}

}  // namespace delabole
