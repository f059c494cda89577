#include "reconstruct/ground/blocks_on_ground.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "reconstruct/cloud/cloud.hpp"

namespace clast {

namespace {

constexpr double kClear = 3.0;       ///< times the roughness: certainly above the ground
constexpr double kSmoothest = 3e-4;  ///< of the diagonal; a ground made by a program has none
constexpr double kThinCell =
    1.0 / 200.0;  ///< of the diagonal: components are separated on fewer points
constexpr double kComponentReach = 2.5;         ///< cells from one point of a component to the next
constexpr double kMinFractionOfLargest = 0.05;  ///< of the points of the largest component
constexpr double kSlenderest = 0.1;  ///< height over plan diagonal; a step in the ground has less
/// Continuation of a wall to the ground: step in roughnesses, number of points of the fitted plane,
/// and width of their band in steps.
constexpr double kStep = 0.5;
constexpr int kWallPoints = 24;
constexpr int kBandSteps = 6;
/// Uncertainty of a continued wall, as a fraction of the distance from these points.
constexpr double kWallSpread = 0.15;
/// Cosine to the ground's normal above which it is no wall; undercut walls face down.
constexpr double kSteep = 0.9;

/// A wall as it is known near a point.
struct Wall {
  Vec3 normal;
  double off;      ///< of the point, outwards from the block, m
  double spread;   ///< standard deviation of the wall there, m
  double nearest;  ///< distance of the nearest point of the wall, m
};

Wall wall_near(const Vec3& point, const Vec3& block_centre, std::span<const Vec3> band,
               const reconstruct_detail::PointTree& tree) {
  const std::vector<reconstruct_detail::PointTree::Neighbour> near =
      tree.nearest_neighbours(point, kWallPoints);
  Vec3 centre = Vec3::Zero();
  for (const auto& n : near) centre += band[n.point] / static_cast<double>(near.size());
  Mat3 scatter = Mat3::Zero();
  for (const auto& n : near) {
    scatter += (band[n.point] - centre) * (band[n.point] - centre).transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Mat3> solver(scatter / static_cast<double>(near.size()));
  Vec3 normal = solver.eigenvectors().col(0);
  if (normal.dot(centre - block_centre) < 0.0) normal = -normal;
  const double rough = std::sqrt(std::max(0.0, solver.eigenvalues()[0]));
  return {normal, normal.dot(point - centre), rough + kWallSpread * near.front().distance,
          near.front().distance};
}

/// Components of decimated points above the ground, as they are seen from it.
struct RisingComponent {
  std::vector<Vec3> points;
  double height = 0.0, plan_diagonal = 0.0;
  Vec3 centre = Vec3::Zero();
};

class Standing {
 public:
  Standing(std::span<const Vec3> points, const Ground& ground,
           const GroundDetectionOptions& options)
      : points_(points), ground_(ground), options_(options) {
    for (const Vec3& p : points) box_.include(p);
    cell_ = kThinCell * box_.diagonal();
    roughness_ = std::max(ground.roughness(), kSmoothest * box_.diagonal());
    clear_ = kClear * roughness_;
    turn_ = Quat::FromTwoVectors(ground.plane().normal, Vec3::UnitZ());
  }

  BlocksOnGround run() {
    heights_.reserve(points_.size());
    for (const Vec3& p : points_) heights_.push_back(ground_.height_above_ground(p));
    find_components();
    BlocksOnGround result;
    if (components_.empty()) {
      for (std::uint32_t i = 0; i < points_.size(); ++i) result.ground.push_back(i);
      return result;
    }
    share_out(result);
    result.central_block = central_component();
    return result;
  }

 private:
  void find_components() {
    std::vector<Vec3> above;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      if (heights_[i] > clear_) above.push_back(points_[i]);
    }
    if (above.empty()) return;
    const std::vector<Vec3> sparse = reconstruct_detail::decimate_points(above, cell_);
    for (const std::vector<std::uint32_t>& set :
         reconstruct_detail::find_clusters(sparse, kComponentReach * cell_, 10)) {
      if (!components_.empty() &&
          static_cast<double>(set.size()) <
              kMinFractionOfLargest * static_cast<double>(components_.front().points.size())) {
        break;
      }
      RisingComponent component;
      Bounds box, plan;
      for (const std::uint32_t i : set) {
        component.points.push_back(sparse[i]);
        component.height = std::max(component.height, ground_.height_above_ground(sparse[i]));
        box.include(sparse[i]);
        const Vec3 flat = turn_ * sparse[i];
        plan.include({flat.x(), flat.y(), 0.0});
      }
      component.centre = 0.5 * (box.low + box.high);
      component.plan_diagonal = plan.diagonal();
      const bool rises = component.height > options_.min_block_height * box_.diagonal() &&
                         component.height > 2.0 * clear_ &&
                         component.height > kSlenderest * component.plan_diagonal;
      if (rises) components_.push_back(std::move(component));
    }
    std::stable_sort(components_.begin(), components_.end(),
                     [](const RisingComponent& a, const RisingComponent& b) {
                       return a.centre.x() != b.centre.x() ? a.centre.x() < b.centre.x()
                                                           : a.centre.y() < b.centre.y();
                     });
  }

  /// Every point to the component it is nearest to, to the ground, or to neither.
  void share_out(BlocksOnGround& result) const {
    std::vector<Vec3> all;
    std::vector<std::uint32_t> component_of;
    for (std::uint32_t k = 0; k < components_.size(); ++k) {
      const RisingComponent& component = components_[k];
      all.insert(all.end(), component.points.begin(), component.points.end());
      component_of.insert(component_of.end(), component.points.size(), k);
      result.blocks.push_back({{}, component.centre, component.height});
    }
    const reconstruct_detail::PointTree tree(all);
    std::vector<std::int64_t> owner(points_.size(), -1);
    std::vector<std::uint32_t> strip;
    for (std::uint32_t i = 0; i < points_.size(); ++i) {
      if (heights_[i] < -clear_) continue;
      const auto near = tree.nearest_neighbours(points_[i], 1).front();
      if (heights_[i] <= clear_) {
        if (near.distance < 2.0 * clear_ + kComponentReach * cell_) strip.push_back(i);
      } else if (near.distance < kComponentReach * cell_) {
        owner[i] = component_of[near.point];
      }
    }
    follow_walls(strip, owner);
    for (std::uint32_t i = 0; i < points_.size(); ++i) {
      if (owner[i] >= 0) {
        result.blocks[static_cast<std::size_t>(owner[i])].points.push_back(i);
      } else if (std::abs(heights_[i]) <= clear_) {
        result.ground.push_back(i);
      }
    }
  }

  /// Goes down the walls into the gravel. Densities of wall and ground are compared, each a bell
  /// curve across its surface; no ground is seen behind a wall.
  void follow_walls(const std::vector<std::uint32_t>& strip,
                    std::vector<std::int64_t>& owner) const {
    const double step = kStep * roughness_;
    const double reach = kBandSteps * step;
    for (double top = clear_; top > -clear_; top -= step) {
      std::vector<Vec3> band;
      std::vector<std::int64_t> owner_of;
      for (std::size_t i = 0; i < points_.size(); ++i) {
        if (owner[i] < 0 || heights_[i] > top + reach) continue;
        band.push_back(points_[i]);
        owner_of.push_back(owner[i]);
      }
      if (band.size() < kWallPoints) return;
      const reconstruct_detail::PointTree walls(band);
      for (const std::uint32_t i : strip) {
        if (heights_[i] > top || heights_[i] <= top - step) continue;
        const auto near = walls.nearest_neighbours(points_[i], 1).front();
        if (near.distance > reach) continue;
        const std::int64_t block = owner_of[near.point];
        const Wall wall =
            wall_near(points_[i], components_[static_cast<std::size_t>(block)].centre, band, walls);
        if (wall.normal.dot(ground_.plane().normal) > kSteep) continue;
        const double across = std::max(0.0, wall.off) / wall.spread;
        const double up = heights_[i] / roughness_;
        if (across * across + 2.0 * std::log(wall.spread) < up * up + 2.0 * std::log(roughness_)) {
          owner[i] = block;
        }
      }
    }
  }

  /// High, and near the middle: height times a bell curve of the distance in plan.
  std::size_t central_component() const {
    Bounds plan;
    for (const Vec3& p : points_) {
      const Vec3 flat = turn_ * p;
      plan.include({flat.x(), flat.y(), 0.0});
    }
    const Vec3 middle = 0.5 * (plan.low + plan.high);
    const double half = 0.5 * plan.diagonal();
    std::size_t best = 0;
    double best_weight = -1.0;
    for (std::size_t k = 0; k < components_.size(); ++k) {
      const Vec3 flat = turn_ * components_[k].centre;
      const double away = (flat - middle).head<2>().norm() / half;
      const double weight = components_[k].height * std::exp(-4.0 * away * away);
      if (weight > best_weight) {
        best_weight = weight;
        best = k;
      }
    }
    return best;
  }

  std::span<const Vec3> points_;
  const Ground& ground_;
  const GroundDetectionOptions& options_;
  Bounds box_;
  double cell_ = 0.0, roughness_ = 0.0, clear_ = 0.0;
  Quat turn_;
  std::vector<double> heights_;
  std::vector<RisingComponent> components_;
};

}  // namespace

BlocksOnGround find_blocks_on_ground(std::span<const Vec3> points, const Ground& ground,
                                     const GroundDetectionOptions& options) {
  return Standing(points, ground, options).run();
}

}  // namespace clast
