#pragma once
/// GDAL with its drivers registered and its messages kept for ours. For .cpp files only.
#include <cpl_error.h>
#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <filesystem>
#include <memory>
#include <mutex>
#include <string>

namespace clast::terrain_detail {

/// While it lives, GDAL prints nothing; `last_message` is what it would have said last.
class GdalSession {
 public:
  GdalSession() {
    static std::once_flag once;
    std::call_once(once, [] { GDALAllRegister(); });
    CPLPushErrorHandler(CPLQuietErrorHandler);
    CPLErrorReset();
  }
  ~GdalSession() { CPLPopErrorHandler(); }
  GdalSession(const GdalSession&) = delete;
  GdalSession& operator=(const GdalSession&) = delete;

  static std::string last_message() {
    const std::string text = CPLGetLastErrorMsg();
    return text.empty() ? std::string("GDAL gives no reason") : text;
  }
};

struct DatasetCloser {
  void operator()(GDALDataset* dataset) const { GDALClose(dataset); }
};
using DatasetPointer = std::unique_ptr<GDALDataset, DatasetCloser>;

/// @throws InputError  not `done`: file, what, and what GDAL says
void check_written(bool done, const std::filesystem::path& target, const std::string& what);

/// The map system by name; a local one in metres where it has none or an unknown one, since
/// coordinates without any are read as degrees.
OGRSpatialReference make_spatial_reference(const std::string& crs);

/// "EPSG:25832" when the system has a code, else its WKT; empty for none.
std::string crs_name(const OGRSpatialReference* system);

}  // namespace clast::terrain_detail
