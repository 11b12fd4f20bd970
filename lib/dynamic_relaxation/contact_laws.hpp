// Each law of a list of contacts once.
#pragma once

#include "dynamic_relaxation/contacts.hpp"

#include <bit>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace delabole {

class ContactLaws {
  public:
    void clear() { number_.clear(); }

    // Of the laws that a list has.
    void resume(const std::vector<ContactLaw>& list) {
        number_.clear();
        for (std::uint32_t number = 0; number < list.size(); ++number) {
            number_.try_emplace(list[number], number);
        }
    }

    // Adds the law to the list if it is new.
    std::uint32_t number_of(const ContactLaw& law, std::vector<ContactLaw>& list) {
        const auto [entry, is_new] = number_.try_emplace(law, static_cast<std::uint32_t>(list.size()));
        if (is_new) {
            list.push_back(law);
        }
        return entry->second;
    }

  private:
    struct Hash {
        std::size_t operator()(const ContactLaw& law) const {
            std::uint64_t hash = 0;
            for (const double number : {law.start_weight, law.end_weight, law.inverse_blend, law.rival_sine,
                                        law.normal_stiffness, law.normal_dashpot, law.friction, law.cohesion}) {
                hash = (hash ^ std::bit_cast<std::uint64_t>(number)) * 0x9e3779b97f4a7c15U;
                hash ^= hash >> 32U;
            }
            return hash;
        }
    };

    std::unordered_map<ContactLaw, std::uint32_t, Hash> number_ = {};
};

}  // namespace delabole
