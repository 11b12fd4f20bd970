#include "dynamic_relaxation/contact/contacts.hpp"

#include "dynamic_relaxation/contact/contact_list.hpp"
#include "dynamic_relaxation/contact/pair_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace delabole {

OutlineShift outline_shift(const SharedFace& face, const std::array<double, 2>& displaced) {
    // The outline of the block that the face names first turns about the middle of the face.
    const double angle = (displaced[0] - displaced[1]) / face.length;
    const PlanePoint<> out = (displaced[0] + displaced[1]) / 2 * PlanePoint<>(face.along.y(), -face.along.x());
    const bool is_lower = face.block < face.other;
    const double sense = is_lower ? 1 : -1;
    Motion turn;
    turn.set_angle(sense * angle);
    const PlanePoint<> of_centroid = sense * out - turn.turned_by(is_lower ? face.arm : face.other_arm);
    return {of_centroid.x(), of_centroid.y(), turn.angle};
}

std::vector<ShiftedPair> closing_shifts(const Bodies& bodies) {
    constexpr double rounding = 1e-9;  // of the shortest edge
    std::vector<ShiftedPair> shifts;
    const std::vector<SharedFace> faces = find_shared_faces(bodies);
    for (auto begin = faces.begin(); begin != faces.end();) {
        const BlockPair pair(begin->block, begin->other);
        const auto end = std::find_if(
            begin, faces.end(), [&](const SharedFace& face) { return BlockPair(face.block, face.other) != pair; });
        const SharedFace& longest =
            *std::max_element(begin, end, [](const auto& one, const auto& other) { return one.length < other.length; });
        const std::array<double, 2> opening = opening_in_drawing(bodies, longest);
        const double little = rounding * std::min(bodies.shortest_edge[pair.first], bodies.shortest_edge[pair.second]);
        const OutlineShift shift = outline_shift(longest, {-opening[0], -opening[1]});
        Motion as_motion;
        as_motion.set_angle(shift.angle);
        const auto stays_as_drawn = [&](const SharedFace& face) {
            const std::array<double, 2> before = opening_in_drawing(bodies, face);
            const PlanePoint<> normal(face.along.y(), -face.along.x());
            const PlanePoint<> half = face.length / 2 * face.along;
            const std::array<PlanePoint<>, 2> arm{face.arm - half, face.arm + half};
            const auto stays = [&](std::size_t point) {
                const PlanePoint<> moved = PlanePoint<>(shift.x, shift.y) + as_motion.turned_by(arm[point]);
                const double after = before[point] + normal.dot(moved);
                return after >= std::min(before[point], 0.0) - little && after <= std::max(before[point], 0.0) + little;
            };
            return stays(0) && stays(1);
        };
        if (std::max(std::abs(opening[0]), std::abs(opening[1])) > little && std::all_of(begin, end, stays_as_drawn)) {
            shifts.push_back({pair, shift});
        }
        begin = end;
    }
    return shifts;
}

void reach_as_shifted(const Bodies& bodies, std::span<const ShiftedPair> shifted, std::vector<double>& reach) {
    for (const auto& [pair, shift] : shifted) {
        for (const std::uint32_t block : {pair.first, pair.second}) {
            reach[block] = std::max(reach[block], opening_of_closed_joint(bodies, pair.first, pair.second));
        }
    }
}

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
    std::vector<double> reach(bodies.size(), options.margin / 2);
    reach_as_shifted(bodies, options.shifted, reach);
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
