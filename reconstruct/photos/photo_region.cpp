#include "reconstruct/photos/photo_region.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/error.hpp"
#include "core/statistics/statistics.hpp"
#include "reconstruct/cloud/cloud.hpp"
#include "reconstruct/ground/blocks_on_ground.hpp"
#include "reconstruct/ground/ground.hpp"

namespace clast {

namespace {

constexpr std::size_t kMinSparsePoints =
    300;                                    ///< sparse points, for a ground and a block among them
constexpr std::size_t kMinRegionViews = 3;  ///< that a sparse point was seen in
constexpr int kNeighbours = 12;             ///< of the test for outliers
constexpr double kDeviations = 1.5;
/// Distance of the block's farthest points from its middle times this: sparse points end a little
/// short of the rock, and the ground is wanted on all sides.
constexpr double kRegionMargin = 1.15;
constexpr double kFarthestFraction = 0.995;  ///< of the block's points; the rest may be strays
/// Radius over that of the ball that fills the photos, to include the ground around a block.
constexpr double kFilled = 0.8;
/// Distances from the centre, over that of the cameras, up to which sparse points are used. The
/// nearest ground is wanted, but little ground may be near a large block.
constexpr std::array<double, 3> kForegrounds = {0.8, 3.0, 10.0};
/// Fraction of the foreground points in the ball if there is no ground.
constexpr double kRetainedFraction = 0.9;
/// Maximum radius of that ball, over the distance of the cameras.
constexpr double kLargest = 0.6;

/// The place nearest to the lines that the cameras look along.
Vec3 looked_at(const PhotoModel& model) {
  Mat3 sum = Mat3::Zero();
  Vec3 right = Vec3::Zero();
  for (const Photo& photo : model.photos) {
    const Pose world_from_camera = photo.camera_from_world.inverse();
    const Vec3 axis = world_from_camera.rotation * Vec3::UnitZ();
    const Mat3 across = Mat3::Identity() - axis * axis.transpose();
    sum += across;
    right += across * world_from_camera.translation;
  }
  // Parallel axes meet nowhere: the matrix is singular then.
  if (!(sum.determinant() > 1e-6 * std::pow(static_cast<double>(model.photos.size()), 3))) {
    throw InputError("the " + std::to_string(model.photos.size()) +
                     " cameras look along parallel lines, not at one block: take photos all "
                     "round it");
  }
  const Vec3 position = sum.ldlt().solve(right);
  for (const Photo& photo : model.photos) {
    if ((photo.camera_from_world * position).z() > 0.0) return position;
  }
  throw InputError(
      "the cameras look away from each other, not at one block: take photos all round it");
}

/// The block on the ground among sparse points not farther than `reach` from the middle; none where
/// there is no ground, or the block is not what the cameras look at.
std::optional<PhotoRegion> standing_region(const PhotoModel& model, const Vec3& middle,
                                           double reach, double most_aside) {
  std::vector<Vec3> near;
  for (const SparsePoint& point : model.points) {
    const bool known = point.photos.size() >= kMinRegionViews;
    if (known && (point.position - middle).norm() < reach) near.push_back(point.position);
  }
  if (near.size() < kMinSparsePoints) return std::nullopt;
  std::vector<Vec3> points;
  for (const std::uint32_t i : reconstruct_detail::find_inliers(near, kNeighbours, kDeviations)) {
    points.push_back(near[i]);
  }
  const std::optional<Ground> ground = find_ground(points);
  if (!ground) return std::nullopt;
  const BlocksOnGround standing = find_blocks_on_ground(points, *ground);
  if (standing.blocks.empty()) return std::nullopt;
  const BlockOnGround& block = standing.blocks[standing.central_block];
  Bounds box;
  for (const std::uint32_t i : block.points) box.include(points[i]);
  const Vec3 centre = 0.5 * (box.low + box.high);
  std::vector<double> distances;
  for (const std::uint32_t i : block.points) distances.push_back((points[i] - centre).norm());
  std::sort(distances.begin(), distances.end());
  const double radius =
      kRegionMargin * distances[static_cast<std::size_t>(
                          kFarthestFraction * static_cast<double>(distances.size() - 1))];
  if ((centre - middle).norm() > radius + most_aside) return std::nullopt;
  return PhotoRegion{centre, radius, true};
}

}  // namespace

PhotoRegion find_photo_region(const PhotoModel& model) {
  if (model.photos.size() < 2) {
    throw InputError(std::to_string(model.photos.size()) +
                     " photos with a camera are too few; a block needs at least 20, all round it");
  }
  const Vec3 middle = looked_at(model);
  std::vector<double> distances, reaches;
  for (const Photo& photo : model.photos) {
    const CameraIntrinsics& lens = model.lenses[photo.lens];
    const double distance = (photo.centre() - middle).norm();
    distances.push_back(distance);
    const double half = 0.5 * std::min(lens.width / lens.fx, lens.height / lens.fy);
    reaches.push_back(distance * std::sin(std::atan(half)));
  }
  const double away = upper_median(distances);
  PhotoRegion region{middle, kFilled * upper_median(reaches), false};
  for (const double fraction : kForegrounds) {
    if (const auto found = standing_region(model, middle, fraction * away, 0.2 * away))
      return *found;
  }
  std::vector<double> known;
  for (const SparsePoint& point : model.points) {
    const double distance = (point.position - middle).norm();
    if (point.photos.size() >= kMinRegionViews && distance < kForegrounds[0] * away) {
      known.push_back(distance);
    }
  }
  if (known.size() < kMinSparsePoints) return region;
  std::sort(known.begin(), known.end());
  const double held =
      known[static_cast<std::size_t>(kRetainedFraction * static_cast<double>(known.size()))];
  return {middle, std::min(kRegionMargin * held, kLargest * away), false};
}

double viewing_angle(const PhotoModel& model, const PhotoRegion& region, std::size_t first,
                     std::size_t second) {
  const Vec3 a = model.photos[first].centre() - region.centre;
  const Vec3 b = model.photos[second].centre() - region.centre;
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

}  // namespace clast
