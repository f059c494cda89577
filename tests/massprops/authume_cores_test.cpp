#include <gtest/gtest.h>

#include <string>

#include "massprops/principal_frame.hpp"
#include "massprops/sphero.hpp"
#include "reconstruct/scan.hpp"
#include "tests/support/reference_data.hpp"

namespace clast {
namespace {

/// A row of Table 1 of Garcia et al. 2022, and the radius that goes with the published core.
struct Published {
  const char* block;
  double radius;  ///< m
  double volume;  ///< m^3
  double mass;    ///< kg
  Vec3 moments;   ///< principal, kg m^2, ascending
};
void PrintTo(const Published& core, std::ostream* out) { *out << core.block; }

class AuthumeCores : public testing::TestWithParam<Published> {
 protected:
  SpheroPolyhedron body() const {
    const std::string file = std::string("authume/blocks/") + GetParam().block + ".stl";
    return make_sphero_polyhedron(read_scan(test_data(file)).mesh, GetParam().radius);
  }
};

// The published moments carry up to 2.4 % of sampling noise.
TEST_P(AuthumeCores, MassPropertiesAreThoseOfTable1) {
  const Published& published = GetParam();
  const MassProperties p = sphero_mass_properties(body(), 1.0);
  EXPECT_NEAR(p.volume / published.volume, 1.0, 0.01);
  const Vec3 per_mass = principal_frame(p).moments / p.mass;
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(per_mass[i] / (published.moments[i] / published.mass), 1.0, 0.03);
  }
}

TEST_P(AuthumeCores, TrueErrorIsInsideTheStatedOne) {
  const MassProperties coarse = sphero_mass_properties(body(), 1.0);
  const MassProperties fine = sphero_mass_properties(body(), 1.0, 1e-5);
  EXPECT_LE(coarse.relative_error, 1e-4);
  EXPECT_LE(fine.relative_error, 1e-5);
  const double bound = coarse.relative_error + fine.relative_error;
  EXPECT_NEAR(coarse.volume / fine.volume, 1.0, bound);
  EXPECT_LT((coarse.inertia - fine.inertia).norm(), bound * principal_frame(fine).moments[0]);
}

INSTANTIATE_TEST_SUITE_P(
    Table1, AuthumeCores,
    testing::Values(Published{"SP1A", 0.027, 0.137, 343.5, Vec3(12.27, 16.4, 20.29)},
                    Published{"SP2A", 0.049, 0.589, 1472.5, Vec3(141.87, 176.74, 228.65)},
                    Published{"SP2B", 0.006, 0.707, 1767.5, Vec3(191.27, 240.4, 317.42)},
                    Published{"SP3A", 0.005, 0.205, 514.0, Vec3(18.4, 48.75, 55.75)}));

}  // namespace
}  // namespace clast
