#include "dynamic_relaxation/contact/contact_list.hpp"

#include <cstdint>

namespace delabole {

namespace {

// `shift` is taken modulo 2^32.
void shift_twins(std::size_t begin, std::uint32_t shift, ContactList& list) {
    if (shift == 0) {
        return;
    }
    for (ContactBlocks& contact : list.contact.blocks().subspan(begin)) {
        contact.twin += contact.twin == no_twin ? 0 : shift;
    }
}

}  // namespace

ContactRange next_of_pair(const ContactList& list, std::size_t from, const BlockPair& pair) {
    const auto pair_of = [&](std::size_t index) { return list.contact.blocks()[index].pair(); };
    while (from < list.contact.size() && pair_of(from) < pair) {
        ++from;
    }
    std::size_t end = from;
    while (end < list.contact.size() && pair_of(end) == pair) {
        ++end;
    }
    return {from, end};
}

ContactList list_like(const ContactList& list) {
    constexpr std::size_t more = 64;
    ContactList like;
    like.contact.reserve(list.contact.size() + more);
    like.memory.reserve(list.contact.size() + more);
    like.force.reserve(list.contact.size() + more);
    like.open_until.reserve(list.contact.size() + more);
    return like;
}

void append(const ContactList& from, const ContactRange& range, ContactList& to) {
    const std::size_t begin = to.contact.size();
    for (std::size_t index = range.begin; index < range.end; ++index) {
        to.contact.push_back(from.contact[index]);
        to.memory.push_back(from.memory[index]);
    }
    const auto copy = [&](const auto& source, auto& target) {
        const std::span part = part_of(source, range);
        target.insert(target.end(), part.begin(), part.end());
    };
    copy(from.force, to.force);
    copy(from.open_until, to.open_until);
    shift_twins(begin, static_cast<std::uint32_t>(begin) - static_cast<std::uint32_t>(range.begin), to);
}

void append(const PairContacts& found, const ContactRange& range, ContactLaws& laws, ContactList& to) {
    const std::size_t begin = to.contact.size();
    for (std::size_t index = range.begin; index < range.end; ++index) {
        to.contact.push_back(found.contact[index]);
        laws.name(found.law[index], to, to.contact.blocks().back());
        to.memory.push_back(found.memory[index]);
        to.force.emplace_back();
        to.open_until.push_back(not_open);
    }
    shift_twins(begin, static_cast<std::uint32_t>(begin), to);
}

}  // namespace delabole
