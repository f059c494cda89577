#pragma once
/// Two made-up cameras that every format of a project is written for, and the check of its pixels.
#include <gtest/gtest.h>

#include <functional>

#include "core/files/text_file.hpp"
#include "core/number_text.hpp"
#include "core/random.hpp"
#include "reconstruct/photos/model_files.hpp"

namespace clast {

inline constexpr double kModelBar = 1e-6;  // px; the bar of the project is 0.1

/// Two cameras that look at the origin, as rotations and centres.
struct TwoViews {
  Mat3 rotation[2];  ///< camera from world
  Vec3 centre[2];

  TwoViews() {
    for (int i = 0; i < 2; ++i) {
      centre[i] = i == 0 ? Vec3(2.1, 0.4, 0.9) : Vec3(1.4, 1.7, 1.1);
      const Vec3 forward = -centre[i].normalized();
      const Vec3 right = forward.cross(Vec3::UnitZ()).normalized();
      rotation[i] << right.transpose(), forward.cross(right).transpose(), forward.transpose();
    }
  }
  Vec3 in_camera(int i, const Vec3& p) const { return rotation[i] * (p - centre[i]); }
};

inline std::string text(double value) { return format_significant(value, 17); }

/// Expects pixels, given with the first pixel's centre at (half, half), of both photos.
inline void expect_pixels(const PhotoModel& model, double half,
                          const std::function<Vec2(int, const Vec3&)>& expected) {
  ASSERT_EQ(model.photos.size(), 2u);
  Random random(21);
  for (int n = 0; n < 50; ++n) {
    const Vec3 p(random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3));
    for (int i = 0; i < 2; ++i) {
      const std::optional<Vec2> seen = project_into_photo(model, static_cast<std::size_t>(i), p);
      ASSERT_TRUE(seen.has_value());
      EXPECT_NEAR((*seen + Vec2(half, half) - expected(i, p)).norm(), 0.0, kModelBar);
    }
  }
}

}  // namespace clast
