#include "pipeline/stations_file.hpp"

#include "core/error.hpp"
#include "mesh/point_cloud.hpp"

namespace clast {

std::vector<Vec3> read_stations(const std::filesystem::path& file) {
  constexpr std::size_t kMostStations = 100000;  // more are a scan
  std::vector<Vec3> stations;
  stream_cloud(file, [&](const PointBatch& batch) {
    stations.insert(stations.end(), batch.points.begin(), batch.points.end());
    if (stations.size() > kMostStations) {
      throw InputError(file.string() + ": holds more than " + std::to_string(kMostStations) +
                       " positions of scanner or cameras; it may be the scan itself");
    }
  });
  return stations;
}

}  // namespace clast
