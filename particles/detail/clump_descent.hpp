#pragma once
/// Joint descent on centres and radii of the balls of a clump.
#include <vector>

#include "core/random.hpp"
#include "particles/detail/ball_contacts.hpp"
#include "particles/detail/clump_problem.hpp"

namespace clast::particles_detail {

/// Loss of a distance e between body and union: (e / scale)^(1 + 2^doublings), or
/// max(0, e / scale - 1)^2 if `hinge`.
struct DescentLoss {
  double scale = 0.02;  ///< relative to L
  int doublings = 1;
  bool hinge = false;

  double slope(double distance) const;
};

/// Descent on the loss of all distances between body and union by Adam (Kingma & Ba 2015).
///
/// The distances are those of surface samples from the union, of lattice points inside the body
/// that the union leaves out, and of points of the union from the body: random exposed points of
/// the spheres and of the circles where two meet, and the corners where three meet.
/// @cite kingma2015
class ClumpDescent {
 public:
  ClumpDescent(ClumpProblem& problem, std::vector<Ball> balls, double smallest_radius,
               std::uint64_t seed);

  const std::vector<Ball>& balls() const { return balls_; }
  /// Makes steps whose rate (relative to L) falls from `first_rate` to `last_rate`. Volume and
  /// second moments are corrected at intervals.
  void run(int steps, const DescentLoss& loss, double first_rate, double last_rate);
  /// Moves balls without exposed surface to the largest distances of the last step.
  void move_hidden_balls();
  /// Removes the balls with the smallest exposed areas.
  void remove_least_balls(std::size_t count);
  /// Adds balls at the largest distances of the last step.
  void add_balls(std::size_t count);
  /// Returns the largest distance of the last step.
  double worst_distance() const;

 private:
  struct Gradient {
    Vec3 centre = Vec3::Zero();
    double radius = 0.0;
  };
  struct Parameters {
    Gradient slope, mean, square;
  };
  struct Distance {
    double value = 0.0;
    Vec3 place = Vec3::Zero();
  };

  void step(const DescentLoss& loss, double rate);
  void update_dense_samples();
  void update_near_balls();
  void add_cover_terms(const DescentLoss& loss);
  void add_sphere_terms(const DescentLoss& loss, const BallNeighbours& neighbours);
  void add_circle_terms(const DescentLoss& loss, const BallNeighbours& neighbours);
  void add_corner_terms(const DescentLoss& loss, const BallNeighbours& neighbours);
  /// Evaluates the distance of a point of the union from the body.
  /// @return gradient of the loss with respect to the point
  Vec3 point_slope(const DescentLoss& loss, const Vec3& point);
  void add(std::uint32_t ball, double weight, const Vec3& normal);
  void erase(std::size_t ball);

  ClumpProblem* problem_;
  std::vector<Ball> balls_;
  double smallest_radius_;
  Random random_;
  std::vector<Parameters> parameters_;
  int steps_ = 0;
  std::vector<Vec3> dense_;                       ///< dense samples with the largest distances
  std::vector<std::vector<std::uint32_t>> near_;  ///< balls near each sample
  std::vector<Distance> distances_;               ///< largest distance of each kind and ball
};

}  // namespace clast::particles_detail
