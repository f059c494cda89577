#pragma once
/// GDAL with its drivers registered and its messages kept for ours. For .cpp files only.
#include <cpl_error.h>
#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <memory>
#include <mutex>
#include <string>

namespace clast::terrain_detail {

/// While it lives, GDAL prints nothing; `message` is what it would have said last.
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

  static std::string message() {
    const std::string text = CPLGetLastErrorMsg();
    return text.empty() ? std::string("GDAL gives no reason") : text;
  }
};

struct CloseDataset {
  void operator()(GDALDataset* dataset) const { GDALClose(dataset); }
};
using DatasetPointer = std::unique_ptr<GDALDataset, CloseDataset>;

/// "EPSG:25832" when the system has a code, else its WKT; empty for none.
std::string crs_name(const OGRSpatialReference* system);

}  // namespace clast::terrain_detail
