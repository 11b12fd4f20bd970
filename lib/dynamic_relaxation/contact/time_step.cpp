#include "dynamic_relaxation/contact/time_step.hpp"

#include "dynamic_relaxation/contact/contact_law.hpp"

#include <Eigen/Dense>

#include <cmath>
#include <limits>

namespace delabole {

namespace {

double greatest_eigenvalue(const Eigen::Matrix3d& matrix) {
    return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(matrix, Eigen::EigenvaluesOnly).eigenvalues()(2);
}

Eigen::Vector3d row(double x, double y, double arm_x, double arm_y) {
    return {x, y, arm_x * y - arm_y * x};
}

}  // namespace

void SpringsOnBlock::add(const Eigen::Vector3d& normal, const Eigen::Vector3d& along, const auto& joint, double share) {
    const Eigen::Matrix3d across = share * normal * normal.transpose();
    const Eigen::Matrix3d in_shear = share * along * along.transpose();
    stiffness_ += joint.normal_stiffness * across + joint.shear_stiffness * in_shear;
    damping_ += joint.normal_dashpot * across + joint.shear_dashpot * in_shear;
}

void SpringsOnBlock::add(const RelaxationContact& contact, const ContactLaw& law, const std::vector<Motion>& motion) {
    const ContactPosition at = locate(contact, motion[contact.block], motion[contact.other]);
    const bool both_free = bodies_.fixed[contact.block] == 0 && bodies_.fixed[contact.other] == 0;
    // A twin takes over only what the other twin leaves, but either of two rivals may carry the whole force.
    const double share = (both_free ? 2 : 1) * (contact.twin == no_twin || law.alone > 0 ? 1.0 : 0.5);
    const bool own = contact.block == block_;
    const double arm_x = own ? at.arm_x : at.other_arm_x;
    const double arm_y = own ? at.arm_y : at.other_arm_y;
    add(row(at.normal_x, at.normal_y, arm_x, arm_y), row(at.along_x(), at.along_y(), arm_x, arm_y), law, share);
}

void SpringsOnBlock::add(const Bond& bond, const std::vector<Motion>& motion) {
    const std::size_t block = bond.face.block;
    const std::size_t other = bond.face.other;
    const FacePosition at = locate(bond.face, motion[block], motion[other]);
    const double share = bodies_.fixed[block] == 0 && bodies_.fixed[other] == 0 ? 2 : 1;
    const double arm_x = block == block_ ? at.arm_x : at.other_arm_x;
    const double arm_y = block == block_ ? at.arm_y : at.other_arm_y;
    add(row(at.normal_x, at.normal_y, arm_x, arm_y), row(at.along_x(), at.along_y(), arm_x, arm_y), bond.stiffest,
        share);
    stiffness_(2, 2) += share * bond.stiffest.bending_stiffness;
    damping_(2, 2) += share * bond.stiffest.bending_dashpot;
}

double SpringsOnBlock::stable_step() const {
    const Eigen::Vector3d scale(std::sqrt(bodies_.inverse_mass[block_]), std::sqrt(bodies_.inverse_mass[block_]),
                                std::sqrt(bodies_.inverse_inertia[block_]));
    const double stiffness = greatest_eigenvalue(scale.asDiagonal() * stiffness_ * scale.asDiagonal());
    const double damping = greatest_eigenvalue(scale.asDiagonal() * damping_ * scale.asDiagonal());
    return stiffness > 0 ? 2 / (damping / 2 + std::sqrt(damping * damping / 4 + stiffness))
                         : std::numeric_limits<double>::infinity();
}

}  // namespace delabole
