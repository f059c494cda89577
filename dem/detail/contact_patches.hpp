#pragma once
/// Which contact points act as one, and what share of the stiffness each carries.
/// @cite garcia2022 (Eqs. 6-8)
#include <array>
#include <span>
#include <vector>

#include "dem/contact_law.hpp"
#include "dem/detail/contact_search.hpp"

namespace clast {

/// The weights of the contact points of one pair of bodies.
class ContactPatches {
 public:
  ContactPatches(const SurfaceFeatures& block, ContactWeights weights)
      : block_(block), weights_(weights) {}

  /// Weight of every point, valid until the next call. Points that share a law have the same
  /// number in `law_of`.
  std::span<const double> share(const std::vector<ContactPoint>& points, const Quat& orientation);
  std::size_t law_of(std::size_t point);

 private:
  void join(const std::vector<ContactPoint>& points, const Quat& orientation);
  /// Planes and straight edges of the block that a contact point lies on.
  std::span<const std::uint32_t> joints_of(const ContactPoint& point,
                                           std::array<std::uint32_t, 3>& buffer) const;

  const SurfaceFeatures& block_;
  ContactWeights weights_;

  // Scratch of one call, kept to spare the allocations.
  std::vector<double> share_;
  std::vector<std::size_t> law_;  ///< union-find over the points
  std::vector<double> law_overlap_;
  std::vector<std::vector<std::uint32_t>> on_joint_;  ///< points on each plane and line
  std::vector<std::uint32_t> joints_used_;
};

}  // namespace clast
