#include "reconstruct/registration/detail/rotation_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>

#include "core/parallel.hpp"
#include "mesh/triangle_mesh.hpp"

namespace clast::reconstruct_detail {

namespace {

constexpr std::size_t kRotations = 12000;  ///< about 11 degrees apart
constexpr std::size_t kPerTask = 100;      ///< rotations per parallel task
constexpr std::size_t kPeaks = 6;          ///< translations of each rotation
constexpr double kCell = 0.05;             ///< of translations, relative to the smaller diagonal
constexpr double kParallel = 0.95;         ///< cosine: 18 degrees
constexpr int kDirectionCells = 10;        ///< cells of directions along each side of a cube

/// A nearly even grid of rotations on two spirals.
Quat grid_rotation(std::size_t index) {
  constexpr double kFirst = 1.4142135623730951, kSecond = 1.533751168755204288;
  const double s = static_cast<double>(index) + 0.5, n = static_cast<double>(kRotations);
  const double r = std::sqrt(s / n), big = std::sqrt(1.0 - s / n);
  const double a = 2.0 * kPi * s / kFirst, b = 2.0 * kPi * s / kSecond;
  return Quat(big * std::cos(b), r * std::sin(a), r * std::cos(a), big * std::sin(b)).normalized();
}

/// Index of the cell of a direction, on the faces of a cube.
std::size_t direction_cell(const Vec3& direction) {
  int axis = 0;
  direction.cwiseAbs().maxCoeff(&axis);
  const double scale = std::abs(direction[axis]);
  const auto along = [&](int other) {
    const double x = 0.5 * (direction[other % 3] / scale + 1.0) * kDirectionCells;
    return std::clamp(static_cast<int>(x), 0, kDirectionCells - 1);
  };
  const int face = 2 * axis + (direction[axis] < 0.0 ? 1 : 0);
  return static_cast<std::size_t>((face * kDirectionCells + along(axis + 1)) * kDirectionCells +
                                  along(axis + 2));
}

Vec3 cell_direction(std::size_t cell) {
  const auto index = static_cast<int>(cell);
  const int face = index / (kDirectionCells * kDirectionCells), axis = face / 2;
  const auto coordinate = [](int at) { return 2.0 * (at + 0.5) / kDirectionCells - 1.0; };
  Vec3 direction;
  direction[axis] = face % 2 == 0 ? 1.0 : -1.0;
  direction[(axis + 1) % 3] = coordinate(index / kDirectionCells % kDirectionCells);
  direction[(axis + 2) % 3] = coordinate(index % kDirectionCells);
  return direction.normalized();
}

/// Points of a surface by the directions to which their normals are nearly parallel.
class PointsByNormal {
 public:
  explicit PointsByNormal(const SampledSurface& sampled) : points_(kCells) {
    for (std::size_t cell = 0; cell < kCells; ++cell) {
      const Vec3 direction = cell_direction(cell);
      for (const std::uint32_t i : sampled.sparse) {
        if (sampled.surface.normals[i].dot(direction) < kParallel) continue;
        points_[cell].push_back(sampled.surface.points[i]);
      }
    }
  }

  const std::vector<Vec3>& with_normal(const Vec3& normal) const {
    return points_[direction_cell(normal)];
  }

 private:
  static constexpr std::size_t kCells = 6u * kDirectionCells * kDirectionCells;
  std::vector<std::vector<Vec3>> points_;
};

/// Votes for translations in cubic cells.
class TranslationVotes {
 public:
  /// @param reach  largest coordinate of a translation, m
  TranslationVotes(double reach, double cell)
      : cell_(cell),
        half_(reach),
        count_(static_cast<std::size_t>(2.0 * reach / cell) + 2),
        votes_(count_ * count_ * count_, 0) {}

  void clear() {
    for (const std::uint32_t at : used_) votes_[at] = 0;
    used_.clear();
  }

  void add(const Vec3& translation) {
    std::size_t index = 0;
    for (int axis = 2; axis >= 0; --axis) {
      const double along = (translation[axis] + half_) / cell_;
      if (along < 0.0 || along >= static_cast<double>(count_)) return;
      index = index * count_ + static_cast<std::size_t>(along);
    }
    if (votes_[index]++ == 0) used_.push_back(static_cast<std::uint32_t>(index));
  }

  /// Centres of the cells with most votes.
  std::vector<Vec3> find_peaks() {
    const std::size_t count = std::min(kPeaks, used_.size());
    std::partial_sort(used_.begin(), used_.begin() + static_cast<std::ptrdiff_t>(count),
                      used_.end(), [&](std::uint32_t a, std::uint32_t b) {
                        return votes_[a] != votes_[b] ? votes_[a] > votes_[b] : a < b;
                      });
    std::vector<Vec3> peaks;
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t at = used_[i];
      const Vec3 cell(static_cast<double>(at % count_), static_cast<double>(at / count_ % count_),
                      static_cast<double>(at / (count_ * count_)));
      peaks.push_back(cell_ * (cell + Vec3::Constant(0.5)) - Vec3::Constant(half_));
    }
    return peaks;
  }

 private:
  double cell_, half_;
  std::size_t count_;
  std::vector<std::uint32_t> votes_;
  std::vector<std::uint32_t> used_;
};

double farthest(const SampledSurface& sampled, const Vec3& from) {
  double most = 0.0;
  for (const Vec3& p : sampled.surface.points) most = std::max(most, (p - from).norm());
  return most;
}

Vec3 middle_of_box(const SampledSurface& sampled) {
  Bounds box;
  for (const Vec3& p : sampled.surface.points) box.include(p);
  return 0.5 * (box.low + box.high);
}

}  // namespace

std::vector<Pose> search_rotations(const SampledSurface& fixed, const SampledSurface& moving,
                                   unsigned threads) {
  const Vec3 fixed_middle = middle_of_box(fixed), moving_middle = middle_of_box(moving);
  const double reach = farthest(fixed, fixed_middle) + farthest(moving, moving_middle);
  const double cell = kCell * std::min(fixed.diagonal, moving.diagonal);
  const PointsByNormal by_normal(fixed);
  std::vector<std::vector<Pose>> found((kRotations + kPerTask - 1) / kPerTask);
  parallel_for(found.size(), threads, [&](std::size_t task) {
    TranslationVotes votes(reach, cell);
    const std::size_t end = std::min(kRotations, (task + 1) * kPerTask);
    for (std::size_t r = task * kPerTask; r < end; ++r) {
      const Quat rotation = grid_rotation(r);
      const Mat3 matrix = rotation.toRotationMatrix();
      votes.clear();
      for (const std::uint32_t i : moving.sparse) {
        const Vec3 from = matrix * (moving.surface.points[i] - moving_middle) + fixed_middle;
        for (const Vec3& to : by_normal.with_normal(matrix * moving.surface.normals[i])) {
          votes.add(to - from);
        }
      }
      for (const Vec3& shift : votes.find_peaks()) {
        found[task].push_back({fixed_middle + shift - matrix * moving_middle, rotation});
      }
    }
  });
  std::vector<Pose> poses;
  for (const std::vector<Pose>& of_task : found) {
    poses.insert(poses.end(), of_task.begin(), of_task.end());
  }
  return poses;
}

}  // namespace clast::reconstruct_detail
