#include "samples/quarry.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "core/random.hpp"

namespace clast {
namespace {

constexpr double kCell = 0.5;  // m; every break of both sections lies on a grid line
constexpr double kFirstX = -6.0, kLastX = 80.0;
constexpr double kFirstY = -30.0, kLastY = 110.0;
constexpr double kBlendBegin = 30.0, kBlendEnd = 50.0;  // y between the lanes
constexpr double kZoneSwitch = 40.0;
constexpr double kNoise = 0.10;  // m, standard deviation
constexpr std::uint64_t kNoiseSeed = 2022;
// A Gaussian kernel of deviation s makes noise whose correlation falls to 1/e at 2 s; here 2 m.
constexpr double kKernelCells = 1.0 / kCell;
constexpr int kKernelReach = 8;  // four deviations

constexpr int kNodesX = static_cast<int>((kLastX - kFirstX) / kCell) + 1;
constexpr int kNodesY = static_cast<int>((kLastY - kFirstY) / kCell) + 1;

double section_height(const QuarryLane& lane, double x) {
  std::size_t i = 1;
  while (i + 1 < lane.section.size() && lane.section[i].x() < x) ++i;
  const Vec2 &a = lane.section[i - 1], &b = lane.section[i];
  return a.y() + (b.y() - a.y()) * (x - a.x()) / (b.x() - a.x());
}

/// Noise per node, row by row along y. It is smooth over four cells and the same on both sides of a
/// break, so it moves a break line up and down with the slopes but never blurs it: the cliff edge
/// stays one grid line with the full change of slope across it.
std::vector<double> correlated_noise() {
  std::array<double, 2 * kKernelReach + 1> kernel{};
  double squares = 0.0;
  for (int k = -kKernelReach; k <= kKernelReach; ++k) {
    const double distance = k / kKernelCells;
    kernel[k + kKernelReach] = std::exp(-distance * distance / 2.0);
    squares += kernel[k + kKernelReach] * kernel[k + kKernelReach];
  }
  for (double& weight : kernel) weight /= std::sqrt(squares);

  const int wide = kNodesX + 2 * kKernelReach, high = kNodesY + 2 * kKernelReach;
  Random random(kNoiseSeed);
  std::vector<double> white(static_cast<std::size_t>(wide) * high);
  for (double& value : white) value = kNoise * random.normal();
  std::vector<double> along_x(static_cast<std::size_t>(kNodesX) * high, 0.0);
  for (int j = 0; j < high; ++j) {
    for (int i = 0; i < kNodesX; ++i) {
      for (std::size_t k = 0; k < kernel.size(); ++k) {
        along_x[j * kNodesX + i] += kernel[k] * white[j * wide + i + k];
      }
    }
  }
  std::vector<double> noise(static_cast<std::size_t>(kNodesX) * kNodesY, 0.0);
  for (int j = 0; j < kNodesY; ++j) {
    for (int i = 0; i < kNodesX; ++i) {
      for (std::size_t k = 0; k < kernel.size(); ++k) {
        noise[j * kNodesX + i] += kernel[k] * along_x[(j + k) * kNodesX + i];
      }
    }
  }
  return noise;
}

TriangleMesh quarry_nodes() {
  const std::vector<double> noise = correlated_noise();
  TriangleMesh mesh;
  for (int j = 0; j < kNodesY; ++j) {
    const double y = kFirstY + kCell * j;
    const double t = std::clamp((y - kBlendBegin) / (kBlendEnd - kBlendBegin), 0.0, 1.0);
    const double share = t * t * (3.0 - 2.0 * t);
    for (int i = 0; i < kNodesX; ++i) {
      const double x = kFirstX + kCell * i;
      const double height = (1.0 - share) * section_height(list_quarry_lanes()[0], x) +
                            share * section_height(list_quarry_lanes()[1], x);
      mesh.vertices.emplace_back(x, y, height + noise[j * kNodesX + i]);
    }
  }
  return mesh;
}

const std::string& zone_at(double x, double y) {
  const QuarryLane& lane = list_quarry_lanes()[y < kZoneSwitch ? 0 : 1];
  for (const auto& [end, name] : lane.zones) {
    if (x < end) return name;
  }
  return lane.zones.back().second;
}

}  // namespace

const std::vector<QuarryLane>& list_quarry_lanes() {
  static const std::vector<QuarryLane> kLanes = {
      {.name = "P1",
       .axis = 0.0,
       .release_height = 211.75,
       .section = {{-6, 213.5},
                   {-4, 211},
                   {0, 205.5},
                   {4, 203},
                   {22, 191.5},
                   {26, 189.5},
                   {28, 188.5},
                   {30, 186},
                   {32, 173},
                   {34, 171.5},
                   {41, 171},
                   {44, 162},
                   {52, 160},
                   {80, 158}},
       .zones = {{27.0, "blue"}, {kLastX, "gray"}}},
      {.name = "P2",
       .axis = 80.0,
       .release_height = 209.5,
       .section = {{-6, 210},
                   {-4, 208},
                   {0, 204.5},
                   {16, 193},
                   {21, 191},
                   {22, 190},
                   {26, 184},
                   {36, 176},
                   {39, 174.5},
                   {50, 172},
                   {55, 172.5},
                   {58, 172.5},
                   {60, 171},
                   {70, 165.5},
                   {80, 164}},
       .zones = {{21.0, "blue"}, {25.0, "gray"}, {37.0, "red"}, {55.0, "gray"}, {kLastX, "blue"}}}};
  return kLanes;
}

std::vector<QuarryZone> quarry_zones() {
  const TriangleMesh nodes = quarry_nodes();
  std::vector<QuarryZone> zones = {{"blue", {}}, {"gray", {}}, {"red", {}}};
  std::vector<std::vector<std::uint32_t>> number(
      zones.size(), std::vector<std::uint32_t>(nodes.vertices.size(), 0xffffffffu));
  for (int j = 0; j + 1 < kNodesY; ++j) {
    for (int i = 0; i + 1 < kNodesX; ++i) {
      const std::string& name = zone_at(kFirstX + kCell * (i + 0.5), kFirstY + kCell * (j + 0.5));
      std::size_t z = 0;
      while (zones[z].name != name) ++z;
      const auto corner = [&](int di, int dj) {
        const std::uint32_t node = static_cast<std::uint32_t>((j + dj) * kNodesX + i + di);
        std::uint32_t& vertex = number[z][node];
        if (vertex == 0xffffffffu) {
          vertex = static_cast<std::uint32_t>(zones[z].mesh.vertices.size());
          zones[z].mesh.vertices.push_back(nodes.vertices[node]);
        }
        return vertex;
      };
      const std::uint32_t a = corner(0, 0), b = corner(1, 0), c = corner(1, 1), d = corner(0, 1);
      // Diagonals alternate, so that the mesh has no grain that would steer a block.
      if ((i + j) % 2 == 0) {
        zones[z].mesh.triangles.push_back({a, b, c});
        zones[z].mesh.triangles.push_back({a, c, d});
      } else {
        zones[z].mesh.triangles.push_back({a, b, d});
        zones[z].mesh.triangles.push_back({b, c, d});
      }
    }
  }
  return zones;
}

std::string release_points(const QuarryLane& lane) {
  std::string text = "# release points of lane " + lane.name + ": x y z, m, z up\n";
  for (const auto& [x, side] : {std::pair{2.3, 2.0}, {2.3, -2.0}, {-1.7, -2.0}, {-1.7, 2.0}}) {
    std::array<char, 64> line{};
    std::snprintf(line.data(), line.size(), "%.2f %.2f %.2f\n", x, lane.axis + side,
                  lane.release_height);
    text += line.data();
  }
  return text;
}

}  // namespace clast
