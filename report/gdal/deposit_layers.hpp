#pragma once
/// Map layers of a deposit for GIS programs.
#include <filesystem>

#include "core/files/output_file.hpp"
#include "report/maps/deposit_map.hpp"

namespace clast::report_detail {

/// Writes a GeoPackage with outlines and centres of the blocks of a deposit and with the parts that
/// are left out.
/// @throws InputError  if GDAL cannot write the file, or `rules` do not allow to replace one
void write_deposit_layers(const std::filesystem::path& path, const DepositMap& map,
                          const OverwritePolicy& rules);

}  // namespace clast::report_detail
