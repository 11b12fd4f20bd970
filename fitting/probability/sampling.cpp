#include "fitting/probability/sampling.hpp"

#include <gsl/gsl_qrng.h>

#include <bit>
#include <cmath>
#include <memory>
#include <new>
#include <numeric>
#include <stdexcept>
#include <string>

namespace delabole {

namespace {

constexpr std::size_t most_dimensions = 40;
constexpr std::size_t most_digits = 30;

}  // namespace

SobolSequence::SobolSequence(std::size_t dimension, std::size_t count, std::uint64_t seed)
    : dimension_(dimension), shift_(seed, RandomPurpose::shift) {
    if (dimension < 1 || dimension > most_dimensions) {
        throw std::invalid_argument("SobolSequence: " + std::to_string(dimension) + " dimensions, from 1 to 40");
    }
    if (count < 1 || count > std::size_t{1} << most_digits) {
        throw std::invalid_argument("SobolSequence: " + std::to_string(count) + " points, from 1 to 2^30");
    }
    digits_ = static_cast<std::size_t>(std::bit_width(count - 1));
    directions_.resize(digits_ * dimension);
    const std::unique_ptr<gsl_qrng, decltype(&gsl_qrng_free)> generator(
        gsl_qrng_alloc(gsl_qrng_sobol, static_cast<unsigned>(dimension)), &gsl_qrng_free);
    if (!generator) {
        throw std::bad_alloc();
    }
    // GSL steps in Gray-code order: point n + 1 differs from point n by the direction of the lowest zero digit of n, so
    // each direction first appears between points 2^digit - 1 and 2^digit.
    std::vector<double> point(dimension);
    std::vector<std::uint32_t> before(dimension, 0);
    std::size_t drawn = 0;
    for (std::size_t digit = 0; digit < digits_; ++digit) {
        for (const std::size_t last = std::size_t{1} << digit; drawn < last; ++drawn) {
            gsl_qrng_get(generator.get(), point.data());
            if (drawn + 2 < last) {
                continue;
            }
            for (std::size_t coordinate = 0; coordinate < dimension; ++coordinate) {
                const auto bits = static_cast<std::uint32_t>(std::ldexp(point[coordinate], most_digits));
                directions_[digit * dimension + coordinate] = bits ^ before[coordinate];
                before[coordinate] = bits;
            }
        }
    }
}

void SobolSequence::point(std::size_t index, std::size_t replicate, std::span<double> coordinates) const {
    constexpr unsigned digits_of_double = 52;
    std::array<std::uint32_t, most_dimensions> bits{};
    std::size_t gray = index ^ (index >> 1U);
    for (const std::uint32_t* direction = directions_.data(); gray != 0; gray >>= 1U, direction += dimension_) {
        if ((gray & 1U) != 0) {
            for (std::size_t coordinate = 0; coordinate < dimension_; ++coordinate) {
                bits[coordinate] ^= direction[coordinate];
            }
        }
    }
    for (std::size_t coordinate = 0; coordinate < dimension_; ++coordinate) {
        const std::uint64_t shift =
            shift_.bits(replicate, static_cast<std::uint32_t>(coordinate)) >> (64 - digits_of_double);
        const std::uint64_t shifted =
            (static_cast<std::uint64_t>(bits[coordinate]) << (digits_of_double - most_digits)) ^ shift;
        coordinates[coordinate] = (static_cast<double>(shifted) + 0.5) * 0x1p-52;
    }
}

SamplePlan::SamplePlan(SamplingMethod method, std::size_t dimension, std::size_t points, std::size_t replicates,
                       std::uint64_t seed)
    : method_(method),
      dimension_(dimension),
      points_(points),
      replicates_(replicates),
      random_(seed, method == SamplingMethod::latin_hypercube ? RandomPurpose::jitter : RandomPurpose::sample) {
    if (dimension < 1 || points < 1 || replicates < 1) {
        throw std::invalid_argument("SamplePlan: needs dimension, points and replicates >= 1");
    }
    if (method == SamplingMethod::sobol_sequence) {
        sobol_.emplace_back(dimension, points, seed);
    }
    if (method != SamplingMethod::latin_hypercube) {
        return;
    }
    const CountedRandom shuffle(seed, RandomPurpose::permutation);
    permutation_.resize(dimension * points * replicates);
    for (std::size_t column = 0; column < dimension * replicates; ++column) {
        const auto strata = std::span(permutation_).subspan(column * points, points);
        std::iota(strata.begin(), strata.end(), 0U);
        for (std::size_t last = points - 1; last > 0; --last) {
            std::swap(strata[last], strata[shuffle.below(last + 1, last, static_cast<std::uint32_t>(column))]);
        }
    }
}

void SamplePlan::point(std::size_t index, std::span<double> coordinates) const {
    switch (method_) {
    case SamplingMethod::monte_carlo:
        for (std::size_t coordinate = 0; coordinate < dimension_; ++coordinate) {
            coordinates[coordinate] = random_.unit(index, static_cast<std::uint32_t>(coordinate));
        }
        return;
    case SamplingMethod::latin_hypercube: {
        const std::size_t replicate = index / points_;
        for (std::size_t coordinate = 0; coordinate < dimension_; ++coordinate) {
            const std::size_t column = replicate * dimension_ + coordinate;
            const double stratum = permutation_[column * points_ + index % points_];
            coordinates[coordinate] =
                (stratum + random_.unit(index, static_cast<std::uint32_t>(coordinate))) / static_cast<double>(points_);
        }
        return;
    }
    case SamplingMethod::sobol_sequence:
        sobol_.front().point(index % points_, index / points_, coordinates);
        return;
    }
}

}  // namespace delabole
