// Four numbers worked on at once: formulas written for `Number` are compiled for double and for Lanes, and each lane
// gets the same bits as the number alone. Comparisons give a mask, which `select` and `any` take, for either.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

// Lanes pass between inlined functions only, wherever these are compiled for.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"

// A function so marked is compiled for all processors and for those with wider registers, and the right one is taken at
// the start of the program. All give the same bits: multiplications and additions are never contracted.
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#define DELABOLE_FOR_EACH_PROCESSOR __attribute__((target_clones("arch=x86-64-v4", "avx2", "default")))
#else
#define DELABOLE_FOR_EACH_PROCESSOR
#endif

// Into each of these: what is not inlined is compiled for all processors only.
#define DELABOLE_INLINED [[gnu::always_inline]] inline

namespace delabole {

constexpr std::size_t lane_count = 4;

// Registers of 32 bytes, or pairs of half as long ones, as the function they are inlined into has them.
using Lanes = double __attribute__((vector_size(lane_count * sizeof(double))));
using LaneMask = decltype(Lanes{} < Lanes{});

using LaneBits = std::int64_t __attribute__((vector_size(lane_count * sizeof(double))));

template <class Number>
using MaskOf = decltype(Number{} < Number{});

DELABOLE_INLINED double select(bool first, const double& one, const double& two) {
    return first ? one : two;
}
DELABOLE_INLINED Lanes select(const LaneMask& first, const Lanes& one, const Lanes& two) {
    return first ? one : two;
}

// One for each lane, the first one lowest.
constexpr unsigned all_lanes = (1U << lane_count) - 1;

DELABOLE_INLINED unsigned bits(const LaneMask& mask) {
#ifdef __SSE2__
    const auto low = (__m128d)__builtin_shufflevector(mask, mask, 0, 1);
    const auto high = (__m128d)__builtin_shufflevector(mask, mask, 2, 3);
    return static_cast<unsigned>(_mm_movemask_pd(low) | _mm_movemask_pd(high) << 2);
#else
    const LaneMask one = mask & LaneMask{1, 2, 4, 8};
    return static_cast<unsigned>(one[0] | one[1] | one[2] | one[3]);
#endif
}

DELABOLE_INLINED bool any(bool mask) {
    return mask;
}
DELABOLE_INLINED bool any(const LaneMask& mask) {
    return bits(mask) != 0;
}

DELABOLE_INLINED double absolute(const double& value) {
    return std::abs(value);
}
DELABOLE_INLINED Lanes absolute(const Lanes& value) {
    constexpr std::int64_t all_but_sign = INT64_MAX;
    return (Lanes)((LaneBits)value & all_but_sign);
}

// As std::copysign.
DELABOLE_INLINED double with_sign(const double& value, const double& sign) {
    return std::copysign(value, sign);
}
DELABOLE_INLINED Lanes with_sign(const Lanes& value, const Lanes& sign) {
    constexpr std::int64_t all_but_sign = INT64_MAX;
    return (Lanes)(((LaneBits)value & all_but_sign) | ((LaneBits)sign & ~all_but_sign));
}

DELABOLE_INLINED double square_root(const double& value) {
    return std::sqrt(value);
}
DELABOLE_INLINED Lanes square_root(const Lanes& value) {
#ifdef __SSE2__
    const __m128d low = _mm_sqrt_pd(__builtin_shufflevector(value, value, 0, 1));
    const __m128d high = _mm_sqrt_pd(__builtin_shufflevector(value, value, 2, 3));
    return __builtin_shufflevector(low, high, 0, 1, 2, 3);
#else
    return Lanes{std::sqrt(value[0]), std::sqrt(value[1]), std::sqrt(value[2]), std::sqrt(value[3])};
#endif
}

// As std::min and std::max.
template <class Number>
DELABOLE_INLINED Number lesser(const Number& one, const Number& two) {
    return select(two < one, two, one);
}
template <class Number>
DELABOLE_INLINED Number greater(const Number& one, const Number& two) {
    return select(one < two, two, one);
}

// The first two with the other sign, the last two exchanged.
DELABOLE_INLINED Lanes opposite(const Lanes& value) {
    constexpr LaneBits signs{INT64_MIN, INT64_MIN, 0, 0};
    return (Lanes)((LaneBits)__builtin_shufflevector(value, value, 0, 1, 3, 2) ^ signs);
}

using FourLanes = std::array<Lanes, lane_count>;

// Anywhere in memory.
using LanesInMemory __attribute__((aligned(sizeof(double)), may_alias)) = Lanes;

DELABOLE_INLINED Lanes load_lanes(const double* from) {
    return *reinterpret_cast<const LanesInMemory*>(from);
}
DELABOLE_INLINED void store_lanes(const Lanes& lanes, double* to) {
    *reinterpret_cast<LanesInMemory*>(to) = lanes;
}

// Four by four: what was a row becomes a column.
DELABOLE_INLINED FourLanes transposed(const Lanes& one, const Lanes& two, const Lanes& three, const Lanes& four) {
    const Lanes low_12 = __builtin_shufflevector(one, two, 0, 4, 2, 6);
    const Lanes high_12 = __builtin_shufflevector(one, two, 1, 5, 3, 7);
    const Lanes low_34 = __builtin_shufflevector(three, four, 0, 4, 2, 6);
    const Lanes high_34 = __builtin_shufflevector(three, four, 1, 5, 3, 7);
    return {__builtin_shufflevector(low_12, low_34, 0, 1, 4, 5), __builtin_shufflevector(high_12, high_34, 0, 1, 4, 5),
            __builtin_shufflevector(low_12, low_34, 2, 3, 6, 7), __builtin_shufflevector(high_12, high_34, 2, 3, 6, 7)};
}

// What stands in the same place of four rows, side by side: four places from `place` on, and one.
using Rows = std::array<const double*, lane_count>;

DELABOLE_INLINED FourLanes gather_four(const Rows& rows, std::size_t place) {
    return transposed(load_lanes(rows[0] + place), load_lanes(rows[1] + place), load_lanes(rows[2] + place),
                      load_lanes(rows[3] + place));
}
DELABOLE_INLINED Lanes gather(const Rows& rows, std::size_t place) {
    return Lanes{rows[0][place], rows[1][place], rows[2][place], rows[3][place]};
}

DELABOLE_INLINED void store_rows(const FourLanes& rows, const std::array<double*, lane_count>& to) {
    store_lanes(rows[0], to[0]);
    store_lanes(rows[1], to[1]);
    store_lanes(rows[2], to[2]);
    store_lanes(rows[3], to[3]);
}

}  // namespace delabole

#pragma GCC diagnostic pop
