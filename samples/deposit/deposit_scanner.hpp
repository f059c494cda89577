#pragma once
/// Scanner of virtual deposits: rays from cameras or tripods to the first surface they hit.
#include <cstdint>
#include <span>
#include <vector>

#include "core/random.hpp"
#include "mesh/triangle_mesh.hpp"
#include "samples/deposit/deposit_recipe.hpp"

namespace clast {

/// All surfaces of a deposit in one mesh.
struct DepositScene {
  TriangleMesh mesh;
  std::vector<std::uint32_t> block_of_triangle;  ///< 0: ground and fines; 1, 2, ...: blocks
};

/// Point of a scan.
struct ScannedPoint {
  Eigen::Vector3f position = Eigen::Vector3f::Zero();  ///< with noise, as files hold it, m
  std::uint32_t triangle = 0;                          ///< triangle of the scene that the ray hit
};

/// Points and the places from which they were seen.
struct DepositScan {
  std::vector<Vec3> stations;
  std::vector<ScannedPoint> points;
};

/// Rays of a view: a pencil through a grid of pixels, or equal steps of azimuth and elevation.
struct ScanView {
  Vec3 station = Vec3::Zero();
  Mat3 world_from_view = Mat3::Identity();  ///< a camera looks along its third column
  bool panoramic = false;
  double step = 1e-3;  ///< angle between rays (at the centre of a picture), rad
  int columns = 0, rows = 0;
};

/// Returns the views of the stations: 4 vertical and 8 oblique pictures that cover the scene, or 5
/// panoramas. Rays are about 0.65 spacings apart at the middle of the scene, those of panoramas one
/// spacing at the distance of its border.
std::vector<ScanView> plan_views(const DepositRecipe& recipe, const DepositScene& scene);

/// Draws the rays of a view, each through a random place in its pixel, as a regular grid would
/// leave its pattern in the points.
/// @return unit directions, row by row
std::vector<Vec3> draw_ray_directions(const ScanView& view, Random& random);

/// First triangle that a ray hits.
struct RayHit {
  std::uint32_t triangle = kNoIndex;  ///< `kNoIndex`: the ray hits nothing
  double distance = 0.0;              ///< m
};
/// Casts all rays of a view. Only outer sides of triangles are hit.
/// @param directions  as from `draw_ray_directions`
/// @return one hit per ray
std::vector<RayHit> cast_rays(const ScanView& view, std::span<const Vec3> directions,
                              const TriangleMesh& mesh);

/// Scans the scene. Rays that graze a surface are lost, from 75 degrees of incidence increasingly.
/// Points of a drone are subsampled in random order so that none is closer than 0.78 spacings to
/// another, those of tripods 0.5. Distances then get normal noise of `recipe.noise` spacings.
DepositScan scan_deposit(const DepositRecipe& recipe, const DepositScene& scene, unsigned threads);

}  // namespace clast
