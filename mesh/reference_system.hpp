#pragma once
/// Length units of coordinates, as declared by coordinate systems and headings.
#include <optional>
#include <string>
#include <vector>

#include "core/types.hpp"

namespace clast {

struct DeclaredUnit {
  double metres = 1.0;  ///< metres per unit; 0 if unknown
  std::string name;     ///< "US survey foot"
};

enum class ReferenceSystemKind {
  kUnstated,    ///< the declaration only states units
  kUnknown,     ///< not understood by PROJ
  kProjected,   ///< projected or local system, whose horizontal coordinates are lengths
  kGeographic,  ///< longitude and latitude
  kGeocentric,  ///< geocentric system, whose z does not point up
  kVertical     ///< heights only
};

/// Length units declared by one coordinate system or heading of a file.
struct LengthUnitDeclaration {
  std::string source;  ///< origin for messages: "GeoTIFF key 3072 = 26913, NAD83 / UTM zone 13N"
  ReferenceSystemKind kind = ReferenceSystemKind::kUnstated;
  std::optional<DeclaredUnit> plan = {};    ///< empty if not declared
  std::optional<DeclaredUnit> height = {};  ///< empty if not declared
  /// Name of a continental projection, whose local scale is unknown; otherwise empty.
  std::string world_projection = {};
};

/// Determines the kind and the units of a coordinate system.
/// @param crs  "EPSG:25832", or WKT of either version
/// @param source  origin of the declaration for messages; the name of the system is appended
LengthUnitDeclaration determine_crs_units(const std::string& crs, std::string source);

/// Returns the length unit of an EPSG code such as 9003; empty for other codes.
std::optional<DeclaredUnit> epsg_length_unit(int code);

/// Requirements on length unit and axes of a file, and advice for error messages.
struct LengthUnitRequirements {
  double unit = 1.0;  ///< assumed metres per unit of the file
  /// True if the user gave `unit`, which then overrides declarations.
  bool unit_given = false;
  bool needs_z_up = true;  ///< true if z must point up; geocentric coordinates are then refused
  std::string conversion_command =
      {};  ///< command that converts the file to metres: "gdalwarp -t_srs EPSG:CODE"
  std::string correction_command =
      {};  ///< command that corrects the declarations of the file: "pdal translate ..."
  /// True if the caller has an option `units`, which messages then suggest.
  bool has_units_option = false;
};

/// Checks that the coordinates of a file are lengths in the required unit.
/// @param name  name of the file, for messages
/// @return notes on declarations that are overridden or not understood
/// @throws InputError  if coordinates are in degrees, geocentric or in another unit, if horizontal
///                     and vertical units differ, or if declarations contradict each other
std::vector<std::string> check_length_units(const std::string& name,
                                            const std::vector<LengthUnitDeclaration>& declared,
                                            const LengthUnitRequirements& use);

/// Checks that a projection distorts lengths by at most 1 % at a position. Mercator exceeds this
/// away from the equator. Positions outside the system's area of use or within 100 km of its origin
/// count as local coordinates, which are accepted.
/// @param crs  system with horizontal coordinates in metres, "EPSG:3857" or WKT; may be empty
/// @param position  horizontal coordinates in the file
/// @param conversion_command  command that projects the file, with "EPSG:CODE" for the system; for
///                            messages
/// @throws InputError  if the distortion is larger; the message gives the scale factor and a
///                     suitable system
void check_map_scale(const std::string& name, const std::string& crs, const Vec2& position,
                     const std::string& conversion_command);

/// Returns the map scale factor along x and y; empty if PROJ cannot compute it.
/// @cite snyder1987
std::optional<Vec2> map_scale_factor(const std::string& crs, const Vec2& position);

/// Returns the display name of a system: "NAD83 / UTM zone 13N (EPSG:26913)". A text that PROJ does
/// not understand is truncated to 60 characters.
std::string reference_system_name(const std::string& crs);

}  // namespace clast
