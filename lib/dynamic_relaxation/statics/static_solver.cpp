#include "dynamic_relaxation/statics/static_solver.hpp"

#include "dynamic_relaxation/contact/contact_law.hpp"
#include "dynamic_relaxation/contact/contact_transition.hpp"
#include "dynamic_relaxation/contact/corner_choice.hpp"
#include "dynamic_relaxation/statics/local_balance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace delabole {

namespace {

// With more free blocks, rounds diverge: too many contacts change in each of them.
constexpr std::size_t few_blocks = 24;

class StaticSolver {
  public:
    StaticSolver(const Bodies& bodies, const StaticSolveSettings& settings, const StaticSolution* creeping,
                 const Bonds& bonds, StaticEquations& equations)
        : bodies_(bodies),
          settings_(settings),
          creeping_(creeping),
          bonds_(bonds),
          equations_(equations),
          is_small_(equations.free_blocks().size() < few_blocks) {}

    StaticSolution solve(std::vector<Motion>& motion, ContactList& list) {
        if (equations_.free_blocks().empty()) {
            return {0, false, false, motion, list.memory, 0};
        }
        forget_tried(list.memory);
        std::vector<Motion> start = motion;
        StaticSolution found = approach(start, motion, list);
        // Joints lose their peak strength one after the other, wherever it is reached.
        while (found.ratio <= settings_.tolerance && break_spent(motion, list)) {
            start = motion;
            found = approach(start, motion, list);
        }
        while (settings_.corners_bear && found.ratio <= settings_.tolerance && try_corners(found, motion, list)) {
        }
        if (creeping_ != nullptr && found.ratio > settings_.tolerance && creeping_->ratio < found.ratio) {
            found.ratio = creeping_->ratio;
            found.most_balanced = creeping_->most_balanced;
            found.memory = {};
        }
        found.contacts_evaluated = equations_.contacts_evaluated();
        return found;
    }

  private:
    // Blocks held by corners on corners have to be held with either edge (corner_choice.hpp). Returns whether there was
    // anything to try.
    bool try_corners(StaticSolution& found, std::vector<Motion>& motion, ContactList& list) {
        MemoryArray memory_before = list.memory;
        if (try_other_edges({bodies_, motion}, equations_.weights(), list).empty()) {
            return false;
        }
        const std::vector<Motion> before = motion;
        StaticSolution other = approach(before, motion, list);
        if (other.ratio > settings_.tolerance) {
            found = std::move(other);
            return true;
        }
        note_tried(list.memory, memory_before);
        motion = before;
        list.memory = std::move(memory_before);
        return true;
    }

    // Contacts with a peak that carry their full strength can slip, and have their residual strength from then on.
    bool break_spent(const std::vector<Motion>& motion, ContactList& list) const {
        constexpr double nearly = 1 - 1e-9;
        bool any = false;
        for (std::size_t index = 0; index < list.contact.size(); ++index) {
            auto [contact, law, memory, at] = contact_now(list, index, motion);
            if (!memory.touching || memory.broken || !has_peak(law)) {
                continue;
            }
            const double strength = shear_strength(law, law.normal_stiffness * std::max(-at.gap, 0.0), false);
            memory.broken = law.shear_stiffness * std::abs(memory.shear) >= nearly * strength;
            list.memory.set(index, memory);
            any |= memory.broken;
        }
        return any;
    }

    // `start`: the state from which the limits of motion are measured.
    StaticSolution approach(const std::vector<Motion>& start, std::vector<Motion>& motion, ContactList& list) {
        if (!is_small_) {
            return approach_in_motion(start, motion, list);
        }
        // Rounds in which blocks may creep, or the large steps of the first rounds, can miss a balance near by.
        std::optional<StaticSolution> nearest;
        if (settings_.nearest && creeping_ == nullptr) {
            constexpr double well_within = 0.1;  // of the limits of creep
            const std::vector<Motion> motion_before = motion;
            const MemoryArray memory_before = list.memory;
            const Creep creep = std::exchange(settings_.creep, Creep::none);
            double least = std::numeric_limits<double>::infinity();
            for (const double resistance : {1.0, 30.0, 1e3}) {
                StaticSolution found = approach_in_rounds(start, resistance, motion, list);
                const double share = share_of_creep(start, motion);
                if (found.ratio <= settings_.tolerance && share < least) {
                    nearest = std::move(found);
                    least = share;
                }
                motion = motion_before;
                list.memory = memory_before;
                if (least < well_within) {
                    break;
                }
            }
            settings_.creep = creep;
        }
        if (nearest) {
            motion = nearest->most_balanced;
            list.memory = nearest->memory;
            return std::move(*nearest);
        }
        return approach_in_rounds(start, 1, motion, list);
    }

    StaticSolution approach_in_rounds(const std::vector<Motion>& start, double resistance, std::vector<Motion>& motion,
                                      ContactList& list) {
        // The resistance is at first as stiff as the joints or stiffer, so that no contact is missed in a large step.
        // It is then reduced as long as the balance does not become much worse: blocks may lose balance for a while
        // before they jam. A step that makes the balance far worse, or exceeds half of the allowed distance, is not
        // made: friction would preserve the forces that it leaves, and could hold blocks that nothing else holds.
        constexpr double smaller = 1.6;
        constexpr double larger = 4;
        constexpr double much_worse = 1.5;
        constexpr double far_worse = 4;
        constexpr double half_way = 0.5;
        const int most_rounds = may_leave_crept() ? 2000 : 300;
        double ratio = evaluate(motion, list);
        StaticSolution best{ratio, false, false, motion, list.memory, 0};
        bool improves = true;
        for (int round = 0; round < most_rounds && !stopped(); ++round) {
            if (best.ratio <= settings_.finest || (best.ratio <= settings_.tolerance && !improves)) {
                break;
            }
            const std::optional<Eigen::VectorXd> change = equations_.change({resistance, 0}, equations_.unbalanced());
            if (!change) {
                break;
            }
            const std::vector<Motion> motion_before = motion;
            const MemoryArray memory_before = list.memory;
            const double ratio_before = ratio;
            const double come = share_of_limits(start, best, motion);
            equations_.move(*change, motion);
            const double gone = share_of_limits(start, best, motion);
            if (gone >= 1 && come > half_way) {
                if (!may_leave_crept() || best.ratio <= settings_.tolerance) {
                    break;
                }
                best.at_farthest = share_of_farthest(start, motion) >= gone;
                equations_.move(-share_beyond(come, gone) * *change, motion);
                evaluate(motion, list);
                settle(resistance, motion, list);
                return best;
            }
            ratio = gone < 1 ? evaluate(motion, list) : std::numeric_limits<double>::infinity();
            if (may_leave_crept() && gone < 1 && ratio > settings_.tolerance) {
                ratio = settle(resistance, motion, list);
            }
            if (!(ratio < far_worse * ratio_before)) {
                motion = motion_before;
                list.memory = memory_before;
                ratio = evaluate(motion, list);
                resistance *= larger;
                continue;
            }
            improves = ratio < ratio_before / 2;
            if (ratio < best.ratio) {
                best.ratio = ratio;
                best.most_balanced = motion;
                best.memory = list.memory;
            }
            resistance =
                std::max(ratio < much_worse * ratio_before ? resistance / smaller : resistance * larger, 1e-13);
        }
        motion = best.most_balanced;
        list.memory = best.memory;
        return best;
    }

    double evaluate(const std::vector<Motion>& motion, ContactList& list) {
        equations_.evaluate(motion, list.memory, list);
        return equations_.unbalanced_ratio();
    }

    // A round with too much pseudo-viscosity for blocks to creep. The last round moved blocks along straight lines, and
    // joints that are stiff only recover from that here.
    double settle(double resistance, std::vector<Motion>& motion, ContactList& list) {
        constexpr double least = 1e-3;
        if (const auto change = equations_.change({std::max(resistance, least), 0}, equations_.unbalanced())) {
            equations_.move(*change, motion);
        }
        return evaluate(motion, list);
    }

    // One implicit step of the motion without mass, from `motion` and the memories that contacts had before it:
    // pseudo-viscosity balances the unbalanced forces. The method is Newton's, with a line search over the root mean
    // square of the remaining imbalance; where a step of all blocks leaves much imbalance, the blocks with most of it
    // are solved for one by one.
    struct ImplicitStep {
        Eigen::VectorXd moved;
        int solutions = 0;      // of linear equations
        bool balanced = false;  // including pseudo-viscosity, well enough for the next step
        bool kept = false;      // balanced, or nearer to balance than at first
    };

    ImplicitStep step_implicitly(double pseudo_viscosity, const MemoryArray& before, std::vector<Motion>& motion,
                                 ContactList& list) {
        constexpr double well_enough = 0.3;  // of the initial imbalance: the next step corrects the rest
        constexpr double nearer = 0.5;
        constexpr double astray = 2;
        constexpr int most_solutions = 8;
        constexpr int most_halvings = 3;
        constexpr double rounding = 1e-13;
        // The resistance to rigid motion of many blocks together has to decrease faster than the one between contacts.
        const PseudoViscosity resisting{pseudo_viscosity * std::min(1.0, 10 * pseudo_viscosity), pseudo_viscosity};
        ImplicitStep step{Eigen::VectorXd::Zero(equations_.unbalanced().size())};
        Eigen::VectorXd lacking = equations_.unbalanced();
        const double at_first = equations_.mean_ratio(lacking);
        const double enough = std::max(well_enough * at_first, rounding);
        double lacks = at_first;
        while (step.solutions < most_solutions && !step.balanced) {
            ++step.solutions;
            const std::optional<Eigen::VectorXd> change = equations_.change(resisting, lacking);
            if (!change) {
                return step;
            }
            const std::vector<Motion> from = motion;
            const Eigen::VectorXd moved_before = step.moved;
            const double lacked = lacks;
            const auto compare = [&] {
                lacking = equations_.unbalanced() - equations_.resistance(resisting, step.moved);
                lacks = equations_.mean_ratio(lacking);
            };
            const auto weigh = [&] {
                equations_.evaluate(motion, before, list);
                compare();
            };
            const auto follow_alone = [&] {
                const std::vector<Motion> together = motion;
                const Eigen::VectorXd moved_together = step.moved;
                const double lacks_together = lacks;
                balance_one_by_one(resisting, lacking, before, equations_, step.moved, motion, list);
                equations_.evaluate_again(motion, before, list);
                compare();
                if (!(lacks < lacks_together)) {
                    motion = together;
                    step.moved = moved_together;
                    weigh();
                }
            };
            double share = 1;
            for (int halvings = 0;; ++halvings, share /= 2) {
                motion = from;
                equations_.move(share * *change, motion);
                step.moved = moved_before + share * *change;
                weigh();
                if (lacks > enough && bonds_.empty()) {
                    follow_alone();
                }
                if (lacks < lacked || halvings == most_halvings) {
                    break;
                }
            }
            step.balanced = lacks <= enough;
            if (!(lacks < astray * at_first)) {
                return step;
            }
        }
        step.kept = step.balanced || lacks <= nearer * at_first;
        return step;
    }

    StaticSolution approach_in_motion(const std::vector<Motion>& start, std::vector<Motion>& motion,
                                      ContactList& list) {
        constexpr double smaller = 2;
        constexpr double larger = 4;
        constexpr double least_viscosity = 1e-13;
        constexpr double greatest_viscosity = 1e3;
        constexpr int easily = 4;  // solutions
        constexpr int most_solutions = 2000;
        constexpr double half_way = 0.5;
        constexpr double short_step = 1;
        constexpr int most_jumps = 20;  // jumps to and fro lead nowhere
        int jumped = 0;
        double pseudo_viscosity = 0.3;
        equations_.let_contacts_resist();
        double ratio = evaluate(motion, list);
        MemoryArray memory = list.memory;
        StaticSolution best{ratio, false, false, motion, list.memory, 0};
        bool improves = true;
        int solutions = 0;
        while (best.ratio > settings_.finest && (best.ratio > settings_.tolerance || improves) &&
               pseudo_viscosity <= greatest_viscosity && !stopped()) {
            if (solutions >= most_solutions) {
                best.cut_short = best.ratio > settings_.tolerance;
                break;
            }
            const std::vector<Motion> from = motion;
            const double come = share_of_limits(start, best, from);
            const Eigen::VectorXd unbalanced_before = equations_.unbalanced();
            const ImplicitStep step = step_implicitly(pseudo_viscosity, memory, motion, list);
            solutions += step.solutions;
            const double gone = share_of_limits(start, best, motion);
            if (gone >= 1 && come > half_way) {
                best.at_farthest = creeps() && share_of_farthest(start, motion) >= gone;
                if (best.ratio <= settings_.tolerance || !(may_leave_crept() || best.at_farthest)) {
                    break;
                }
                equations_.move(-share_beyond(come, gone) * step.moved, motion);
                equations_.evaluate(motion, memory, list);
                return best;
            }
            // Even in a very short step a contact's force may jump, for instance where one corner hands over to
            // another. The steps after it remove that imbalance. With bonds the motion after a jump could break some:
            // the dynamic run then decides.
            const bool jumps =
                gone < 1 && !step.kept && pseudo_viscosity > short_step && jumped < most_jumps && bonds_.empty();
            jumped += jumps ? 1 : 0;
            if (!(gone < 1) || !(step.kept || jumps)) {
                improves = false;
                motion = from;
                equations_.evaluate(motion, memory, list);
                pseudo_viscosity *= larger;
                continue;
            }
            memory = list.memory;
            if (step.balanced && go_on_alike(start, best, unbalanced_before, step.moved, memory, motion, list)) {
                memory = list.memory;
            }
            const double ratio_before = std::exchange(ratio, equations_.unbalanced_ratio());
            improves = ratio < ratio_before / 2;
            if (ratio < best.ratio) {
                best.ratio = ratio;
                best.most_balanced = motion;
                best.memory = memory;
            }
            if (step.balanced && step.solutions <= easily) {
                const double by = step.solutions == 1 ? smaller * smaller : smaller;
                pseudo_viscosity = std::max(pseudo_viscosity / by, least_viscosity);
            }
        }
        motion = best.most_balanced;
        list.memory = best.memory;
        return best;
    }

    // Near the limit of stability each step leaves much the same imbalance: blocks approach their balance in a slow
    // motion that dies out, or creep at a steady rate. The rest of the former (Aitken's extrapolation), or many steps
    // of the latter, are made at once if they leave little imbalance.
    bool go_on_alike(const std::vector<Motion>& start, const StaticSolution& met,
                     const Eigen::VectorXd& unbalanced_before, const Eigen::VectorXd& moved, const MemoryArray& memory,
                     std::vector<Motion>& motion, ContactList& list) {
        constexpr double slow = 0.5;
        constexpr double steady = 0.9;
        constexpr double alike = 0.9;  // cosine of the angle between the imbalances before and after the step
        constexpr double better = 0.75;
        constexpr double corrected_soon = 10;  // imbalance over that of steady creep
        const Eigen::VectorXd left = equations_.unbalanced();
        const double common = left.dot(unbalanced_before);
        const double share = common / unbalanced_before.squaredNorm();
        if (!(share > slow && common > alike * left.norm() * unbalanced_before.norm())) {
            return false;
        }
        const auto go_on = [&](double steps, double most_left) {
            const std::vector<Motion> before = motion;
            equations_.move(steps * moved, motion);
            if (share_of_limits(start, met, motion) < 1) {
                equations_.evaluate(motion, memory, list);
                if (equations_.mean_ratio(equations_.unbalanced()) < most_left * equations_.mean_ratio(left)) {
                    return true;
                }
            }
            motion = before;
            equations_.evaluate(motion, memory, list);
            return false;
        };
        if (share < 1 && go_on(share / (1 - share), better)) {
            return true;
        }
        if (!creeps() || share < steady) {
            return false;
        }
        const bool goes_on = go_on(steps_at_once_, corrected_soon);
        steps_at_once_ = goes_on ? 2 * steps_at_once_ : std::max(steps_at_once_ / 4, 1.0);
        return goes_on;
    }

    bool stopped() const { return settings_.stop != nullptr && *settings_.stop; }
    bool may_leave_crept() const { return settings_.creep == Creep::left; }

    // Creep of few blocks is not worth its cost unless they are left where they crept to: they jam sooner in the run.
    bool creeps() const { return may_leave_crept() || (settings_.creep == Creep::put_back && !is_small_); }

    // Share of a change to take back if it led from within the limits to beyond them, so that the run only has to show
    // that blocks move on.
    static double share_beyond(double come, double gone) {
        constexpr double just_within = 0.99;
        return std::min(1.0, (gone - just_within) / (gone - come));
    }

    double share_of_farthest(const std::vector<Motion>& start, const std::vector<Motion>& motion) const {
        double share = 0;
        for (const std::size_t block : equations_.free_blocks()) {
            const Motion& now = motion[block];
            const Motion& then = start[block];
            const double displacement =
                std::hypot(now.x - then.x, now.y - then.y) + std::abs(now.angle - then.angle) * bodies_.radius[block];
            share = std::max(share, displacement / settings_.farthest);
        }
        return share;
    }

    // A share up to 1 means that the motion is within the limits.
    double share_of_limits(const std::vector<Motion>& start, const StaticSolution& met,
                           const std::vector<Motion>& motion) const {
        const double share = share_of_farthest(start, motion);
        if (!creeps()) {
            return share;
        }
        const bool began_better = creeping_ != nullptr && creeping_->ratio < met.ratio;
        return std::max(share, share_of_creep((began_better ? *creeping_ : met).most_balanced, motion));
    }

    // The greatest motion of a block over what creep is allowed.
    double share_of_creep(const std::vector<Motion>& from, const std::vector<Motion>& motion) const {
        double share = 0;
        for (const std::size_t block : equations_.free_blocks()) {
            const Motion& now = motion[block];
            const Motion& then = from[block];
            share = std::max(
                {share, std::abs(now.angle - then.angle) / settings_.creep_rotation,
                 std::hypot(now.x - then.x, now.y - then.y) / (settings_.creep_slide * bodies_.radius[block])});
        }
        return share;
    }

    const Bodies& bodies_;
    StaticSolveSettings settings_;
    const StaticSolution* creeping_;
    const Bonds& bonds_;
    StaticEquations& equations_;
    bool is_small_;
    double steps_at_once_ = 8;  // of steady creep
};

}  // namespace

StaticSolution solve_statically(const Bodies& bodies, const std::vector<char>& held,
                                const std::vector<Eigen::Vector3d>& loads, const StaticSolveSettings& settings,
                                const StaticSolution* creeping, const Bonds& bonds,
                                const std::vector<BondMemory>& bond_memory, std::span<const HeldByBolt> bolts,
                                std::vector<Motion>& motion, ContactList& list) {
    StaticEquations equations(bodies, held, loads, bonds, bond_memory, bolts, list);
    return StaticSolver(bodies, settings, creeping, bonds, equations).solve(motion, list);
}

}  // namespace delabole
