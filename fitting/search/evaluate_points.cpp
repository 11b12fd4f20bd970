#include "fitting/search/evaluate_points.hpp"

#include "fitting/probability/dependence.hpp"
#include "fitting/work/parallel.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

namespace delabole {

namespace {

// Gives every rank the evaluations of all others. Pieces belong to the ranks in turn.
void gather(const Ranks& ranks, std::size_t piece, std::vector<Evaluation>& evaluations) {
    const auto visit_pieces_of = [&](std::size_t rank, const auto& visit) {
        for (std::size_t first = rank * piece; first < evaluations.size();
             first += piece * static_cast<std::size_t>(ranks.count())) {
            for (std::size_t index = first; index < std::min(first + piece, evaluations.size()); ++index) {
                visit(evaluations[index]);
            }
        }
    };
    ArchiveWriter writer;
    visit_pieces_of(static_cast<std::size_t>(ranks.number()), [&](const Evaluation& evaluation) {
        writer.put(evaluation.value);
        writer.put(evaluation.failure);
    });
    const std::vector<std::string> all = ranks.exchange(writer.bytes());
    for (std::size_t rank = 0; rank < all.size(); ++rank) {
        ArchiveReader reader(all[rank]);
        visit_pieces_of(rank, [&](Evaluation& evaluation) {
            reader.get(evaluation.value);
            std::string failure;
            reader.get(failure);
            evaluation.failure = failure.empty() ? std::string_view() : ranks.word(failure);
        });
        demand_whole(reader);
    }
}

}  // namespace

std::vector<Evaluation> Evaluator::evaluate(std::size_t dimension, std::size_t count, const PointOf& point) const {
    if (dimension > most_parameters) {
        throw std::invalid_argument("Evaluator: too many parameters");
    }
    const bool alone = workers().alone();
    const auto rank_count = static_cast<std::size_t>(alone ? 1 : ranks->count());
    const auto own = static_cast<std::size_t>(alone ? 0 : ranks->number());
    // There are enough pieces for the threads to end together and for the progress to be smooth, but so few that
    // handing them out costs nothing.
    const std::size_t piece =
        std::clamp<std::size_t>(count / (64 * rank_count * static_cast<std::size_t>(std::max(threads, 1))), 1, 1024);
    const std::size_t pieces = (count + piece - 1) / piece;
    std::vector<Evaluation> evaluations(count);
    std::vector<std::size_t> finished(pieces, 0);  // points of each piece
    run_tasks((pieces + rank_count - 1 - own) / rank_count, threads, [&](std::size_t place) {
        const std::size_t number = own + place * rank_count;
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
        // The other ranks are assumed to have done as many.
        progress.count(static_cast<long>((index - first) * rank_count));
    });
    if (!alone) {
        gather(*ranks, piece, evaluations);
        return evaluations;
    }
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
