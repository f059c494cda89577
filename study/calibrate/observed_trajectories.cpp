#include "study/calibrate/observed_trajectories.hpp"

#include <algorithm>
#include <map>

#include "core/error.hpp"
#include "core/files/digest.hpp"
#include "core/files/number_table.hpp"
#include "core/files/text_file.hpp"

namespace clast::study_detail {

double ObservedTrajectorySet::longest() const {
  double time = 0.0;
  for (const ObservedTrajectory& trajectory : all) time = std::max(time, trajectory.back().time);
  return time;
}

ObservedTrajectorySet read_trajectories(const std::filesystem::path& file) {
  constexpr const char* kColumns =
      "six numbers: trajectory, time_s, x_m, y_m, speed_m_s and spin_rad_s";
  const std::vector<NumericRow> rows = read_numeric_table(
      file,
      {.column_names = {{"trajectory"}, {"time_s"}, {"x"}, {"y"}, {"speed_m_s"}, {"spin_rad_s"}},
       .range = {-1e8, 1e8},
       .expected_line = kColumns});
  std::map<double, ObservedTrajectory> by_number;
  for (const NumericRow& row : rows) {
    ObservedTrajectory& own = by_number[row.values[0]];
    const double time = row.values[1];
    if (!own.empty() && !(time > own.back().time)) {
      throw InputError(file.string() + ":" + std::to_string(row.line) +
                       ": the times of a trajectory must rise; sort its rows");
    }
    own.push_back({time, {row.values[2], row.values[3]}, row.values[4], row.values[5]});
  }
  ObservedTrajectorySet read{sha256(read_text_file(file)), {}};
  for (auto& [number, trajectory] : by_number) {
    const double release = trajectory.front().time;
    for (TrajectoryPoint& point : trajectory) point.time -= release;
    read.all.push_back(std::move(trajectory));
  }
  return read;
}

TrajectoryPoint interpolate_trajectory(const ObservedTrajectory& trajectory, double time) {
  const auto next = std::find_if(trajectory.begin(), trajectory.end(),
                                 [&](const TrajectoryPoint& point) { return point.time >= time; });
  if (next == trajectory.end()) return trajectory.back();
  if (next == trajectory.begin()) return *next;
  const TrajectoryPoint &a = *(next - 1), &b = *next;
  const double share = (time - a.time) / (b.time - a.time);
  return {time, a.position + share * (b.position - a.position),
          a.speed + share * (b.speed - a.speed), a.spin + share * (b.spin - a.spin)};
}

}  // namespace clast::study_detail
