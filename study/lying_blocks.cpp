#include "study/lying_blocks.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include "core/axial_statistics.hpp"
#include "dem/terrain_surface.hpp"
#include "shapes/oriented_box.hpp"
#include "study/realisation_deposits.hpp"

namespace clast {
namespace {

using Rows = std::vector<std::size_t>;

/// Shapes of a file with the directions of their L, body frame, each found once.
class LongAxes {
 public:
  explicit LongAxes(const CampaignResults& results) : results_(results) {}

  const Vec3& of(const BlockSummary& block) {
    const auto [at, is_new] = axes_.emplace(block.shape, Vec3::Zero());
    if (is_new) at->second = smallest_box(results_.shapes[block.shape]).axes.col(0);
    return at->second;
  }

 private:
  const CampaignResults& results_;
  std::map<std::uint32_t, Vec3> axes_;
};

/// Skins where they lie, to look up what is above a place.
class Pile {
 public:
  Pile(const CampaignResults& results, const Comparison& comparison, const Rows& lying) {
    for (const std::size_t row : lying) {
      const RunRow& run = comparison.rows[row];
      const SpheroPolyhedron shape = scaled(results.shapes[run.block->shape], run.block->scale);
      const RigidState& state = run.record->result.final_state;
      Block block{transformed(skin_mesh(shape), state.world_from_body()), {}};
      for (const Vec3& vertex : block.skin.vertices) block.box.include(vertex);
      widest_ = std::max(widest_, block.box.high.x() - block.box.low.x());
      blocks_.push_back(std::move(block));
    }
    std::stable_sort(blocks_.begin(), blocks_.end(),
                     [](const Block& a, const Block& b) { return a.box.low.x() < b.box.low.x(); });
  }

  std::optional<double> top(const Vec2& place) const {
    std::optional<double> highest;
    const auto first = std::partition_point(
        blocks_.begin(), blocks_.end(),
        [&](const Block& block) { return block.box.low.x() < place.x() - widest_; });
    for (auto block = first; block != blocks_.end() && block->box.low.x() <= place.x(); ++block) {
      const Vec2 low = block->box.low.head<2>(), high = block->box.high.head<2>();
      if ((place.array() < low.array()).any() || (place.array() > high.array()).any()) continue;
      const std::optional<double> top = top_over(block->skin, place);
      if (top && !(highest && *highest >= *top)) highest = top;
    }
    return highest;
  }

 private:
  struct Block {
    TriangleMesh skin;
    Bounds box;
  };
  std::vector<Block> blocks_;  ///< by their least x
  double widest_ = 0.0;        ///< along x
};

/// Centre of mass of the starts, or of where blocks lie, on the map.
Vec3 centre_of(const Comparison& comparison, const Rows& lying, Vec3 RunRow::*place) {
  // Summed from the first place: map coordinates of 5e6 m would cost digits.
  const Vec3 origin = comparison.rows[lying.front()].*place;
  Vec3 sum = Vec3::Zero();
  double mass = 0.0;
  for (const std::size_t row : lying) {
    const RunRow& run = comparison.rows[row];
    sum += run.block->mass * (run.*place - origin);
    mass += run.block->mass;
  }
  return origin + sum / mass;
}

void find_heights(const Comparison& comparison, const TerrainSurface& ground, const Rows& lying,
                  std::vector<LyingBlock>& blocks) {
  const CampaignResults& results = comparison.results[blocks.front().file];
  const Pile pile(results, comparison, lying);
  for (LyingBlock& block : blocks) {
    const Vec3& centre = comparison.rows[block.row].record->result.final_state.position;
    const std::optional<double> below = ground.height(centre.x(), centre.y(), centre.z());
    if (!below) continue;
    block.height = centre.z() - *below;
    const std::optional<double> top = pile.top(centre.head<2>());
    if (top && *top > *below) block.relative_height = block.height / (*top - *below);
  }
}

/// The blocks of one realisation, without heights.
std::vector<LyingBlock> placed(const Comparison& comparison, const Rows& all, const Rows& lying,
                               LongAxes& axes) {
  const Vec2 down = comparison.downslope, right(down.y(), -down.x());
  Vec3 crest = comparison.rows[all.front()].start;
  for (const std::size_t row : all) {
    if (comparison.rows[row].start.z() > crest.z()) crest = comparison.rows[row].start;
  }
  const Vec3 starts = centre_of(comparison, lying, &RunRow::start);
  const Vec3 centre = centre_of(comparison, lying, &RunRow::stop);
  std::vector<LyingBlock> blocks;
  for (const std::size_t row : lying) {
    const RunRow& run = comparison.rows[row];
    LyingBlock block;
    block.row = row;
    block.file = run.file;
    block.realisation = cluster_of(comparison.results[run.file], *run.record);
    block.along = down.dot((run.stop - crest).head<2>());
    block.ahead = down.dot((run.stop - centre).head<2>());
    block.aside = right.dot((run.stop - starts).head<2>());
    const Vec3 axis = run.record->result.final_state.orientation * axes.of(*run.block);
    block.long_axis = {down.dot(axis.head<2>()), right.dot(axis.head<2>()), axis.z()};
    block.trend = axial_angle(std::atan2(block.long_axis.y(), block.long_axis.x()));
    block.plunge = std::asin(std::min(1.0, std::abs(axis.z())));
    blocks.push_back(block);
  }
  return blocks;
}

}  // namespace

std::optional<double> top_over(const TriangleMesh& skin, const Vec2& place) {
  const auto cross = [](const Vec2& u, const Vec2& v) { return u.x() * v.y() - u.y() * v.x(); };
  std::optional<double> highest;
  for (const TriangleMesh::Triangle& triangle : skin.triangles) {
    const Vec3 &a = skin.vertices[triangle[0]], &b = skin.vertices[triangle[1]],
               &c = skin.vertices[triangle[2]];
    const Vec2 pa = a.head<2>() - place, pb = b.head<2>() - place, pc = c.head<2>() - place;
    const double of_a = cross(pb, pc), of_b = cross(pc, pa), of_c = cross(pa, pb);
    if (of_a < 0.0 || of_b < 0.0 || of_c < 0.0) continue;  // beside it, or it faces down
    const double twice_area = of_a + of_b + of_c;
    if (!(twice_area > 0.0)) continue;  // on edge
    const double height = (of_a * a.z() + of_b * b.z() + of_c * c.z()) / twice_area;
    if (!(highest && *highest >= height)) highest = height;
  }
  return highest;
}

std::vector<std::size_t> nearest_others(const std::vector<Vec3>& places) {
  std::vector<std::size_t> order(places.size()), nearest(places.size(), 0);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t i, std::size_t k) { return places[i].x() < places[k].x(); });
  for (std::size_t at = 0; at < order.size(); ++at) {
    const std::size_t i = order[at];
    double least = INFINITY;
    const auto look = [&](std::size_t k) {
      const double distance = (places[k] - places[i]).norm();
      if (distance < least || (distance == least && k < nearest[i])) {
        least = distance;
        nearest[i] = k;
      }
    };
    // Outwards along x, as far as the nearest one found.
    const auto in_reach = [&](std::size_t k) {
      return std::abs(places[k].x() - places[i].x()) <= least;
    };
    for (std::size_t k = at; k-- > 0 && in_reach(order[k]);) look(order[k]);
    for (std::size_t k = at + 1; k < order.size() && in_reach(order[k]); ++k) look(order[k]);
  }
  return nearest;
}

std::vector<LyingBlock> lying_blocks(const Comparison& comparison) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, Rows> rows;
  for (std::size_t i = 0; i < comparison.rows.size(); ++i) {
    const RunRow& row = comparison.rows[i];
    const CampaignResults& results = comparison.results[row.file];
    if (results.stay) rows[{row.file, cluster_of(results, *row.record)}].push_back(i);
  }
  std::vector<LyingBlock> all;
  std::optional<TerrainSurface> ground;
  std::optional<LongAxes> axes;
  std::optional<std::uint32_t> file;
  for (const auto& [key, of_realisation] : rows) {
    if (file != key.first) {
      file = key.first;
      ground.emplace(terrain_surface(comparison.results[*file].terrain));
      axes.emplace(comparison.results[*file]);
    }
    Rows lying;
    for (const std::size_t row : of_realisation) {
      if (lies_there(comparison, comparison.rows[row])) lying.push_back(row);
    }
    if (lying.empty()) continue;
    std::vector<LyingBlock> blocks = placed(comparison, of_realisation, lying, *axes);
    find_heights(comparison, *ground, lying, blocks);
    all.insert(all.end(), blocks.begin(), blocks.end());
  }
  return all;
}

}  // namespace clast
