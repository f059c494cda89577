#include "reconstruct/repair/repair.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>

#include "core/error.hpp"
#include "core/types.hpp"
#include "mesh/mesh_topology.hpp"
#include "mesh/self_intersection.hpp"
#include "tests/reconstruct/damage_study.hpp"
#include "tests/shapes/shape_samples.hpp"
#include "tests/support/damage.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/rock_mesh.hpp"

namespace clast {
namespace {

using Triangle = TriangleMesh::Triangle;

const TriangleMesh& rock() {
  static const TriangleMesh mesh = rock_mesh(16, {1.0, 0.8, 0.6}, 5);
  return mesh;
}

TriangleMesh at(TriangleMesh mesh, const Vec3& position) {
  return transformed(std::move(mesh), Pose{position, Quat::Identity()});
}

void expect_sound(const TriangleMesh& mesh) {
  const MeshReport report = inspect_mesh(mesh);
  EXPECT_TRUE(report.is_closed() && report.is_oriented()) << report.summary();
  EXPECT_EQ(report.pinched_vertices, 0u);
  EXPECT_EQ(report.components, 1u);
  EXPECT_GT(enclosed_volume(mesh), 0.0);
  EXPECT_TRUE(find_self_intersections(mesh).empty());
}

std::size_t count(const RepairedMesh& result, DefectKind kind) {
  const Defect* defect = result.report.find_defect(kind);
  return defect == nullptr ? 0 : defect->count;
}

/// Without the triangles whose corners all lie above `height`.
TriangleMesh beheaded(TriangleMesh mesh, double height) {
  std::erase_if(mesh.triangles, [&](const Triangle& t) {
    return mesh.vertices[t[0]].z() > height && mesh.vertices[t[1]].z() > height &&
           mesh.vertices[t[2]].z() > height;
  });
  return mesh;
}

TEST(Repair, AMeshOfNoExtentIsRefused) {
  TriangleMesh beside_a_vertex = scaled(rock(), 1e-39);
  beside_a_vertex.vertices.push_back(Vec3::UnitX());  // of no triangle
  for (const TriangleMesh& mesh : {scaled(rock(), 1e-44), beside_a_vertex}) {
    EXPECT_TRUE(contains(refusal<GeometryError>([&] { repair_mesh(mesh); }),
                         "m across: the file is damaged, or its unit is wrong"));
  }
  EXPECT_NO_THROW(repair_mesh(scaled(rock(), 1e-8)));
}

TEST(Repair, AHoleInAFineMeshJoinsNoVertices) {
  // Edges are 0.0005 of the diagonal: within the widest weld.
  TriangleMesh torn = spindle(4000);
  torn.triangles.pop_back();
  const RepairedMesh result = repair_mesh(torn);
  EXPECT_EQ(result.report.find_defect(DefectKind::kNearVertices), nullptr);
  EXPECT_EQ(result.mesh.vertices.size(), torn.vertices.size());
}

TEST(Repair, ASoundMeshKeepsEveryBitWhereverItLies) {
  for (const Vec3& position : {Vec3(0, 0, 0), Vec3(888600.123, 6671300.456, 1234.5)}) {
    const TriangleMesh mesh = at(rock(), position);
    const RepairedMesh result = repair_mesh(mesh);
    EXPECT_EQ(result.mesh.vertices, mesh.vertices);
    EXPECT_EQ(result.mesh.triangles, mesh.triangles);
    EXPECT_TRUE(result.report.defects.empty());
    EXPECT_EQ(result.report.filled_fraction, 0.0);
    EXPECT_TRUE(describe_repairs(result.report).empty());
  }
}

/// A cap of a sphere goes on as the sphere does: the filling is smooth at the border.
TEST(Repair, AHoleInASphereIsFilledRoundAndMeasured) {
  const TriangleMesh sphere = geodesic_sphere(24);
  const double height = 0.9;
  const RepairedMesh result = repair_mesh(beheaded(sphere, height));
  expect_sound(result.mesh);
  ASSERT_EQ(result.report.holes.size(), 1u);
  const FilledHole& hole = result.report.holes[0];
  const double rim = std::sqrt(1.0 - height * height);
  EXPECT_NEAR(hole.radius, rim, 0.05);
  EXPECT_NEAR(hole.perimeter, 2.0 * kPi * rim, 0.25);  // it runs in zigzags
  EXPECT_NEAR(hole.centre.z(), height, 0.02);
  // A cap's share of the sphere's area is half its height over the radius.
  EXPECT_NEAR(hole.area_fraction, 0.5 * (1.0 - height), 0.01);
  EXPECT_EQ(result.report.filled_fraction, hole.area_fraction);
  EXPECT_NEAR(enclosed_volume(result.mesh) / enclosed_volume(sphere), 1.0, 1e-3);
  for (const Vec3& v : result.mesh.vertices) EXPECT_NEAR(v.norm(), 1.0, 0.01);
}

TEST(Repair, AHoleOfMoreThanATenthIsToldOfByItself) {
  const RepairedMesh small = repair_mesh(beheaded(geodesic_sphere(16), 0.85));
  const RepairedMesh large = repair_mesh(beheaded(geodesic_sphere(16), 0.7));
  const auto notes = [](const RepairedMesh& result) {
    std::string text;
    for (const std::string& note : describe_repairs(result.report)) text += note + "\n";
    return text;
  };
  EXPECT_TRUE(contains(notes(small), "1 hole filled; the largest has "));
  EXPECT_TRUE(contains(notes(small), " % of the surface was filled without data: no scan shows"));
  EXPECT_FALSE(contains(notes(small), "a guess"));
  EXPECT_TRUE(contains(notes(large),
                       " % of the surface; it is an assumption on which volume and axes depend"));
  EXPECT_GT(large.report.holes[0].area_fraction, kLargeHoleFraction);
}

TEST(Repair, AnOpenSheetIsRefusedAsGround) {
  TriangleMesh sheet = box_mesh({2, 2, 1}, 8);
  std::erase_if(sheet.triangles, [&](const Triangle& t) {
    return sheet.vertices[t[0]].z() < 1 || sheet.vertices[t[1]].z() < 1 ||
           sheet.vertices[t[2]].z() < 1;
  });
  Random random(3);
  for (Vec3& v : sheet.vertices) v.z() += 0.1 * random.uniform();
  const std::string message = refusal<GeometryError>([&] { repair_mesh(sheet); });
  EXPECT_TRUE(
      contains(message, "is an open sheet, not a block: 32 open edges in 1 hole: 32 edges"));
  EXPECT_TRUE(contains(message, "clast terrain"));
}

TEST(Repair, FinsAreDroppedAndNothingElse) {
  TriangleMesh dirty = rock();
  Random random(4);
  for (int i = 0; i < 40; ++i) {
    const Triangle t = rock().triangles[random.uniform_index(rock().triangles.size())];
    dirty.vertices.push_back(1.2 * dirty.vertices[t[0]]);
    dirty.triangles.push_back({t[0], t[1], static_cast<std::uint32_t>(dirty.vertices.size() - 1)});
  }
  const RepairedMesh result = repair_mesh(dirty);
  EXPECT_EQ(result.mesh.vertices, rock().vertices);
  EXPECT_EQ(result.mesh.triangles, rock().triangles);
  EXPECT_EQ(count(result, DefectKind::kFin), 40u);
}

// At a border such a fin looks like the surface going on, and the hole would be filled up to it.
TEST(Repair, FinsAtBordersAreDropped) {
  TriangleMesh dirty = beheaded(rock(), 0.55);
  const Triangle inner = dirty.triangles[500];
  std::vector<std::array<std::uint32_t, 2>> edges = {{inner[0], inner[1]}};
  const std::vector<std::vector<std::uint32_t>> borders = boundary_loops(dirty);
  ASSERT_EQ(borders.size(), 1u);
  ASSERT_GT(borders[0].size(), 10u);
  for (const std::size_t i : {0u, 4u, 8u}) edges.push_back({borders[0][i], borders[0][i + 1]});
  for (const auto& [a, b] : edges) {
    dirty.vertices.push_back(1.15 * dirty.vertices[a]);
    dirty.triangles.push_back({a, b, static_cast<std::uint32_t>(dirty.vertices.size() - 1)});
  }
  const RepairedMesh result = repair_mesh(dirty);
  expect_sound(result.mesh);
  EXPECT_EQ(count(result, DefectKind::kFin), edges.size());
  EXPECT_LT(vertex_hausdorff(result.mesh, rock()), 0.02 * bounds(rock()).diagonal());
}

TEST(Repair, ASheetScannedTwiceIsDroppedLooseOrWeldedAtItsRim) {
  for (const bool welded_rim : {false, true}) {
    SCOPED_TRACE(welded_rim);
    TriangleMesh dirty = rock();
    std::vector<std::uint32_t> copy(rock().vertices.size(), 0);
    std::vector<bool> rim(rock().vertices.size(), false);
    const auto high = [&](const Triangle& t) {
      return std::all_of(t.begin(), t.end(),
                         [&](std::uint32_t v) { return rock().vertices[v].z() > 0.55; });
    };
    if (welded_rim) {
      for (const Triangle& t : rock().triangles) {
        if (!high(t))
          for (const std::uint32_t v : t) rim[v] = true;
      }
    }
    std::size_t doubled = 0;
    for (const Triangle& t : rock().triangles) {
      if (!high(t)) continue;
      Triangle again = t;
      for (std::uint32_t& v : again) {
        if (rim[v]) continue;
        if (copy[v] == 0) {
          copy[v] = static_cast<std::uint32_t>(dirty.vertices.size());
          dirty.vertices.push_back(1.01 * rock().vertices[v]);
        }
        v = copy[v];
      }
      dirty.triangles.push_back(again);
      ++doubled;
    }
    ASSERT_GT(doubled, 20u);
    const RepairedMesh result = repair_mesh(dirty);
    expect_sound(result.mesh);
    EXPECT_NEAR(enclosed_volume(result.mesh) / enclosed_volume(rock()), 1.0, 1e-9);
    EXPECT_EQ(count(result, welded_rim ? DefectKind::kFin : DefectKind::kDuplicateSheet),
              welded_rim ? doubled : 1u);
  }
}

TEST(Repair, SpikesArePutBack) {
  TriangleMesh dirty = rock();
  const double diagonal = bounds(rock()).diagonal();
  for (const std::uint32_t v : {100u, 900u, 1700u}) {
    dirty.vertices[v] += 0.15 * diagonal * dirty.vertices[v].normalized();
  }
  const RepairedMesh result = repair_mesh(dirty);
  expect_sound(result.mesh);
  EXPECT_EQ(count(result, DefectKind::kSpike), 3u);
  EXPECT_NEAR(result.report.find_defect(DefectKind::kSpike)->size, 0.15 * diagonal,
              0.01 * diagonal);
  EXPECT_NEAR(enclosed_volume(result.mesh) / enclosed_volume(rock()), 1.0, 1e-3);
  EXPECT_LT(vertex_hausdorff(result.mesh, rock()), 0.01 * diagonal);
}

// On a coarse scan a spike is hardly longer than its edges: left standing, it is a longer block.
TEST(Repair, SpikesOfCoarseScansArePutBack) {
  const TriangleMesh sound = rock_mesh(9, {0.35, 0.30, 0.25}, 3, 0.08);
  TriangleMesh dirty = sound;
  const double diagonal = bounds(sound).diagonal();
  for (const std::uint32_t v : {40u, 200u, 420u, 700u}) {
    dirty.vertices[v] += 0.08 * diagonal * dirty.vertices[v].normalized();
  }
  const RepairedMesh result = repair_mesh(dirty);
  expect_sound(result.mesh);
  EXPECT_EQ(count(result, DefectKind::kSpike), 4u);
  EXPECT_LT(vertex_hausdorff(result.mesh, sound), 0.015 * diagonal);
  EXPECT_EQ(count(repair_mesh(sound), DefectKind::kSpike), 0u);
}

// Neither of them has smooth surroundings, and the filling of a hole would go on to a spike at it.
TEST(Repair, SpikesBesideOneAnotherAndAtHolesArePutBack) {
  const double diagonal = bounds(rock()).diagonal();
  TriangleMesh dirty = beheaded(rock(), 0.55);
  const std::vector<std::vector<std::uint32_t>> borders = boundary_loops(dirty);
  ASSERT_EQ(borders.size(), 1u);
  const Triangle& pair = dirty.triangles[500];
  const std::uint32_t at_hole = borders[0][0];
  for (const std::uint32_t v : {pair[0], pair[1], at_hole}) {
    dirty.vertices[v] += 0.06 * diagonal * dirty.vertices[v].normalized();
  }
  const RepairedMesh result = repair_mesh(dirty);
  expect_sound(result.mesh);
  EXPECT_EQ(count(result, DefectKind::kSpike), 3u);
  EXPECT_LT(vertex_hausdorff(result.mesh, rock()), 0.02 * diagonal);
}

// Hardly as tall as the edges around it are long.
TEST(Repair, LowSpikesArePutBack) {
  TriangleMesh dirty = rock();
  for (const std::uint32_t v : {100u, 900u, 1700u}) {
    const Triangle& t = *std::find_if(rock().triangles.begin(), rock().triangles.end(),
                                      [&](const Triangle& own) { return own[0] == v; });
    const double edge = (rock().vertices[t[1]] - rock().vertices[t[0]]).norm();
    dirty.vertices[v] += 1.2 * edge * dirty.vertices[v].normalized();
  }
  const RepairedMesh result = repair_mesh(dirty);
  EXPECT_EQ(count(result, DefectKind::kSpike), 3u);
  EXPECT_LT(vertex_hausdorff(result.mesh, rock()), 0.01 * bounds(rock()).diagonal());
}

// An obelisk: its tip is five times as high as the edges of its sides are long.
TEST(Repair, SharpTipsAreNoSpikes) {
  constexpr std::uint32_t kRows = 20, kSides = 8;
  TriangleMesh obelisk;
  for (std::uint32_t row = 0; row < kRows; ++row) {
    for (std::uint32_t side = 0; side < kSides; ++side) {
      const double angle = 2.0 * kPi * side / kSides;
      obelisk.vertices.emplace_back(0.13 * std::cos(angle), 0.13 * std::sin(angle), 0.1 * row);
    }
  }
  const std::uint32_t bottom = kRows * kSides, tip = bottom + 1;
  obelisk.vertices.emplace_back(0.0, 0.0, 0.0);
  obelisk.vertices.emplace_back(0.0, 0.0, 0.1 * (kRows - 1) + 0.5);
  for (std::uint32_t side = 0; side < kSides; ++side) {
    const std::uint32_t next = (side + 1) % kSides, top = (kRows - 1) * kSides;
    obelisk.triangles.push_back({next, side, bottom});
    obelisk.triangles.push_back({top + side, top + next, tip});
    for (std::uint32_t row = 0; row + 1 < kRows; ++row) {
      const std::uint32_t low = row * kSides, high = low + kSides;
      obelisk.triangles.push_back({low + side, low + next, high + next});
      obelisk.triangles.push_back({low + side, high + next, high + side});
    }
  }
  EXPECT_EQ(repair_mesh(obelisk).mesh.vertices, obelisk.vertices);
}

TEST(Repair, TheCornersOfCoarseModelsAreNoSpikes) {
  TriangleMesh crystal = tetrahedron();
  for (Vec3& v : crystal.vertices) v.z() *= 8.0;
  EXPECT_EQ(repair_mesh(crystal).mesh.vertices, crystal.vertices);
}

TEST(Repair, SheetsThatTouchAlongAnEdgeArePartedOnTheRocksSide) {
  const TriangleMesh two = merged(box_mesh({1, 1, 1}), at(box_mesh({1, 1, 1}), {1, 1, 0}));
  const std::string message = refusal<GeometryError>([&] { repair_mesh(two); });
  EXPECT_TRUE(contains(message, "2 separate components, the second with 100 % of the area"));
  EXPECT_TRUE(contains(message, "save each block to a separate file"));
  // The smaller of two that touch is a scrap of the larger.
  const TriangleMesh scrap = at(scaled(box_mesh({1, 1, 1}), 0.1), {1, 1, 0});
  TriangleMesh column = box_mesh({1, 1, 0.1});
  for (Vec3& v : column.vertices) v = Vec3(v.x(), v.y(), v.z() > 0 ? 0.1 : 0.0);
  const RepairedMesh result = repair_mesh(merged(column, scrap));
  expect_sound(result.mesh);
  EXPECT_NEAR(enclosed_volume(result.mesh), 0.1, 1e-12);
}

/// Two triangles of a fold pass through each other.
TEST(Repair, CrossingTrianglesAreReplaced) {
  TriangleMesh dirty = rock();
  // One vertex is drawn through the surface beside it, along the surface.
  const Vec3 from = dirty.vertices[500];
  std::uint32_t beside = 0;
  double nearest = 1e9;
  for (std::uint32_t v = 0; v < dirty.vertices.size(); ++v) {
    const double far = (dirty.vertices[v] - from).norm();
    if (v != 500 && far > 0.12 && far < nearest) {
      nearest = far;
      beside = v;
    }
  }
  dirty.vertices[500] += 1.1 * (dirty.vertices[beside] - from);
  ASSERT_FALSE(find_self_intersections(dirty).empty());
  const RepairedMesh result = repair_mesh(dirty);
  expect_sound(result.mesh);
  EXPECT_NEAR(enclosed_volume(result.mesh) / enclosed_volume(rock()), 1.0, 2e-3);
}

TEST(Repair, WhatCantBeMendedIsRefusedWithItsPlace) {
  // The upper part is inside out: no small change gives the volume it seems to have.
  TriangleMesh twisted = box_mesh({1, 1, 1});
  for (Vec3& v : twisted.vertices) {
    if (v.z() > 0.0) v.x() = 0.8 - 0.6 * v.x();
  }
  const std::string message = refusal<GeometryError>([&] { repair_mesh(twisted); });
  EXPECT_TRUE(contains(message, "the surface passes through itself at "));
  EXPECT_TRUE(contains(message, "pairs of triangles, the first near ("));
  EXPECT_TRUE(contains(message, "MeshLab"));
}

TEST(Repair, HalvesThatDontMeetAreToldToBeMerged) {
  const TriangleMesh upper = beheaded(geodesic_sphere(12), 0.3);
  TriangleMesh lower = upper;
  for (Vec3& v : lower.vertices) v = Vec3(-v.x(), v.y(), -v.z()) + Vec3(4, 0, 0);
  const std::string message = refusal<GeometryError>([&] { repair_mesh(merged(upper, lower)); });
  EXPECT_TRUE(contains(message, "2 separate components"));
  EXPECT_TRUE(contains(message, "align and merge them first (CloudCompare"));
}

TEST(Repair, PlacesAreToldAsAsked) {
  RepairOptions options;
  options.to_reported_position = [](const Vec3& p) -> Vec3 { return 1000.0 * p + Vec3(5e6, 0, 0); };
  const RepairedMesh result = repair_mesh(beheaded(geodesic_sphere(12), 0.9), options);
  EXPECT_NEAR(result.report.holes[0].centre.x(), 5e6, 50.0);
  EXPECT_NEAR(result.report.holes[0].centre.z(), 900.0, 50.0);
  EXPECT_LT(result.report.holes[0].radius, 1.0);
}

/// Every damage at once. The full table over real rocks is the test DamagedRealRocks.
TEST(Repair, DamagedRocksComeBackWithTheirVolume) {
  const TriangleMesh rough = rough_rock_mesh(20, {1.0, 0.8, 0.6}, 3, 0.1);
  for (const double intensity : {0.5, 1.0, 1.5}) {
    std::vector<Trial> trials;
    for (std::uint64_t seed = 0; seed < 2; ++seed) {
      trials.push_back(mend_damaged(rough, intensity, seed));
      const Trial& trial = trials.back();
      SCOPED_TRACE("intensity " + std::to_string(intensity) + " seed " + std::to_string(seed));
      EXPECT_TRUE(trial.valid) << trial.refusal;
      EXPECT_NEAR(trial.volume_error, 0.0, 2e-3);
      EXPECT_LE(trial.hausdorff, trial.largest_hole);
      EXPECT_GT(trial.filled_fraction, 0.5 * trial.lost_share);
    }
    std::cout << table_line("x" + std::to_string(intensity).substr(0, 3), trials) << "\n";
  }
}

TEST(Repair, TheSameDirtGivesTheSameBits) {
  const TriangleMesh dirty = damaged(rock(), Damage::of_intensity(1.0), 1).mesh;
  const RepairedMesh a = repair_mesh(dirty), b = repair_mesh(dirty);
  EXPECT_EQ(a.mesh.vertices, b.mesh.vertices);
  EXPECT_EQ(a.mesh.triangles, b.mesh.triangles);
}

TEST(Repair, BadOptionsAreRefusedByName) {
  EXPECT_TRUE(contains(refusal([] { repair_mesh(tetrahedron(), {.weld_tolerance = -1.0}); }),
                       "weld_tolerance"));
  EXPECT_TRUE(contains(refusal([] { repair_mesh(tetrahedron(), {.max_hole_fraction = 1.5}); }),
                       "largest_hole"));
}

}  // namespace
}  // namespace clast
