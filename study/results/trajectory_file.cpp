#include "study/campaign/checked_group.hpp"
#include "study/results/detail/results_layout.hpp"
#include "study/results/results.hpp"

namespace clast {

using namespace study_detail;
namespace fs = std::filesystem;

struct TrajectoryFile::Impl {
  explicit Impl(const fs::path& path)
      : file(Hdf5File::open(path, kResultsFormat, kResultsSchema)),
        reader{path.string(), "/trajectories", file.root().open_group("trajectories")} {}
  Hdf5File file;
  CheckedGroup reader;
};

TrajectoryFile::TrajectoryFile(const fs::path& path) : impl_(std::make_unique<Impl>(path)) {}
TrajectoryFile::~TrajectoryFile() = default;
TrajectoryFile::TrajectoryFile(TrajectoryFile&&) noexcept = default;

std::size_t TrajectoryFile::frame_count(std::uint32_t run) const {
  const CheckedGroup& reader = impl_->reader;
  const std::string name = trajectory_dataset_name(run);
  if (!reader.group.contains(name)) return 0;
  const std::vector<std::size_t> shape = reader.group.shape(name);
  if (shape.size() != 2 || shape[0] != trajectory_row_count()) {
    reader.throw_damaged(name,
                         "is not a table of " + std::to_string(trajectory_row_count()) + " rows");
  }
  return shape[1];
}

Trajectory TrajectoryFile::read(std::uint32_t run) const {
  const CheckedGroup& reader = impl_->reader;
  const std::string name = trajectory_dataset_name(run);
  const std::size_t count = frame_count(run);
  if (!reader.group.contains(name)) {
    const bool any = !reader.group.child_names().empty();
    throw InputError(reader.file + ": no trajectory of run " + std::to_string(run) + "; " +
                     (any ? "there is no such run"
                          : "none are stored; set [run] trajectory_interval_s above zero"));
  }
  const std::vector<double> rows = reader.group.read<double>(name);
  Trajectory trajectory;
  trajectory.time.assign(rows.begin(), rows.begin() + static_cast<std::ptrdiff_t>(count));
  trajectory.states.resize(count);
  auto value = rows.begin() + static_cast<std::ptrdiff_t>(count);
  visit_columns(kRowType<RigidState>,
                [&](const auto&, const auto&, const auto&, const auto& field) {
                  for (RigidState& state : trajectory.states) field(state) = *value++;
                });
  return trajectory;
}

Trajectory read_trajectory(const fs::path& path, std::uint32_t run) {
  return TrajectoryFile(path).read(run);
}

}  // namespace clast
