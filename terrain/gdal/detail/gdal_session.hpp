#pragma once
/// GDAL with registered drivers and captured messages. For .cpp files only.
#include <cpl_error.h>
#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <filesystem>
#include <memory>
#include <mutex>
#include <string>

namespace clast::terrain_detail {

/// Captures GDAL's messages during its lifetime.
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

/// Checks that a GDAL write succeeded.
/// @throws InputError  if it failed; the message gives file, action and GDAL's message
void check_written(bool done, const std::filesystem::path& target, const std::string& what);

/// Makes a spatial reference from an EPSG code or WKT. If the text is empty or unknown, a local
/// system in metres is made, because other programs read coordinates without a system as degrees.
OGRSpatialReference make_spatial_reference(const std::string& crs);

/// Returns "EPSG:25832" if the system has a code, otherwise its WKT; empty if there is none.
std::string crs_code_or_wkt(const OGRSpatialReference* system);

}  // namespace clast::terrain_detail
