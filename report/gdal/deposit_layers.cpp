#include "report/gdal/deposit_layers.hpp"

#include <ogrsf_frmts.h>

#include <utility>

#include "report/gdal/detail/geopackage_file.hpp"

namespace clast::report_detail {
namespace {

const std::vector<GeoPackageLayer::Field> kDepositBlockFields = {
    {"block", OFTString},     {"L_m", OFTReal},
    {"I_m", OFTReal},         {"S_m", OFTReal},
    {"volume_m3", OFTReal},   {"mass_kg", OFTReal},
    {"class", OFTString},     {"shape", OFTString},
    {"points", OFTInteger64}, {"visible_fraction", OFTReal},
    {"confidence", OFTReal},  {"trend_deg", OFTReal},
    {"plunge_deg", OFTReal}};

OGRMultiPolygon outline_geometry(const DepositMapBlock& block) {
  OGRMultiPolygon area;
  for (const std::vector<Vec2>& outline : block.outlines) {
    OGRLinearRing ring;
    for (const Vec2& corner : outline) ring.addPoint(corner.x(), corner.y());
    ring.closeRings();
    OGRPolygon polygon;
    polygon.addRing(&ring);
    area.addGeometry(&polygon);
  }
  return area;
}

OGRPoint point_geometry(const Vec3& place) { return {place.x(), place.y(), place.z()}; }

/// Adds one feature per row.
template <class Row, class Geometry>
void write_rows(GeoPackageLayer layer, const TableColumns<Row>& all, const std::vector<Row>& rows,
                const Geometry& geometry) {
  const TableColumns<Row> columns = selected_columns(all, layer.fields());
  for (const Row& row : rows) {
    FeaturePointer feature = layer.feature();
    set_feature_fields(*feature, columns, row);
    layer.add(std::move(feature), geometry(row));
  }
}

}  // namespace

void write_deposit_layers(const std::filesystem::path& path, const DepositMap& map,
                          const OverwritePolicy& rules) {
  GeoPackageFile file(path, map.crs, rules);
  write_rows(file.add_layer("outlines", wkbMultiPolygon, kDepositBlockFields),
             deposit_block_columns(), map.blocks, outline_geometry);
  write_rows(file.add_layer("centres", wkbPoint25D, kDepositBlockFields), deposit_block_columns(),
             map.blocks, [](const DepositMapBlock& block) { return point_geometry(block.centre); });
  write_rows(
      file.add_layer("left_out", wkbPoint25D, {{"reason", OFTString}, {"points", OFTInteger64}}),
      left_out_columns(), map.left_out,
      [](const DepositMapPart& part) { return point_geometry(part.place); });
  file.commit(make_deposit_styles());
}

}  // namespace clast::report_detail
