#pragma once
/// What the writers of map files share.
#include <cpl_error.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <filesystem>
#include <memory>
#include <string>

namespace clast::report_detail {

struct DatasetCloser {
  void operator()(GDALDataset* dataset) const { GDALClose(dataset); }
};
using Dataset = std::unique_ptr<GDALDataset, DatasetCloser>;

/// Keeps GDAL from printing; its last message goes into ours instead.
struct QuietGdal {
  QuietGdal() { CPLPushErrorHandler(CPLQuietErrorHandler); }
  ~QuietGdal() { CPLPopErrorHandler(); }
};

/// @throws InputError  not `done`: file, what, and what GDAL says
void check_written(bool done, const std::filesystem::path& target, const std::string& what);

/// The map system by name; a local one in metres where it has none or an unknown one, since
/// coordinates without any are read as degrees.
OGRSpatialReference reference_of(const std::string& crs);

}  // namespace clast::report_detail
