#include "reconstruct/registration/detail/pose_check.hpp"

#include <algorithm>
#include <cmath>

#include "core/angle.hpp"
#include "core/error.hpp"
#include "core/number_text.hpp"

namespace clast::reconstruct_detail {

namespace {

/// Least overlap, and least fraction of the comparable surface that matches.
constexpr double kLeastMatched = 0.1, kLeastConsistency = 0.88;
/// Least overlap of scans whose poses are nearly known.
constexpr double kLeastNearMatched = 0.03;
/// Least consistency, and largest contradicted fraction for each scan of the group, of a pose that
/// was searched. At the true poses of 34 pairs of virtual scans (12 stones, 10 made rocks) the
/// consistency was at least 0.946 and the contradicted fraction at most 0.018; at the best wrong
/// poses, where the scans show opposite sides of a flat block, 0.076 and more were contradicted.
constexpr double kLeastSearchedConsistency = 0.92, kMostContradicted = 0.04;
/// A rival of the best pose has the least overlap, at least this consistency, and at most this
/// ratio of the mean square misfits. Its overlap may be much smaller: two scans of opposite sides
/// of a symmetric block overlap most where they show one side.
constexpr double kRivalConsistency = 0.82, kRivalMisfit = 2.0;
/// Steps in which a surface is moved along others to see whether that gives another body: their
/// length, relative to the diagonal, and their number.
constexpr double kSlide = 0.1;
constexpr int kSlides = 10;
constexpr std::size_t kNamedPoses = 3;
/// A difference of scales counts if it is larger than this and than so many standard errors.
constexpr double kScaleDifference = 0.005, kScaleErrors = 3.0;
constexpr std::size_t kScaledPoses = 5;  ///< poses at which other scales are tried

/// Rotation as "x=10,y=20,z=30": degrees about x, then y, then z.
std::string format_rotation(const Quat& rotation) {
  const Mat3 r = rotation.toRotationMatrix();
  const double y = std::asin(std::clamp(-r(2, 0), -1.0, 1.0));
  const double x = std::atan2(r(2, 1), r(2, 2)), z = std::atan2(r(1, 0), r(0, 0));
  const auto degrees = [](double angle) {
    return std::to_string(std::lround(angle * kDegreesPerRadian));
  };
  return "x=" + degrees(x) + ",y=" + degrees(y) + ",z=" + degrees(z);
}

/// Names the scan and the group, as the beginning of a message.
std::string name_scans(const ScanToAdd& scan) { return scan.name + " and " + scan.group_names; }

/// States the scale at which a scan fits; empty if there is none.
std::string describe_scale(const ScanToAdd& scan, const std::vector<PoseCandidate>& poses) {
  if (scan.has_free_scale) return "";
  for (std::size_t i = 0; i < std::min(kScaledPoses, poses.size()); ++i) {
    const ScaleEstimate estimate =
        estimate_scale(scan.group, {scan.surface, poses[i].fixed_from_moving});
    if (estimate.agreement.consistency() < kLeastConsistency ||
        estimate.agreement.matched < kLeastMatched || !is_scale_different(estimate)) {
      continue;
    }
    return " They fit if lengths of " + scan.name + " are multiplied by " +
           format_significant(estimate.scale, 5) + " +- " +
           format_significant(estimate.standard_error, 1);
  }
  return "";
}

void refuse_disagreement(const ScanToAdd& scan, const std::vector<PoseCandidate>& poses) {
  const SurfaceAgreement& best = poses[0].agreement;
  const bool was_searched = !scan.is_near && !scan.is_picked;
  const double most = kMostContradicted * static_cast<double>(scan.group.size());
  const bool fits =
      was_searched ? best.consistency() >= kLeastSearchedConsistency && best.contradicted <= most
                   : best.consistency() >= kLeastConsistency;
  if (fits) return;
  const Disagreement found =
      measure_disagreement(scan.group, {scan.surface, poses[0].fixed_from_moving});
  throw GeometryError(name_scans(scan) + ": at the best pose the scans disagree by " +
                      format_significant(found.distance, 2) + " m over " +
                      format_percent_of(found.fraction) +
                      " of their overlap: scale, movement, a mirrored scan or another block?" +
                      describe_scale(scan, poses));
}

/// True if a better pose of the list is nearly the same.
bool is_known(const ScanToAdd& scan, const std::vector<PoseCandidate>& poses, std::size_t index) {
  constexpr double kNear = 0.02;  // relative to the diagonal
  const double size = scan.surface->diagonal;
  return std::any_of(poses.begin(), poses.begin() + static_cast<std::ptrdiff_t>(index),
                     [&](const PoseCandidate& better) {
                       return are_near(better.fixed_from_moving, poses[index].fixed_from_moving,
                                       Vec3::Zero(), 0.5 * size, kNear * size);
                     });
}

/// Refuses poses that are nearly as good as the best and give other bodies.
/// @returns number of poses that give the same body as the best, itself included
std::size_t refuse_other_bodies(const ScanToAdd& scan, const std::vector<PoseCandidate>& poses) {
  std::vector<Quat> others = {poses[0].fixed_from_moving.pose.rotation};
  std::size_t same = 1;
  if (scan.is_picked) return same;
  for (std::size_t i = 1; i < poses.size(); ++i) {
    const PoseCandidate& rival = poses[i];
    if (rival.agreement.matched < kLeastMatched ||
        rival.agreement.consistency() < kRivalConsistency ||
        rival.agreement.misfit > kRivalMisfit * poses[0].agreement.misfit ||
        is_known(scan, poses, i)) {
      continue;
    }
    if (is_same_body(scan.group, *scan.surface, poses[0].fixed_from_moving,
                     rival.fixed_from_moving)) {
      ++same;
    } else {
      others.push_back(rival.fixed_from_moving.pose.rotation);
    }
  }
  if (others.size() < 2) return same;
  std::string list;
  for (std::size_t i = 0; i < std::min(kNamedPoses, others.size()); ++i) {
    list += (i == 0 ? "" : " or ") + format_rotation(scan.first_from_group * others[i]);
  }
  throw GeometryError(name_scans(scan) + ": they fit in " + std::to_string(others.size()) +
                      " poses that give different bodies (" + list +
                      ", degrees that turn the scan to the first); state one as `pose`, or give "
                      "the same three places of both as `picked`");
}

/// Refuses a pose from which the surface can slide along the others and make another body.
void refuse_sliding(const ScanToAdd& scan, const PoseCandidate& best) {
  for (const PoseStep& movement : best.free_movements) {
    for (const double distance : {kSlide, -kSlide}) {
      const PoseStep step = distance * scan.surface->diagonal * movement;
      Similarity moved = best.fixed_from_moving;
      for (int i = 0; i < kSlides; ++i) {
        const PlacedSurface next{scan.surface, moved_by_step(moved, step)};
        moved = refine_in_group(scan.group, next).fixed_from_moving;
      }
      if (is_same_body(scan.group, *scan.surface, best.fixed_from_moving, moved)) continue;
      throw GeometryError(name_scans(scan) +
                          ": the surfaces that both show can slide along each other, so the "
                          "pose is not determined; scan more of the block from both sides, or "
                          "give the same three places of both as `picked`");
    }
  }
}

}  // namespace

std::size_t check_best_pose(const ScanToAdd& scan, const std::vector<PoseCandidate>& poses) {
  const double least = scan.is_near ? kLeastNearMatched : kLeastMatched;
  if (poses.empty() || poses[0].agreement.matched < least) {
    throw GeometryError(name_scans(scan) + ": no pose was found at which they share at least " +
                        format_percent_of(least) +
                        " of a surface; are they scans of one block? If so, `pose` or `picked` "
                        "give the pose");
  }
  refuse_disagreement(scan, poses);
  const std::size_t same = refuse_other_bodies(scan, poses);
  refuse_sliding(scan, poses[0]);
  return same;
}

bool is_scale_different(const ScaleEstimate& estimate) {
  const double difference = std::abs(std::log(estimate.scale));
  return difference > kScaleDifference && difference > kScaleErrors * estimate.standard_error;
}

std::string format_percent_of(double fraction) {
  return format_significant(100.0 * fraction, 2) + " %";
}

}  // namespace clast::reconstruct_detail
