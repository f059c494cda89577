#pragma once
/// The record of one block: shape, mass, axes, classes and where it came from.
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

/// Where a block came from.
struct BlockSource {
  std::string file;     ///< path as the user gave it
  std::string sha256;   ///< of that file
  std::string options;  ///< everything that shaped the block, as "key=value" separated by blanks
  std::string program_version;  ///< of the clast that made it
  /// Nothing said how long a unit of the source is (photographs without any scale): every length of
  /// the block is in that unit, areas and volumes in its powers, and its mass means nothing. Its
  /// shape and its density are as good as another block's.
  bool unscaled = false;
};

/// What the field book says, attached by `clast library set`.
struct FieldNotes {
  std::string site;
  std::string note;
  std::optional<Axes> taped_axes;      ///< m
  std::optional<double> weighed_mass;  ///< kg
};

/// A block. Everything geometric is in the frame of the stored mesh (the source's, scaled to metres
/// and turned z up), except the principal moments.
struct Block {
  std::string id;
  BlockSource source;
  TriangleMesh surface;  ///< closed mesh the block was made from: outer surface, or the core
  SpheroPolyhedron body;
  double density = 2650.0;  ///< kg/m^3
  MassProperties mass;      ///< of the rounded body
  double area = 0.0;        ///< of the rounded surface, m^2
  PrincipalFrame principal;
  OrientedBox box;             ///< smallest box of the rounded body
  SurfaceDeviation deviation;  ///< rounded body against the whole scan; zero for a core
  bool from_core = false;
  std::optional<VolumeBracket> volume_bracket;  ///< none: the scan leaves nothing to speak of open
  std::vector<std::string> warnings;
  FieldNotes field;

  Axes axes() const { return {box.lengths[0], box.lengths[1], box.lengths[2]}; }
  /// The body frame has its origin at the centre of mass and its axes along the principal axes.
  Pose source_from_body() const { return {mass.centre, principal.rotation}; }
};

}  // namespace clast
