#pragma once
/// Two scans of one block that lies on its ground, turned over in between.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/pose.hpp"
#include "core/random.hpp"
#include "mesh/triangle_mesh.hpp"
#include "mesh/triangle_tree.hpp"
#include "tests/support/surface_sampler.hpp"

namespace clast {

/// Properties of a partial scan. Lengths are relative to the largest extent of the block.
struct PartialScanRecipe {
  std::size_t points = 6000;    ///< on the block
  double noise = 0.002;         ///< standard deviation along the line of sight
  double ground_points = 1.0;   ///< density of ground points relative to that on the block; 0: none
  double ground_noise = 0.004;  ///< roughness of the ground
  double sunk = 0.0;            ///< depth of the lowest point of the block below the ground
  double first_azimuth = 0.0, azimuths = 2.0 * kPi;  ///< sector of the stations, rad
  /// Elevations of the stations, in turn, rad.
  double low_elevation = 20.0 * kPi / 180.0, high_elevation = 50.0 * kPi / 180.0;
};

struct PartialScan {
  std::vector<Vec3> points;  ///< block, then ground
  std::size_t on_block = 0;  ///< number of points on the block
  Pose scan_from_block;      ///< pose of the block in the scan
};

/// Scanner of one body.
class PartialScanner {
 public:
  /// @param body  closed, outward; must outlive this
  explicit PartialScanner(const TriangleMesh& body) : body_(body), tree_(body), sampler_(body) {
    Bounds box = bounds(body);
    size_ = (box.high - box.low).maxCoeff();
    centre_ = 0.5 * (box.low + box.high);
  }

  double size() const { return size_; }

  /// Stations around the block in its own frame.
  std::vector<Vec3> stations(const Quat& scan_from_block, const PartialScanRecipe& recipe) const {
    std::vector<Vec3> places;
    for (int i = 0; i < 8; ++i) {
      const double azimuth = recipe.first_azimuth + recipe.azimuths * (i + 0.5) / 8.0;
      const double elevation = i % 2 == 0 ? recipe.low_elevation : recipe.high_elevation;
      const Vec3 towards(std::cos(elevation) * std::cos(azimuth),
                         std::cos(elevation) * std::sin(azimuth), std::sin(elevation));
      places.push_back(centre_ + 3.0 * size_ * (scan_from_block.conjugate() * towards));
    }
    return places;
  }

  /// True if the station sees the point of the surface.
  bool sees(const Vec3& station, const SurfaceSampler::Drawn& drawn) const {
    const Vec3 ray = (station - drawn.point).normalized();
    const Vec3 normal = unit_normal(body_, drawn.triangle);
    if (normal.dot(ray) < 0.15) return false;
    return !tree_.first_exit(drawn.point + 1e-6 * size_ * normal, ray, kNoIndex);
  }

  /// Fraction of the smaller of two observed surfaces that the other scan observes too.
  double overlap(const Quat& first, const PartialScanRecipe& of_first, const Quat& second,
                 const PartialScanRecipe& of_second, Random& random) const {
    const std::vector<Vec3> a = stations(first, of_first), b = stations(second, of_second);
    double in_first = 0.0, in_second = 0.0, in_both = 0.0;
    for (int i = 0; i < 600; ++i) {
      const SurfaceSampler::Drawn drawn = sampler_.draw(random);
      const auto seen = [&](const std::vector<Vec3>& from) {
        return std::any_of(from.begin(), from.end(),
                           [&](const Vec3& station) { return sees(station, drawn); });
      };
      const bool by_first = seen(a), by_second = seen(b);
      in_first += by_first;
      in_second += by_second;
      in_both += by_first && by_second;
    }
    return in_both / std::max(1.0, std::min(in_first, in_second));
  }

  PartialScan scan(const Quat& scan_from_block, const PartialScanRecipe& recipe,
                   Random& random) const {
    PartialScan made;
    double low = 1e300;
    for (const Vec3& v : body_.vertices) low = std::min(low, (scan_from_block * v).z());
    const Vec3 middle = scan_from_block * centre_;
    made.scan_from_block = {Vec3(-middle.x(), -middle.y(), -low - recipe.sunk * size_),
                            scan_from_block};
    const std::vector<Vec3> from = stations(scan_from_block, recipe);
    std::size_t drawn_points = 0;
    while (made.points.size() < recipe.points) {
      const SurfaceSampler::Drawn drawn = sampler_.draw(random);
      ++drawn_points;
      const Vec3& station = from[random.uniform_index(from.size())];
      if (!sees(station, drawn)) continue;
      const Vec3 placed = made.scan_from_block * drawn.point;
      if (placed.z() < 0.0) continue;
      const Vec3 sight = scan_from_block * (station - drawn.point).normalized();
      made.points.push_back(placed + recipe.noise * size_ * random.normal() * sight);
    }
    made.on_block = made.points.size();
    add_ground(made, from, recipe, random);
    return made;
  }

 private:
  void add_ground(PartialScan& made, const std::vector<Vec3>& from, const PartialScanRecipe& recipe,
                  Random& random) const {
    const double half = 1.3 * size_;
    const double density = static_cast<double>(made.on_block) / (0.6 * surface_area(body_));
    const auto count = static_cast<std::size_t>(recipe.ground_points * density * 4.0 * half * half);
    const Pose back = made.scan_from_block.inverse();
    for (std::size_t i = 0; i < count; ++i) {
      const Vec3 place(random.uniform(-half, half), random.uniform(-half, half), 0.0);
      const Vec3 in_block = back * place;
      const Vec3 station = from[random.uniform_index(from.size())];
      if (tree_.signed_distance(in_block) < 0.0) continue;
      if (tree_.first_exit(in_block, (station - in_block).normalized(), kNoIndex)) continue;
      made.points.push_back(place + Vec3(0, 0, recipe.ground_noise * size_ * random.normal()));
    }
  }

  const TriangleMesh& body_;
  TriangleTree tree_;
  SurfaceSampler sampler_;
  double size_ = 0.0;
  Vec3 centre_ = Vec3::Zero();
};

/// Two scans with an overlap in a range, and a body turned over between them by 60 to 180 degrees.
struct ScanPair {
  PartialScan first, second;
  double overlap = 0.0;
};

/// Stations in a sector of 90 to 360 degrees, the lower ones at elevations of 15 to 50 degrees.
inline PartialScanRecipe with_random_stations(PartialScanRecipe recipe, Random& random) {
  recipe.first_azimuth = random.uniform(0.0, 2.0 * kPi);
  recipe.azimuths = random.uniform(0.5 * kPi, 2.0 * kPi);
  recipe.low_elevation = random.uniform(15.0, 50.0) * kPi / 180.0;
  recipe.high_elevation = recipe.low_elevation + 30.0 * kPi / 180.0;
  return recipe;
}

/// Turns a body by 60 to 180 degrees about a horizontal axis, then about the vertical.
inline Quat turned_over(const Quat& pose, Random& random) {
  const double heading = random.uniform(0.0, 2.0 * kPi);
  const double turn = random.uniform(kPi / 3.0, kPi);
  const Vec3 axis(std::cos(heading), std::sin(heading), 0.0);
  return Quat(Eigen::AngleAxisd(random.uniform(0.0, 2.0 * kPi), Vec3::UnitZ())) *
         Quat(Eigen::AngleAxisd(turn, axis)) * pose;
}

/// Overlaps are evenly spread over their range, as far as turned bodies have them.
/// @param least, most  range of the overlap
inline ScanPair make_scan_pair(const PartialScanner& scanner, PartialScanRecipe of_first,
                               PartialScanRecipe of_second, double least, double most,
                               Random& random) {
  constexpr double kClose = 0.02;
  constexpr int kTries = 60;
  for (;;) {
    const double aim = random.uniform(least, most);
    for (int i = 0; i < kTries; ++i) {
      const Quat first = random.rotation();
      const Quat second = turned_over(first, random);
      of_first = with_random_stations(of_first, random);
      of_second = with_random_stations(of_second, random);
      const double overlap = scanner.overlap(first, of_first, second, of_second, random);
      if (overlap < least || overlap > most || std::abs(overlap - aim) > kClose) continue;
      return {scanner.scan(first, of_first, random), scanner.scan(second, of_second, random),
              overlap};
    }
  }
}

/// Scans of a body that is turned over before each of them by 60 to 180 degrees.
struct ScanChain {
  std::vector<PartialScan> scans;
  double overlap = 0.0;  ///< least overlap of a scan and the one before
};

/// Each scan overlaps the one before by a fraction in a range.
inline ScanChain make_scan_chain(const PartialScanner& scanner,
                                 std::vector<PartialScanRecipe> recipes, double least, double most,
                                 Random& random) {
  std::vector<Quat> poses = {random.rotation()};
  recipes[0] = with_random_stations(recipes[0], random);
  ScanChain chain;
  chain.overlap = most;
  while (poses.size() < recipes.size()) {
    PartialScanRecipe& next = recipes[poses.size()];
    const Quat pose = turned_over(poses.back(), random);
    next = with_random_stations(next, random);
    const double overlap =
        scanner.overlap(poses.back(), recipes[poses.size() - 1], pose, next, random);
    if (overlap < least || overlap > most) continue;
    chain.overlap = std::min(chain.overlap, overlap);
    poses.push_back(pose);
  }
  for (std::size_t i = 0; i < poses.size(); ++i) {
    chain.scans.push_back(scanner.scan(poses[i], recipes[i], random));
  }
  return chain;
}

}  // namespace clast
