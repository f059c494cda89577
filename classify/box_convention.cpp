#include "classify/box_convention.hpp"

#include "core/error.hpp"
#include "massprops/principal_frame.hpp"
#include "shapes/conventional_boxes.hpp"

namespace clast {

std::string name_of(BoxConvention convention) {
  switch (convention) {
    case BoxConvention::kSmallest:
      return "smallest";
    case BoxConvention::kInertia:
      return "inertia";
    case BoxConvention::kFeret:
      return "feret";
    case BoxConvention::kPca:
      return "pca";
  }
  return {};
}

BoxConvention parse_box_convention(const std::string& name) {
  for (const BoxConvention convention : kBoxConventions) {
    if (name_of(convention) == name) return convention;
  }
  throw InputError("unknown box convention \"" + name +
                   "\"; known are smallest, inertia, feret and pca");
}

OrientedBox box_by_convention(const SpheroPolyhedron& body, const PrincipalFrame& frame,
                              BoxConvention convention) {
  switch (convention) {
    case BoxConvention::kSmallest:
      break;
    case BoxConvention::kInertia:
      return principal_box(body.vertices, frame.rotation.toRotationMatrix(), frame.moments,
                           body.radius);
    case BoxConvention::kFeret:
      return feret_box(body.vertices, body.radius);
    case BoxConvention::kPca:
      return pca_box(body.vertices, body.radius);
  }
  return smallest_box(body);
}

}  // namespace clast
