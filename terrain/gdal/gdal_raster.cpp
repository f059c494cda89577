#include "terrain/gdal/gdal_raster.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <sstream>
#include <string_view>

#include "core/error.hpp"
#include "core/files/output_file.hpp"
#include "core/files/text_file.hpp"
#include "core/number_text.hpp"
#include "core/printable.hpp"
#include "core/utf8.hpp"
#include "mesh/reference_system.hpp"
#include "terrain/gdal/detail/esri_grid.hpp"
#include "terrain/gdal/detail/gdal_session.hpp"
#include "terrain/gdal/detail/tiff_keys.hpp"

namespace clast::terrain_detail {
namespace {

constexpr double kNoData = -9999.0;

/// Names of the metre in bands and headings, in lower case.
constexpr std::array<std::string_view, 16> kMetres = {
    "m",     "metre",  "meter", "metres", "meters", "metro",
    "metri", "metros", "mètre", "mètres", "gpm",  // and above the sea, without full stops
    "masl",  "mslm",   "msnm",  "müm",    "mnn"};
/// Words for a unit that say nothing.
constexpr std::array<std::string_view, 6> kNoUnit = {"", "unknown", "none", "n/a", "-", "1"};

/// Sizes of other units of heights, in metres.
const std::map<std::string_view, double> kOtherUnits = {{"ft", 0.3048},
                                                        {"foot", 0.3048},
                                                        {"feet", 0.3048},
                                                        {"ftus", 1200.0 / 3937.0},
                                                        {"sft", 1200.0 / 3937.0},
                                                        {"us-ft", 1200.0 / 3937.0},
                                                        {"us_survey_foot", 1200.0 / 3937.0},
                                                        {"dm", 0.1},
                                                        {"decimetre", 0.1},
                                                        {"decimeter", 0.1},
                                                        {"decimetres", 0.1},
                                                        {"decimeters", 0.1},
                                                        {"cm", 0.01},
                                                        {"centimetre", 0.01},
                                                        {"centimeter", 0.01},
                                                        {"centimetres", 0.01},
                                                        {"centimeters", 0.01},
                                                        {"mm", 0.001},
                                                        {"millimetre", 0.001},
                                                        {"millimeter", 0.001},
                                                        {"millimetres", 0.001},
                                                        {"millimeters", 0.001},
                                                        {"km", 1000.0},
                                                        {"kilometre", 1000.0},
                                                        {"kilometer", 1000.0},
                                                        {"kilometres", 1000.0},
                                                        {"kilometers", 1000.0},
                                                        {"in", 0.0254},
                                                        {"inch", 0.0254},
                                                        {"inches", 0.0254},
                                                        {"yd", 0.9144},
                                                        {"yard", 0.9144},
                                                        {"yards", 0.9144},
                                                        {"fathom", 1.8288},
                                                        {"fathoms", 1.8288}};

std::array<double, 6> north_up_transform(GDALDataset& dataset, const std::filesystem::path& path) {
  std::array<double, 6> transform{};
  if (dataset.GetGeoTransform(transform.data()) != CE_None) {
    throw InputError(path.string() +
                     ": has no georeference, so its position and cell size are unknown; give it "
                     "one (gdal_translate -a_ullr WEST NORTH EAST SOUTH -a_srs EPSG:CODE)");
  }
  const double largest = std::max(std::abs(transform[1]), std::abs(transform[5]));
  if (std::abs(transform[2]) > 1e-9 * largest || std::abs(transform[4]) > 1e-9 * largest) {
    throw InputError(path.string() +
                     ": the raster is rotated on the map; turn it north up first (gdalwarp)");
  }
  for (const double value : transform) {
    if (!std::isfinite(value)) {
      throw InputError(path.string() + ": its georeference is damaged; export it again");
    }
  }
  if (!(transform[1] > 0.0) || transform[5] == 0.0) {
    throw InputError(path.string() + ": cell size " + format_significant(transform[1], 6) + " x " +
                     format_significant(transform[5], 6) +
                     "; columns must run east and cells need a size (gdalwarp turns it)");
  }
  return transform;
}

// Values of one row; NaN at nodata.
void read_row(GDALRasterBand& band, int row, std::vector<double>& values,
              std::vector<unsigned char>& mask, const std::filesystem::path& path) {
  const int columns = static_cast<int>(values.size());
  if (band.RasterIO(GF_Read, 0, row, columns, 1, values.data(), columns, 1, GDT_Float64, 0, 0,
                    nullptr) != CE_None ||
      band.GetMaskBand()->RasterIO(GF_Read, 0, row, columns, 1, mask.data(), columns, 1, GDT_Byte,
                                   0, 0, nullptr) != CE_None) {
    throw InputError(path.string() + ": row " + std::to_string(row + 1) + " can't be read (" +
                     GdalSession::last_message() +
                     "); the file may be cut short: copy or export it again");
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (mask[i] == 0 || !std::isfinite(values[i])) {
      values[i] = std::numeric_limits<double>::quiet_NaN();
    }
  }
}

/// Heights from south to north, whichever way the file has them.
/// @param transform  of the file, north up or south up
HeightGrid read_heights(GDALRasterBand& band, const std::array<double, 6>& transform,
                        const std::filesystem::path& path) {
  HeightGrid grid;
  grid.columns = static_cast<std::size_t>(band.GetXSize());
  grid.rows = static_cast<std::size_t>(band.GetYSize());
  grid.cell_size = {transform[1], std::abs(transform[5])};
  const bool north_first = transform[5] < 0.0;
  const double south =
      north_first ? transform[3] + transform[5] * static_cast<double>(grid.rows) : transform[3];
  grid.first_centre = Vec2(transform[0], south) + grid.cell_size / 2.0;
  grid.heights.resize(grid.columns * grid.rows);
  const double scale = band.GetScale(), offset = band.GetOffset();
  std::vector<double> values(grid.columns);
  std::vector<unsigned char> mask(grid.columns);
  // Rows are read in file order: GDAL finds a row of a text grid through the preceding rows, and in
  // a truncated grid that search does not end.
  for (std::size_t row = 0; row < grid.rows; ++row) {
    read_row(band, static_cast<int>(row), values, mask, path);
    const std::size_t j = north_first ? grid.rows - 1 - row : row;
    for (std::size_t i = 0; i < grid.columns; ++i) {
      grid.heights[j * grid.columns + i] = values[i] * scale + offset;
    }
  }
  return grid;
}

/// Text that PROJ reads without loss.
std::string full_wkt(const OGRSpatialReference& system) {
  const char* options[] = {"FORMAT=WKT2_2019", nullptr};
  char* wkt = nullptr;
  std::string text;
  if (system.exportToWkt(&wkt, options) == OGRERR_NONE && wkt) text = wkt;
  CPLFree(wkt);
  return text;
}

/// The unit of heights in the old form of Esri's .prj files, "Zunits FEET", which GDAL passes over.
void check_zunits(const std::filesystem::path& path) {
  std::filesystem::path beside = path;
  std::error_code code;
  if (!std::filesystem::is_regular_file(beside.replace_extension(".prj"), code)) return;
  std::istringstream lines(read_text_file(beside));
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string key, unit;
    words >> key >> unit;
    unit = lower_case_ascii(unit);
    if (lower_case_ascii(key) == "zunits" && unit != "no") check_height_unit(path, unit);
  }
}

/// @param system  null: GDAL finds none
std::vector<std::string> check_raster_map(const std::filesystem::path& path,
                                          const OGRSpatialReference* system, const Vec2& middle) {
  const LengthUnitRequirements metres{
      .conversion_command = "gdalwarp -t_srs EPSG:CODE",
      .correction_command = "gdal_edit.py -a_srs EPSG:CODE " + path.filename().string()};
  std::vector<LengthUnitDeclaration> declared =
      parse_geotiff_keys(read_geotiff_keys(path)).unit_declarations;
  const std::string wkt = system ? full_wkt(*system) : std::string();
  if (system && system->IsProjected()) {  // its scale at the place is known
    for (LengthUnitDeclaration& each : declared) each.world_projection.clear();
  }
  if (!wkt.empty()) declared.push_back(determine_crs_units(wkt, "reference system"));
  check_zunits(path);
  std::vector<std::string> notes = check_length_units(path.string(), declared, metres);
  check_map_scale(path.string(), wkt, middle, metres.conversion_command);
  return notes;
}

}  // namespace

void check_height_unit(const std::filesystem::path& path, const std::string& unit) {
  // "US survey foot", "m a.s.l.", "[m]", "metre (EGM96)"
  std::string text = lower_case_ascii(unit);
  std::erase_if(text,
                [](char c) { return std::string_view("[]()\"").find(c) != std::string::npos; });
  std::vector<std::string> words;
  std::istringstream stream(text);
  for (std::string word; stream >> word;) words.push_back(word);
  if (words.empty() || std::find(kNoUnit.begin(), kNoUnit.end(), words[0]) != kNoUnit.end()) return;
  std::string first = words[0];
  std::erase_if(first, [](char c) { return c == '.' || c == ','; });
  if (std::find(kMetres.begin(), kMetres.end(), first) != kMetres.end()) return;
  const std::string file = path.filename().string();
  for (const std::string& word : words) {
    const auto other = kOtherUnits.find(word);
    const bool feet =
        text.find("foot") != std::string::npos || text.find("feet") != std::string::npos;
    if (other == kOtherUnits.end() && !feet) continue;
    const double factor = other != kOtherUnits.end() ? other->second : 0.3048;
    throw InputError(path.string() + ": its heights are in " +
                     (factor > 0.3 && factor < 0.31 ? "feet" : word) + " (unit \"" +
                     escape_nonprintable(unit) +
                     "\"); convert them to metres first (gdal_calc.py -A " + file + " --calc=A*" +
                     format_significant(factor, 10) + " --outfile=metres.tif)");
  }
  throw InputError(path.string() + ": its heights are in the unit \"" + escape_nonprintable(unit) +
                   "\", which is unknown; convert them to metres, or if they are in metres, set "
                   "the unit (gdal_edit.py -units m " +
                   file + ")");
}

std::string crs_code_or_wkt(const OGRSpatialReference* system) {
  if (!system) return {};
  OGRSpatialReference known(*system);
  if (known.IsCompound()) known.StripVertical();  // the plan decides where things are
  known.AutoIdentifyEPSG();
  const char* authority = known.GetAuthorityName(nullptr);
  const char* code = known.GetAuthorityCode(nullptr);
  if (authority && code && std::string(authority) == "EPSG") return std::string("EPSG:") + code;
  char* wkt = nullptr;
  std::string text;
  if (known.exportToWkt(&wkt) == OGRERR_NONE && wkt) text = wkt;
  CPLFree(wkt);
  return text;
}

std::string normalised_crs(const std::string& crs) {
  if (crs.empty()) return crs;
  const GdalSession session;
  OGRSpatialReference system;
  if (system.SetFromUserInput(crs.c_str()) != OGRERR_NONE) return crs;
  const std::string usual = crs_code_or_wkt(&system);
  return usual.empty() ? crs : usual;
}

Raster read_raster(const std::filesystem::path& path) {
  const GdalSession session;
  // GDAL leaves out the vertical part of GeoTIFF 1.0 otherwise.
  CPLSetThreadLocalConfigOption("GTIFF_REPORT_COMPD_CS", "YES");
  // GDAL would round the numbers of an Esri grid to floats: 2e-5 m at 250 m.
  const char* as_doubles[] = {"DATATYPE=Float64", nullptr};
  const EsriGrid grid(path);
  const DatasetPointer dataset(GDALDataset::Open(
      grid.path().c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR, nullptr,
      lower_case_extension(path) == ".asc" ? as_doubles : nullptr, nullptr));
  if (!dataset) {
    throw InputError(path.string() + ": is not a raster that GDAL can read (" +
                     GdalSession::last_message() + "); export it as GeoTIFF");
  }
  int bands = 0;
  for (int i = 1; i <= dataset->GetRasterCount(); ++i) {
    if (dataset->GetRasterBand(i)->GetColorInterpretation() != GCI_AlphaBand) ++bands;
  }
  if (bands != 1) {
    throw InputError(
        path.string() + ": " + std::to_string(bands) +
        " bands; a raster of heights or zones has one: is it a picture? Save the band as a "
        "file of its own (gdal_translate -b N)");
  }
  GDALRasterBand& band = *dataset->GetRasterBand(1);
  Raster raster;
  raster.unit = band.GetUnitType();
  int declared = 0;
  const double no_data = band.GetNoDataValue(&declared);
  if (declared) raster.no_data = no_data;
  raster.crs = crs_code_or_wkt(dataset->GetSpatialRef());
  const std::array<double, 6> transform = north_up_transform(*dataset, path);
  const Vec2 middle(transform[0] + transform[1] * band.GetXSize() / 2.0,
                    transform[3] + transform[5] * band.GetYSize() / 2.0);
  raster.notes = check_raster_map(path, dataset->GetSpatialRef(), middle);
  raster.grid = read_heights(band, transform, path);
  return raster;
}

void check_written(bool done, const std::filesystem::path& target, const std::string& what) {
  if (done) return;
  throw InputError(target.string() + ": can't write " + what + " (" + GdalSession::last_message() +
                   "); free some space on the disk or name another place");
}

OGRSpatialReference make_spatial_reference(const std::string& name) {
  OGRSpatialReference crs;
  crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);  // x east, y north, as the numbers are
  if (name.empty() || crs.SetFromUserInput(name.c_str()) != OGRERR_NONE) {
    crs.SetLocalCS("map frame of the terrain");
    crs.SetLinearUnits("metre", 1.0);
  }
  return crs;
}

bool is_same_crs(const std::string& one, const std::string& other) {
  if (one == other) return true;
  const GdalSession session;
  OGRSpatialReference a, b;
  return a.SetFromUserInput(one.c_str()) == OGRERR_NONE &&
         b.SetFromUserInput(other.c_str()) == OGRERR_NONE && a.IsSame(&b) != 0;
}

bool is_raster_file(const std::filesystem::path& path) {
  static const std::set<std::string> kKnown = {".tif", ".tiff", ".asc", ".vrt", ".img",
                                               ".bil", ".flt",  ".grd", ".dem", ".hgt"};
  return kKnown.contains(lower_case_extension(path));
}

}  // namespace clast::terrain_detail
