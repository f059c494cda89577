#include "samples/deposit/deposit.hpp"

#include <algorithm>
#include <utility>

#include "classify/schemes.hpp"
#include "core/files/table.hpp"
#include "core/files/text_file.hpp"
#include "core/parallel.hpp"
#include "massprops/solid.hpp"
#include "mesh/labelled_cloud.hpp"
#include "mesh/mesh_io.hpp"
#include "mesh/triangle_geometry.hpp"
#include "samples/deposit/block_table.hpp"
#include "samples/deposit/deposit_ground.hpp"
#include "samples/deposit/point_grid.hpp"
#include "samples/deposit/separation.hpp"
#include "samples/deposit/settling.hpp"

namespace clast {
namespace {

/// Overlap of two surfaces that may remain, spacings.
constexpr double kAllowedOverlap = 0.4;

/// Blocks and their poses; blocks that did not come to rest are left out.
struct PlacedBlocks {
  std::vector<VirtualBlock> blocks;
  std::vector<Pose> poses;
  TriangleMesh ground;
  double largest_overlap = 0.0;
};

PlacedBlocks place_blocks(const DepositRecipe& recipe, std::span<const StoneScan> scans,
                          unsigned threads) {
  std::vector<VirtualBlock> made =
      make_deposit_blocks(recipe, count_released_blocks(recipe), scans, threads);
  PlacedBlocks placed;
  if (recipe.kind == DepositKind::kNatural) {
    NaturalScene natural = make_natural_scene(recipe, made, threads);
    placed.blocks = std::move(made);
    placed.poses = std::move(natural.poses);
    placed.ground = std::move(natural.ground);
    return placed;
  }
  const std::vector<std::optional<Pose>> settled = settle_blocks(recipe, made, threads);
  for (std::size_t i = 0; i < made.size(); ++i) {
    if (!settled[i]) continue;
    placed.blocks.push_back(std::move(made[i]));
    placed.poses.push_back(*settled[i]);
  }
  placed.largest_overlap =
      separate_surfaces(placed.blocks, placed.poses, kAllowedOverlap * recipe.spacing(), threads);
  placed.ground = make_floor_ground(recipe, placed.blocks, placed.poses, threads);
  return placed;
}

void add_surface(DepositScene& scene, const TriangleMesh& surface, std::uint32_t block) {
  scene.mesh = merged(std::move(scene.mesh), surface);
  scene.block_of_triangle.resize(scene.mesh.triangles.size(), block);
}

/// Fills in points and visible fractions.
void measure_visibility(VirtualDeposit& deposit, double spacing, unsigned threads) {
  const DepositScene& scene = deposit.scene;
  PointGrid seen(spacing);
  for (const ScannedPoint& point : deposit.scan.points) {
    seen.add(point.position.cast<double>());
    const std::uint32_t block = scene.block_of_triangle[point.triangle];
    if (block > 0) ++deposit.blocks[block - 1].points;
  }
  std::vector<std::uint32_t> ends(deposit.blocks.size() + 1, 0);
  for (std::uint32_t t = 0; t < scene.mesh.triangles.size(); ++t) {
    ends[scene.block_of_triangle[t]] = t + 1;
  }
  parallel_for(deposit.blocks.size(), threads, [&](std::size_t b) {
    double whole = 0.0, visible = 0.0;
    for (std::uint32_t t = ends[b]; t < ends[b + 1]; ++t) {
      const TriangleMesh::Triangle& triangle = scene.mesh.triangles[t];
      const double area = triangle_area(scene.mesh, triangle);
      const Vec3 normal = unit_normal(scene.mesh, triangle);
      whole += area;
      const bool is_seen =
          seen.any_within(centroid(scene.mesh, triangle), spacing, [&](std::uint32_t i) {
            const std::uint32_t hit = deposit.scan.points[i].triangle;
            return scene.block_of_triangle[hit] == b + 1 &&
                   normal.dot(unit_normal(scene.mesh, scene.mesh.triangles[hit])) > 0.0;
          });
      if (is_seen) visible += area;
    }
    deposit.blocks[b].visible_fraction = visible / whole;
  });
}

}  // namespace

VirtualDeposit make_deposit(const DepositRecipe& recipe, std::span<const StoneScan> scans,
                            unsigned threads) {
  recipe.check();
  const PlacedBlocks placed = place_blocks(recipe, scans, threads);
  VirtualDeposit deposit;
  deposit.largest_overlap = placed.largest_overlap;
  add_surface(deposit.scene, placed.ground, 0);
  for (std::size_t i = 0; i < placed.blocks.size(); ++i) {
    const VirtualBlock& block = placed.blocks[i];
    deposit.bodies.push_back(transformed(block.surface, placed.poses[i]));
    add_surface(deposit.scene, deposit.bodies.back(), static_cast<std::uint32_t>(i + 1));
    TrueBlock truth;
    truth.block = i + 1;
    truth.shape = block.shape;
    truth.centre = solid_mass_properties(deposit.bodies.back(), 1.0).centre;
    truth.axes = block.axes;
    truth.volume = block.volume;
    deposit.blocks.push_back(truth);
  }
  deposit.scan = scan_deposit(recipe, deposit.scene, threads);
  measure_visibility(deposit, recipe.spacing(), threads);
  return deposit;
}

void write_deposit(const VirtualDeposit& deposit, const std::filesystem::path& folder,
                   bool with_bodies) {
  std::filesystem::create_directories(folder);
  std::vector<Vec3> points;
  std::vector<std::uint32_t> blocks;
  for (const ScannedPoint& point : deposit.scan.points) {
    points.emplace_back(point.position.cast<double>());
    blocks.push_back(deposit.scene.block_of_triangle[point.triangle]);
  }
  write_labelled_cloud(folder / "scan.ply", points, {});
  write_labelled_cloud(folder / "truth.ply", points, blocks);
  write_text_file(folder / kTrueBlocksFile, format_csv(true_block_columns(), deposit.blocks));
  CsvWriter stations;
  stations.write_header("x_m,y_m,z_m");
  for (const Vec3& station : deposit.scan.stations) {
    for (int axis = 0; axis < 3; ++axis) stations.write_cell(station[axis]);
    stations.end_row();
  }
  write_text_file(folder / "stations.csv", stations.take_text());
  if (!with_bodies) return;
  std::filesystem::create_directories(folder / "bodies");
  for (std::size_t i = 0; i < deposit.bodies.size(); ++i) {
    write_mesh(folder / "bodies" / (std::to_string(i + 1) + ".ply"), deposit.bodies[i]);
  }
}

}  // namespace clast
