#pragma once
/// Surfaces of what is not one whole rock: shells, bodies that touch, blocks with their ground,
/// rings.
#include <algorithm>
#include <cmath>

#include "core/random.hpp"
#include "mesh/sub_mesh.hpp"
#include "tests/support/rock_mesh.hpp"

namespace clast {

/// A ball, open below `cut`, with a second surface `thickness` inside it.
inline TriangleMesh cup(double cut, double thickness) {
  // The directions are folded at the rim: those below run back up inside.
  TriangleMesh mesh = geodesic_sphere(40);
  for (Vec3& vertex : mesh.vertices) {
    const double polar = std::acos(std::clamp(vertex.z(), -1.0, 1.0));
    const double rim = std::acos(cut), fold = 0.5 * kPi;
    const double share = polar <= fold ? polar / fold : (kPi - polar) / (kPi - fold);
    const double angle = share * rim, radius = polar <= fold ? 1.0 : 1.0 - thickness;
    const double around = std::atan2(vertex.y(), vertex.x());
    vertex = radius * Vec3(std::sin(angle) * std::cos(around), std::sin(angle) * std::sin(around),
                           std::cos(angle));
  }
  return mesh;
}

/// Two balls along x whose surface is that of their union, joined by a neck where they do not
/// touch.
inline TriangleMesh two_balls(double second, double distance, double neck) {
  constexpr int kAlong = 160, kRound = 64;
  const auto outline = [&](double x) {
    const double one = 1.0 - x * x, other = second * second - (x - distance) * (x - distance);
    double squared = std::max(one, other);
    if (x > 0.0 && x < distance) squared = std::max(squared, neck * neck);
    return std::sqrt(std::max(0.0, squared));
  };
  TriangleMesh mesh;
  const double first = -1.0, last = distance + second;
  mesh.vertices.emplace_back(first, 0.0, 0.0);
  for (int i = 1; i < kAlong; ++i) {
    const double x = first + (last - first) * 0.5 * (1.0 - std::cos(kPi * i / kAlong));
    for (int j = 0; j < kRound; ++j) {
      const double angle = 2.0 * kPi * j / kRound;
      mesh.vertices.emplace_back(x, outline(x) * std::cos(angle), outline(x) * std::sin(angle));
    }
  }
  mesh.vertices.emplace_back(last, 0.0, 0.0);
  const auto at = [&](int i, int j) {
    return static_cast<std::uint32_t>(1 + (i - 1) * kRound + (j % kRound));
  };
  const auto end = static_cast<std::uint32_t>(mesh.vertices.size() - 1);
  for (int j = 0; j < kRound; ++j) {
    mesh.triangles.push_back({0, at(1, j + 1), at(1, j)});
    for (int i = 1; i + 1 < kAlong; ++i) {
      mesh.triangles.push_back({at(i, j), at(i, j + 1), at(i + 1, j)});
      mesh.triangles.push_back({at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)});
    }
    mesh.triangles.push_back({at(kAlong - 1, j), at(kAlong - 1, j + 1), end});
  }
  return mesh;
}

/// A square of rough ground with a rock on it, closed by a flat bottom.
inline TriangleMesh slab(double side, double depth, double rock, double rough, std::uint64_t seed) {
  constexpr int kCells = 48;
  Random random(seed);
  TriangleMesh mesh;
  const auto index = [](int i, int j) { return static_cast<std::uint32_t>(i * (kCells + 1) + j); };
  for (int layer = 0; layer < 2; ++layer) {
    for (int i = 0; i <= kCells; ++i) {
      for (int j = 0; j <= kCells; ++j) {
        const double x = side * (i / static_cast<double>(kCells) - 0.5),
                     y = side * (j / static_cast<double>(kCells) - 0.5);
        const double dome = rock * rock - x * x - y * y;
        const double top = depth + rough * random.normal() + (dome > 0.0 ? std::sqrt(dome) : 0.0);
        mesh.vertices.emplace_back(x, y, layer == 0 ? top : 0.0);
      }
    }
  }
  const std::uint32_t below = (kCells + 1) * (kCells + 1);
  const auto quad = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a, c, d});
  };
  for (int i = 0; i < kCells; ++i) {
    for (int j = 0; j < kCells; ++j) {
      quad(index(i, j), index(i + 1, j), index(i + 1, j + 1), index(i, j + 1));
      quad(below + index(i, j + 1), below + index(i + 1, j + 1), below + index(i + 1, j),
           below + index(i, j));
    }
    quad(index(i + 1, 0), index(i, 0), below + index(i, 0), below + index(i + 1, 0));
    quad(index(i, kCells), index(i + 1, kCells), below + index(i + 1, kCells),
         below + index(i, kCells));
    quad(index(0, i), index(0, i + 1), below + index(0, i + 1), below + index(0, i));
    quad(index(kCells, i + 1), index(kCells, i), below + index(kCells, i),
         below + index(kCells, i + 1));
  }
  return mesh;
}

/// A torus about z without the part of its surface within `unseen` degrees of facing the axis.
inline TriangleMesh torus_without_inner_wall(double ring, double thick, double unseen) {
  constexpr std::uint32_t kAround = 96, kAcross = 48;
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i < kAround; ++i) {
    for (std::uint32_t j = 0; j < kAcross; ++j) {
      const double a = 2.0 * kPi * i / kAround, b = 2.0 * kPi * j / kAcross;
      const double radius = ring + thick * std::cos(b);
      mesh.vertices.emplace_back(radius * std::cos(a), radius * std::sin(a), thick * std::sin(b));
    }
  }
  std::vector<bool> keep;
  for (std::uint32_t i = 0; i < kAround; ++i) {
    for (std::uint32_t j = 0; j < kAcross; ++j) {
      const std::uint32_t a = i * kAcross + j, b = (i + 1) % kAround * kAcross + j,
                          c = (i + 1) % kAround * kAcross + (j + 1) % kAcross,
                          d = i * kAcross + (j + 1) % kAcross;
      mesh.triangles.push_back({a, b, c});
      mesh.triangles.push_back({a, c, d});
      const bool seen = std::abs((j + 0.5) / kAcross * 360.0 - 180.0) >= unseen;
      keep.insert(keep.end(), 2, seen);
    }
  }
  return extract_triangles(mesh, keep);
}

}  // namespace clast
