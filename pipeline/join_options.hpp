#pragma once
/// Options for scans that are joined to one block.
#include <string>
#include <vector>

#include "core/fields.hpp"
#include "core/types.hpp"

namespace clast {

/// Rotation of a scan relative to the first one, right within 30 degrees.
struct NamedPose {
  std::string scan;            ///< path, name or stem of its file, or name of its folder
  Vec3 angles = Vec3::Zero();  ///< rotations about x, then y, then z that turn it to the first, rad
};

template <class Visit>
void visit_fields(const NamedPose& pose, Visit&& visit) {
  const auto& [scan, angles] = pose;
  visit("scan", scan);
  visit("angles", angles);
}

/// One place of a block in two scans, in units and axes of their files.
struct NamedPair {
  std::string scan_a;
  Vec3 point_a = Vec3::Zero();
  std::string scan_b;
  Vec3 point_b = Vec3::Zero();
};

template <class Visit>
void visit_fields(const NamedPair& pair, Visit&& visit) {
  const auto& [scan_a, point_a, scan_b, point_b] = pair;
  visit("scan_a", scan_a);
  visit("point_a", point_a);
  visit("scan_b", scan_b);
  visit("point_b", point_b);
}

struct JoinOptions {
  std::vector<NamedPose> poses = {};
  std::vector<NamedPair> pairs = {};  ///< at least three of a scan and those before it
  /// True if only the first scan has a scale; the scales of the others are estimated.
  bool free_scale = false;
};

template <class Visit>
void visit_fields(const JoinOptions& options, Visit&& visit) {
  const auto& [poses, pairs, free_scale] = options;
  visit("poses", poses);
  visit("pairs", pairs);
  visit("free_scale", free_scale);
}

}  // namespace clast
