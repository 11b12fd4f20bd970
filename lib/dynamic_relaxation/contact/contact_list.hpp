// Lists of contacts put together, out of other lists and of what a search of one pair has found.
#pragma once

#include "dynamic_relaxation/contact/contact_laws.hpp"
#include "dynamic_relaxation/contact/contacts.hpp"
#include "dynamic_relaxation/contact/pair_search.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace delabole {

template <class T, class Allocator>
std::span<const T> part_of(const std::vector<T, Allocator>& items, const ContactRange& range) {
    return std::span<const T>(items).subspan(range.begin, range.size());
}

// The contacts of a pair in a list, of which those before `from` belong to lower pairs; where there are none, an empty
// range before the first of a higher pair.
ContactRange next_of_pair(const ContactList& list, std::size_t from, const BlockPair& pair);

// Empty, with room for what another list has and some more.
ContactList list_like(const ContactList& list);

// Whole pairs of another list with the same laws.
void append(const ContactList& from, const ContactRange& range, ContactList& to);

// Contacts of one pair, whose twins are counted from its first; forces have yet to be evaluated.
void append(const PairContacts& found, const ContactRange& range, ContactLaws& laws, ContactList& to);

}  // namespace delabole
