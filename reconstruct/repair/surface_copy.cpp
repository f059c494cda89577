#include "reconstruct/repair/surface_copy.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <vector>

#include "mesh/mesh_topology.hpp"
#include "mesh/triangle_geometry.hpp"

namespace clast::reconstruct_detail {

namespace {

constexpr std::size_t kSamples = 800;  ///< vertices of the component that are compared
constexpr int kSteps = 30;
/// Largest distance of a copy, and of one that fits as well as an exact one, over the diagonal.
constexpr double kFarthestCopy = 0.08, kFitsCopy = 0.003;
/// Left of the distance once a copy is fitted, at most.
constexpr double kLeft = 0.35;
/// Fractions of the samples: minimum that faces one way, and those used in a fit.
constexpr double kCopyOneWay = 0.9, kCounted = 0.9;
constexpr double kSameWay = 0.3;  ///< cosine between the normals of copy and surface
/// A copy with this share of the area is one of the whole block; of two such the one with so many
/// times the triangles is finer.
constexpr double kCompleteCopy = 0.5, kFiner = 1.25;
constexpr double kMaxScale = 0.12;
constexpr double kMaxTurn = 0.2;  ///< rad
/// Damping of rotations and scales that are otherwise undetermined, as for a ball or a flat patch.
constexpr double kDamping = 1e-6;

using Vec7 = Eigen::Matrix<double, 7, 1>;
using Mat7 = Eigen::Matrix<double, 7, 7>;

struct Sample {
  Vec3 position, normal;
};

std::vector<Sample> samples_of(const TriangleMesh& component) {
  std::vector<Vec3> normals(component.vertices.size(), Vec3::Zero());
  for (const TriangleMesh::Triangle& t : component.triangles) {
    const Vec3 doubled = doubled_area_vector(component, t);
    for (const std::uint32_t v : t) normals[v] += doubled;
  }
  std::vector<Sample> samples;
  const std::size_t step = std::max<std::size_t>(1, component.vertices.size() / kSamples);
  for (std::size_t v = 0; v < component.vertices.size(); v += step) {
    if (normals[v].norm() > 0.0) {
      samples.push_back({component.vertices[v], normals[v].normalized()});
    }
  }
  return samples;
}

/// The foot of a sample on the surface.
struct SurfaceFoot {
  Vec3 normal = Vec3::Zero();
  double height = 0.0;    ///< of the sample over the plane there
  double distance = 0.0;  ///< to the surface
};

std::vector<SurfaceFoot> feet_of(const std::vector<Sample>& samples, const TriangleTree& tree) {
  std::vector<SurfaceFoot> feet;
  std::uint32_t hint = 0;
  for (const Sample& sample : samples) {
    const TriangleTree::Closest found = tree.closest_point(sample.position, hint);
    hint = found.triangle;
    const Vec3& normal = tree.face_normal(found.triangle);
    feet.push_back(
        {normal, normal.dot(sample.position - found.point), std::sqrt(found.squared_distance)});
  }
  return feet;
}

/// Distance within which the counted share of the samples is.
double counted_distance(const std::vector<SurfaceFoot>& feet) {
  std::vector<double> distances;
  for (const SurfaceFoot& foot : feet) distances.push_back(foot.distance);
  const auto last = distances.begin() +
                    static_cast<std::ptrdiff_t>(kCounted * static_cast<double>(feet.size() - 1));
  std::nth_element(distances.begin(), last, distances.end());
  return *last;
}

double root_mean_square(const std::vector<SurfaceFoot>& feet) {
  const double limit = counted_distance(feet);
  double sum = 0.0;
  std::size_t count = 0;
  for (const SurfaceFoot& foot : feet) {
    if (foot.distance > limit) continue;
    sum += foot.distance * foot.distance;
    ++count;
  }
  return std::sqrt(sum / static_cast<double>(count));
}

/// True if nearly all normals of the component agree with the surface, or nearly all oppose it.
bool faces_one_way(const std::vector<Sample>& samples, const std::vector<SurfaceFoot>& feet) {
  std::size_t same = 0, other = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double cosine = samples[i].normal.dot(feet[i].normal);
    same += cosine > kSameWay;
    other += cosine < -kSameWay;
  }
  return static_cast<double>(std::max(same, other)) >=
         kCopyOneWay * static_cast<double>(samples.size());
}

/// One step towards the surface; adds what it turns (rad) and scales by.
void approach(std::vector<Sample>& samples, const std::vector<SurfaceFoot>& feet, double diagonal,
              Vec3& total_rotation, double& scale) {
  Vec3 middle = Vec3::Zero();
  for (const Sample& s : samples) middle += s.position / static_cast<double>(samples.size());
  const double limit = counted_distance(feet);
  Mat7 matrix = Mat7::Zero();
  Vec7 side = Vec7::Zero();
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (feet[i].distance > limit) continue;
    const Vec3 arm = (samples[i].position - middle) / diagonal;
    Vec7 row;
    row << feet[i].normal, arm.cross(feet[i].normal), arm.dot(feet[i].normal);
    matrix += row * row.transpose();
    side -= feet[i].height / diagonal * row;
  }
  matrix += kDamping * matrix.trace() * Mat7::Identity();
  const Vec7 move = matrix.ldlt().solve(side);
  const Vec3 rotation_vector = move.segment<3>(3);
  const double angle = rotation_vector.norm();
  const Quat rotation =
      angle > 0.0 ? Quat(Eigen::AngleAxisd(angle, rotation_vector / angle)) : Quat::Identity();
  const double factor = 1.0 + std::clamp(move[6], -0.05, 0.05);
  for (Sample& s : samples) {
    s.position = middle + diagonal * move.head<3>() + factor * (rotation * (s.position - middle));
  }
  total_rotation += rotation_vector;
  scale *= factor;
}

}  // namespace

std::optional<SurfaceCopy> match_surface_copy(const TriangleMesh& component,
                                              const TriangleTree& tree, double diagonal) {
  std::vector<Sample> samples = samples_of(component);
  if (samples.size() < 10) return std::nullopt;
  std::vector<SurfaceFoot> feet = feet_of(samples, tree);
  if (counted_distance(feet) > kFarthestCopy * diagonal || !faces_one_way(samples, feet)) {
    return std::nullopt;
  }
  SurfaceCopy copy;
  const double before = root_mean_square(feet);
  for (const SurfaceFoot& foot : feet) {
    copy.offset += foot.height / static_cast<double>(feet.size());
    copy.distance += foot.distance * foot.distance / static_cast<double>(feet.size());
  }
  copy.distance = std::sqrt(copy.distance);
  Vec3 total_rotation = Vec3::Zero();
  double scale = 1.0;
  for (int step = 0; step < kSteps; ++step) {
    approach(samples, feet, diagonal, total_rotation, scale);
    feet = feet_of(samples, tree);
  }
  copy.scale = 1.0 / scale;
  if (std::abs(copy.scale - 1.0) > kMaxScale || total_rotation.norm() > kMaxTurn)
    return std::nullopt;
  const double left = root_mean_square(feet);
  if (left > std::max(kLeft * before, kFitsCopy * diagonal)) return std::nullopt;
  return copy;
}

void move_best_copy_first(std::vector<SurfaceComponent>& components) {
  const auto better = [](const SurfaceComponent& a, const SurfaceComponent& b) {
    const bool a_closed = inspect_mesh(a.mesh).is_closed(),
               b_closed = inspect_mesh(b.mesh).is_closed();
    if (a_closed != b_closed) return a_closed;
    return static_cast<double>(a.mesh.triangles.size()) >
           kFiner * static_cast<double>(b.mesh.triangles.size());
  };
  std::size_t best = 0;
  for (std::size_t i = 1; i < components.size(); ++i) {
    if (components[i].area < kCompleteCopy * components[0].area) break;
    if (!better(components[i], components[best])) continue;
    const TriangleTree tree(components[0].mesh);
    if (match_surface_copy(components[i].mesh, tree, bounds(components[0].mesh).diagonal()))
      best = i;
  }
  std::rotate(components.begin(), components.begin() + static_cast<std::ptrdiff_t>(best),
              components.begin() + static_cast<std::ptrdiff_t>(best) + 1);
}

DuplicateSurface describe_copy(const SurfaceCopy& copy, const SurfaceComponent& dropped,
                               const TriangleMesh& kept, const TriangleTree& tree) {
  DuplicateSurface doubled;
  doubled.closed = inspect_mesh(dropped.mesh).is_closed();
  doubled.area_fraction = dropped.area / surface_area(kept);
  doubled.offset = copy.offset;
  doubled.distance = copy.distance;
  doubled.scale = copy.scale;
  const std::size_t of_kept = kept.triangles.size(), of_copy = dropped.mesh.triangles.size();
  if (inspect_mesh(kept).is_closed() && !doubled.closed) {
    doubled.retention_reason = RetentionReason::kClosed;
  } else if (doubled.area_fraction < kCompleteCopy) {
    doubled.retention_reason = RetentionReason::kMoreComplete;
  } else if (static_cast<double>(of_kept) > kFiner * static_cast<double>(of_copy)) {
    doubled.retention_reason = RetentionReason::kFiner;
  }
  if (inspect_mesh(kept).is_closed()) doubled.retained_volume = std::abs(signed_volume(kept));
  if (doubled.closed && doubled.retained_volume > 0.0) {
    doubled.volume_change = std::abs(signed_volume(dropped.mesh)) - doubled.retained_volume;
    return doubled;
  }
  std::uint32_t hint = 0;
  for (const TriangleMesh::Triangle& t : dropped.mesh.triangles) {
    const Vec3 &a = dropped.mesh.vertices[t[0]], &b = dropped.mesh.vertices[t[1]],
               &c = dropped.mesh.vertices[t[2]];
    const Vec3 middle = (a + b + c) / 3.0;
    const TriangleTree::Closest found = tree.closest_point(middle, hint);
    hint = found.triangle;
    doubled.volume_change += 0.5 * (b - a).cross(c - a).norm() *
                             tree.face_normal(found.triangle).dot(middle - found.point);
  }
  return doubled;
}

}  // namespace clast::reconstruct_detail
