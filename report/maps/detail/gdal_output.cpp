#include "report/maps/detail/gdal_output.hpp"

#include "core/error.hpp"

namespace clast::report_detail {

void check_written(bool done, const std::filesystem::path& target, const std::string& what) {
  if (done) return;
  throw InputError(target.string() + ": can't write " + what + " (" + CPLGetLastErrorMsg() +
                   "); free some space on the disk or name another place");
}

OGRSpatialReference reference_of(const std::string& name) {
  OGRSpatialReference crs;
  crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);  // x east, y north, as the numbers are
  if (name.empty() || crs.SetFromUserInput(name.c_str()) != OGRERR_NONE) {
    crs.SetLocalCS("map frame of the terrain");
    crs.SetLinearUnits("metre", 1.0);
  }
  return crs;
}

}  // namespace clast::report_detail
