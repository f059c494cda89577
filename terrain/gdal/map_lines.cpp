#include "terrain/gdal/map_lines.hpp"

#include "core/error.hpp"
#include "terrain/gdal/detail/vector_layer.hpp"

namespace clast::terrain_detail {
namespace {

void add_line(const OGRLineString& line, const std::string& name, std::vector<MapLine>& lines) {
  MapLine result{.points = {}, .has_heights = line.Is3D() != 0, .name = name};
  for (int i = 0; i < line.getNumPoints(); ++i) {
    result.points.emplace_back(line.getX(i), line.getY(i), result.has_heights ? line.getZ(i) : 0.0);
    if (!result.points.back().allFinite()) {
      throw InputError(name + " has a corner that is not a number; correct it, or draw it again");
    }
  }
  if (result.points.size() > 1) lines.push_back(std::move(result));
}

}  // namespace

std::vector<MapLine> read_map_lines(const std::filesystem::path& path, const std::string& crs) {
  const GdalSession session;
  const DatasetPointer dataset = open_feature_file(path, "lines");
  OGRLayer& layer = find_geometry_layer(*dataset, path, "lines");
  const TransformationPointer transform = make_transformation(layer, crs, path);
  std::vector<MapLine> lines;
  layer.ResetReading();
  while (const FeaturePointer feature{layer.GetNextFeature()}) {
    const std::string name = feature_name(*feature, path);
    const std::unique_ptr<OGRGeometry> geometry =
        linearised_geometry(*feature, transform.get(), path);
    const OGRwkbGeometryType type = geometry ? wkbFlatten(geometry->getGeometryType()) : wkbUnknown;
    if (type == wkbLineString) {
      add_line(*geometry->toLineString(), name, lines);
    } else if (type == wkbMultiLineString) {
      for (const OGRLineString* part : *geometry->toMultiLineString()) add_line(*part, name, lines);
    } else {
      throw InputError(name + " is a " +
                       (geometry ? geometry->getGeometryName() : "feature without geometry") +
                       "; a line is needed");
    }
  }
  if (lines.empty()) {
    throw InputError(path.string() + ": holds no lines; draw one, or leave the file out");
  }
  return lines;
}

}  // namespace clast::terrain_detail
