// Independent tasks on the threads of every rank.
#pragma once

#include "fitting/search/minimise.hpp"
#include "fitting/work/bytes.hpp"
#include "fitting/work/parallel.hpp"
#include "fitting/work/ranks.hpp"
#include "geometry/polyline.hpp"

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace delabole {

// What travels between ranks: numbers, enums, texts, vectors and pairs of such, and structs whose members() says of
// what they consist.
template <class Type>
requires std::same_as<std::remove_const_t<Type>, EvaluationCount>
auto members(Type& count) {
    return std::tie(count.total, count.optimiser_rejections, count.failed_by_cause);
}

template <class Type>
requires std::same_as<std::remove_const_t<Type>, MinimiseResult>
auto members(Type& result) {
    return std::tie(result.status, result.point, result.value, result.evaluations);
}

// Throws std::runtime_error where what another rank sent is not what this one expects.
inline void demand_whole(const ByteReader& reader) {
    if (!reader.whole()) {
        throw std::runtime_error("the ranks do not agree on what they work at: do all run the same program?");
    }
}

template <class Type>
requires std::same_as<std::remove_const_t<Type>, Interval>
auto members(Type& interval) {
    return std::tie(interval.lower, interval.upper, interval.lower_open, interval.upper_open);
}

template <class Type>
requires std::same_as<std::remove_const_t<Type>, Point>
auto members(Type& point) {
    return std::tie(point.x(), point.y());
}

namespace detail {

template <class Type>
inline constexpr bool is_std_vector = false;
template <class Type>
inline constexpr bool is_std_vector<std::vector<Type>> = true;
template <class Type>
inline constexpr bool is_std_pair = false;
template <class First, class Second>
inline constexpr bool is_std_pair<std::pair<First, Second>> = true;

template <class Type>
void pack(ByteWriter& bytes, const Type& value) {
    if constexpr (std::is_floating_point_v<Type>) {
        bytes.real(value);
    } else if constexpr (std::is_integral_v<Type> || std::is_enum_v<Type>) {
        bytes.number(static_cast<std::uint64_t>(value));
    } else if constexpr (std::same_as<Type, std::string>) {
        bytes.text(value);
    } else if constexpr (is_std_vector<Type>) {
        bytes.number(value.size());
        for (const auto& element : value) {
            pack(bytes, element);
        }
    } else if constexpr (is_std_pair<Type>) {
        pack(bytes, value.first);
        pack(bytes, value.second);
    } else {
        std::apply([&](const auto&... member) { (pack(bytes, member), ...); }, members(value));
    }
}

template <class Type>
void unpack(ByteReader& bytes, Type& value) {
    if constexpr (std::is_floating_point_v<Type>) {
        value = bytes.real();
    } else if constexpr (std::is_integral_v<Type> || std::is_enum_v<Type>) {
        value = static_cast<Type>(bytes.number());
    } else if constexpr (std::same_as<Type, std::string>) {
        value = bytes.text();
    } else if constexpr (is_std_vector<Type>) {
        value.resize(bytes.number());
        for (auto& element : value) {
            unpack(bytes, element);
        }
    } else if constexpr (is_std_pair<Type>) {
        unpack(bytes, value.first);
        unpack(bytes, value.second);
    } else {
        std::apply([&](auto&... member) { (unpack(bytes, member), ...); }, members(value));
    }
}

}  // namespace detail

// The threads of this rank and the ranks beside it; no result depends on either number.
struct Workers {
    int threads = 1;
    const Ranks* ranks = nullptr;  // null: this process alone

    bool alone() const { return ranks == nullptr || ranks->alone(); }
};

// task(0) ... task(count - 1), each done once by one of the workers, in their order on every rank. Task `number` is
// done by rank `number` modulo their number: neighbours often cost alike. Every rank calls this, outside of other
// tasks.
template <class Result>
std::vector<Result> share_tasks(std::size_t count, const Workers& workers,
                                const std::function<Result(std::size_t)>& task) {
    const auto ranks = static_cast<std::size_t>(workers.alone() ? 1 : workers.ranks->count());
    const auto own = static_cast<std::size_t>(workers.alone() ? 0 : workers.ranks->number());
    std::vector<Result> results(count);
    const std::size_t own_count = (count + ranks - 1 - own) / ranks;
    run_tasks(own_count, workers.threads, [&](std::size_t place) {
        const std::size_t number = own + place * ranks;
        results[number] = task(number);
    });
    if (workers.alone()) {
        return results;
    }
    ByteWriter writer;
    for (std::size_t number = own; number < count; number += ranks) {
        detail::pack(writer, results[number]);
    }
    const std::vector<std::string> all = workers.ranks->exchange(writer.bytes());
    for (std::size_t rank = 0; rank < ranks; ++rank) {
        ByteReader reader(all[rank]);
        for (std::size_t number = rank; number < count; number += ranks) {
            detail::unpack(reader, results[number]);
        }
        demand_whole(reader);
    }
    return results;
}

}  // namespace delabole
