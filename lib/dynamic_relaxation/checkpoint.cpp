#include "dynamic_relaxation/checkpoint.hpp"

#include "dynamic_relaxation/checkpoint_members.hpp"
#include "dynamic_relaxation/outcome.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <optional>
#include <utility>

namespace delabole {

namespace {

// No text begins like this, and a transfer that takes it for text spoils its line end.
constexpr std::string_view mark =
    "\x89"
    "DlbRlx\n";
constexpr std::uint64_t checkpoint_version = 2;
constexpr std::size_t header_size = 32;
constexpr std::size_t checksum_size = 8;

std::uint64_t fnv_1a(std::string_view bytes) {
    std::uint64_t hash = 0xcbf29ce484222325U;
    for (const char byte : bytes) {
        hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3U;
    }
    return hash;
}

class Writer {
  public:
    std::string take() { return std::move(bytes_); }

    void put(double value) { put(std::bit_cast<std::uint64_t>(value)); }
    void put(bool value) { bytes_ += static_cast<char>(value); }
    void put(char value) { bytes_ += value; }
    void put(std::uint32_t value) { put_low_byte_first(value); }
    void put(std::uint64_t value) { put_low_byte_first(value); }
    void put(RelaxationStart value) { put(static_cast<std::uint64_t>(value)); }
    void put(const PlanePoint<>& point) {
        put(point.x());
        put(point.y());
    }
    template <class T>
    void put(const std::optional<T>& value) {
        put(value.has_value());
        if (value) {
            put(*value);
        }
    }
    template <class T>
    void put(const std::vector<T>& items) {
        put(static_cast<std::uint64_t>(items.size()));
        for (const T& item : items) {
            put(item);
        }
    }
    template <HasMembers T>
    void put(const T& object) {
        std::apply([&](const auto&... member) { (put(member), ...); }, members_of(object));
    }
    void put_raw(std::string_view bytes) { bytes_ += bytes; }

    const std::string& bytes() const { return bytes_; }

  private:
    template <class T>
    void put_low_byte_first(T value) {
        std::array<char, sizeof(T)> bytes{};
        for (std::size_t index = 0; index < sizeof(T); ++index) {
            bytes[index] = static_cast<char>(value >> (8 * index));
        }
        bytes_.append(bytes.data(), bytes.size());
    }

    std::string bytes_;
};

template <class T>
std::size_t encoded_size() {
    Writer writer;
    writer.put(T{});
    return writer.bytes().size();
}

// Takes what the writer put. Once something is wrong it stays so, and nothing is taken any more.
class Reader {
  public:
    explicit Reader(std::string_view bytes) : rest_(bytes) {}

    bool good() const { return good_; }
    bool at_end() const { return rest_.empty(); }

    void get(double& value) {
        std::uint64_t bits = 0;
        get(bits);
        value = std::bit_cast<double>(bits);
    }
    void get(bool& value) {
        char byte = 0;
        get(byte);
        value = byte == 1;
    }
    // Always a truth value here.
    void get(char& value) {
        if (ask_for(1)) {
            value = rest_.front();
            rest_.remove_prefix(1);
            good_ = value == 0 || value == 1;
        }
    }
    void get(std::uint32_t& value) { get_low_byte_first(value); }
    void get(std::uint64_t& value) { get_low_byte_first(value); }
    void get(PlanePoint<>& point) {
        get(point.x());
        get(point.y());
    }
    template <class T>
    void get(std::vector<T>& items) {
        std::uint64_t count = 0;
        get(count);
        // Before anything is allocated.
        if (!good_ || count > rest_.size() / encoded_size<T>()) {
            good_ = false;
            return;
        }
        items.resize(count);
        for (T& item : items) {
            get(item);
        }
    }
    template <HasMembers T>
    void get(T& object) {
        std::apply([&](auto&... member) { (get(member), ...); }, members_of(object));
    }

  private:
    bool ask_for(std::size_t size) {
        good_ = good_ && rest_.size() >= size;
        return good_;
    }
    template <class T>
    void get_low_byte_first(T& value) {
        if (!ask_for(sizeof(T))) {
            return;
        }
        value = 0;
        for (std::size_t index = 0; index < sizeof(T); ++index) {
            value |= static_cast<T>(static_cast<unsigned char>(rest_[index])) << (8 * index);
        }
        rest_.remove_prefix(sizeof(T));
    }

    std::string_view rest_;
    bool good_ = true;
};

std::uint64_t hash_of(const RelaxationScene& scene, const RelaxationSettings& settings) {
    RelaxationSettings of_a_step = settings;
    of_a_step.duration = 0;
    of_a_step.most_steps = 0;
    of_a_step.threads = 0;
    Writer writer;
    writer.put(scene);
    writer.put(of_a_step);
    return fnv_1a(writer.bytes());
}

bool fits(const RelaxationState& state, const RelaxationScene& scene) {
    const std::size_t blocks = scene.block.size();
    if (state.motion.size() != blocks || state.origin.size() != blocks || state.removed.size() != blocks ||
        state.base_slip.size() != blocks || state.seen.size() != blocks || state.calm.size() != blocks) {
        return false;
    }
    std::vector<std::size_t> corners_before{0};
    for (const RelaxationBlock& block : scene.block) {
        corners_before.push_back(corners_before.back() + block.outline.size());
    }
    const auto is_of = [&](std::size_t corner, std::size_t block) {
        return block < blocks && corner >= corners_before[block] && corner < corners_before[block + 1];
    };
    const ContactList& list = state.contacts;
    const std::size_t contacts = list.contact.size();
    return list.memory.size() == contacts && list.force.size() == contacts &&
           std::all_of(list.contact.begin(), list.contact.end(),
                       [&](const RelaxationContact& contact) {
                           return is_of(contact.corner, contact.block) && is_of(contact.edge, contact.other) &&
                                  (contact.twin == no_twin || contact.twin < contacts);
                       }) &&
           state.outcome < enum_names(RelaxationOutcome{}).size();
}

}  // namespace

std::string checkpoint_of(const RelaxationScene& scene, const RelaxationSettings& settings,
                          const RelaxationState& state) {
    Writer body;
    body.put(state);
    Writer whole;
    whole.put_raw(mark);
    whole.put(checkpoint_version);
    whole.put(hash_of(scene, settings));
    whole.put(static_cast<std::uint64_t>(body.bytes().size()));
    whole.put_raw(body.bytes());
    whole.put(fnv_1a(whole.bytes()));
    return whole.take();
}

RestoredState restore_checkpoint(std::string_view bytes, const RelaxationScene& scene,
                                 const RelaxationSettings& settings) {
    if (!bytes.starts_with(mark)) {
        return {CheckpointCheck::not_a_checkpoint};
    }
    Reader header(bytes.substr(mark.size()));
    std::uint64_t version = 0;
    std::uint64_t hash = 0;
    std::uint64_t size = 0;
    header.get(version);
    // Of other versions only this much is known.
    if (header.good() && version != checkpoint_version) {
        return {CheckpointCheck::other_version};
    }
    header.get(hash);
    header.get(size);
    if (!header.good() || bytes.size() < header_size + checksum_size ||
        size != bytes.size() - header_size - checksum_size) {
        return {CheckpointCheck::damaged};
    }
    std::uint64_t checksum = 0;
    Reader(bytes.substr(header_size + size)).get(checksum);
    if (checksum != fnv_1a(bytes.substr(0, header_size + size))) {
        return {CheckpointCheck::damaged};
    }
    if (hash != hash_of(scene, settings)) {
        return {CheckpointCheck::other_scene};
    }
    Reader body(bytes.substr(header_size, size));
    RelaxationState state;
    body.get(state);
    if (!body.good() || !body.at_end() || !fits(state, scene)) {
        return {CheckpointCheck::damaged};
    }
    return {CheckpointCheck::ok, std::move(state)};
}

}  // namespace delabole
