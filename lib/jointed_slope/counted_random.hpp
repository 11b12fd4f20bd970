// Random numbers by their count: the n-th of a stream without the ones before it, the same on every machine.
//
// The mixing of splitmix64 (Steele, Lea and Flood 2014), once for the seed, once for the stream and once for the count.
#pragma once

#include <cstdint>

namespace delabole {

constexpr std::uint64_t mixed_bits(std::uint64_t bits) {
    bits += 0x9e3779b97f4a7c15U;
    bits = (bits ^ (bits >> 30U)) * 0xbf58476d1ce4e5b9U;
    bits = (bits ^ (bits >> 27U)) * 0x94d049bb133111ebU;
    return bits ^ (bits >> 31U);
}

// Uniform in [0, 1), a multiple of 2^-53. Counts may be negative.
constexpr double counted_uniform(std::uint64_t seed, std::uint64_t stream, std::int64_t count) {
    const std::uint64_t bits = mixed_bits(mixed_bits(mixed_bits(seed) + stream) + static_cast<std::uint64_t>(count));
    return static_cast<double>(bits >> 11U) * 0x1p-53;
}

}  // namespace delabole
