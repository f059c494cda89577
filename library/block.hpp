#pragma once
/// Record of a block: shape, mass properties, axes and origin.
#include <optional>
#include <string>
#include <vector>

#include "classify/schemes.hpp"
#include "massprops/mass_properties.hpp"
#include "massprops/principal_frame.hpp"
#include "shapes/oriented_box.hpp"
#include "shapes/sphero_polyhedron.hpp"
#include "shapes/surface_deviation.hpp"
#include "shapes/volume_bracket.hpp"

namespace clast {

/// File and options from which a block was made.
struct BlockSource {
  std::string file;     ///< path as given by the user
  std::string sha256;   ///< digest of the file
  std::string options;  ///< all options that affect the block, as "key=value" separated by blanks
  std::string program_version;  ///< version of the program that made the block
  /// True if the scale of the source is unknown, as for photographs without a scale. Lengths are
  /// then in units of the source, and the mass is meaningless. Shape and density are valid.
  bool unscaled = false;
};

/// Field data of a block, entered by the user.
struct FieldNotes {
  std::string site;
  std::string note;
  std::optional<Axes> taped_axes;      ///< m
  std::optional<double> weighed_mass;  ///< kg
};

/// Visibility and certainty of a block in the scan of a deposit.
struct DepositRecord {
  std::size_t points = 0;         ///< number of points on its surface
  double spacing = 0.0;           ///< distance of these points, m
  double visible_fraction = 0.0;  ///< observed area over the area of the body
  /// Probability that the outline is that of one block (`DepositBlock::confidence`).
  double confidence = 0.0;
  std::vector<std::string> contacts = {};  ///< ids of the blocks that it touches
  std::size_t blocks = 1;                  ///< number of blocks that were found in the scan
};

/// Block: shape, mass properties, source and field notes. Geometry is in the frame of the source,
/// in metres, z up.
struct Block {
  std::string id;
  BlockSource source;
  TriangleMesh surface;  ///< closed mesh from which the block was made: outer surface or core
  SpheroPolyhedron body;
  double density = 2650.0;  ///< kg/m^3
  MassProperties mass;      ///< mass properties of the rounded body
  double area = 0.0;        ///< area of the rounded surface, m^2
  PrincipalFrame principal;
  OrientedBox box;  ///< smallest box of the rounded body
  SurfaceDeviation
      deviation;  ///< deviation of the rounded body from the full scan; zero for a core
  bool from_core = false;
  std::optional<VolumeBracket>
      volume_bracket;  ///< bounds of volume and axes; empty if the scan is practically complete
  std::optional<DepositRecord> deposit;  ///< empty if it was not split off the scan of a deposit
  std::vector<std::string> warnings;
  FieldNotes field;

  Axes axes() const { return {box.lengths[0], box.lengths[1], box.lengths[2]}; }
  /// Returns the transform from the body frame to the source frame. The body frame has its origin
  /// at the centre of mass and its axes along the principal axes.
  Pose source_from_body() const { return {mass.centre, principal.rotation}; }
};

}  // namespace clast
