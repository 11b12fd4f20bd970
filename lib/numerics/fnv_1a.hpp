// FNV-1a hash of bytes: distinguishes texts and detects damage, but does not protect against forgery. Source: G.
// Fowler, L. C. Noll, K.-P. Vo, D. Eastlake, The FNV non-cryptographic hash algorithm.
#pragma once

#include <cstdint>
#include <string_view>

namespace delabole {

constexpr std::uint64_t fnv_1a(std::string_view bytes) {
    std::uint64_t hash = 0xCBF29CE484222325U;
    for (const char byte : bytes) {
        hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001B3U;
    }
    return hash;
}

}  // namespace delabole
