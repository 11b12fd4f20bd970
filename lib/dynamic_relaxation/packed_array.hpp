// Structs of numbers in groups of eight: of each member, the numbers of a group stand side by side in a line of 64
// bytes, as loops over lanes want them.
#pragma once

#include "dynamic_relaxation/large_array.hpp"

#include <array>
#include <cstddef>
#include <cstring>
#include <type_traits>

namespace delabole {

constexpr std::size_t packed_size = 8;

struct alignas(packed_size * sizeof(double)) NumberGroup : std::array<double, packed_size> {};
using FlagGroup = std::array<bool, packed_size>;

// One member after the other, by their places: `Struct` has members of this type alone.
template <template <class> class Struct, class Number, class Group>
Struct<Number> taken_from(const Struct<Group>& group, std::size_t place) {
    constexpr std::size_t members = sizeof(Struct<Number>) / sizeof(Number);
    static_assert(sizeof(Struct<Group>) == members * sizeof(Group) && std::is_trivially_copyable_v<Struct<Group>>);
    Struct<Number> one;
    const auto* const from = reinterpret_cast<const std::byte*>(&group) + place * sizeof(Number);
    auto* const to = reinterpret_cast<std::byte*>(&one);
    for (std::size_t member = 0; member < members; ++member) {
        std::memcpy(to + member * sizeof(Number), from + member * sizeof(Group), sizeof(Number));
    }
    return one;
}
template <template <class> class Struct, class Number, class Group>
void put_into(Struct<Group>& group, std::size_t place, const Struct<Number>& one) {
    constexpr std::size_t members = sizeof(Struct<Number>) / sizeof(Number);
    static_assert(sizeof(Struct<Group>) == members * sizeof(Group) && std::is_trivially_copyable_v<Struct<Group>>);
    auto* const to = reinterpret_cast<std::byte*>(&group) + place * sizeof(Number);
    const auto* const from = reinterpret_cast<const std::byte*>(&one);
    for (std::size_t member = 0; member < members; ++member) {
        std::memcpy(to + member * sizeof(Group), from + member * sizeof(Number), sizeof(Number));
    }
}

// Group: NumberGroup for structs of double, FlagGroup for structs of bool.
template <template <class> class Struct, class Group>
class PackedArray {
  public:
    using Number = typename Group::value_type;

    std::size_t size() const { return size_; }
    Struct<Number> operator[](std::size_t index) const {
        return taken_from<Struct, Number, Group>(group_[index / packed_size], index % packed_size);
    }
    void set(std::size_t index, const Struct<Number>& one) {
        put_into<Struct, Number, Group>(group_[index / packed_size], index % packed_size, one);
    }
    void push_back(const Struct<Number>& one) {
        if (size_ % packed_size == 0) {
            group_.emplace_back();
        }
        set(size_++, one);
    }
    void append(const PackedArray& from, std::size_t begin, std::size_t end) {
        for (std::size_t index = begin; index < end; ++index) {
            push_back(from[index]);
        }
    }
    void reserve(std::size_t count) { group_.reserve(count / packed_size + 1); }

    Struct<Group>* groups() { return group_.data(); }
    const Struct<Group>* groups() const { return group_.data(); }

  private:
    LargeArray<Struct<Group>> group_ = {};
    std::size_t size_ = 0;
};

}  // namespace delabole
