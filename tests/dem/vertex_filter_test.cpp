// The vertex filter against distances from the whole ground, and with every instruction set.
#include "dem/search/vertex_filter.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <numeric>

#include "core/random.hpp"
#include "dem/surface/terrain_impl.hpp"
#include "tests/support/ground_gap.hpp"
#include "tests/support/test_rock.hpp"

namespace clast {

using namespace dem_detail;

namespace {

/// Rock in a random attitude, about 2 cm deep in a rough slope, with the faces around it.
struct Scene {
  explicit Scene(std::uint64_t seed, double roughness = 0.10)
      : terrain(ground(rough_slope(24, 0.5, 0.5, roughness, seed))),
        block(rock(3, {0.42, 0.36, 0.30}, 0.02, 2700.0, seed).shape) {
    Random random(seed);
    position = {random.uniform(-2.0, 2.0), random.uniform(-2.0, 2.0), 0.0};
    rotation = random.rotation().toRotationMatrix();
    position.z() = *terrain.height_at(position.x(), position.y(), 0.0) + 1.0;
    for (int lowering = 0; lowering < 4; ++lowering) {
      measure_distances();
      position.z() -= *std::min_element(distances.begin(), distances.end()) + 0.02;
    }
    measure_distances();
    for (const double distance : distances) max_depth = std::max(max_depth, -distance);
    for (std::uint32_t f = 0; f < surface().features.faces.size(); ++f) {
      prisms.push_back(make_face_prism(surface().features, f));
    }
    const double touching = block.bounding_radius + max_depth;
    for (std::uint32_t f = 0; f < prisms.size(); ++f) {
      const NearestPoint nearest = nearest_point_on_face(surface().features, f, position);
      if (std::abs(nearest.distance) <= touching) close_faces.push_back(f);
    }
  }
  const IndexedSurface& surface() const { return terrain.impl().surface; }
  void measure_distances() {
    distances.clear();
    for (const std::uint32_t v : block.parts.vertices) {
      const Vec3 vertex = position + rotation * block.features.vertices[v];
      distances.push_back(surface().nearest_point(vertex, 100.0).value().distance);
    }
  }
  std::vector<FilteredVertices> filter(InstructionSet instructions) const {
    std::vector<FilteredVertices> result(block.parts.vertex_groups.size());
    std::vector<std::uint32_t> all_groups(result.size());
    std::iota(all_groups.begin(), all_groups.end(), 0u);
    filter_vertices({.rotation = rotation.data(),
                     .position = position.data(),
                     .reach = reach,
                     .max_depth = max_depth},
                    block.parts.vertex_groups.data(), all_groups.data(), result.size(),
                    prisms.data(), close_faces.data(), close_faces.size(), result.data(),
                    instructions);
    return result;
  }
  /// Clearances of vertices from all faces.
  std::vector<PrismClearance> measure(const std::vector<FilteredVertices>& vertices,
                                      InstructionSet instructions) const {
    std::vector<PrismClearance> result;
    for (std::uint32_t f = 0; f < prisms.size(); ++f) {
      result.push_back(
          {.face = f, .displacement_per_height = is_at_border(surface().features, f) ? 0.0 : 1.5});
    }
    measure_prism_clearances(prisms.data(), reach, vertices.data(), vertices.size(), result.data(),
                             result.size(), instructions);
    return result;
  }

  TerrainSurface terrain;
  BlockSurface block;
  Vec3 position;
  Mat3 rotation;
  double reach = 0.02, max_depth = 0.0;
  std::vector<FacePrism> prisms;
  std::vector<std::uint32_t> close_faces;
  std::vector<double> distances;  ///< signed, of the vertices in the order of `BlockParts`, m
};

TEST(VertexFilter, GivesTheSameBitsWithEveryInstructionSet) {
  if (widest_instruction_set() == InstructionSet::kPortable) {
    GTEST_SKIP() << "the processor has one set only";
  }
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const Scene scene(seed);
    const auto portable = scene.filter(InstructionSet::kPortable);
    const auto wide = scene.filter(widest_instruction_set());
    EXPECT_EQ(std::memcmp(portable.data(), wide.data(), portable.size() * sizeof(FilteredVertices)),
              0)
        << seed;
    const auto one = scene.measure(wide, InstructionSet::kPortable);
    const auto other = scene.measure(wide, widest_instruction_set());
    for (std::size_t f = 0; f < one.size(); ++f) {
      EXPECT_EQ(one[f].over_plane, other[f].over_plane) << seed;
      EXPECT_EQ(one[f].from_face, other[f].from_face) << seed;
    }
  }
}

TEST(VertexFilter, AgreesWithTheDistanceFromTheWholeGround) {
  std::array<std::size_t, 3> counts{};
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const Scene scene(seed, seed % 2 == 0 ? 0.10 : 0.4);
    const SurfaceFeatures& features = scene.surface().features;
    const auto groups = scene.filter(widest_instruction_set());
    for (const BlockPart& part : scene.block.parts.parts) {
      for (std::uint32_t v = part.first_vertex; v < part.end_vertex; ++v) {
        const std::uint32_t i = v - part.first_vertex;
        const FilteredVertices& group = groups[part.first_group + i / 4];
        const Vec3 vertex(group.placed.x[i % 4], group.placed.y[i % 4], group.placed.z[i % 4]);
        const Vec3& in_body = scene.block.features.vertices[scene.block.parts.vertices[v]];
        EXPECT_LT((vertex - (scene.position + scene.rotation * in_body)).norm(), 1e-14);
        const std::int64_t result = group.result[i % 4];
        ++counts.at(static_cast<std::size_t>(result));
        if (result == FilteredVertices::kClear) {
          EXPECT_GE(scene.distances[v], scene.reach) << seed;
        } else if (result == FilteredVertices::kOneFace) {
          const auto face = static_cast<std::uint32_t>(group.face[i % 4]);
          const NearestPoint own = nearest_point_on_face(features, face, vertex);
          EXPECT_TRUE(own.within_face) << seed;
          EXPECT_NEAR(own.distance, scene.distances[v], 1e-12) << seed;
          EXPECT_LT(own.distance, scene.reach) << seed;
          for (std::uint32_t other = 0; own.distance >= 0.0 && other < features.faces.size();
               ++other) {
            if (other == face) continue;
            EXPECT_GE(std::abs(nearest_point_on_face(features, other, vertex).distance),
                      scene.reach)
                << seed;
          }
        }
      }
    }
  }
  // Few vertices need an exact test.
  EXPECT_GT(counts[FilteredVertices::kClear], 1000u);
  EXPECT_GT(counts[FilteredVertices::kOneFace], 80u);
  EXPECT_LT(counts[FilteredVertices::kUnknown], counts[FilteredVertices::kOneFace] / 2);
}

// Without a bound of the depth, sides are decided by the faces alone.
TEST(VertexFilter, ClearsNoVertexInsideTheGroundWhoseDepthIsUnknown) {
  std::size_t inside = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Scene scene(seed, 0.4);
    scene.max_depth = 1e100;
    const auto groups = scene.filter(widest_instruction_set());
    for (const BlockPart& part : scene.block.parts.parts) {
      for (std::uint32_t v = part.first_vertex; v < part.end_vertex; ++v) {
        const std::uint32_t i = v - part.first_vertex;
        if (scene.distances[v] >= scene.reach) continue;
        ++inside;
        EXPECT_NE(groups[part.first_group + i / 4].result[i % 4], FilteredVertices::kClear);
      }
    }
  }
  EXPECT_GT(inside, 80u);
}

TEST(VertexFilter, LeavesVerticesBelowThePlaneOfABorderToExactTests) {
  const TerrainSurface flat = ground(plane_mesh(1.0, 1));
  const SurfaceFeatures& features = flat.impl().surface.features;
  std::vector<FacePrism> prisms;
  for (std::uint32_t f = 0; f < features.faces.size(); ++f) {
    EXPECT_TRUE(is_at_border(features, f));
    prisms.push_back(make_face_prism(features, f));
  }
  // Beyond the border, over it and under it.
  const VertexGroup group{{1.5, 1.5, 0.0, 0.0}, {0.0, 0.0, 0.1, 0.1}, {0.1, -0.1, 0.1, -0.1}};
  const Mat3 rotation = Mat3::Identity();
  const Vec3 position = Vec3::Zero();
  std::vector<std::uint32_t> faces(prisms.size());
  std::iota(faces.begin(), faces.end(), 0u);
  const std::uint32_t first_group = 0;
  FilteredVertices filtered;
  filter_vertices(
      {.rotation = rotation.data(), .position = position.data(), .reach = 0.0, .max_depth = 0.2},
      &group, &first_group, 1, prisms.data(), faces.data(), faces.size(), &filtered);
  EXPECT_EQ(filtered.result[0], FilteredVertices::kClear);
  EXPECT_EQ(filtered.result[1], FilteredVertices::kUnknown);
  EXPECT_EQ(filtered.result[2], FilteredVertices::kClear);
  EXPECT_EQ(filtered.result[3], FilteredVertices::kUnknown);
}

TEST(PrismClearance, BoundsTheDistanceOfEveryVertex) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Scene scene(seed);
    const SurfaceFeatures& features = scene.surface().features;
    const auto groups = scene.filter(widest_instruction_set());
    const auto clearances = scene.measure(groups, widest_instruction_set());
    for (std::uint32_t f = 0; f < scene.prisms.size(); ++f) {
      const PrismClearance& clearance = clearances[f];
      for (const std::uint32_t v : scene.block.parts.vertices) {
        const Vec3 vertex = scene.position + scene.rotation * scene.block.features.vertices[v];
        const double over = scene.prisms[f].height(vertex) - scene.reach;
        const double from =
            std::abs(nearest_point_on_face(features, f, vertex).distance) - scene.reach;
        EXPECT_TRUE(over >= clearance.over_plane - 1e-12 || from >= clearance.from_face - 1e-12);
      }
      if (is_at_border(features, f)) {
        EXPECT_EQ(clearance.from_face, 1e300);
      }
    }
  }
}

TEST(FacePrism, IsNeverFartherThanTheFace) {
  Random random(8);
  const Scene scene(3);
  const SurfaceFeatures& features = scene.surface().features;
  std::size_t within = 0;
  for (int i = 0; i < 3000; ++i) {
    const auto f = static_cast<std::uint32_t>(random.uniform_index(features.faces.size()));
    const Vec3 point = features.vertices[features.faces[f].vertices[0]] +
                       random.uniform(0.0, 0.6) * random.unit_vector();
    const NearestPoint nearest = nearest_point_on_face(features, f, point);
    const FacePrism& prism = scene.prisms[f];
    EXPECT_LE(std::hypot(prism.height(point), std::max(0.0, prism.distance_beside(point))),
              std::abs(nearest.distance) + 1e-12);
    if (!nearest.within_face) continue;
    ++within;
    EXPECT_NEAR(prism.height(point), nearest.distance, 1e-12);
    EXPECT_LE(prism.distance_beside(point), 1e-12);
  }
  EXPECT_GT(within, 200u);
}

}  // namespace
}  // namespace clast
