#include "reconstruct/underside/detail/bottom_closure.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace clast::reconstruct_detail {

namespace {

constexpr int kPowerSteps = 40;  ///< halvings of a range of powers

}  // namespace

double BottomClosure::lowering_at_vertex(std::size_t vertex,
                                         const ClosureDisplacement& move) const {
  return move.depth * std::pow(patch_.deflection[vertex], move.power);
}

TriangleMesh BottomClosure::lowered_mesh(const ClosureDisplacement& move) const {
  TriangleMesh mesh = closed_;
  if (move.depth <= 0.0) return mesh;
  for (std::size_t i = 0; i < patch_.deflection.size(); ++i) {
    mesh.vertices[first_vertex_ + i] += lowering_at_vertex(i, move) * down_;
  }
  return mesh;
}

ClosureDisplacement BottomClosure::displacement_for_volume(double added, double power,
                                                           double deepest) const {
  while (added / volume_per_depth(power) > deepest && power > kMinPower) power *= 0.8;
  return {power, added / volume_per_depth(power)};
}

ClosureDisplacement BottomClosure::displacement_touching_ground(const Plane& ground,
                                                                const ClosureDisplacement& blunt,
                                                                double added,
                                                                double max_power) const {
  if (touches(ground, blunt)) return blunt;
  const auto of_power = [&](double power) {
    return ClosureDisplacement{power, added / volume_per_depth(power)};
  };
  double low = blunt.power, high = max_power;
  for (int i = 0; i < kPowerSteps; ++i) {
    const double power = 0.5 * (low + high);
    (touches(ground, of_power(power)) ? high : low) = power;
  }
  return of_power(high);
}

bool BottomClosure::touches(const Plane& ground, const ClosureDisplacement& move) const {
  for (std::size_t i = 0; i < patch_.deflection.size(); ++i) {
    if (ground.signed_distance(closed_.vertices[first_vertex_ + i]) <= lowering_at_vertex(i, move))
      return true;
  }
  return false;
}

double BottomClosure::volume_per_depth(double power) const {
  double volume = 0.0;
  for (const TriangleMesh::Triangle& t : patch_.triangles) {
    double mean = 0.0;
    for (const std::uint32_t v : t) {
      if (v >= first_vertex_) mean += std::pow(patch_.deflection[v - first_vertex_], power) / 3.0;
    }
    const auto& [a, b, c] = t;
    const std::vector<Vec3>& at = closed_.vertices;
    volume += mean * 0.5 * (at[b] - at[a]).cross(at[c] - at[a]).dot(down_);
  }
  return volume;
}

}  // namespace clast::reconstruct_detail
