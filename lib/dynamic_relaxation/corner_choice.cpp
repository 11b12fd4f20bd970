#include "dynamic_relaxation/corner_choice.hpp"

#include "dynamic_relaxation/contact_law.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace delabole {

namespace {

struct CornerPair {
    std::uint32_t lower;
    std::uint32_t higher;

    bool operator==(const CornerPair&) const = default;
};

// The contact's corner and the end of its edge at which its rival begins.
CornerPair corners_of(const Bodies& bodies, const ContactLaw& law, const RelaxationContact& contact) {
    const auto end =
        static_cast<std::uint32_t>(law.rival > 0 ? contact.edge : bodies.range[contact.other].after(contact.edge));
    return {std::min(contact.corner, end), std::max(contact.corner, end)};
}

// What a contact at a corner on a corner does now.
struct AtCorner {
    std::size_t index;
    double overlap;
    PlanePoint<> apart;  // unit vector in which the block with the higher number would be parted from the other
};

AtCorner at_corner(const CornerMotion& blocks, std::size_t index, const RelaxationContact& contact) {
    const ContactPosition at = locate(contact, blocks.motion[contact.block], blocks.motion[contact.other]);
    const double sense = contact.block > contact.other ? 1 : -1;
    return {index, -at.gap, sense * PlanePoint<>(at.normal_x, at.normal_y)};
}

bool on_one_face(const AtCorner& one, const AtCorner& other) {
    return one.apart.dot(other.apart) > one_face;
}

// As a contact that ceases to bear leaves its memory: what it held is dissipated.
void make_yield(const ContactLaw& law, const RelaxationContact& contact, const CornerMotion& blocks,
                ContactMemory& memory) {
    memory.friction += elastic_energy(law, contact, memory, blocks.motion[contact.block], blocks.motion[contact.other]);
    memory.shear = memory.normal_drag = memory.shear_drag = 0;
    memory.touching = memory.sliding = false;
    memory.yields = true;
}

// What it begins to hold is not gained: it is taken from what has been dissipated.
void make_bear(const ContactLaw& law, const RelaxationContact& contact, const CornerMotion& blocks,
               ContactMemory& memory) {
    memory.yields = memory.beneath = false;
    const ContactPosition at = locate(contact, blocks.motion[contact.block], blocks.motion[contact.other]);
    if (at.gap < 0 && contact_weight(law, contact, at) > 0) {
        memory.touching = true;
        memory.place = at.slide;
        memory.friction -=
            elastic_energy(law, contact, memory, blocks.motion[contact.block], blocks.motion[contact.other]);
    }
}

PlanePoint<> drawn(const Bodies& bodies, std::size_t corner) {
    return bodies.corner[corner];
}

bool coincide_in_drawing(const Bodies& bodies, const CornerPair& pair, double within) {
    const std::size_t lower = bodies.block_of[pair.lower];
    const std::size_t higher = bodies.block_of[pair.higher];
    const PlanePoint<> apart =
        (bodies.centroid[higher] - bodies.centroid[lower]) + (drawn(bodies, pair.higher) - drawn(bodies, pair.lower));
    return apart.norm() < within;
}

}  // namespace

void choose_at_corners(const CornerMotion& blocks, const std::vector<char>& is_new, double coincide,
                       const PlanePoint<>& up, PairContacts& found) {
    std::vector<char> done(found.contact.size(), 0);
    std::vector<AtCorner> here;
    for (std::size_t first = 0; first < found.contact.size(); ++first) {
        if (done[first] != 0 || found.law[first].alone == 0) {
            continue;
        }
        const CornerPair pair = corners_of(blocks.bodies, found.law[first], found.contact[first]);
        here.clear();
        for (std::size_t index = first; index < found.contact.size(); ++index) {
            if (found.law[index].alone != 0 &&
                corners_of(blocks.bodies, found.law[index], found.contact[index]) == pair) {
                done[index] = 1;
                here.push_back(at_corner(blocks, index, found.contact[index]));
            }
        }
        const auto less_deep = [](const AtCorner& one, const AtCorner& other) { return one.overlap < other.overlap; };
        // Whatever a corner has come beneath without meeting it comes last.
        const auto before = [&](const AtCorner& one, const AtCorner& other) {
            const bool beneath = found.memory[one.index].beneath;
            return beneath == found.memory[other.index].beneath ? less_deep(one, other) : !beneath;
        };
        const auto least = std::min_element(here.begin(), here.end(), before);
        auto bearing = here.end();
        for (auto one = here.begin(); one != here.end(); ++one) {
            const ContactMemory& memory = found.memory[one->index];
            const bool bore = is_new[one->index] == 0 && !memory.yields && !memory.beneath;
            bearing = bore && (bearing == here.end() || less_deep(*one, *bearing)) ? one : bearing;
        }
        if (bearing == here.end()) {
            bearing = least;
            if (coincide > 0 && coincide_in_drawing(blocks.bodies, pair, coincide)) {
                bearing = std::min_element(here.begin(), here.end(), [&](const AtCorner& one, const AtCorner& other) {
                    constexpr double alike = 1e-9;
                    return std::abs(one.apart.dot(up)) < std::abs(other.apart.dot(up)) - alike;
                });
            }
        } else {
            const double way = 1 / found.law[bearing->index].inverse_blend;
            if (bearing->overlap - least->overlap > std::max(way, least->overlap)) {
                bearing = least;
            }
        }
        for (const AtCorner& one : here) {
            ContactMemory& memory = found.memory[one.index];
            const bool yields = !on_one_face(one, *bearing);
            if (yields == memory.yields && (yields || here.size() == 1)) {
                continue;
            }
            if (is_new[one.index] != 0) {
                memory.yields = yields;
                memory.beneath = memory.beneath && (yields || coincide == 0);
                memory.touching = memory.touching && !yields;
            } else if (yields) {
                make_yield(found.law[one.index], found.contact[one.index], blocks, memory);
            } else if (memory.yields) {
                make_bear(found.law[one.index], found.contact[one.index], blocks, memory);
            }
        }
    }
}

std::vector<std::uint32_t> exchange_at_corners(const CornerMotion& blocks, const std::vector<double>& weight,
                                               ContactList& list) {
    constexpr double relied_on = 1e-3;
    const Bodies& bodies = blocks.bodies;
    std::vector<char> concerned(bodies.size(), 0);
    std::vector<AtCorner> here;
    const auto law_of = [&](std::size_t index) { return list.law_of(list.contact.blocks()[index]); };
    for (std::size_t begin = 0, end = 0; begin < list.contact.size(); begin = end) {
        const BlockPair pair = list.contact.blocks()[begin].pair();
        while (end < list.contact.size() && list.contact.blocks()[end].pair() == pair) {
            ++end;
        }
        const double lighter = std::min(weight[pair.first], weight[pair.second]);
        for (std::size_t index = begin; index < end; ++index) {
            const ContactLaw law = law_of(index);
            const RelaxationContact contact = list.contact[index];
            if (law.alone == 0 || !list.memory[index].touching) {
                continue;
            }
            const AtCorner one = at_corner(blocks, index, contact);
            const ContactPosition at = locate(contact, blocks.motion[contact.block], blocks.motion[contact.other]);
            const double share = contact_weight(law, contact, at);
            if (share >= 1 || share * law.normal_stiffness * one.overlap < relied_on * lighter) {
                continue;
            }
            const CornerPair corners = corners_of(bodies, law, contact);
            here.clear();
            bool has_been_tried = true;
            bool has_other = false;
            for (std::size_t other = begin; other < end; ++other) {
                if (law_of(other).alone != 0 && corners_of(bodies, law_of(other), list.contact[other]) == corners) {
                    here.push_back(at_corner(blocks, other, list.contact[other]));
                    const ContactMemory memory = list.memory[other];
                    has_other |= memory.yields;
                    has_been_tried &= !memory.yields || memory.tried;
                }
            }
            if (!has_other || has_been_tried) {
                continue;
            }
            for (const AtCorner& there : here) {
                ContactMemory memory = list.memory[there.index];
                const RelaxationContact its = list.contact[there.index];
                if (memory.yields) {
                    make_bear(law_of(there.index), its, blocks, memory);
                } else {
                    make_yield(law_of(there.index), its, blocks, memory);
                    memory.tried = true;
                }
                list.memory.set(there.index, memory);
                list.force[there.index] = {};
                list.open_until[there.index] = not_open;
            }
            concerned[pair.first] = concerned[pair.second] = 1;
        }
    }
    std::vector<std::uint32_t> blocks_concerned;
    for (std::uint32_t block = 0; block < bodies.size(); ++block) {
        if (concerned[block] != 0 && std::isfinite(weight[block])) {
            blocks_concerned.push_back(block);
        }
    }
    return blocks_concerned;
}

void forget_tried(MemoryArray& memory) {
    for (std::size_t index = 0; index < memory.size(); ++index) {
        ContactMemory one = memory[index];
        one.tried = false;
        memory.set(index, one);
    }
}

}  // namespace delabole
