#pragma once
/// Registration of several scans of one block, without initial poses.
#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/progress.hpp"
#include "mesh/plane.hpp"
#include "reconstruct/registration/similarity.hpp"

namespace clast {

/// Points of a block in one scan, without ground and outliers.
struct ScanToRegister {
  std::string name;                  ///< for messages
  std::vector<Vec3> points;          ///< m
  std::optional<Plane> ground = {};  ///< ground on which the block lay; its normal points up
};

/// The same place of the block in two scans, m.
struct PickedPair {
  std::size_t scan_a = 0, scan_b = 0;
  Vec3 point_a = Vec3::Zero(), point_b = Vec3::Zero();
};

/// Rotation of a scan relative to the first, as far as it is known.
struct PoseHint {
  std::size_t scan = 0;
  Quat first_from_scan = Quat::Identity();  ///< right within 30 degrees
};

struct RegistrationOptions {
  std::vector<PoseHint> hints = {};
  std::vector<PickedPair> pairs = {};  ///< three or more for each scan that they register
  /// True if all scans have the same frame, in which they are displaced by at most a few percent of
  /// their size, and the same scale: poses are refined without a search.
  bool nearly_aligned = false;
  /// True if the scales of all scans but the first are unknown, and are estimated.
  bool free_scale = false;
  unsigned threads = 1;  ///< number of threads, 0: one per core; does not affect the result
  ProgressCallback progress = {};  ///< called with the name of each step before it starts
};

/// Estimated scale of a scan.
struct FoundScale {
  std::size_t scan = 0;
  double scale = 1.0;           ///< metres per unit of the scan
  double standard_error = 0.0;  ///< of `scale`
};

/// Scans in the frame of the first.
struct Registration {
  /// The identity for the first; scales are 1 unless they were free.
  std::vector<Similarity> first_from_scan;
  std::vector<FoundScale> scales = {};  ///< of the scans with free scales
  /// Covariance of rotation (rad), translation (m) and logarithm of the scale of the scans but the
  /// first, seven rows each, about `centre`.
  Eigen::MatrixXd covariance;
  Vec3 centre = Vec3::Zero();  ///< centre of the rotations, in the frame of the first scan
  double overlap = 0.0;        ///< least fraction of a scan that the others observed too
  double deviation = 0.0;      ///< root mean square distance of the surfaces in the overlap, m
  double disagreement = 0.0;   ///< distance beyond the noise, m; 0 if there is none
  double disagreeing_fraction = 0.0;  ///< fraction of the overlap with such distances
  double noise = 0.0;                 ///< standard deviation of the points of the noisiest scan, m
  std::vector<std::string> notes;
};

/// Finds the poses at which scans show one block.
///
/// All rotations are searched, and translations by votes of points with parallel normals. A pose
/// is judged by the surfaces that coincide, and by points of one scan where the other saw free
/// space or another surface. Scans are joined to the first pair in the order of their agreement,
/// and all poses are refined together.
/// @param scans  two to eight
/// @throws InputError  if the number of scans, a pair or a hint is invalid
/// @throws GeometryError  if the scans do not fit, if they disagree, if they fit in several poses
///                        that give different bodies, or if their scales differ
Registration register_scans(const std::vector<ScanToRegister>& scans,
                            const RegistrationOptions& options = {});

}  // namespace clast
