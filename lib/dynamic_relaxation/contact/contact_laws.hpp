// The distinct laws of a list of contacts, each stored once.
#pragma once

#include "dynamic_relaxation/contact/contacts.hpp"

#include <bit>
#include <cstdint>
#include <initializer_list>
#include <unordered_map>
#include <vector>

namespace delabole {

class ContactLaws {
  public:
    void clear() {
        ends_.clear();
        joint_.clear();
    }

    // Takes over the laws of a list.
    void resume(const ContactList& list) {
        clear();
        resume(list.ends, ends_);
        resume(list.joint, joint_);
    }

    // Adds the parts of the law that are new to the list, and gives the contact their numbers.
    void name(const ContactLaw& law, ContactList& list, ContactBlocks& contact) {
        contact.ends = number_of<EdgeEnds>(law, list.ends, ends_);
        contact.joint = number_of<JointLaw>(law, list.joint, joint_);
    }

  private:
    struct Hash {
        std::size_t operator()(const EdgeEnds& ends) const {
            return of({ends.start_weight, ends.end_weight, ends.inverse_blend, ends.rival_sine});
        }
        std::size_t operator()(const JointLaw& joint) const {
            return of({joint.normal_stiffness, joint.normal_dashpot, joint.friction, joint.cohesion});
        }
        static std::size_t of(std::initializer_list<double> numbers) {
            std::uint64_t hash = 0;
            for (const double number : numbers) {
                hash = (hash ^ std::bit_cast<std::uint64_t>(number)) * 0x9e3779b97f4a7c15U;
                hash ^= hash >> 32U;
            }
            return hash;
        }
    };

    template <class Part>
    using Numbers = std::unordered_map<Part, std::uint32_t, Hash>;

    template <class Part>
    static void resume(const std::vector<Part>& list, Numbers<Part>& numbers) {
        for (std::uint32_t number = 0; number < list.size(); ++number) {
            numbers.try_emplace(list[number], number);
        }
    }
    template <class Part>
    static std::uint32_t number_of(const Part& part, std::vector<Part>& list, Numbers<Part>& numbers) {
        const auto [entry, is_new] = numbers.try_emplace(part, static_cast<std::uint32_t>(list.size()));
        if (is_new) {
            list.push_back(part);
        }
        return entry->second;
    }

    Numbers<EdgeEnds> ends_ = {};
    Numbers<JointLaw> joint_ = {};
};

}  // namespace delabole
