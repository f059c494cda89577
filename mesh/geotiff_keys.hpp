#pragma once
/// Reference systems in GeoTIFF keys of LAS and TIFF files.
#include <string>
#include <vector>

#include "mesh/reference_system.hpp"

namespace clast {

/// GeoTIFF key records as little-endian bytes.
struct GeoTiffKeys {
  std::string directory;  ///< tag 34735: four short integers each
  std::string doubles;    ///< tag 34736
  std::string texts;      ///< tag 34737
};

/// Reference system and units declared by GeoTIFF keys.
struct GeoTiffReferenceSystem {
  std::string crs;  ///< "EPSG:25832"; empty if there is none or it is user-defined
  std::vector<LengthUnitDeclaration> lengths;
};

/// Parses all declarations of length units: keys 1024 (kind of system), 2048, 3072 and 4096
/// (codes), 2052, 3076, 3077 and 4099 (units), 3075 (projection), and citations if only they name a
/// unit. The geographic base system of a projection does not affect its coordinates.
GeoTiffReferenceSystem parse_geotiff_keys(const GeoTiffKeys& keys);

}  // namespace clast
