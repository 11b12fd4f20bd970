#include "dynamic_relaxation/contact/contacts.hpp"

#include "dynamic_relaxation/contact/contact_list.hpp"
#include "dynamic_relaxation/contact/pair_search.hpp"

#include <algorithm>

namespace delabole {

OutlineShift shift_of(const BlockPair& pair, std::span<const ShiftedPair> shifted) {
    const auto found = std::ranges::lower_bound(shifted, pair, {}, &ShiftedPair::pair);
    return found != shifted.end() && found->pair == pair ? found->shift : OutlineShift{};
}

ContactList find_contacts(const RelaxationScene& scene, const Bodies& bodies, const std::vector<Motion>& motion,
                          const std::vector<char>& removed, const SearchOptions& options, const ContactList& previous) {
    ContactList list = list_like(previous);
    ContactLaws laws;
    PairSearch search(scene, bodies, options.viscous_damping);
    PairContacts found;
    const std::vector<double> reach(bodies.size(), options.margin / 2);
    ContactRange before{0, 0};
    for (const BlockPair& pair : neighbouring_blocks(bodies, motion, removed, reach)) {
        if (std::binary_search(options.bonded.begin(), options.bonded.end(), pair)) {
            continue;
        }
        before = next_of_pair(previous, before.end, pair);
        search.find(pair, motion, {options.margin, options.first, shift_of(pair, options.shifted)}, previous, before,
                    {}, found);
        append(found, {0, found.contact.size()}, laws, list);
    }
    return list;
}

}  // namespace delabole
