#include "particles/detail/distance_field.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace clast::particles_detail {

DistanceField::DistanceField(const BodySurface& surface, const Bounds& box, double spacing)
    : surface_(surface), origin_(box.low), spacing_(spacing) {
  std::size_t count = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const auto k = static_cast<std::size_t>(axis);
    const double cells = std::ceil((box.high[axis] - box.low[axis]) / spacing);
    size_[k] = static_cast<std::size_t>(std::max(cells, 1.0)) + 1;
    bricks_[k] = (size_[k] + kBrick - 1) / kBrick;
    count *= bricks_[k];
  }
  values_.assign(count * kBrick * kBrick * kBrick, std::numeric_limits<float>::quiet_NaN());
  hints_.assign(count, 0);
}

double DistanceField::node(std::size_t x, std::size_t y, std::size_t z) {
  const std::size_t brick = ((z / kBrick) * bricks_[1] + y / kBrick) * bricks_[0] + x / kBrick;
  const std::size_t within = ((z % kBrick) * kBrick + y % kBrick) * kBrick + x % kBrick;
  float& value = values_[brick * kBrick * kBrick * kBrick + within];
  if (std::isnan(value)) {
    const Vec3 point = origin_ + spacing_ * Vec3(static_cast<double>(x), static_cast<double>(y),
                                                 static_cast<double>(z));
    const BodySurface::Closest found = surface_.closest(point, hints_[brick]);
    hints_[brick] = found.triangle;
    value = static_cast<float>(found.distance);
  }
  return value;
}

DistanceField::Value DistanceField::at(const Vec3& point) {
  std::array<std::size_t, 3> cell;
  Vec3 f;
  for (int axis = 0; axis < 3; ++axis) {
    const auto k = static_cast<std::size_t>(axis);
    const double last = static_cast<double>(size_[k] - 1);
    const double place = std::clamp((point[axis] - origin_[axis]) / spacing_, 0.0, last);
    cell[k] = std::min(static_cast<std::size_t>(place), size_[k] - 2);
    f[axis] = place - static_cast<double>(cell[k]);
  }
  double v[2][2][2];
  for (std::size_t x : {0u, 1u}) {
    for (std::size_t y : {0u, 1u}) {
      for (std::size_t z : {0u, 1u}) v[x][y][z] = node(cell[0] + x, cell[1] + y, cell[2] + z);
    }
  }
  const auto mix = [](double a, double b, double t) { return a + (b - a) * t; };
  const double y0z0 = mix(v[0][0][0], v[1][0][0], f.x()), y1z0 = mix(v[0][1][0], v[1][1][0], f.x());
  const double y0z1 = mix(v[0][0][1], v[1][0][1], f.x()), y1z1 = mix(v[0][1][1], v[1][1][1], f.x());
  const double z0 = mix(y0z0, y1z0, f.y()), z1 = mix(y0z1, y1z1, f.y());
  Value result;
  result.distance = mix(z0, z1, f.z());
  const double dx_z0 = mix(v[1][0][0] - v[0][0][0], v[1][1][0] - v[0][1][0], f.y());
  const double dx_z1 = mix(v[1][0][1] - v[0][0][1], v[1][1][1] - v[0][1][1], f.y());
  result.gradient =
      Vec3(mix(dx_z0, dx_z1, f.z()), mix(y1z0 - y0z0, y1z1 - y0z1, f.z()), z1 - z0) / spacing_;
  return result;
}

}  // namespace clast::particles_detail
