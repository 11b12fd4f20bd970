#include "dynamic_relaxation/statics/local_balance.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cstdint>
#include <utility>

namespace delabole {

namespace {

// Newton's method with a line search. Returns whether the block moved.
bool balance_alone(std::size_t index, const PseudoViscosity& resisting, const MemoryArray& before,
                   StaticEquations& equations, Eigen::VectorXd& moved, std::vector<Motion>& motion, ContactList& list) {
    constexpr int most_rounds = 6;
    constexpr int most_halvings = 4;
    constexpr double well_enough = 0.1;  // of the load; neighbours that move later change the rest
    const auto at = 3 * static_cast<Eigen::Index>(index);
    Motion& motion_of_block = motion[equations.free_blocks()[index]];
    StaticEquations::BlockBalance balance = equations.balance_of(index, resisting, moved, motion, before, list);
    bool any = false;
    for (int round = 0; round < most_rounds && balance.force.norm() > well_enough * equations.load_of(index); ++round) {
        const Eigen::Vector3d change = balance.tangent.fullPivLu().solve(balance.force);
        const Motion motion_before = motion_of_block;
        const Eigen::Vector3d moved_before = moved.segment<3>(at);
        bool better = false;
        double share = 1;
        for (int halvings = 0; halvings <= most_halvings && !better; ++halvings, share /= 2) {
            motion_of_block = motion_before;
            equations.move(index, share * change, motion);
            moved.segment<3>(at) = moved_before + share * change;
            const StaticEquations::BlockBalance now =
                equations.balance_of(index, resisting, moved, motion, before, list);
            better = now.force.norm() < balance.force.norm();
            balance = better ? now : balance;
        }
        if (!better) {
            motion_of_block = motion_before;
            moved.segment<3>(at) = moved_before;
            break;
        }
        any = true;
    }
    return any;
}

}  // namespace

void balance_one_by_one(const PseudoViscosity& resisting, const Eigen::VectorXd& lacking, const MemoryArray& before,
                        StaticEquations& equations, Eigen::VectorXd& moved, std::vector<Motion>& motion,
                        ContactList& list) {
    constexpr int most_sweeps = 5;
    constexpr double of_greatest = 0.02;
    constexpr double of_mean = 3;
    const std::size_t count = equations.free_blocks().size();
    std::vector<double> lacks(count);
    for (std::size_t index = 0; index < count; ++index) {
        lacks[index] = lacking.segment<3>(3 * static_cast<Eigen::Index>(index)).norm() / equations.load_of(index);
    }
    const double much =
        std::max(of_greatest * *std::ranges::max_element(lacks), of_mean * equations.mean_ratio(lacking));
    std::vector<char> due(count);
    std::ranges::transform(lacks, due.begin(), [&](double lack) { return lack >= much ? 1 : 0; });
    // With this limit the sweeps cost no more than one evaluation of all contacts.
    const std::uint64_t most_evaluations = equations.contacts_evaluated() + list.contact.size();
    const auto may_go_on = [&] { return equations.contacts_evaluated() < most_evaluations; };
    for (int sweep = 0; sweep < most_sweeps && may_go_on(); ++sweep) {
        std::vector<char> next(count, 0);
        for (std::size_t index = 0; index < count; ++index) {
            if (due[index] != 0 && may_go_on() &&
                balance_alone(index, resisting, before, equations, moved, motion, list)) {
                next[index] = 1;
                for (const int neighbour : equations.neighbours_of(index)) {
                    next[static_cast<std::size_t>(neighbour)] = 1;
                }
            }
        }
        due = std::move(next);
    }
}

}  // namespace delabole
