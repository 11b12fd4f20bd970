// Random numbers that follow from an index instead of a running state: a sample gets the same number whichever thread
// draws it and whatever was drawn before.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace delabole {

// Philox4x32 with ten rounds: a keyed bijection of 128-bit counters that passes all known statistical tests. Source: J.
// K. Salmon, M. A. Moraes, R. O. Dror & D. E. Shaw, Proc. SC11 (2011), "Parallel random numbers: as easy as 1, 2, 3".
constexpr std::array<std::uint32_t, 4> philox(std::array<std::uint32_t, 4> counter, std::array<std::uint32_t, 2> key) {
    constexpr std::uint64_t multiplier_0 = 0xD2511F53U;
    constexpr std::uint64_t multiplier_1 = 0xCD9E8D57U;
    for (int round = 0; round < 10; ++round) {
        const std::uint64_t product_0 = multiplier_0 * counter[0];
        const std::uint64_t product_1 = multiplier_1 * counter[2];
        counter = {
            static_cast<std::uint32_t>(product_1 >> 32U) ^ counter[1] ^ key[0], static_cast<std::uint32_t>(product_1),
            static_cast<std::uint32_t>(product_0 >> 32U) ^ counter[3] ^ key[1], static_cast<std::uint32_t>(product_0)};
        key[0] += 0x9E3779B9U;
        key[1] += 0xBB67AE85U;
    }
    return counter;
}

// Numbers that are drawn for different purposes are independent.
enum class RandomPurpose : std::uint32_t {
    sample,
    shift,
    permutation,
    jitter,
    trajectory,
    bootstrap,
    start,
    chain,
    fit,
    outcome,
    truth,
    error
};

class CountedRandom {
  public:
    CountedRandom(std::uint64_t seed, RandomPurpose purpose) : seed_(seed), purpose_(purpose) {}

    // 64 random bits. index < 2^64, dimension < 2^31.
    constexpr std::uint64_t bits(std::uint64_t index, std::uint32_t dimension = 0) const {
        // One call of philox() gives the bits of two neighbouring dimensions.
        const std::array<std::uint32_t, 4> words =
            philox({static_cast<std::uint32_t>(index), static_cast<std::uint32_t>(index >> 32U), dimension / 2,
                    static_cast<std::uint32_t>(purpose_)},
                   {static_cast<std::uint32_t>(seed_), static_cast<std::uint32_t>(seed_ >> 32U)});
        const std::size_t first = dimension % 2 == 0 ? 0 : 2;
        return (static_cast<std::uint64_t>(words[first]) << 32U) | words[first + 1];
    }

    // A number in the open interval (0, 1), one of 2^52 equally likely ones.
    constexpr double unit(std::uint64_t index, std::uint32_t dimension = 0) const {
        return (static_cast<double>(bits(index, dimension) >> 12U) + 0.5) * 0x1p-52;
    }

    // A whole number from 0 to count - 1, each equally likely to within count / 2^52; 0 < count <= 2^30.
    constexpr std::size_t below(std::size_t count, std::uint64_t index, std::uint32_t dimension = 0) const {
        return static_cast<std::size_t>(unit(index, dimension) * static_cast<double>(count));
    }

  private:
    std::uint64_t seed_;
    RandomPurpose purpose_;
};

// Random numbers one after the other, for a random walk whose length is not known beforehand. Streams with different
// numbers are independent; stream < 2^31.
class RandomStream {
  public:
    RandomStream(std::uint64_t seed, RandomPurpose purpose, std::uint32_t stream)
        : random_(seed, purpose), stream_(stream) {}

    double unit() { return random_.unit(drawn_++, stream_); }
    std::size_t below(std::size_t count) { return random_.below(count, drawn_++, stream_); }

  private:
    CountedRandom random_;
    std::uint32_t stream_;
    std::uint64_t drawn_ = 0;
};

}  // namespace delabole
