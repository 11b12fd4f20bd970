// The greatest stable step of a system of blocks on springs.
#pragma once

#include "dynamic_relaxation/contact/bonds.hpp"
#include "dynamic_relaxation/contact/contacts.hpp"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace delabole {

// The springs and dashpots on one block and its greatest stable step of leap-frog integration with dashpots half a step
// behind, which follows from
//   step^2 stiffness / 4 + step damping / 2 = 1,
// where stiffness and damping are the greatest eigenvalues of (mass matrix)^-1 (sum over all contacts of the list and
// all whole bonds, each taken with the contacts that would replace it), contacts and bonds with free blocks counted
// twice: no system of such blocks can be stiffer, whichever of the contacts close. Without damping the step is
// 2 / (circular frequency). The least step of all blocks is stable for the whole system.
class SpringsOnBlock {
  public:
    SpringsOnBlock(const Bodies& bodies, std::size_t block) : bodies_(bodies), block_(block) {}

    void add(const RelaxationContact& contact, const ContactLaw& law, const std::vector<Motion>& motion);
    void add(const Bond& bond, const std::vector<Motion>& motion);

    double stable_step() const;  // s; infinite without springs

  private:
    // Adds rows that map the block's two displacements and its rotation to a displacement at the contact.
    void add(const Eigen::Vector3d& normal, const Eigen::Vector3d& along, const auto& joint, double share);

    const Bodies& bodies_;
    std::size_t block_;
    Eigen::Matrix3d stiffness_ = Eigen::Matrix3d::Zero();
    Eigen::Matrix3d damping_ = Eigen::Matrix3d::Zero();
};

}  // namespace delabole
