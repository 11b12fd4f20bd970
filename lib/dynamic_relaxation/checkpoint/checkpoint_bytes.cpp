#include "dynamic_relaxation/checkpoint/checkpoint_bytes.hpp"

namespace delabole {

namespace {

// No text begins like this, and a transfer in text mode would damage its line end.
constexpr std::string_view mark =
    "\x89"
    "DlbRlx\n";
constexpr std::uint64_t checkpoint_version = 29;
constexpr std::size_t checksum_size = 8;
static_assert(checkpoint_header_size == mark.size() + 3 * sizeof(std::uint64_t));

}  // namespace

std::string seal_checkpoint(std::uint64_t hash, std::string_view body) {
    ArchiveWriter header;
    header.put(checkpoint_version);
    header.put(hash);
    header.put(static_cast<std::uint64_t>(body.size()));
    std::string sealed;
    sealed.append(mark).append(header.bytes()).append(body);
    ArchiveWriter checksum;
    checksum.put(fnv_1a(sealed));
    return sealed + checksum.bytes();
}

CheckpointCheck check_beginning(std::string_view beginning, std::uint64_t size) {
    if (!beginning.starts_with(mark)) {
        return CheckpointCheck::not_a_checkpoint;
    }
    ArchiveReader header(beginning.substr(mark.size()));
    std::uint64_t version = 0;
    std::uint64_t hash = 0;
    std::uint64_t body_size = 0;
    header.get(version);
    // The version is all that can be read from checkpoints of other versions.
    if (header.good() && version != checkpoint_version) {
        return CheckpointCheck::other_version;
    }
    header.get(hash);
    header.get(body_size);
    const bool whole = header.good() && size >= checkpoint_header_size + checksum_size &&
                       body_size == size - checkpoint_header_size - checksum_size;
    return whole ? CheckpointCheck::ok : CheckpointCheck::damaged;
}

OpenedCheckpoint open_checkpoint(std::string_view sealed, std::uint64_t hash) {
    const CheckpointCheck beginning = check_beginning(sealed, sealed.size());
    if (beginning != CheckpointCheck::ok) {
        return {beginning};
    }
    const std::size_t end = sealed.size() - checksum_size;
    std::uint64_t checksum = 0;
    ArchiveReader(sealed.substr(end)).get(checksum);
    if (checksum != fnv_1a(sealed.substr(0, end))) {
        return {CheckpointCheck::damaged};
    }
    std::uint64_t hash_then = 0;
    ArchiveReader(sealed.substr(mark.size() + sizeof(checkpoint_version))).get(hash_then);
    if (hash_then != hash) {
        return {CheckpointCheck::other_scene};
    }
    return {CheckpointCheck::ok, sealed.substr(checkpoint_header_size, end - checkpoint_header_size)};
}

}  // namespace delabole
