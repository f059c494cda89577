#include "samples/deposit/deposit_scanner.hpp"

#include <algorithm>
#include <cmath>

#include "core/parallel.hpp"
#include "mesh/triangle_geometry.hpp"
#include "samples/deposit/point_grid.hpp"

namespace clast {
namespace {

constexpr double kRaysPerSpacing = 1.0 / 0.65;
constexpr double kFlightHeight = 1.2;  // of a drone over the widest side of the scene
constexpr double kOblique = 40.0 * kPi / 180.0;
constexpr double kTripodHeight = 2.0;  // m above the ground
constexpr double kTripodMargin = 1.5;  // m beside the scene
constexpr double kLowest = -70.0 * kPi / 180.0, kHighest = 30.0 * kPi / 180.0;  // of a panorama
constexpr double kGrazing = 75.0 * kPi / 180.0, kLost = 88.0 * kPi / 180.0;
constexpr double kDroneDistance = 0.78;  // least one of two points, spacings
constexpr double kTripodDistance = 0.5;
constexpr double kNearest = 0.05;  // m, of a surface to a station

/// Where a point is in the grid of rays.
struct RayPlace {
  double column = 0.0, row = 0.0;
  bool valid = false;
};

RayPlace project(const ScanView& view, const Vec3& point) {
  const Vec3 p = view.world_from_view.transpose() * (point - view.station);
  if (view.panoramic) {
    const double plan = p.head<2>().norm();
    if (plan < kNearest) return {};
    return {(std::atan2(p.y(), p.x()) + kPi) / view.step,
            (std::atan2(p.z(), plan) - kLowest) / view.step, true};
  }
  if (p.z() < kNearest) return {};
  return {p.x() / p.z() / view.step + 0.5 * (view.columns - 1),
          p.y() / p.z() / view.step + 0.5 * (view.rows - 1), true};
}

ScanView make_camera(const Vec3& station, const Vec3& target, const DepositScene& scene,
                     double spacing) {
  ScanView view;
  view.station = station;
  const Vec3 forward = (target - station).normalized();
  const Vec3 side = std::abs(forward.z()) > 0.99 ? Vec3(Vec3::UnitX())
                                                 : Vec3(forward.cross(Vec3::UnitZ()).normalized());
  view.world_from_view.col(0) = (side - side.dot(forward) * forward).normalized();
  view.world_from_view.col(1) = forward.cross(view.world_from_view.col(0));
  view.world_from_view.col(2) = forward;
  view.step = spacing / kRaysPerSpacing / (target - station).norm();
  double widest = 0.0, highest = 0.0;
  for (const Vec3& vertex : scene.mesh.vertices) {
    const RayPlace place = project(view, vertex);
    widest = std::max(widest, std::abs(place.column));
    highest = std::max(highest, std::abs(place.row));
  }
  view.columns = 2 * static_cast<int>(widest) + 3;
  view.rows = 2 * static_cast<int>(highest) + 3;
  return view;
}

ScanView make_panorama(const Vec3& station, double step) {
  ScanView view;
  view.station = station;
  view.panoramic = true;
  view.columns = static_cast<int>(std::ceil(2.0 * kPi / step));
  view.step = 2.0 * kPi / view.columns;
  view.rows = static_cast<int>((kHighest - kLowest) / view.step);
  return view;
}

/// Height of the vertex that is nearest to a place in plan, m.
double height_near(const TriangleMesh& mesh, const Vec2& place) {
  const auto nearest = std::min_element(
      mesh.vertices.begin(), mesh.vertices.end(), [&](const Vec3& a, const Vec3& b) {
        return (a.head<2>() - place).squaredNorm() < (b.head<2>() - place).squaredNorm();
      });
  return nearest->z();
}

double chance_of_loss(double cosine) {
  const double incidence = std::acos(std::clamp(cosine, 0.0, 1.0));
  return std::clamp((incidence - kGrazing) / (kLost - kGrazing), 0.0, 1.0);
}

/// Measurement along a ray.
struct Measurement {
  Vec3 place = Vec3::Zero();  ///< on the surface, m
  Vec3 error = Vec3::Zero();  ///< along the ray, m
  std::uint32_t triangle = 0;
};

/// Measurements of one view in random order.
std::vector<Measurement> measure(const ScanView& view, const DepositScene& scene, double noise,
                                 Random random) {
  const std::vector<Vec3> directions = draw_ray_directions(view, random);
  const std::vector<RayHit> hits = cast_rays(view, directions, scene.mesh);
  std::vector<Measurement> measurements;
  for (std::size_t i = 0; i < hits.size(); ++i) {
    const RayHit& hit = hits[i];
    if (hit.triangle == kNoIndex) continue;
    const Vec3& direction = directions[i];
    const double cosine =
        -direction.dot(unit_normal(scene.mesh, scene.mesh.triangles[hit.triangle]));
    const double error = noise * random.normal();
    if (random.uniform() < chance_of_loss(cosine)) continue;
    measurements.push_back(
        {view.station + hit.distance * direction, error * direction, hit.triangle});
  }
  for (std::size_t i = measurements.size(); i > 1; --i) {
    std::swap(measurements[i - 1], measurements[random.uniform_index(i)]);
  }
  return measurements;
}

/// Direction through a place of a picture or panorama, in the frame of the view; not a unit vector.
Vec3 direction_in_view(const ScanView& view, double column, double row) {
  if (view.panoramic) {
    const double azimuth = column * view.step - kPi, elevation = row * view.step + kLowest;
    return {std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
            std::sin(elevation)};
  }
  return {(column - 0.5 * (view.columns - 1)) * view.step,
          (row - 0.5 * (view.rows - 1)) * view.step, 1.0};
}

}  // namespace

std::vector<Vec3> draw_ray_directions(const ScanView& view, Random& random) {
  std::vector<Vec3> directions;
  directions.reserve(static_cast<std::size_t>(view.columns) * static_cast<std::size_t>(view.rows));
  for (int row = 0; row < view.rows; ++row) {
    for (int column = 0; column < view.columns; ++column) {
      const double x = column + random.uniform(-0.5, 0.5), y = row + random.uniform(-0.5, 0.5);
      directions.push_back(view.world_from_view * direction_in_view(view, x, y).normalized());
    }
  }
  return directions;
}

std::vector<ScanView> plan_views(const DepositRecipe& recipe, const DepositScene& scene) {
  const Bounds box = bounds(scene.mesh);
  const Vec3 centre = 0.5 * (box.low + box.high);
  const Vec3 size = box.high - box.low;
  const double spacing = recipe.spacing();
  std::vector<ScanView> views;
  if (recipe.stations == ScanStations::kTripod) {
    std::vector<Vec2> places;
    for (const double x : {-1.0, 1.0}) {
      for (const double y : {-1.0, 1.0}) {
        places.push_back(centre.head<2>() +
                         Vec2(x * (0.5 * size.x() + kTripodMargin), y * 0.4 * size.y()));
      }
    }
    places.push_back(centre.head<2>() + Vec2(0.1 * size.x(), 0.55 * size.y() + kTripodMargin));
    const double step = spacing / (0.5 * size.head<2>().norm());
    for (const Vec2& place : places) {
      const double ground = height_near(scene.mesh, place);
      views.push_back(make_panorama({place.x(), place.y(), ground + kTripodHeight}, step));
    }
    return views;
  }
  const double height = kFlightHeight * size.head<2>().maxCoeff() + 0.5 * size.z();
  for (const double x : {-0.25, 0.25}) {
    for (const double y : {-0.25, 0.25}) {
      const Vec3 aside(x * size.x(), y * size.y(), 0.0);
      views.push_back(
          make_camera(centre + aside + height * Vec3::UnitZ(), centre + aside, scene, spacing));
    }
  }
  for (int i = 0; i < 8; ++i) {
    const double azimuth = (i + 0.5) * kPi / 4.0;
    const Vec3 towards(std::sin(kOblique) * std::cos(azimuth),
                       std::sin(kOblique) * std::sin(azimuth), std::cos(kOblique));
    views.push_back(make_camera(centre + height * towards, centre, scene, spacing));
  }
  return views;
}

std::vector<RayHit> cast_rays(const ScanView& view, std::span<const Vec3> directions,
                              const TriangleMesh& mesh) {
  std::vector<RayPlace> places;
  places.reserve(mesh.vertices.size());
  for (const Vec3& vertex : mesh.vertices) places.push_back(project(view, vertex));
  std::vector<RayHit> hits(directions.size());
  // Rays are anywhere in their pixels. A side of a panorama's triangle may also bulge a little out
  // of the box of its corners.
  const double bulge = view.panoramic ? 1.5 : 0.5;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [i, j, k] = mesh.triangles[t];
    const Vec3 a = mesh.vertices[i] - view.station;
    const Vec3 normal =
        (mesh.vertices[j] - mesh.vertices[i]).cross(mesh.vertices[k] - mesh.vertices[i]);
    const double height = normal.dot(a);
    if (!(height < 0.0)) continue;  // seen from inside
    RayPlace corners[3] = {places[i], places[j], places[k]};
    if (!corners[0].valid || !corners[1].valid || !corners[2].valid) continue;
    if (view.panoramic) {  // all corners on the same side of the seam
      for (RayPlace& corner : corners) {
        const double apart = corner.column - corners[0].column;
        if (apart > 0.5 * view.columns) corner.column -= view.columns;
        if (apart < -0.5 * view.columns) corner.column += view.columns;
      }
    }
    const auto [left, right] =
        std::minmax({corners[0].column, corners[1].column, corners[2].column});
    const auto [bottom, top] = std::minmax({corners[0].row, corners[1].row, corners[2].row});
    const int first_row = std::max(0, static_cast<int>(std::ceil(bottom - bulge)));
    const int last_row = std::min(view.rows - 1, static_cast<int>(std::floor(top + bulge)));
    int first_column = static_cast<int>(std::ceil(left - bulge));
    int last_column = static_cast<int>(std::floor(right + bulge));
    if (!view.panoramic) {
      first_column = std::max(0, first_column);
      last_column = std::min(view.columns - 1, last_column);
    }
    const Vec3 b = mesh.vertices[j] - view.station, c = mesh.vertices[k] - view.station;
    const Vec3 side_ab = a.cross(b), side_bc = b.cross(c), side_ca = c.cross(a);
    for (int row = first_row; row <= last_row; ++row) {
      for (int column = first_column; column <= last_column; ++column) {
        const int at = (column + view.columns) % view.columns;
        const std::size_t ray =
            static_cast<std::size_t>(row) * static_cast<std::size_t>(view.columns) +
            static_cast<std::size_t>(at);
        const Vec3& direction = directions[ray];
        // Spanned by the corners, as the outer side of the triangle faces the station.
        if (side_ab.dot(direction) > 0.0 || side_bc.dot(direction) > 0.0 ||
            side_ca.dot(direction) > 0.0) {
          continue;
        }
        const double distance = height / normal.dot(direction);
        RayHit& hit = hits[ray];
        if (hit.triangle == kNoIndex || distance < hit.distance) hit = {t, distance};
      }
    }
  }
  return hits;
}

DepositScan scan_deposit(const DepositRecipe& recipe, const DepositScene& scene, unsigned threads) {
  const double spacing = recipe.spacing();
  const double least =
      spacing * (recipe.stations == ScanStations::kDrone ? kDroneDistance : kTripodDistance);
  const std::vector<ScanView> views = plan_views(recipe, scene);
  Random random(recipe.seed + 3);
  std::vector<std::uint64_t> seeds;
  for (std::size_t v = 0; v < views.size(); ++v) seeds.push_back(random.next_bits());
  DepositScan scan;
  PointGrid kept(least);
  // As many views as threads at a time, to save memory.
  const std::size_t together = resolve_thread_count(threads);
  for (std::size_t first = 0; first < views.size(); first += together) {
    const std::size_t end = std::min(views.size(), first + together);
    std::vector<std::vector<Measurement>> measured(end - first);
    parallel_for(end - first, threads, [&](std::size_t i) {
      measured[i] =
          measure(views[first + i], scene, recipe.noise * spacing, Random(seeds[first + i]));
    });
    for (const std::vector<Measurement>& measurements : measured) {
      for (const Measurement& one : measurements) {
        if (kept.has_point_within(one.place, least)) continue;
        kept.add(one.place);
        const Vec3 position = one.place + one.error;
        scan.points.push_back({position.cast<float>(), one.triangle});
      }
    }
  }
  for (const ScanView& view : views) scan.stations.push_back(view.station);
  return scan;
}

}  // namespace clast
