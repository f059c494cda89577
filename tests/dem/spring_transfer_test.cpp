// What tangential springs carry when weights move from one point of a patch to another.
#include <gtest/gtest.h>

#include "dem/contact/contact_forces.hpp"
#include "tests/support/test_bodies.hpp"

namespace clast {

using namespace dem_detail;

namespace {

constexpr double kStep = 1e-4, kSpringStiffness = 1e6, kDepth = 1e-3, kSlip = 4e-5;

/// A cube on level ground whose lower corners are loaded as asked.
class SpringTransfer : public testing::TestWithParam<ContactWeighting> {
 protected:
  SpringTransfer() {
    motion_.world_from_body = {Vec3(0.0, 0.0, 0.5 - kDepth), Quat::Identity()};
    motion_.begin_position = motion_.world_from_body.translation;
  }

  /// @param corners  overlap of the lower corners, none where it is zero
  ContactLoad load(const std::vector<double>& corners, const Vec3& velocity) {
    std::vector<ContactPoint> points;
    std::uint32_t corner = 0;
    for (std::uint32_t v = 0; v < cube_.shape.vertices.size(); ++v) {
      if (cube_.shape.vertices[v].z() > 0.0 || corner == corners.size()) continue;
      const double overlap = corners[corner++];
      if (!(overlap > 0.0)) continue;
      ContactPoint point;
      point.block_feature = v;
      point.normal = Vec3::UnitZ();
      point.overlap = overlap;
      point.surface_point = Vec3(cube_.shape.vertices[v].x(), cube_.shape.vertices[v].y(), 0.0);
      points.push_back(point);
    }
    motion_.velocity = motion_.begin_velocity = velocity;
    return forces_.update_loads(points, motion_, {}, kStep, energy_balance_);
  }

  RigidBody cube_ = box(1000.0, Vec3::Ones());
  BlockSurface surface_{cube_.shape};
  std::vector<GroundParameters> zones_ = {{1.0, 1e3, 0.0}};
  ContactModel model_{
      zones_, {}, {kSpringStiffness, kSpringStiffness, kSpringStiffness, kStep}, GetParam(), {}};
  ContactForces forces_{model_, surface_, 1.0};
  BodyMotion motion_;
  EnergyBalance energy_balance_;
};

// One corner alone is pushed by k_t s. Others that share its load share its spring: the force on
// the block stays, and nothing is lost.
TEST_P(SpringTransfer, ForceAndEnergyStayWhenPointsJoin) {
  load({kDepth}, Vec3::Zero());
  const double force = -load({kDepth}, Vec3(kSlip / kStep, 0.0, 0.0)).force.x();
  EXPECT_NEAR(force, kSpringStiffness * kSlip, 1e-9 * force);
  for (const std::vector<double>& corners : {std::vector<double>{kDepth, kDepth},
                                             {kDepth, kDepth, 0.0, 0.5 * kDepth},
                                             {0.2 * kDepth, kDepth, 0.3 * kDepth, 0.5 * kDepth}}) {
    EXPECT_NEAR(-load(corners, Vec3::Zero()).force.x(), force, 1e-9 * force) << corners.size();
  }
  load({kDepth, kDepth, kDepth, kDepth}, Vec3::Zero());
  const double stored = 0.5 * kSpringStiffness * (kDepth * kDepth + kSlip * kSlip);
  EXPECT_NEAR(forces_.stored_energy(), stored, 1e-9 * stored);
}
INSTANTIATE_TEST_SUITE_P(Weights, SpringTransfer,
                         testing::Values(ContactWeighting::kPatch, ContactWeighting::kOverlap,
                                         ContactWeighting::kCount),
                         [](const auto& test) { return name_of(test.param); });

}  // namespace
}  // namespace clast
