#include "mesh/point_cloud.hpp"

#include <algorithm>
#include <fstream>

#include "core/error.hpp"
#include "core/error_context.hpp"
#include "core/files/input_file.hpp"
#include "core/files/text_file.hpp"
#include "mesh/detail/cloud_readers.hpp"
#include "mesh/detail/laz_unpacker.hpp"
#include "mesh/detail/mesh_readers.hpp"
#include "mesh/mesh_io.hpp"

namespace clast {

namespace mesh_detail {

namespace {
constexpr std::size_t kBatch = 65536;
}

bool PointBatcher::is_usable(const Vec3& point) {
  if (point.allFinite()) return true;
  ++non_finite_;
  return false;
}

void PointBatcher::add_point(const Vec3& point) {
  if (!is_usable(point)) return;
  batch_.points.push_back(point);
  if (batch_.points.size() >= kBatch) flush_batch();
}

void PointBatcher::add_point(const Vec3& point, std::uint8_t asprs_class,
                             const PointRecording& recording) {
  if (!is_usable(point)) return;
  batch_.points.push_back(point);
  batch_.classes.push_back(asprs_class);
  batch_.recordings.push_back(recording);
  if (batch_.points.size() >= kBatch) flush_batch();
}

void PointBatcher::flush_batch() {
  points_ += batch_.points.size();
  if (!batch_.points.empty()) consume_(batch_);
  batch_.points.clear();
  batch_.classes.clear();
  batch_.recordings.clear();
}

CloudSummary PointBatcher::finish(CloudSummary summary) {
  flush_batch();
  summary.point_count = points_;
  summary.non_finite_points = non_finite_;
  return summary;
}

}  // namespace mesh_detail

namespace {

bool is_text_cloud(const std::string& extension) {
  return extension == ".xyz" || extension == ".txt" || extension == ".csv" || extension == ".pts" ||
         extension == ".asc";
}

CloudSummary read_cloud_by_format(const std::filesystem::path& path, const std::string& extension,
                                  mesh_detail::PointBatcher& sink,
                                  const std::vector<std::string>& columns,
                                  mesh_detail::LasCopy* copy) {
  if (!columns.empty() && !is_text_cloud(extension)) {
    throw InputError("`columns` applies only to clouds in text; leave it out");
  }
  if (extension == ".pcd") return mesh_detail::read_pcd_cloud(read_text_file(path), sink);
  if (is_text_cloud(extension) || extension == ".las" || extension == ".laz") {
    check_input_file(path);
    std::ifstream stream(path, std::ios::binary);
    if (!stream) throw InputError("can't be read; check its permissions");
    return is_text_cloud(extension)
               ? mesh_detail::read_text_cloud(stream, sink, columns, extension == ".pts")
               : mesh_detail::read_las_cloud(stream, path, sink, copy);
  }
  const std::optional<TriangleMesh> mesh =
      extension == ".ply" ? mesh_detail::read_ply_mesh(read_text_file(path)) : read_mesh(path);
  if (!mesh) throw InputError("its points can't be read");
  for (const Vec3& vertex : mesh->vertices) sink.add_point(vertex);
  return sink.finish({});
}

/// Why a file that could be read gives no point.
std::string nothing_in(const CloudSummary& summary) {
  if (summary.withheld_points > 0) {
    return "holds no usable points: " + std::to_string(summary.withheld_points) +
           " are flagged as withheld or classed as noise; classify them anew";
  }
  if (summary.non_finite_points > 0) {
    return "holds no usable points: " + std::to_string(summary.non_finite_points) +
           " have a coordinate that is not finite; export it again";
  }
  return "holds no points; export it again";
}

CloudSummary stream_points(const std::filesystem::path& path,
                           const std::function<void(const PointBatch&)>& consume,
                           const std::vector<std::string>& columns, mesh_detail::LasCopy* copy) {
  mesh_detail::PointBatcher sink(consume);
  const CloudSummary summary = with_file_context(path.string(), [&] {
    std::error_code code;
    if (std::filesystem::is_regular_file(path, code) && std::filesystem::is_empty(path, code)) {
      throw InputError("holds no points: the file is empty; copy or export it again");
    }
    return read_cloud_by_format(path, lower_case_extension(path), sink, columns, copy);
  });
  if (summary.point_count == 0) throw InputError(path.string() + ": " + nothing_in(summary));
  return summary;
}

}  // namespace

CloudSummary stream_cloud(const std::filesystem::path& path,
                          const std::function<void(const PointBatch&)>& consume,
                          const std::vector<std::string>& columns) {
  return stream_points(path, consume, columns, nullptr);
}

CloudFile::CloudFile(std::filesystem::path path, std::vector<std::string> columns)
    : path_(std::move(path)),
      columns_(std::move(columns)),
      copy_(std::make_unique<mesh_detail::LasCopy>()) {}
CloudFile::~CloudFile() = default;
CloudFile::CloudFile(CloudFile&&) noexcept = default;
CloudFile& CloudFile::operator=(CloudFile&&) noexcept = default;

CloudSummary CloudFile::stream(const std::function<void(const PointBatch&)>& consume) const {
  return stream_points(path_, consume, columns_, copy_.get());
}

std::vector<Vec3> read_cloud(const std::filesystem::path& path) {
  std::vector<Vec3> points;
  stream_cloud(path, [&](const PointBatch& batch) {
    points.insert(points.end(), batch.points.begin(), batch.points.end());
  });
  return points;
}

const std::vector<std::string>& cloud_extensions() {
  static const std::vector<std::string> kExtensions = {".csv", ".las", ".laz", ".pcd",
                                                       ".pts", ".txt", ".xyz"};
  return kExtensions;
}

}  // namespace clast
