#include "reconstruct/photos/detail/triangulation.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace clast::photos_detail {

namespace {

constexpr std::size_t kMaxPairs = 400;
constexpr double kMinAngle = 0.03;  ///< between two rays, rad: less says nothing of the depth
constexpr int kSteps = 10;

struct Ray {
  Vec3 from, along;  ///< `along` is unit
};

/// The middle of the shortest line between two rays.
std::optional<Vec3> meeting(const Ray& a, const Ray& b) {
  const double c = a.along.dot(b.along), sine2 = 1.0 - c * c;
  if (sine2 < kMinAngle * kMinAngle) return std::nullopt;
  const Vec3 between = b.from - a.from;
  const double s = (a.along.dot(between) - c * b.along.dot(between)) / sine2;
  const double t = (c * a.along.dot(between) - b.along.dot(between)) / sine2;
  if (!(s > 0.0 && t > 0.0)) return std::nullopt;
  return 0.5 * (a.from + s * a.along + b.from + t * b.along);
}

TriangulatedPoint judged(const PhotoModel& model, const std::vector<ImageObservation>& observations,
                         const Vec3& position, double max_reprojection_error) {
  TriangulatedPoint result{position, std::vector<bool>(observations.size()), 0, 0.0};
  for (std::size_t i = 0; i < observations.size(); ++i) {
    const std::optional<Vec2> projection =
        project_into_photo(model, observations[i].photo, position);
    const double error2 = projection ? (*projection - observations[i].pixel).squaredNorm() : 1e300;
    if (error2 > max_reprojection_error * max_reprojection_error) continue;
    result.is_inlier[i] = true;
    ++result.inlier_count;
    result.squared_error += error2;
  }
  return result;
}

/// A step of least squares over the sightings that agree; derivatives by differences.
Vec3 improved(const PhotoModel& model, const std::vector<ImageObservation>& observations,
              const TriangulatedPoint& now) {
  Mat3 normal = Mat3::Zero();
  Vec3 right = Vec3::Zero();
  for (std::size_t i = 0; i < observations.size(); ++i) {
    if (!now.is_inlier[i]) continue;
    const std::size_t photo = observations[i].photo;
    const Photo& camera = model.photos[photo];
    const double step = 1e-6 * (camera.camera_from_world * now.position).norm();
    const std::optional<Vec2> here = project_into_photo(model, photo, now.position);
    Eigen::Matrix<double, 2, 3> slope;
    for (int axis = 0; axis < 3; ++axis) {
      const Vec3 move = step * Vec3::Unit(axis);
      const std::optional<Vec2> ahead = project_into_photo(model, photo, now.position + move);
      const std::optional<Vec2> behind = project_into_photo(model, photo, now.position - move);
      if (!ahead || !behind) return now.position;
      slope.col(axis) = (*ahead - *behind) / (2.0 * step);
    }
    normal += slope.transpose() * slope;
    right += slope.transpose() * (observations[i].pixel - *here);
  }
  const Vec3 move = normal.ldlt().solve(right);
  return move.allFinite() ? Vec3(now.position + move) : now.position;
}

}  // namespace

std::optional<TriangulatedPoint> triangulate(const PhotoModel& model,
                                             const std::vector<ImageObservation>& observations,
                                             double max_reprojection_error) {
  std::vector<std::optional<Ray>> rays;
  for (const ImageObservation& sighting : observations) {
    const Photo& photo = model.photos[sighting.photo];
    const std::optional<Vec3> direction = unproject(model.lenses[photo.lens], sighting.pixel);
    const Pose world_from_camera = photo.camera_from_world.inverse();
    rays.push_back(direction
                       ? std::optional(Ray{world_from_camera.translation,
                                           world_from_camera.rotation * direction->normalized()})
                       : std::nullopt);
  }
  std::optional<TriangulatedPoint> best;
  const std::size_t count = observations.size(), pairs = count * (count - 1) / 2;
  const std::size_t stride = pairs / kMaxPairs + 1;
  std::size_t pair = 0;
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = i + 1; j < count; ++j) {
      if (pair++ % stride != 0 || !rays[i] || !rays[j]) continue;
      const std::optional<Vec3> position = meeting(*rays[i], *rays[j]);
      if (!position) continue;
      TriangulatedPoint trial = judged(model, observations, *position, max_reprojection_error);
      const bool better =
          !best || trial.inlier_count > best->inlier_count ||
          (trial.inlier_count == best->inlier_count && trial.squared_error < best->squared_error);
      if (trial.inlier_count >= 2 && better) best = std::move(trial);
    }
  }
  if (!best) return std::nullopt;
  for (int step = 0; step < kSteps; ++step) {
    TriangulatedPoint next =
        judged(model, observations, improved(model, observations, *best), max_reprojection_error);
    if (next.inlier_count < best->inlier_count) break;
    const bool still = (next.position - best->position).norm() < 1e-12 * best->position.norm();
    best = std::move(next);
    if (still) break;
  }
  return best;
}

}  // namespace clast::photos_detail
