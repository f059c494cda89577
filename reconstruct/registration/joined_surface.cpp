#include "reconstruct/registration/joined_surface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "core/number_text.hpp"
#include "mesh/triangle_mesh.hpp"
#include "reconstruct/registration/detail/scan_group.hpp"

namespace clast {

namespace {

using namespace reconstruct_detail;

/// Standard deviations of the position by which each end of a side may be off.
constexpr double kPoseErrors = 2.0;
/// Standard deviations of the volume by which it may be off.
constexpr double kVolumeErrors = 3.0;
/// Registration errors that the noise does not explain, as a fraction of the deviation of the
/// surfaces in the overlap.
constexpr double kUnexplained = 0.25;

/// Oriented surfaces of all scans in the frame of the first.
class PlacedScans {
 public:
  PlacedScans(const std::vector<ScanToRegister>& scans, const Registration& fit) : fit_(fit) {
    double cell = 0.0;
    for (std::size_t s = 0; s < scans.size(); ++s) {
      std::vector<Vec3> placed;
      for (const Vec3& p : scans[s].points) placed.push_back(fit.first_from_scan[s] * p);
      cell = std::max(cell, registration_cell(placed));
      points_.push_back(std::move(placed));
    }
    for (const std::vector<Vec3>& placed : points_) {
      surfaces_.push_back(
          std::make_unique<SampledSurface>(orient_surface(placed, cell, std::nullopt)));
    }
  }

  const std::vector<std::vector<Vec3>>& points() const { return points_; }

  /// Normal of a scan's surface near a point, and its relation to the other scans.
  struct Place {
    PointRelation relation = PointRelation::kUnobserved;
    double height = std::numeric_limits<double>::quiet_NaN();
    std::size_t scans = 1;  ///< that observed the place
  };
  Place compare(std::size_t scan, const Vec3& position, const Vec3& normal) const {
    Place place;
    for (std::size_t other = 0; other < surfaces_.size(); ++other) {
      if (other == scan) continue;
      const SampledSurface& to = *surfaces_[other];
      const double tolerance = fine_tolerance(surfaces_[scan]->surface, to.surface,
                                              std::min(surfaces_[scan]->diagonal, to.diagonal));
      const PointComparison found = compare_point(to, position, normal, kWide * tolerance);
      if (found.relation == PointRelation::kMatched) {
        ++place.scans;
        if (!(std::abs(place.height) <= std::abs(found.height))) place.height = found.height;
        place.relation = PointRelation::kMatched;
      } else if (found.relation == PointRelation::kContradicted &&
                 place.relation != PointRelation::kMatched) {
        place.relation = PointRelation::kContradicted;
      }
    }
    return place;
  }

  Place compare_scanned(std::size_t scan, const Vec3& position) const {
    const std::uint32_t near = surfaces_[scan]->grid.nearest_point(position);
    return compare(scan, position, surfaces_[scan]->surface.normals[near]);
  }

  /// Adds the effect of pose errors on volume and sides.
  void add_uncertainty(SurfaceUncertainty& uncertainty) const {
    const double systematic = kUnexplained * fit_.deviation;
    double variance = 0.0, farthest = 0.0, area = 0.0;
    Eigen::VectorXd gradient = Eigen::VectorXd::Zero(fit_.covariance.rows());
    for (std::size_t s = 0; s < surfaces_.size(); ++s) {
      const OrientedSurface& own = surfaces_[s]->surface;
      const Vec3 origin = fit_.first_from_scan[s].pose.translation;
      for (std::size_t i = 0; i < own.size(); ++i) {
        const double weight = own.spacing * own.spacing /
                              static_cast<double>(compare(s, own.points[i], own.normals[i]).scans);
        area += weight;
        if (s == 0) continue;
        Eigen::Matrix<double, 7, 1> change;
        change << (own.points[i] - fit_.centre).cross(own.normals[i]), own.normals[i],
            own.normals[i].dot(own.points[i] - origin);
        const auto at = static_cast<Eigen::Index>(7 * (s - 1));
        gradient.segment<7>(at) += weight * change;
        const double square = change.dot(fit_.covariance.block<7, 7>(at, at) * change);
        farthest = std::max(farthest, square);
      }
    }
    if (gradient.size() > 0) variance = gradient.dot(fit_.covariance * gradient);
    const double volume = kVolumeErrors * std::sqrt(std::max(0.0, variance)) + systematic * area;
    uncertainty.volume_below += volume;
    uncertainty.volume_above += volume;
    uncertainty.extent_error += kPoseErrors * std::sqrt(farthest) + systematic;
  }

 private:
  static constexpr double kWide = 2.0;  ///< tolerances within which points are on the surface
  const Registration& fit_;
  std::vector<std::vector<Vec3>> points_;
  std::vector<std::unique_ptr<SampledSurface>> surfaces_;
};

}  // namespace

JoinedSurface join_surfaces(const std::vector<ScanToRegister>& scans, const Registration& fit,
                            const CloudSurfaceOptions& options) {
  const PlacedScans placed(scans, fit);
  JoinedSurface joined;
  std::vector<Vec3> all;
  std::size_t left_out = 0;
  for (std::size_t s = 0; s < scans.size(); ++s) {
    JoinedPoints kept;
    for (const Vec3& p : placed.points()[s]) {
      const PlacedScans::Place place = placed.compare_scanned(s, p);
      if (place.relation == PointRelation::kContradicted) {
        ++left_out;
        continue;
      }
      kept.points.push_back(p);
      kept.distances.push_back(place.height);
    }
    all.insert(all.end(), kept.points.begin(), kept.points.end());
    joined.scans.push_back(std::move(kept));
  }
  if (left_out > 0) {
    joined.notes.push_back(format_count(left_out, "point") +
                           " left out where another scan saw no surface");
  }
  joined.cloud = fit_cloud_surface(all, options);
  placed.add_uncertainty(joined.cloud.uncertainty);
  return joined;
}

}  // namespace clast
