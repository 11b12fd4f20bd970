#include "dynamic_relaxation/contacts.hpp"

#include "dynamic_relaxation/contact_laws.hpp"
#include "dynamic_relaxation/pair_search.hpp"

#include <algorithm>
#include <limits>

namespace delabole {

double distance_between(const Bodies& bodies, std::size_t first, std::size_t second) {
    double greatest = -std::numeric_limits<double>::infinity();
    for (const auto& [block, other] : {std::pair(first, second), std::pair(second, first)}) {
        const PlanePoint<> between = bodies.centroid[block] - bodies.centroid[other];
        for (std::size_t edge = bodies.range[other].begin; edge < bodies.range[other].end; ++edge) {
            double least = std::numeric_limits<double>::infinity();
            for (std::size_t corner = bodies.range[block].begin; corner < bodies.range[block].end; ++corner) {
                least =
                    std::min(least, bodies.normal(edge).dot(between + (bodies.corner[corner] - bodies.corner[edge])));
            }
            greatest = std::max(greatest, least);
        }
    }
    return greatest;
}

ContactRange next_of_pair(const ContactList& list, std::size_t from, const BlockPair& pair) {
    const auto pair_of = [&](std::size_t index) { return list.contact[index].pair(); };
    while (from < list.contact.size() && pair_of(from) < pair) {
        ++from;
    }
    std::size_t end = from;
    while (end < list.contact.size() && pair_of(end) == pair) {
        ++end;
    }
    return {from, end};
}

ContactList find_contacts(const RelaxationScene& scene, const Bodies& bodies, const std::vector<Motion>& motion,
                          const std::vector<char>& removed, const SearchOptions& options, const ContactList& previous) {
    ContactList list;
    list.contact.reserve(previous.contact.size() + 64);
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
        search.find(pair, motion, options.margin, options.first,
                    std::span(previous.contact).subspan(before.begin, before.size()),
                    std::span(previous.memory).subspan(before.begin, before.size()), found);
        const auto begin = static_cast<std::uint32_t>(list.contact.size());
        for (std::size_t index = 0; index < found.contact.size(); ++index) {
            RelaxationContact& contact = list.contact.emplace_back(found.contact[index]);
            contact.law = laws.number_of(found.law[index], list.law);
            contact.twin += contact.twin == no_twin ? 0 : begin;
            list.memory.push_back(found.memory[index]);
        }
    }
    list.force.resize(list.contact.size());
    list.open_until.resize(list.contact.size(), not_open);
    return list;
}

}  // namespace delabole
