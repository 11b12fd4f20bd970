// Structs of numbers, or of flags, in groups of eight: within a group the values of each member are contiguous, numbers
// in a line of 64 bytes, as loops over lanes need them.
#pragma once

#include "dynamic_relaxation/wide/large_array.hpp"

#include <array>
#include <cstddef>
#include <cstring>
#include <type_traits>

namespace delabole {

constexpr std::size_t packed_size = 8;

struct alignas(packed_size * sizeof(double)) NumberGroup : std::array<double, packed_size> {};
using FlagGroup = std::array<bool, packed_size>;

// Takes the number, or flag, of each member at a place in a group. `Struct` has members of this type alone.
template <template <class> class Struct, class Group>
Struct<typename Group::value_type> taken_from(const Struct<Group>& group, std::size_t place) {
    using Number = typename Group::value_type;
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
template <template <class> class Struct, class Group>
void put_into(Struct<Group>& group, std::size_t place, const Struct<typename Group::value_type>& one) {
    using Number = typename Group::value_type;
    constexpr std::size_t members = sizeof(Struct<Number>) / sizeof(Number);
    static_assert(sizeof(Struct<Group>) == members * sizeof(Group) && std::is_trivially_copyable_v<Struct<Group>>);
    auto* const to = reinterpret_cast<std::byte*>(&group) + place * sizeof(Number);
    const auto* const from = reinterpret_cast<const std::byte*>(&one);
    for (std::size_t member = 0; member < members; ++member) {
        std::memcpy(to + member * sizeof(Group), from + member * sizeof(Number), sizeof(Number));
    }
}

// Group: NumberGroup for structs of double, FlagGroup for structs of bool. The owner of parallel arrays keeps their
// common size.
template <template <class> class Struct, class Group>
class PackedArray {
  public:
    using Item = Struct<typename Group::value_type>;

    Item operator[](std::size_t index) const {
        return taken_from<Struct, Group>(group_[index / packed_size], index % packed_size);
    }
    void set(std::size_t index, const Item& one) {
        put_into<Struct, Group>(group_[index / packed_size], index % packed_size, one);
    }
    // `size`: number of items so far.
    void push_back(std::size_t size, const Item& one) {
        group_.resize(size / packed_size + 1);
        set(size, one);
    }
    void reserve(std::size_t count) { group_.reserve(count / packed_size + 1); }

    Struct<Group>* groups() { return group_.data(); }
    const Struct<Group>* groups() const { return group_.data(); }

  private:
    LargeArray<Struct<Group>> group_ = {};
};

}  // namespace delabole
