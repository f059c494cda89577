#include "study/compare/path_samples.hpp"

#include <algorithm>
#include <cmath>

namespace clast {
namespace {

double rotational_energy(const BlockSummary& block, const RigidState& state) {
  const Vec3 spin = state.orientation.conjugate() * state.angular_velocity;
  return 0.5 * block.moments.dot(Vec3(spin.cwiseProduct(spin)));
}

// The cubic through two places with their velocities.
Vec3 between(const RigidState& a, const RigidState& b, double duration, double share) {
  const double s2 = share * share, s3 = s2 * share;
  return (2 * s3 - 3 * s2 + 1) * a.position + (s3 - 2 * s2 + share) * duration * a.velocity +
         (3 * s2 - 2 * s3) * b.position + (s3 - s2) * duration * b.velocity;
}

}  // namespace

void for_each_path_sample(const Trajectory& trajectory, const BlockSummary& block,
                          const TerrainSurface& ground, double step,
                          const std::function<void(const PathSample&)>& visit) {
  const auto at = [&](const Vec3& position, const Vec3& velocity, double rotational) {
    const std::optional<double> below = ground.height_at(position.x(), position.y(), position.z());
    visit({position, velocity.norm(), 0.5 * block.mass * velocity.squaredNorm() + rotational,
           below ? position.z() - *below : NAN});
  };
  for (std::size_t i = 0; i < trajectory.states.size(); ++i) {
    const RigidState& state = trajectory.states[i];
    const double rotational = rotational_energy(block, state);
    if (i > 0) {
      const RigidState& before = trajectory.states[i - 1];
      const double duration = trajectory.time[i] - trajectory.time[i - 1];
      const double way = (state.position - before.position).head<2>().norm();
      const double parts = std::ceil(way / step);
      const double rotational_before = rotational_energy(block, before);
      for (double part = 1.0; part < parts; ++part) {
        const double share = part / parts;
        at(between(before, state, duration, share),
           (1.0 - share) * before.velocity + share * state.velocity,
           (1.0 - share) * rotational_before + share * rotational);
      }
    }
    at(state.position, state.velocity, rotational);
  }
}

void for_each_trajectory(
    const Comparison& comparison,
    const std::function<void(std::size_t row, const Trajectory&, const TerrainSurface&)>& visit) {
  std::size_t row = 0;
  for (std::size_t file = 0; file < comparison.results.size(); ++file) {
    const CampaignResults& results = comparison.results[file];
    std::size_t end = row;
    while (end < comparison.rows.size() && comparison.rows[end].file == file) ++end;
    std::error_code code;
    if (row < end && std::filesystem::is_regular_file(results.file, code)) {
      const TrajectoryFile trajectories(results.file);
      const TerrainSurface ground = make_terrain_surface(results.terrain);
      for (; row < end; ++row) {
        const std::uint32_t run = comparison.rows[row].record->run;
        if (trajectories.frame_count(run) > 0) visit(row, trajectories.read(run), ground);
      }
    }
    row = end;
  }
}

}  // namespace clast
