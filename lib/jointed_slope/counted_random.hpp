// Random numbers by their index: the n-th number of a stream is computed without the ones before it, and is the same on
// every machine.
//
// The mixing function is that of splitmix64 (Steele, Lea and Flood 2014), applied to the seed, the stream and the
// index.
#pragma once

#include <cstdint>

namespace delabole {

constexpr std::uint64_t mixed_bits(std::uint64_t bits) {
    bits += 0x9e3779b97f4a7c15U;
    bits = (bits ^ (bits >> 30U)) * 0xbf58476d1ce4e5b9U;
    bits = (bits ^ (bits >> 27U)) * 0x94d049bb133111ebU;
    return bits ^ (bits >> 31U);
}

// Uniform in [0, 1), a multiple of 2^-53. The index `count` may be negative.
constexpr double counted_uniform(std::uint64_t seed, std::uint64_t stream, std::int64_t count) {
    const std::uint64_t bits = mixed_bits(mixed_bits(mixed_bits(seed) + stream) + static_cast<std::uint64_t>(count));
    return static_cast<double>(bits >> 11U) * 0x1p-53;
}

}  // namespace delabole
