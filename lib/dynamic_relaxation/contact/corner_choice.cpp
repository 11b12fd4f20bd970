#include "dynamic_relaxation/contact/corner_choice.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace delabole {

namespace {

constexpr double relied_on = 1e-3;  // of the weight of the lighter block

struct CornerPair {
    std::uint32_t lower;
    std::uint32_t higher;

    bool operator==(const CornerPair&) const = default;
};

// The contact's corner and the end of its edge at which its rival begins.
CornerPair corners_of(const Bodies& bodies, const ContactNow& now) {
    const auto& [contact, law, memory, at] = now;
    const auto end =
        static_cast<std::uint32_t>(law.rival > 0 ? contact.edge : bodies.range[contact.other].after(contact.edge));
    return {std::min(contact.corner, end), std::max(contact.corner, end)};
}

// Unit vector along which the block with the higher number would separate from the other.
PlanePoint<> parting(const ContactNow& now) {
    const double sense = now.contact.block > now.contact.other ? 1 : -1;
    return sense * PlanePoint<>(now.at.normal_x, now.at.normal_y);
}

// State of a contact of a corner on a corner in a trial, if one is under way.
enum class InTrial { no, yields, insists };

class Corners {
  public:
    Corners(const CornerMotion& blocks, ContactList& list)
        : blocks_(blocks), list_(list), concerned_(blocks.bodies.size(), 0) {}

    // N/m, normal to the edge; 0 where the corner lies over its edge with full weight.
    double relied_on(std::size_t index) const {
        const auto [contact, law, memory, at] = now(index);
        if (law.alone == 0 || !memory.touching) {
            return 0;
        }
        const double share = contact_weight(law, contact, at, memory.insists);
        return share < 1 ? -share * law.normal_stiffness * at.gap : 0;
    }

    // Exchanges the bearing edge in all contacts of a pair of blocks that have the same two corners.
    void exchange(std::size_t index, const ContactRange& of_pair) {
        const CornerPair corners = corners_of(blocks_.bodies, now(index));
        const PlanePoint<> bearing = parting(now(index));
        std::vector<std::size_t> same_face;
        std::vector<std::size_t> other_face;
        for (std::size_t other = of_pair.begin; other < of_pair.end; ++other) {
            if (!is_at(other, corners)) {
                continue;
            }
            const bool same = parting(now(other)).dot(bearing) > one_face;
            (same ? same_face : other_face).push_back(other);
        }
        for (const std::size_t one : same_face) {
            set_trial(one, InTrial::yields);
        }
        for (const std::size_t one : other_face) {
            set_trial(one, InTrial::insists);
        }
    }

    // Takes both edges away in all contacts of a pair of blocks that have the same two corners.
    void release(std::size_t index, const ContactRange& of_pair) {
        const CornerPair corners = corners_of(blocks_.bodies, now(index));
        for (std::size_t other = of_pair.begin; other < of_pair.end; ++other) {
            if (is_at(other, corners)) {
                set_trial(other, InTrial::yields);
            }
        }
    }

    // Whether a contact is one of these two corners alone.
    bool is_at(std::size_t index, const CornerPair& corners) const {
        const ContactNow here = now(index);
        return here.law.alone != 0 && corners_of(blocks_.bodies, here) == corners;
    }

    void set_trial(std::size_t index, InTrial in_trial) {
        auto [contact, law, memory, at] = now(index);
        memory.friction += elastic_energy(law, contact, memory, at);
        memory.yields = in_trial == InTrial::yields;
        memory.insists = in_trial == InTrial::insists;
        memory.tried |= memory.yields;
        memory.shear = memory.normal_drag = memory.shear_drag = 0;
        memory.sliding = false;
        memory.beneath = memory.beneath && !memory.insists;
        memory.touching =
            at.gap < 0 && !memory.yields && !memory.beneath && contact_weight(law, contact, at, memory.insists) > 0;
        memory.place = at.slide;
        memory.friction -= elastic_energy(law, contact, memory, at);
        list_.memory.set(index, memory);
        list_.force[index] = {};
        list_.open_until[index] = not_open;
        concerned_[contact.block] = concerned_[contact.other] = 1;
    }

    template <class IsHeld>
    std::vector<std::uint32_t> concerned(const IsHeld& is_held) const {
        std::vector<std::uint32_t> blocks;
        for (std::uint32_t block = 0; block < concerned_.size(); ++block) {
            if (concerned_[block] != 0 && !is_held(block)) {
                blocks.push_back(block);
            }
        }
        return blocks;
    }

  private:
    ContactNow now(std::size_t index) const { return contact_now(list_, index, blocks_.motion); }

    const CornerMotion& blocks_;
    ContactList& list_;
    std::vector<char> concerned_;
};

// Calls function(contacts, least) for each pair of blocks: `least` is the force, N/m, above which a pair relies on a
// corner on a corner.
template <class Function>
void for_each_pair(const ContactList& list, const std::vector<double>& weight, const Function& function) {
    for (std::size_t begin = 0, end = 0; begin < list.contact.size(); begin = end) {
        const BlockPair pair = list.contact.blocks()[begin].pair();
        while (end < list.contact.size() && list.contact.blocks()[end].pair() == pair) {
            ++end;
        }
        function(ContactRange{begin, end}, relied_on * std::min(weight[pair.first], weight[pair.second]));
    }
}

}  // namespace

bool is_on_corner(const Bodies& bodies, const ContactLaw& law, const RelaxationContact& contact,
                  const ContactPosition& at) {
    constexpr double near = 0.01;
    const double end = law.rival != 0 ? law.rival : law.rival_sine;
    return end != 0 && (end > 0 ? at.position : contact.edge_length() - at.position) <
                           near * std::min(bodies.radius[contact.block], bodies.radius[contact.other]);
}

bool relies_on_corners(const CornerMotion& blocks, const std::vector<double>& weight, const ContactList& list) {
    for (std::size_t index = 0; index < list.contact.size(); ++index) {
        const auto [contact, law, memory, at] = contact_now(list, index, blocks.motion);
        if (!memory.touching || !is_on_corner(blocks.bodies, law, contact, at)) {
            continue;
        }
        const double share = contact_weight(law, contact, at, memory.insists);
        const double lighter = std::min(weight[contact.block], weight[contact.other]);
        if (-share * law.normal_stiffness * at.gap > relied_on * lighter) {
            return true;
        }
    }
    return false;
}

std::vector<std::uint32_t> try_other_edges(const CornerMotion& blocks, const std::vector<double>& weight,
                                           ContactList& list) {
    Corners corners(blocks, list);
    for_each_pair(list, weight, [&](const ContactRange& of_pair, double least) {
        // Two of the three edges in a corner may bear and squeeze a tip. The one with the larger force gives way,
        // whatever the order of blocks and corners.
        std::vector<std::pair<double, std::size_t>> relied;
        for (std::size_t index = of_pair.begin; index < of_pair.end; ++index) {
            relied.emplace_back(-corners.relied_on(index), index);
        }
        std::ranges::sort(relied);
        for (const auto& [force, index] : relied) {
            const ContactMemory memory = list.memory[index];
            if (!memory.tried && !memory.insists && corners.relied_on(index) > least) {
                corners.exchange(index, of_pair);
            }
        }
    });
    return corners.concerned([&](std::uint32_t block) { return !std::isfinite(weight[block]); });
}

std::vector<std::uint32_t> end_trial(const CornerMotion& blocks, ContactList& list) {
    Corners corners(blocks, list);
    for (std::size_t index = 0; index < list.contact.size(); ++index) {
        const ContactMemory memory = list.memory[index];
        if (memory.yields || memory.insists) {
            corners.set_trial(index, InTrial::no);
        }
    }
    return corners.concerned([&](std::uint32_t block) { return blocks.bodies.fixed[block] != 0; });
}

bool give_way_at_corners(const CornerMotion& blocks, const std::vector<double>& weight, ContactList& list,
                         std::set<std::pair<std::uint32_t, std::uint32_t>>& before) {
    Corners corners(blocks, list);
    bool any = false;
    for_each_pair(list, weight, [&](const ContactRange& of_pair, double least) {
        for (std::size_t index = of_pair.begin; index < of_pair.end; ++index) {
            if (corners.relied_on(index) > least) {
                corners.release(index, of_pair);
                const RelaxationContact contact = list.contact[index];
                any |= before.emplace(contact.corner, contact.edge).second;
            }
        }
    });
    return any;
}

void note_tried(const MemoryArray& in_trial, MemoryArray& memory) {
    for (std::size_t index = 0; index < memory.size(); ++index) {
        ContactMemory one = memory[index];
        if (in_trial[index].tried && !one.tried) {
            one.tried = true;
            memory.set(index, one);
        }
    }
}

void forget_tried(MemoryArray& memory) {
    for (std::size_t index = 0; index < memory.size(); ++index) {
        ContactMemory one = memory[index];
        if (one.tried) {
            one.tried = false;
            memory.set(index, one);
        }
    }
}

}  // namespace delabole
