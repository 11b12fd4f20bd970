#include "dynamic_relaxation/checkpoint_bytes.hpp"

namespace delabole {

namespace {

// No text begins like this, and a transfer that takes it for text spoils its line end.
constexpr std::string_view mark =
    "\x89"
    "DlbRlx\n";
constexpr std::uint64_t checkpoint_version = 13;
constexpr std::size_t header_size = 32;
constexpr std::size_t checksum_size = 8;

}  // namespace

std::string seal_checkpoint(std::uint64_t hash, std::string_view body) {
    CheckpointWriter header;
    header.put(checkpoint_version);
    header.put(hash);
    header.put(static_cast<std::uint64_t>(body.size()));
    std::string sealed;
    sealed.append(mark).append(header.bytes()).append(body);
    CheckpointWriter checksum;
    checksum.put(fnv_1a(sealed));
    return sealed + checksum.bytes();
}

OpenedCheckpoint open_checkpoint(std::string_view sealed, std::uint64_t hash) {
    if (!sealed.starts_with(mark)) {
        return {CheckpointCheck::not_a_checkpoint};
    }
    CheckpointReader header(sealed.substr(mark.size()));
    std::uint64_t version = 0;
    std::uint64_t hash_then = 0;
    std::uint64_t size = 0;
    header.get(version);
    // Of other versions only this much is known.
    if (header.good() && version != checkpoint_version) {
        return {CheckpointCheck::other_version};
    }
    header.get(hash_then);
    header.get(size);
    if (!header.good() || sealed.size() < header_size + checksum_size ||
        size != sealed.size() - header_size - checksum_size) {
        return {CheckpointCheck::damaged};
    }
    std::uint64_t checksum = 0;
    CheckpointReader(sealed.substr(header_size + size)).get(checksum);
    if (checksum != fnv_1a(sealed.substr(0, header_size + size))) {
        return {CheckpointCheck::damaged};
    }
    if (hash_then != hash) {
        return {CheckpointCheck::other_scene};
    }
    return {CheckpointCheck::ok, sealed.substr(header_size, size)};
}

}  // namespace delabole
