#include "dynamic_relaxation/time_step.hpp"

#include "dynamic_relaxation/contact_law.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>

namespace delabole {

namespace {

// Sums over the contacts of a block, for its two displacements and its rotation.
struct Sums {
    Eigen::Matrix3d stiffness = Eigen::Matrix3d::Zero();
    Eigen::Matrix3d damping = Eigen::Matrix3d::Zero();
};

double greatest_eigenvalue(const Eigen::Matrix3d& matrix) {
    return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(matrix, Eigen::EigenvaluesOnly).eigenvalues()(2);
}

}  // namespace

double stable_step(const Bodies& bodies, const std::vector<Motion>& motion, const ContactList& list, const Bonds& bonds,
                   const std::vector<BondMemory>& bond_memory) {
    std::vector<Sums> sums(bodies.size());
    const auto add = [&](std::size_t block, const Eigen::Vector3d& normal, const Eigen::Vector3d& along,
                         const auto& joint, double share) {
        const Eigen::Matrix3d across = share * normal * normal.transpose();
        const Eigen::Matrix3d in_shear = share * along * along.transpose();
        sums[block].stiffness += joint.normal_stiffness * across + joint.shear_stiffness * in_shear;
        sums[block].damping += joint.normal_dashpot * across + joint.shear_dashpot * in_shear;
    };
    const auto row = [](double x, double y, double arm_x, double arm_y) {
        return Eigen::Vector3d(x, y, arm_x * y - arm_y * x);
    };
    for (const RelaxationContact& contact : list.contact) {
        const ContactPosition at = locate(contact, motion[contact.block], motion[contact.other]);
        const ContactLaw& law = list.law_of(contact);
        const bool both_free = bodies.fixed[contact.block] == 0 && bodies.fixed[contact.other] == 0;
        // Of twins, one takes over what the other leaves.
        const double share = (both_free ? 2 : 1) * (contact.twin == no_twin ? 1.0 : 0.5);
        add(contact.block, row(at.normal_x, at.normal_y, at.arm_x, at.arm_y),
            row(at.along_x(), at.along_y(), at.arm_x, at.arm_y), law, share);
        add(contact.other, row(at.normal_x, at.normal_y, at.other_arm_x, at.other_arm_y),
            row(at.along_x(), at.along_y(), at.other_arm_x, at.other_arm_y), law, share);
    }
    for (std::size_t index = 0; index < bonds.list().size(); ++index) {
        if (bond_memory[index].state != BondState::whole) {
            continue;
        }
        const Bond& bond = bonds.list()[index];
        const std::size_t block = bond.face.block;
        const std::size_t other = bond.face.other;
        const FacePosition at = locate(bond.face, motion[block], motion[other]);
        const double share = bodies.fixed[block] == 0 && bodies.fixed[other] == 0 ? 2 : 1;
        add(block, row(at.normal_x, at.normal_y, at.arm_x, at.arm_y),
            row(at.along_x(), at.along_y(), at.arm_x, at.arm_y), bond.stiffest, share);
        add(other, row(at.normal_x, at.normal_y, at.other_arm_x, at.other_arm_y),
            row(at.along_x(), at.along_y(), at.other_arm_x, at.other_arm_y), bond.stiffest, share);
        for (const std::size_t bent : {block, other}) {
            sums[bent].stiffness(2, 2) += share * bond.stiffest.bending_stiffness;
            sums[bent].damping(2, 2) += share * bond.stiffest.bending_dashpot;
        }
    }
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t block = 0; block < bodies.size(); ++block) {
        const Eigen::Vector3d scale(std::sqrt(bodies.inverse_mass[block]), std::sqrt(bodies.inverse_mass[block]),
                                    std::sqrt(bodies.inverse_inertia[block]));
        const double stiffness = greatest_eigenvalue(scale.asDiagonal() * sums[block].stiffness * scale.asDiagonal());
        const double damping = greatest_eigenvalue(scale.asDiagonal() * sums[block].damping * scale.asDiagonal());
        if (stiffness > 0) {
            least = std::min(least, 2 / (damping / 2 + std::sqrt(damping * damping / 4 + stiffness)));
        }
    }
    return least;
}

}  // namespace delabole
