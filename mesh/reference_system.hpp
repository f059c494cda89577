#pragma once
/// Units of the coordinates of a file, as its reference systems and headings declare them.
#include <optional>
#include <string>
#include <vector>

#include "core/types.hpp"

namespace clast {

/// A unit of length by the name that the file or its reference system has for it.
struct DeclaredUnit {
  double metres = 1.0;  ///< in one unit; 0: the file does not say
  std::string name;     ///< "US survey foot"
};

enum class ReferenceSystemKind {
  kUnstated,    ///< the declaration is of units alone
  kUnknown,     ///< PROJ does not understand it
  kProjected,   ///< projected or local, plan coordinates are lengths
  kGeographic,  ///< geographic
  kGeocentric,  ///< z is not up
  kVertical     ///< of heights alone
};

/// What one declaration of a file says of its coordinates.
struct LengthUnitDeclaration {
  std::string source;  ///< for messages: "GeoTIFF key 3072 = 26913, NAD83 / UTM zone 13N"
  ReferenceSystemKind kind = ReferenceSystemKind::kUnstated;
  std::optional<DeclaredUnit> plan = {};    ///< none: not declared
  std::optional<DeclaredUnit> height = {};  ///< none: not declared
  /// A projection of whole continents whose scale at the place is not known; empty: none.
  std::string world_projection = {};
};

/// Kind and units of a reference system.
/// @param crs     "EPSG:25832", or WKT of either version
/// @param source  how messages call it; the name of the system is appended
LengthUnitDeclaration describe_system(const std::string& crs, std::string source);

/// The unit of length that an EPSG code such as 9003 stands for; none for other codes.
std::optional<DeclaredUnit> epsg_length_unit(int code);

/// How coordinates are used, and how they can be converted.
struct LengthUnitUse {
  double unit = 1.0;  ///< metres that one unit of the file is taken for
  /// True: `unit` is the user's word and holds where declarations contradict each other.
  bool unit_given = false;
  bool needs_z_up = true;  ///< z must be up: geocentric coordinates are refused
  std::string conversion_command =
      {};  ///< of bringing the file to metres: "gdalwarp -t_srs EPSG:CODE"
  std::string correction_command = {};  ///< of correcting its declarations: "pdal translate ..."
  /// True: the unit can be given as `units`, which messages then advise.
  bool has_units_option = false;
};

/// Refuses coordinates that are not lengths in the unit that they are taken for.
/// @param name  of the file, for messages
/// @return notes on declarations that were not understood or that the given unit overrides
/// @throws InputError  degrees; geocentric coordinates; plan or heights in another unit; plan and
///                     heights in two units; declarations that contradict each other
std::vector<std::string> check_length_units(const std::string& name,
                                            const std::vector<LengthUnitDeclaration>& declared,
                                            const LengthUnitUse& use);

/// Refuses a projection that stretches lengths by more than 1 % at a place, such as Mercator away
/// from the equator. A place outside of the system's area of use, or within 100 km of the origin of
/// the map, counts as local coordinates and is let through.
/// @param crs    "EPSG:3857" or WKT, plan in metres; empty: none
/// @param place  plan coordinates in the file
/// @param way    a command that projects the file, with "EPSG:CODE" for the system
/// @throws InputError  with the scale and a system that suits the place
void check_map_scale(const std::string& name, const std::string& crs, const Vec2& position,
                     const std::string& conversion_command);

/// Length on the map over length on the ground, along x and along y; none where PROJ can't say.
/// @cite snyder1987
std::optional<Vec2> map_scale_factor(const std::string& crs, const Vec2& position);

/// A system as people call it: "NAD83 / UTM zone 13N (EPSG:26913)". Text that PROJ does not
/// understand is cut to 60 letters.
std::string reference_system_name(const std::string& crs);

}  // namespace clast
