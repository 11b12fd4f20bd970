// This file is compiled without coverage, since it handles the counters.
#include "coverage.hpp"

#include <algorithm>
#include <cstdint>

// The names are the linker's and clang's.
// NOLINTBEGIN(bugprone-reserved-identifier,readability-identifier-naming)

// These counters say how often each piece of code was reached.
extern "C" std::uint8_t __start___sancov_cntrs[];
extern "C" std::uint8_t __stop___sancov_cntrs[];

namespace delabole::fuzzing {

void forget_what_was_reached() {
    std::fill(__start___sancov_cntrs, __stop___sancov_cntrs, std::uint8_t{0});
}

}  // namespace delabole::fuzzing

// Instrumented code reports what it compares to libFuzzer by these calls. The linker sends them here (--wrap), where
// they do nothing: they took two thirds of the time of a case. Bytes guessed from compares are for formats; cases are
// changed by value.
#define UNTRACED extern "C" void
UNTRACED __wrap___sanitizer_cov_trace_cmp1(std::uint8_t, std::uint8_t) {}
UNTRACED __wrap___sanitizer_cov_trace_cmp2(std::uint16_t, std::uint16_t) {}
UNTRACED __wrap___sanitizer_cov_trace_cmp4(std::uint32_t, std::uint32_t) {}
UNTRACED __wrap___sanitizer_cov_trace_cmp8(std::uint64_t, std::uint64_t) {}
UNTRACED __wrap___sanitizer_cov_trace_const_cmp1(std::uint8_t, std::uint8_t) {}
UNTRACED __wrap___sanitizer_cov_trace_const_cmp2(std::uint16_t, std::uint16_t) {}
UNTRACED __wrap___sanitizer_cov_trace_const_cmp4(std::uint32_t, std::uint32_t) {}
UNTRACED __wrap___sanitizer_cov_trace_const_cmp8(std::uint64_t, std::uint64_t) {}
// NOLINTEND(bugprone-reserved-identifier,readability-identifier-naming)
