#include "reconstruct/registration/detail/picked_pose.hpp"

#include <Eigen/SVD>
#include <cmath>

#include "core/error.hpp"
#include "core/number_text.hpp"

namespace clast::reconstruct_detail {

namespace {

constexpr double kLargestMisfit = 0.1;  ///< of the diagonal
constexpr double kOnLine = 0.02;        ///< width over length of places that lie on a line

}  // namespace

void check_pairs(const std::vector<PickedPair>& pairs, std::size_t scans) {
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const PickedPair& pair = pairs[i];
    const std::string which = "picked pair " + std::to_string(i + 1);
    if (pair.scan_a >= scans || pair.scan_b >= scans) {
      throw InputError(which + " is of a scan that is not among the " + std::to_string(scans));
    }
    if (pair.scan_a == pair.scan_b) throw InputError(which + " is of one scan; two are needed");
    if (!pair.point_a.allFinite() || !pair.point_b.allFinite()) {
      throw InputError(which + " has a coordinate that is not finite");
    }
  }
}

Similarity fit_picked_pairs(const std::vector<std::pair<Vec3, Vec3>>& pairs,
                            const std::string& name, double diagonal) {
  const auto count = static_cast<double>(pairs.size());
  Vec3 to_centre = Vec3::Zero(), from_centre = Vec3::Zero();
  for (const auto& [to, from] : pairs) {
    to_centre += to / count;
    from_centre += from / count;
  }
  Mat3 product = Mat3::Zero();
  for (const auto& [to, from] : pairs) {
    product += (to - to_centre) * (from - from_centre).transpose();
  }
  const Eigen::JacobiSVD<Mat3> svd(product, Eigen::ComputeFullU | Eigen::ComputeFullV);
  if (svd.singularValues()[1] <= kOnLine * kOnLine * svd.singularValues()[0]) {
    throw InputError(name +
                     ": its picked places lie on a line, which leaves a rotation open; pick "
                     "three places that span the block");
  }
  Mat3 sign = Mat3::Identity();
  sign(2, 2) = svd.matrixU().determinant() * svd.matrixV().determinant() < 0.0 ? -1.0 : 1.0;
  const Mat3 rotation = svd.matrixU() * sign * svd.matrixV().transpose();
  const Similarity pose{{to_centre - rotation * from_centre, Quat(rotation).normalized()}, 1.0};
  double worst = 0.0;
  for (const auto& [to, from] : pairs) worst = std::max(worst, (pose * from - to).norm());
  if (worst > kLargestMisfit * diagonal) {
    throw InputError(name + ": its picked places do not fit by " + format_significant(worst, 2) +
                     " m; check the coordinates, the units and which place belongs to which");
  }
  return pose;
}

}  // namespace clast::reconstruct_detail
