// The bytes of checkpoints: numbers in a fixed order, low byte first, no padding, in an envelope that tells whether
// they arrived whole (see checkpoint.hpp).
#pragma once

#include "dynamic_relaxation/checkpoint/checkpoint_members.hpp"
#include "numerics/fnv_1a.hpp"

#include <array>
#include <bit>
#include <concepts>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace delabole {

enum class CheckpointCheck {
    ok,
    not_a_checkpoint,
    other_version,  // of the format; also where just those bytes are damaged
    other_scene,    // or other settings
    damaged,        // cut short, lengthened or altered
};

constexpr std::array<std::string_view, 5> enum_names(CheckpointCheck) {
    return {"ok", "not_a_checkpoint", "other_version", "other_scene", "damaged"};
}

// `hash` tells what the body depends on: it must be the same at opening.
std::string seal_checkpoint(std::uint64_t hash, std::string_view body);

// What stands before the body: mark, version, hash, length.
inline constexpr std::size_t checkpoint_header_size = 32;

// Of the first bytes of a file, as many as the header has, and the file's size: whether the rest is worth reading.
// Never other_scene.
CheckpointCheck check_beginning(std::string_view beginning, std::uint64_t size);

struct OpenedCheckpoint {
    CheckpointCheck check = CheckpointCheck::not_a_checkpoint;
    std::string_view body = {};  // of the sealed bytes; empty unless ok
};

OpenedCheckpoint open_checkpoint(std::string_view sealed, std::uint64_t hash);

// Of which items are copies put together.
template <class T>
concept IsPutTogether = std::same_as<T, ContactArray> || std::same_as<T, MemoryArray>;

class CheckpointWriter {
  public:
    std::string take() { return std::move(bytes_); }

    void put(double value) { put(std::bit_cast<std::uint64_t>(value)); }
    void put(bool value) { bytes_ += static_cast<char>(value); }
    void put(char value) { bytes_ += value; }
    void put(std::uint32_t value) { put_low_byte_first(value); }
    void put(std::uint64_t value) { put_low_byte_first(value); }
    template <class T>
    requires std::is_enum_v<T>
    void put(T value) { put(static_cast<std::uint64_t>(value)); }
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
    template <class T, class Allocator>
    void put(const std::vector<T, Allocator>& items) {
        put(static_cast<std::uint64_t>(items.size()));
        for (const T& item : items) {
            put(item);
        }
    }
    template <IsPutTogether T>
    void put(const T& items) {
        put(static_cast<std::uint64_t>(items.size()));
        for (std::size_t index = 0; index < items.size(); ++index) {
            put(items[index]);
        }
    }
    template <HasMembers T>
    void put(const T& object) {
        std::apply([&](const auto&... member) { (put(member), ...); }, members_of(object));
    }

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

// Of lists and what may be absent none is there.
template <class T>
std::size_t smallest_size() {
    CheckpointWriter writer;
    writer.put(T{});
    return writer.bytes().size();
}

// Takes what the writer put. Once something is wrong it stays so, and nothing is taken any more.
class CheckpointReader {
  public:
    explicit CheckpointReader(std::string_view bytes) : rest_(bytes) {}

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
    requires std::is_enum_v<T>
    void get(T& value) {
        std::uint64_t number = 0;
        get(number);
        good_ = good_ && number < enum_names(T{}).size();
        value = good_ ? static_cast<T>(number) : T{};
    }
    template <class T>
    void get(std::optional<T>& value) {
        bool any = false;
        get(any);
        value.reset();
        if (good_ && any) {
            get(value.emplace());
        }
    }
    template <class T, class Allocator>
    void get(std::vector<T, Allocator>& items) {
        items.resize(get_count<T>());
        for (T& item : items) {
            get(item);
        }
    }
    template <IsPutTogether T>
    void get(T& items) {
        using Item = decltype(items[0]);
        items = {};
        for (std::uint64_t left = get_count<Item>(); left > 0 && good_; --left) {
            Item item{};
            get(item);
            items.push_back(item);
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
    // How many items follow; where the rest cannot hold so many, none, and it is not good.
    template <class T>
    std::uint64_t get_count() {
        std::uint64_t count = 0;
        get(count);
        good_ = good_ && count <= rest_.size() / smallest_size<T>();
        return good_ ? count : 0;
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

}  // namespace delabole
