#pragma once
/// Record of a block: shape, mass, axes, classes and origin.
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

struct BlockSource {
  std::string file;     ///< path as given by the user
  std::string sha256;   ///< of that file
  std::string options;  ///< all options that affect the block, as blank-separated "key=value"
  std::string program_version;  ///< of the program that made the block
  /// True if the scale of the source is unknown (photographs without a scale): lengths are in units
  /// of the source, and the mass is meaningless; shape and density are valid.
  bool unscaled = false;
};

/// Field notes, set by `clast library set`.
struct FieldNotes {
  std::string site;
  std::string note;
  std::optional<Axes> taped_axes;      ///< m
  std::optional<double> weighed_mass;  ///< kg
};

/// Block. Geometry is in the frame of the stored mesh (that of the source, in metres and z up),
/// except the principal moments.
struct Block {
  std::string id;
  BlockSource source;
  TriangleMesh surface;  ///< closed mesh from which the block was made: outer surface, or the core
  SpheroPolyhedron body;
  double density = 2650.0;  ///< kg/m^3
  MassProperties mass;      ///< of the rounded body
  double area = 0.0;        ///< of the rounded surface, m^2
  PrincipalFrame principal;
  OrientedBox box;             ///< smallest box of the rounded body
  SurfaceDeviation deviation;  ///< rounded body against the full scan; zero for a core
  bool from_core = false;
  std::optional<VolumeBracket> volume_bracket;  ///< empty if the scan is practically complete
  std::vector<std::string> warnings;
  FieldNotes field;

  Axes axes() const { return {box.lengths[0], box.lengths[1], box.lengths[2]}; }
  /// Returns the transform from the body frame, with its origin at the centre of mass and axes
  /// along the principal axes.
  Pose source_from_body() const { return {mass.centre, principal.rotation}; }
};

}  // namespace clast
