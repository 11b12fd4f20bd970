// The contacts of one pair of blocks.
#pragma once

#include "dynamic_relaxation/blocks/neighbours.hpp"
#include "dynamic_relaxation/contact/contact_law.hpp"
#include "dynamic_relaxation/contact/contacts.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace delabole {

// The contacts that a pair has had so far, or has now. Twins are counted from the pair's first contact.
struct PairContacts {
    std::vector<RelaxationContact> contact = {};
    std::vector<ContactLaw> law = {};  // law of each contact, in the order of `contact`
    std::vector<ContactMemory> memory = {};
    // m, least distance between the blocks; if negative, the least displacement that separates them.
    double distance = 0;
    double worst_overlap = 0;  // in shortest edges of the two blocks: of contacts, or of the blocks if that is more

    void clear();
};

// The places of the blocks of a pair when it was last searched.
struct PairPose {
    double x = 0;  // m, displacement of the first block against the second
    double y = 0;
    double first_angle = 0;  // rad
    double second_angle = 0;
};

// Distance of a pair in the initial geometry.
struct InitialDistance {
    // Greatest distance by which a line along an edge of either block separates them; if negative, the least
    // displacement that ends their overlap.
    double distance;
    // Whether a contact may overlap by more than the margin. If none may, a search for contacts, which takes five times
    // as long, is not needed.
    bool may_overlap;
};
InitialDistance initial_distance(const Bodies& bodies, std::size_t first, std::size_t second, double margin);

// Options of the search of a pair.
struct PairQuery {
    double margin;
    bool first;  // as in SearchOptions
    OutlineShift shift = {};
};

class PairSearch {
  public:
    PairSearch(const RelaxationScene& scene, const Bodies& bodies, double viscous_damping);

    // Finds contacts of corners of the first block on edges of the second, then the other way round. Those that were
    // contacts already, in the range `before` of the list, keep their memory. `then`: the pose at the last search, if
    // there was one.
    void find(const BlockPair& pair, const std::vector<Motion>& motion, const PairQuery& query, const ContactList& list,
              const ContactRange& before, const std::optional<PairPose>& then, PairContacts& found);

  private:
    // A block in its present position; its corners and edges are counted from its first.
    struct Side {
        std::uint32_t block = 0;
        std::size_t begin = 0;
        std::vector<PlanePoint<>> corner = {};
        std::vector<PlanePoint<>> along = {};  // of the edge that begins at the corner

        PlanePoint<> normal(std::size_t edge) const { return {along[edge].y(), -along[edge].x()}; }
        std::size_t before(std::size_t corner_number) const;
        std::size_t after(std::size_t corner_number) const;
    };

    // Distances of the corners of one block above the edges of the other.
    struct Gaps {
        std::size_t corners = 0;
        std::vector<double> gap = {};  // edge by edge

        double& operator()(std::size_t corner, std::size_t edge) { return gap[edge * corners + corner]; }
        double operator()(std::size_t corner, std::size_t edge) const { return gap[edge * corners + corner]; }
    };

    // Corners and directions of the pair's outlines in the initial geometry, about their centroids.
    PlanePoint<> corner_of(std::size_t corner) const;
    PlanePoint<> along_of(std::size_t edge) const;
    bool is_shifted(std::size_t corner) const { return bodies_.block_of[corner] == side_[0].block; }
    void place(const std::vector<Motion>& motion, Side& side) const;
    static double measure(const Side& block, const Side& other, Gaps& gaps);
    void add_corner(std::size_t side, std::size_t corner, std::size_t edge, PairContacts& found) const;
    void add_twin_as_rival(const Side& block, std::size_t corner, const Side& other, std::size_t edge, bool at_start,
                           ContactLaw& law) const;
    bool can_bear(const Side& block, std::size_t corner, const Side& other, std::size_t edge) const;
    bool bears(const Side& block, std::size_t corner, const Side& other, std::size_t edge) const;  // in the list
    double dip_beyond_that_of(std::size_t corner, std::size_t edge, std::size_t beyond, bool at_start) const;
    double dip_below(std::size_t corner, std::size_t edge) const;
    RelaxationContact contact_of(std::size_t corner, std::size_t edge) const;
    // `beyond`: an edge that goes on as one face where the corner is.
    ContactLaw law_between(const Side& block, std::size_t corner, const Side& other, std::size_t edge,
                           std::optional<std::size_t> beyond) const;
    static double shared_length(const Side& block, std::size_t face, const Side& other, std::size_t edge,
                                double length);
    void pair_twins(PairContacts& found) const;
    void remember(PairContacts& found, const std::vector<Motion>& motion) const;
    bool came_over_edge(const RelaxationContact& contact, const ContactPosition& now) const;
    std::size_t known(std::size_t corner, std::size_t edge) const;
    const Side& side_of(std::uint32_t block) const { return block == side_[0].block ? side_[0] : side_[1]; }

    const RelaxationScene& scene_;
    const Bodies& bodies_;
    double viscous_damping_;
    // The pair that is searched:
    std::array<Side, 2> side_ = {};
    std::array<Gaps, 2> gaps_ = {};
    PairQuery query_{};
    Motion shift_ = {};  // of the first block's outline
    double shortest_ = 0;
    const ContactList* list_ = nullptr;
    ContactRange before_{0, 0};
    std::optional<PairPose> then_ = {};
};

}  // namespace delabole
