#include "study/checked_group.hpp"
#include "study/results.hpp"
#include "study/results_layout.hpp"

namespace clast {

namespace fs = std::filesystem;
using namespace results_layout;

struct TrajectoryFile::Impl {
  explicit Impl(const fs::path& path)
      : file(Hdf5File::open(path, kFormat, kSchemaVersion)),
        reader{path.string(), "/trajectories", file.root().group("trajectories")} {}
  Hdf5File file;
  CheckedGroup reader;
};

TrajectoryFile::TrajectoryFile(const fs::path& path) : impl_(std::make_unique<Impl>(path)) {}
TrajectoryFile::~TrajectoryFile() = default;
TrajectoryFile::TrajectoryFile(TrajectoryFile&&) noexcept = default;

std::size_t TrajectoryFile::frames(std::uint32_t run) const {
  const CheckedGroup& reader = impl_->reader;
  const std::string name = trajectory_name(run);
  if (!reader.group.has(name)) return 0;
  const std::vector<std::size_t> shape = reader.group.shape(name);
  if (shape.size() != 2 || shape[0] != kTrajectoryRows) {
    reader.damaged(name, "is not a table of " + std::to_string(kTrajectoryRows) + " rows");
  }
  return shape[1];
}

Trajectory TrajectoryFile::read(std::uint32_t run) const {
  const CheckedGroup& reader = impl_->reader;
  const std::string name = trajectory_name(run);
  const std::size_t count = frames(run);
  if (!reader.group.has(name)) {
    const bool any = !reader.group.names().empty();
    throw InputError(reader.file + ": no trajectory of run " + std::to_string(run) + "; " +
                     (any ? "there is no such run"
                          : "none were stored, set [run] trajectory_interval_s above zero"));
  }
  const std::vector<double> rows = reader.group.read<double>(name);
  Trajectory trajectory;
  trajectory.time.assign(rows.begin(), rows.begin() + static_cast<std::ptrdiff_t>(count));
  for (std::size_t i = 0; i < count; ++i) {
    RigidState state;
    for (std::size_t k = 1; k < kTrajectoryRows; ++k) {
      kStateValues[k - 1].field(state) = rows[k * count + i];
    }
    trajectory.states.push_back(state);
  }
  return trajectory;
}

Trajectory read_trajectory(const fs::path& path, std::uint32_t run) {
  return TrajectoryFile(path).read(run);
}

}  // namespace clast
