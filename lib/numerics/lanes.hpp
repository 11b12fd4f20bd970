// Calculation with several numbers at once: formulas written for `Number` are compiled for double and for lanes, and
// each lane gets the same bits as the number alone. Comparisons give a mask, which `select` and `any` accept for both.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

// Lanes pass only between inlined functions, whatever processor these are compiled for.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"

// A function with this mark is compiled for all processors and for those with wider registers, and the suitable version
// is selected at the start of the program. All versions give the same bits: multiplications and additions are never
// contracted.
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#define DELABOLE_PROCESSORS_DIFFER  // functions can have targets of their own
#define DELABOLE_FOR_EACH_PROCESSOR __attribute__((target_clones("arch=x86-64-v4", "avx2", "default")))
#else
#define DELABOLE_FOR_EACH_PROCESSOR
#endif

// Marks functions that are inlined into these: a function that is not inlined is compiled for all processors only.
#define DELABOLE_INLINED [[gnu::always_inline]] inline

namespace delabole {

// Registers of 32 bytes, or pairs of 16 bytes, as available in the function into which they are inlined.
using FourLanes = double __attribute__((vector_size(4 * sizeof(double))));
// Registers of 64 bytes.
using EightLanes = double __attribute__((vector_size(8 * sizeof(double))));

template <class T>
concept IsLanes = std::same_as<T, FourLanes> || std::same_as<T, EightLanes>;

template <IsLanes Lanes>
constexpr std::size_t lane_count = sizeof(Lanes) / sizeof(double);

template <class Number>
using MaskOf = decltype(Number{} < Number{});

DELABOLE_INLINED double select(bool first, const double& one, const double& two) {
    return first ? one : two;
}
template <IsLanes Lanes>
DELABOLE_INLINED Lanes select(const MaskOf<Lanes>& first, const Lanes& one, const Lanes& two) {
    return first ? one : two;
}

// One bit for each lane, the first lane lowest.
template <IsLanes Lanes>
constexpr unsigned all_lanes = (1U << lane_count<Lanes>)-1;

// Converts bits to bytes of 0 or 1, the lowest bit first.
DELABOLE_INLINED std::uint64_t bytes_of(unsigned bits) {
    const std::uint64_t one_in_each = bits * 0x0101010101010101U & 0x8040201008040201U;
    return (one_in_each + 0x7f7f7f7f7f7f7f7fU) >> 7U & 0x0101010101010101U;
}

// Converts bytes of 0 or 1 to bits.
DELABOLE_INLINED unsigned bits_of(std::uint64_t bytes) {
    return static_cast<unsigned>(bytes * 0x0102040810204080U >> 56U);
}

DELABOLE_INLINED unsigned bits(const MaskOf<FourLanes>& mask) {
#ifdef __SSE2__
    const auto low = (__m128d)__builtin_shufflevector(mask, mask, 0, 1);
    const auto high = (__m128d)__builtin_shufflevector(mask, mask, 2, 3);
    return static_cast<unsigned>(_mm_movemask_pd(low) | _mm_movemask_pd(high) << 2);
#else
    const auto one = mask & MaskOf<FourLanes>{1, 2, 4, 8};
    return static_cast<unsigned>(one[0] | one[1] | one[2] | one[3]);
#endif
}
DELABOLE_INLINED unsigned bits(const MaskOf<EightLanes>& mask) {
    using Bytes = signed char __attribute__((vector_size(8)));
    const auto bytes = __builtin_convertvector(mask, Bytes);
    return bits_of(std::bit_cast<std::uint64_t>(bytes) & 0x0101010101010101U);
}

template <IsLanes Lanes>
DELABOLE_INLINED MaskOf<Lanes> mask_of(unsigned bits) {
    if constexpr (std::same_as<Lanes, FourLanes>) {
        return ((MaskOf<Lanes>{} + bits) & MaskOf<Lanes>{1, 2, 4, 8}) != 0;
    } else {
        return ((MaskOf<Lanes>{} + bits) & MaskOf<Lanes>{1, 2, 4, 8, 16, 32, 64, 128}) != 0;
    }
}

DELABOLE_INLINED bool any(bool mask) {
    return mask;
}
template <class Mask>
DELABOLE_INLINED bool any(const Mask& mask) {
    return bits(mask) != 0;
}

DELABOLE_INLINED double absolute(const double& value) {
    return std::abs(value);
}
template <IsLanes Lanes>
DELABOLE_INLINED Lanes absolute(const Lanes& value) {
    return (Lanes)((MaskOf<Lanes>)value & INT64_MAX);
}

// Equivalent to std::copysign.
DELABOLE_INLINED double with_sign(const double& value, const double& sign) {
    return std::copysign(value, sign);
}
template <IsLanes Lanes>
DELABOLE_INLINED Lanes with_sign(const Lanes& value, const Lanes& sign) {
    using Bits = MaskOf<Lanes>;
    return (Lanes)(((Bits)value & INT64_MAX) | ((Bits)sign & INT64_MIN));
}

DELABOLE_INLINED double square_root(const double& value) {
    return std::sqrt(value);
}
DELABOLE_INLINED FourLanes square_root(const FourLanes& value) {
#ifdef __SSE2__
    const __m128d low = _mm_sqrt_pd(__builtin_shufflevector(value, value, 0, 1));
    const __m128d high = _mm_sqrt_pd(__builtin_shufflevector(value, value, 2, 3));
    return __builtin_shufflevector(low, high, 0, 1, 2, 3);
#else
    return FourLanes{std::sqrt(value[0]), std::sqrt(value[1]), std::sqrt(value[2]), std::sqrt(value[3])};
#endif
}

// Equivalent to std::min and std::max.
template <class Number>
DELABOLE_INLINED Number lesser(const Number& one, const Number& two) {
    return select(two < one, two, one);
}
template <class Number>
DELABOLE_INLINED Number greater(const Number& one, const Number& two) {
    return select(one < two, two, one);
}

// Changes the sign of the first two and exchanges the last two.
DELABOLE_INLINED FourLanes opposite(const FourLanes& value) {
    constexpr MaskOf<FourLanes> signs{INT64_MIN, INT64_MIN, 0, 0};
    return (FourLanes)((MaskOf<FourLanes>)__builtin_shufflevector(value, value, 0, 1, 3, 2) ^ signs);
}

// Types for access to any aligned double in memory.
using FourInMemory __attribute__((aligned(sizeof(double)), may_alias)) = FourLanes;
using EightInMemory __attribute__((aligned(sizeof(double)), may_alias)) = EightLanes;
template <IsLanes Lanes>
DELABOLE_INLINED Lanes load_lanes(const double* from) {
    if constexpr (std::same_as<Lanes, FourLanes>) {
        return *reinterpret_cast<const FourInMemory*>(from);
    } else {
        return *reinterpret_cast<const EightInMemory*>(from);
    }
}
template <IsLanes Lanes>
DELABOLE_INLINED void store_lanes(const Lanes& lanes, double* to) {
    if constexpr (std::same_as<Lanes, FourLanes>) {
        *reinterpret_cast<FourInMemory*>(to) = lanes;
    } else {
        *reinterpret_cast<EightInMemory*>(to) = lanes;
    }
}

// Four numbers of each row; there are as many rows as lanes.
template <IsLanes Lanes>
using FourOf = std::array<Lanes, 4>;

// Transposes four by four numbers; with eight lanes, each half by itself.
template <IsLanes Lanes>
DELABOLE_INLINED FourOf<Lanes> transposed(const Lanes& one, const Lanes& two, const Lanes& three, const Lanes& four) {
    const auto low = [](const Lanes& first, const Lanes& second) __attribute__((always_inline)) {
        if constexpr (std::same_as<Lanes, FourLanes>) {
            return __builtin_shufflevector(first, second, 0, 4, 2, 6);
        } else {
            return __builtin_shufflevector(first, second, 0, 8, 2, 10, 4, 12, 6, 14);
        }
    };
    const auto high = [](const Lanes& first, const Lanes& second) __attribute__((always_inline)) {
        if constexpr (std::same_as<Lanes, FourLanes>) {
            return __builtin_shufflevector(first, second, 1, 5, 3, 7);
        } else {
            return __builtin_shufflevector(first, second, 1, 9, 3, 11, 5, 13, 7, 15);
        }
    };
    const auto first_halves = [](const Lanes& first, const Lanes& second) __attribute__((always_inline)) {
        if constexpr (std::same_as<Lanes, FourLanes>) {
            return __builtin_shufflevector(first, second, 0, 1, 4, 5);
        } else {
            return __builtin_shufflevector(first, second, 0, 1, 8, 9, 4, 5, 12, 13);
        }
    };
    const auto second_halves = [](const Lanes& first, const Lanes& second) __attribute__((always_inline)) {
        if constexpr (std::same_as<Lanes, FourLanes>) {
            return __builtin_shufflevector(first, second, 2, 3, 6, 7);
        } else {
            return __builtin_shufflevector(first, second, 2, 3, 10, 11, 6, 7, 14, 15);
        }
    };
    const Lanes low_12 = low(one, two);
    const Lanes high_12 = high(one, two);
    const Lanes low_34 = low(three, four);
    const Lanes high_34 = high(three, four);
    return {first_halves(low_12, low_34), first_halves(high_12, high_34), second_halves(low_12, low_34),
            second_halves(high_12, high_34)};
}

template <IsLanes Lanes>
using Rows = std::array<const double*, lane_count<Lanes>>;

// Four places of all rows, from `place` on, as one vector for each place.
DELABOLE_INLINED FourOf<FourLanes> gather_four(const Rows<FourLanes>& rows, std::size_t place) {
    return transposed<FourLanes>(load_lanes<FourLanes>(rows[0] + place), load_lanes<FourLanes>(rows[1] + place),
                                 load_lanes<FourLanes>(rows[2] + place), load_lanes<FourLanes>(rows[3] + place));
}

// The first eight places of all rows, as one vector for each place.
template <IsLanes Lanes>
DELABOLE_INLINED std::array<Lanes, 8> gather_eight(const Rows<Lanes>& rows) {
    if constexpr (std::same_as<Lanes, FourLanes>) {
        const FourOf<Lanes> one = gather_four(rows, 0);
        const FourOf<Lanes> two = gather_four(rows, 4);
        return {one[0], one[1], one[2], one[3], two[0], two[1], two[2], two[3]};
    } else {
        // Four rows at a time: the first half has the places from 0 on, the second those from 4 on.
        const auto four_from = [&](std::size_t row) __attribute__((always_inline)) {
            return transposed<Lanes>(load_lanes<Lanes>(rows[row]), load_lanes<Lanes>(rows[row + 1]),
                                     load_lanes<Lanes>(rows[row + 2]), load_lanes<Lanes>(rows[row + 3]));
        };
        const FourOf<Lanes> one = four_from(0);
        const FourOf<Lanes> two = four_from(4);
        const auto first_half = [&](std::size_t place) __attribute__((always_inline)) {
            return __builtin_shufflevector(one[place], two[place], 0, 1, 2, 3, 8, 9, 10, 11);
        };
        const auto second_half = [&](std::size_t place) __attribute__((always_inline)) {
            return __builtin_shufflevector(one[place], two[place], 4, 5, 6, 7, 12, 13, 14, 15);
        };
        return {first_half(0),  first_half(1),  first_half(2),  first_half(3),
                second_half(0), second_half(1), second_half(2), second_half(3)};
    }
}

// Stores the row of one lane, from four transposed numbers.
template <IsLanes Lanes>
DELABOLE_INLINED void store_row(const FourOf<Lanes>& rows, std::size_t lane, double* to) {
    if constexpr (std::same_as<Lanes, FourLanes>) {
        store_lanes<FourLanes>(rows[lane], to);
    } else {
        const Lanes& two = rows[lane % 4];
        store_lanes<FourLanes>(
            lane < 4 ? __builtin_shufflevector(two, two, 0, 1, 2, 3) : __builtin_shufflevector(two, two, 4, 5, 6, 7),
            to);
    }
}

}  // namespace delabole

#pragma GCC diagnostic pop
