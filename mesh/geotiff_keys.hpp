#pragma once
/// Coordinate systems in GeoTIFF keys of LAS and TIFF files.
#include <string>
#include <vector>

#include "mesh/reference_system.hpp"

namespace clast {

/// GeoTIFF key records as little-endian bytes.
struct GeoTiffKeys {
  std::string directory;  ///< tag 34735: key records of four 16-bit integers
  std::string doubles;    ///< tag 34736
  std::string texts;      ///< tag 34737
};

/// Coordinate system and units declared by GeoTIFF keys.
struct GeoTiffReferenceSystem {
  std::string crs;  ///< "EPSG:25832"; empty if there is no system or it is user-defined
  std::vector<LengthUnitDeclaration> unit_declarations;
};

/// Parses the coordinate system and all declarations of length units. They are in keys 1024 (kind
/// of system), 2048, 3072 and 4096 (codes), 2052, 3076, 3077 and 4099 (units), and 3075
/// (projection). Citations are used if only they name a unit. The geographic base system of a
/// projection is ignored, because coordinates do not depend on it.
GeoTiffReferenceSystem parse_geotiff_keys(const GeoTiffKeys& keys);

}  // namespace clast
