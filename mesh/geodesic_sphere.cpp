#include "mesh/geodesic_sphere.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace clast {

TriangleMesh geodesic_sphere(int frequency) {
  const double g = (1.0 + std::sqrt(5.0)) / 2.0;
  const std::array<Vec3, 12> corners = {Vec3(-1, g, 0),  Vec3(1, g, 0),   Vec3(-1, -g, 0),
                                        Vec3(1, -g, 0),  Vec3(0, -1, g),  Vec3(0, 1, g),
                                        Vec3(0, -1, -g), Vec3(0, 1, -g),  Vec3(g, 0, -1),
                                        Vec3(g, 0, 1),   Vec3(-g, 0, -1), Vec3(-g, 0, 1)};
  constexpr int kFaces[20][3] = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                 {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                 {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                 {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  TriangleMesh sphere;
  // A grid point is named by the corners it lies between and its whole-number weights on them.
  std::map<std::vector<std::pair<int, int>>, std::uint32_t> known;
  const auto vertex = [&](const int(&face)[3], int a, int b, int c) {
    std::vector<std::pair<int, int>> name;
    Vec3 point = Vec3::Zero();
    const int weights[3] = {a, b, c};
    for (int k = 0; k < 3; ++k) {
      if (weights[k] > 0) name.emplace_back(face[k], weights[k]);
    }
    std::sort(name.begin(), name.end());
    for (const auto& [corner, weight] : name) point += weight * corners[corner];
    const auto [entry, is_new] =
        known.emplace(name, static_cast<std::uint32_t>(sphere.vertices.size()));
    if (is_new) sphere.vertices.push_back(point.normalized());
    return entry->second;
  };
  for (const auto& face : kFaces) {
    for (int i = 0; i < frequency; ++i) {
      for (int j = 0; i + j < frequency; ++j) {
        const int k = frequency - i - j;
        sphere.triangles.push_back(
            {vertex(face, k, i, j), vertex(face, k - 1, i + 1, j), vertex(face, k - 1, i, j + 1)});
        if (k < 2) continue;
        sphere.triangles.push_back({vertex(face, k - 1, i + 1, j),
                                    vertex(face, k - 2, i + 1, j + 1),
                                    vertex(face, k - 1, i, j + 1)});
      }
    }
  }
  return sphere;
}

}  // namespace clast
