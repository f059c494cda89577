#pragma once
/// Length units of coordinates, as declared by reference systems and headings.
#include <optional>
#include <string>
#include <vector>

#include "core/types.hpp"

namespace clast {

struct DeclaredUnit {
  double metres = 1.0;  ///< per unit; 0 if unknown
  std::string name;     ///< "US survey foot"
};

enum class ReferenceSystemKind {
  kUnstated,    ///< the declaration is about units only
  kUnknown,     ///< not understood by PROJ
  kProjected,   ///< projected or local: plan coordinates are lengths
  kGeographic,  ///< longitude and latitude
  kGeocentric,  ///< z is not up
  kVertical     ///< heights only
};

struct LengthUnitDeclaration {
  std::string source;  ///< for messages: "GeoTIFF key 3072 = 26913, NAD83 / UTM zone 13N"
  ReferenceSystemKind kind = ReferenceSystemKind::kUnstated;
  std::optional<DeclaredUnit> plan = {};    ///< empty if not declared
  std::optional<DeclaredUnit> height = {};  ///< empty if not declared
  /// Name of a continental projection whose local scale is unknown; otherwise empty.
  std::string world_projection = {};
};

/// Determines kind and units of a reference system.
/// @param crs  "EPSG:25832", or WKT of either version
/// @param source  name in messages; the system's name is appended
LengthUnitDeclaration describe_system(const std::string& crs, std::string source);

/// Returns the length unit of an EPSG code such as 9003; empty for other codes.
std::optional<DeclaredUnit> epsg_length_unit(int code);

/// Use of coordinates, with advice for conversion.
struct LengthUnitUse {
  double unit = 1.0;  ///< assumed metres per unit of the file
  /// True if `unit` was given by the user and overrides contradictory declarations.
  bool unit_given = false;
  bool needs_z_up = true;  ///< z must point up: geocentric coordinates are refused
  std::string conversion_command =
      {};  ///< command that converts the file to metres: "gdalwarp -t_srs EPSG:CODE"
  std::string correction_command =
      {};  ///< command that corrects its declarations: "pdal translate ..."
  /// True if the unit can be given as `units`, which messages then suggest.
  bool has_units_option = false;
};

/// Checks that coordinates are lengths in the assumed unit.
/// @param name  of the file, for messages
/// @return notes on declarations that were not understood or are overridden
/// @throws InputError  for degrees, geocentric coordinates, other units, different units of plan
///                     and height, or contradictory declarations
std::vector<std::string> check_length_units(const std::string& name,
                                            const std::vector<LengthUnitDeclaration>& declared,
                                            const LengthUnitUse& use);

/// Checks that a projection distorts lengths by at most 1 % at a position; Mercator fails away from
/// the equator. Positions outside the system's area of use, or within 100 km of the map origin,
/// count as local coordinates and are accepted.
/// @param crs  "EPSG:3857" or WKT, plan in metres; empty: none
/// @param position  plan coordinates in the file
/// @param conversion_command  command that projects the file, with "EPSG:CODE" for the system
/// @throws InputError  with the scale factor and a suitable system
void check_map_scale(const std::string& name, const std::string& crs, const Vec2& position,
                     const std::string& conversion_command);

/// Returns the map scale factor along x and y; empty if PROJ cannot compute it.
/// @cite snyder1987
std::optional<Vec2> map_scale_factor(const std::string& crs, const Vec2& position);

/// Returns the display name of a system: "NAD83 / UTM zone 13N (EPSG:26913)". Text not understood
/// by PROJ is truncated to 60 characters.
std::string reference_system_name(const std::string& crs);

}  // namespace clast
