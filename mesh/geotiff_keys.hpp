#pragma once
/// Reference systems as GeoTIFF keys, which LAS and TIFF files hold.
#include <string>
#include <vector>

#include "mesh/reference_system.hpp"

namespace clast {

/// The three records of keys as bytes, little-endian.
struct GeoTiffKeys {
  std::string directory;  ///< 34735: four short integers each
  std::string doubles;    ///< 34736
  std::string texts;      ///< 34737
};

/// The reference system and the units that GeoTIFF keys declare.
struct GeoTiffSystem {
  std::string crs;  ///< "EPSG:25832"; empty: none, or one that the keys define themselves
  std::vector<LengthUnitDeclaration> lengths;
};

/// Parses every declaration of lengths: keys 1024 (kind of system), 2048, 3072 and 4096 (codes),
/// 2052, 3076, 3077 and 4099 (units), 3075 (projection), and the citations where they alone name a
/// unit. The geographic system of a map is its base and says nothing of its coordinates.
GeoTiffSystem parse_geotiff_keys(const GeoTiffKeys& keys);

}  // namespace clast
