#include "core/files/up_axis.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "tests/support/refusal.hpp"

namespace clast {
namespace {

TEST(UpAxis, GltfIsYUpUnlessSaidOtherwise) {
  EXPECT_EQ(resolve_up_axis("auto", "a.glb"), "y");
  EXPECT_EQ(resolve_up_axis("auto", "a.GLTF"), "y");
  EXPECT_EQ(resolve_up_axis("auto", "a.obj"), "z");
  EXPECT_EQ(resolve_up_axis("auto", "photographs"), "z");
  EXPECT_EQ(resolve_up_axis("z", "a.glb"), "z");
  EXPECT_EQ(resolve_up_axis("y", "a.obj"), "y");
  EXPECT_EQ(refusal<InputError>([] { resolve_up_axis("x", "a.obj"); }),
            "up = \"x\"; must be \"y\", \"z\" or \"auto\"");
}

TEST(UpAxis, TurningThereAndBackChangesNoBit) {
  const Vec3 point(0.1, -0.2, 0.3);
  EXPECT_EQ(z_up_to_y_up(y_up_to_z_up(point)), point);
  EXPECT_EQ(y_up_to_z_up(Vec3::UnitY()), Vec3::UnitZ());
}

}  // namespace
}  // namespace clast
