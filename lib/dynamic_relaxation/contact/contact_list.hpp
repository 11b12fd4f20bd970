// Assembly of lists of contacts from other lists and from the results of a search of one pair.
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

// Range of a pair's contacts in a list whose contacts before `from` belong to lower pairs; if the pair has none, an
// empty range before the first contact of a higher pair.
ContactRange next_of_pair(const ContactList& list, std::size_t from, const BlockPair& pair);

// An empty list with room for the contacts of another list and some more.
ContactList list_like(const ContactList& list);

// Appends whole pairs of another list with the same laws.
void append(const ContactList& from, const ContactRange& range, ContactList& to);

// Appends contacts of one pair, whose twins are counted from its first contact; their forces are not yet evaluated.
void append(const PairContacts& found, const ContactRange& range, ContactLaws& laws, ContactList& to);

}  // namespace delabole
