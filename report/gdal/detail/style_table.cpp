#include "report/gdal/detail/style_table.hpp"

#include <ogrsf_frmts.h>

#include <memory>
#include <string>

#include "terrain/gdal/detail/gdal_session.hpp"

namespace clast::report_detail {
namespace {

struct Column {
  const char* name;
  OGRFieldType type;
  int width = 0;
};

constexpr Column kColumns[] = {{"f_table_catalog", OFTString, 256},
                               {"f_table_schema", OFTString, 256},
                               {"f_table_name", OFTString, 256},
                               {"f_geometry_column", OFTString, 256},
                               {"styleName", OFTString, 30},
                               {"styleQML", OFTString},
                               {"styleSLD", OFTString},
                               {"useAsDefault", OFTInteger},
                               {"description", OFTString},
                               {"owner", OFTString, 30},
                               {"ui", OFTString, 30},
                               {"update_time", OFTDateTime}};

}  // namespace

void add_layer_style_table(GDALDataset& dataset, const std::filesystem::path& target,
                           const std::vector<LayerStyle>& styles) {
  const auto check = [&](bool done) {
    terrain_detail::check_written(done, target, "table layer_styles");
  };
  const char* options[] = {"FID=id", nullptr};
  OGRLayer* table =
      dataset.CreateLayer("layer_styles", nullptr, wkbNone, const_cast<char**>(options));
  check(table != nullptr);
  for (const Column& column : kColumns) {
    OGRFieldDefn definition(column.name, column.type);
    definition.SetWidth(column.width);
    if (std::string(column.name) == "useAsDefault") definition.SetSubType(OFSTBoolean);
    check(table->CreateField(&definition) == OGRERR_NONE);
  }
  for (const LayerStyle& style : styles) {
    OGRLayer* layer = dataset.GetLayerByName(style.layer.c_str());
    check(layer != nullptr);
    const std::unique_ptr<OGRFeature, decltype(&OGRFeature::DestroyFeature)> row(
        OGRFeature::CreateFeature(table->GetLayerDefn()), &OGRFeature::DestroyFeature);
    row->SetField("f_table_catalog", "");
    row->SetField("f_table_schema", "");  // QGIS looks for empty texts, not for NULL
    row->SetField("f_table_name", style.layer.c_str());
    row->SetField("f_geometry_column", layer->GetGeometryColumn());
    row->SetField("styleName", style.layer.c_str());
    row->SetField("styleQML", style.qml.c_str());
    row->SetField("useAsDefault", 1);
    row->SetField("description", "as in report.html");
    row->SetField("owner", "");
    check(table->CreateFeature(row.get()) == OGRERR_NONE);
  }
}

}  // namespace clast::report_detail
