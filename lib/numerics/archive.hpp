// Conversion of values to bytes and back to the same bits, on any machine: numbers low byte first, lists and texts
// after their length, no padding. It is used for checkpoints, stored evaluations and messages between processes. Bytes
// that are read may be damaged: a length that they cannot contain is refused.
#pragma once

#include "parameters/fields.hpp"

#include <array>
#include <bit>
#include <concepts>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace delabole {

// True for arrays whose items are assembled from several columns when they are read.
template <class T>
inline constexpr bool is_put_together = false;

template <class T, class Struct>
concept IsMaybeConst = std::same_as<std::remove_const_t<T>, Struct>;

// Defines members_of(object), a tuple of references to all members, for archives. A structured binding has to name
// every member: if one is added to the struct, its list no longer compiles.
#define DELABOLE_MEMBERS(Struct, ...)      \
    template <IsMaybeConst<Struct> Object> \
    auto members_of(Object& object) {      \
        auto& [__VA_ARGS__] = object;      \
        return std::tie(__VA_ARGS__);      \
    }

template <class T>
concept HasMembers = requires(T& object) {
    members_of(object);
};

template <class T>
concept IsPoint = requires(T point) {
    { point.x() } -> std::same_as<double&>;
    { point.y() } -> std::same_as<double&>;
};

class ArchiveWriter {
  public:
    std::string take() { return std::move(bytes_); }

    void put(double value) { put(std::bit_cast<std::uint64_t>(value)); }
    void put(bool value) { bytes_ += static_cast<char>(value); }
    void put(char value) { bytes_ += value; }
    void put(std::uint32_t value) { put_low_byte_first(value); }
    void put(std::uint64_t value) { put_low_byte_first(value); }
    template <std::signed_integral T>
    requires(sizeof(T) > 1) void put(T value) { put(static_cast<std::uint64_t>(value)); }
    void put(std::string_view text) {
        put(static_cast<std::uint64_t>(text.size()));
        bytes_ += text;
    }
    template <class T>
    requires std::is_enum_v<T>
    void put(T value) { put(static_cast<std::uint64_t>(value)); }
    template <IsPoint T>
    void put(const T& point) {
        put(point.x());
        put(point.y());
    }
    template <class First, class Second>
    void put(const std::pair<First, Second>& both) {
        put(both.first);
        put(both.second);
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
    template <class T>
    requires is_put_together<T>
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

// Size in bytes of an object with empty lists and without its optional parts.
template <class T>
std::size_t smallest_size() {
    if constexpr (IsPoint<T>) {
        return 2 * sizeof(double);  // a new point's coordinates are not set
    } else {
        ArchiveWriter writer;
        writer.put(T{});
        return writer.bytes().size();
    }
}

// Reads the output of the writer. After the first error the reader stays in error and reads nothing more.
class ArchiveReader {
  public:
    explicit ArchiveReader(std::string_view bytes) : rest_(bytes) {}

    bool good() const { return good_; }
    // Whether everything could be read and nothing is left.
    bool whole() const { return good_ && rest_.empty(); }

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
    // A char is always a truth value here.
    void get(char& value) {
        if (ask_for(1)) {
            value = rest_.front();
            rest_.remove_prefix(1);
            good_ = value == 0 || value == 1;
        }
    }
    void get(std::uint32_t& value) { get_low_byte_first(value); }
    void get(std::uint64_t& value) { get_low_byte_first(value); }
    template <std::signed_integral T>
    requires(sizeof(T) > 1) void get(T& value) {
        std::uint64_t bits = 0;
        get(bits);
        value = static_cast<T>(bits);
    }
    void get(std::string& text) {
        const std::uint64_t size = get_count<char>();
        text = rest_.substr(0, size);
        rest_.remove_prefix(size);
    }
    template <IsPoint T>
    void get(T& point) {
        get(point.x());
        get(point.y());
    }
    template <class First, class Second>
    void get(std::pair<First, Second>& both) {
        get(both.first);
        get(both.second);
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
    template <class T>
    requires is_put_together<T>
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
    // Reads the number of items that follow; 0, with an error, if the rest cannot contain so many.
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
