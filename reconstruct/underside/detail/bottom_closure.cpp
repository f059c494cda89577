#include "reconstruct/underside/detail/bottom_closure.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace clast::reconstruct_detail {

namespace {

constexpr int kPowerSteps = 40;  ///< halvings of a range of powers

}  // namespace

double BottomClosure::fall(std::size_t vertex, const Move& move) const {
  return move.depth * std::pow(patch_.bulge[vertex], move.power);
}

TriangleMesh BottomClosure::lowered(const Move& move) const {
  TriangleMesh mesh = closed_;
  if (move.depth <= 0.0) return mesh;
  for (std::size_t i = 0; i < patch_.bulge.size(); ++i) {
    mesh.vertices[first_vertex_ + i] += fall(i, move) * down_;
  }
  return mesh;
}

Move BottomClosure::holding(double added, double power, double deepest) const {
  while (added / column(power) > deepest && power > kBluntest) power *= 0.8;
  return {power, added / column(power)};
}

Move BottomClosure::lying(const Plane& ground, const Move& blunt, double added, double most) const {
  if (touches(ground, blunt)) return blunt;
  const auto of_power = [&](double power) { return Move{power, added / column(power)}; };
  double low = blunt.power, high = most;
  for (int i = 0; i < kPowerSteps; ++i) {
    const double power = 0.5 * (low + high);
    (touches(ground, of_power(power)) ? high : low) = power;
  }
  return of_power(high);
}

bool BottomClosure::touches(const Plane& ground, const Move& move) const {
  for (std::size_t i = 0; i < patch_.bulge.size(); ++i) {
    if (ground.height(closed_.vertices[first_vertex_ + i]) <= fall(i, move)) return true;
  }
  return false;
}

double BottomClosure::column(double power) const {
  double volume = 0.0;
  for (const TriangleMesh::Triangle& t : patch_.triangles) {
    double mean = 0.0;
    for (const std::uint32_t v : t) {
      if (v >= first_vertex_) mean += std::pow(patch_.bulge[v - first_vertex_], power) / 3.0;
    }
    const auto& [a, b, c] = t;
    const std::vector<Vec3>& at = closed_.vertices;
    volume += mean * 0.5 * (at[b] - at[a]).cross(at[c] - at[a]).dot(down_);
  }
  return volume;
}

}  // namespace clast::reconstruct_detail
