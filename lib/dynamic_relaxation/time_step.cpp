#include "dynamic_relaxation/time_step.hpp"

#include "dynamic_relaxation/contact_law.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>

namespace delabole {

double stable_step(const Bodies& bodies, const std::vector<Motion>& motion, const ContactList& list) {
    std::vector<Eigen::Matrix3d> stiffness(bodies.size(), Eigen::Matrix3d::Zero());
    const auto add = [&](std::size_t block, const Eigen::Vector3d& normal, const Eigen::Vector3d& along,
                         const RelaxationContact& contact, double share) {
        stiffness[block] += share * (contact.normal_stiffness * normal * normal.transpose() +
                                     contact.shear_stiffness * along * along.transpose());
    };
    for (const RelaxationContact& contact : list.contact) {
        const ContactPosition at = locate(contact, motion[contact.block], motion[contact.other]);
        const auto row = [](double x, double y, double arm_x, double arm_y) {
            return Eigen::Vector3d(x, y, arm_x * y - arm_y * x);
        };
        const bool both_free = bodies.fixed[contact.block] == 0 && bodies.fixed[contact.other] == 0;
        // Of twins, one takes over what the other leaves.
        const double share = (both_free ? 2 : 1) * (contact.twin == no_twin ? 1.0 : 0.5);
        add(contact.block, row(at.normal_x, at.normal_y, at.arm_x, at.arm_y),
            row(at.along_x(), at.along_y(), at.arm_x, at.arm_y), contact, share);
        add(contact.other, row(at.normal_x, at.normal_y, at.other_arm_x, at.other_arm_y),
            row(at.along_x(), at.along_y(), at.other_arm_x, at.other_arm_y), contact, share);
    }
    double greatest = 0;
    for (std::size_t block = 0; block < bodies.size(); ++block) {
        const Eigen::Vector3d scale(std::sqrt(bodies.inverse_mass[block]), std::sqrt(bodies.inverse_mass[block]),
                                    std::sqrt(bodies.inverse_inertia[block]));
        const Eigen::Matrix3d scaled = scale.asDiagonal() * stiffness[block] * scale.asDiagonal();
        greatest = std::max(
            greatest, Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(scaled, Eigen::EigenvaluesOnly).eigenvalues()(2));
    }
    return greatest > 0 ? 2 / std::sqrt(greatest) : std::numeric_limits<double>::infinity();
}

}  // namespace delabole
