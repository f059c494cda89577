#include "dem/search/block_narrow_phase.hpp"

#include <algorithm>
#include <cmath>

#include "dem/search/detail/resolved_contacts.hpp"

namespace clast::dem_detail {

namespace {

/// List margin, as a fraction of the smallest side. Lists are then short and rarely rebuilt.
constexpr double kBlockMarginFraction = 0.04;
/// A list is rebuilt if it allows contacts deeper than this factor times the depth limit.
constexpr double kListedTooDeep = 2.0;
/// Largest depth of a redirected contact, as a multiple of the depth of other contacts ...
constexpr double kForwardsTimes = 2.0;
/// ... or, if larger, as a fraction of the smallest side. Deeper contacts lead to the far side.
constexpr double kUninvertedFraction = 0.25;
/// Other faces are searched up to this much farther than the nearest, in list margins. The nearest
/// face then stays the nearest for a displacement of half that.
constexpr double kDistinctBlockMargins = 0.25;

}  // namespace

BlockNarrowPhase::BlockNarrowPhase(const BlockSurface& ground, const BlockSurface& block,
                                   double size)
    : ground_(ground),
      block_(block),
      size_(size),
      margin_(kBlockMarginFraction * size),
      turn_(margin_ / block.bounding_radius),
      tests_(ground, block, size) {}

BlockNarrowPhase::Scratch& BlockNarrowPhase::scratch() {
  thread_local Scratch of_thread;
  return of_thread;
}

std::vector<ContactPoint>& BlockNarrowPhase::find_contacts(const Pose& ground_from_block,
                                                           double displacement) {
  std::vector<ContactPoint>& contacts = scratch().contacts;
  tests_.set_pose(ground_from_block.rotation.toRotationMatrix(), ground_from_block.translation);
  contacts.clear();
  scratch().inverted.clear();
  displacement_ = displacement;
  // The depth of the two bodies is unknown at the first call.
  if (list_valid_until_ < 0.0) depth_limit_.reset(size_);
  if (displacement >= list_valid_until_) build_candidate_list();
  contact_free_displacement_ = list_valid_until_;
  find_all_vertex_contacts();
  for (const ContactPoint& contact : contacts) deepest_ = std::max(deepest_, contact.overlap);
  depth_limit_.update(deepest_, margin_);
  if (contact_distance() > max_listed_depth_) build_candidate_list();
  find_side_contacts();
  remove_resolved_contacts(contacts, ground_, block_, ground_from_block, size_);
  deepest_ = 0.0;
  Vec3 normal = Vec3::Zero();
  for (const ContactPoint& contact : contacts) {
    deepest_ = std::max(deepest_, contact.overlap);
    normal += contact.overlap * contact.normal;
  }
  if (contacts.empty()) {
    depth_limit_.reset();
  } else if (!normal.isZero()) {
    direction_ = normal.normalized();
  }
  if (kListedTooDeep * contact_distance() < max_listed_depth_) list_valid_until_ = displacement_;
  return contacts;
}

void BlockNarrowPhase::find_all_vertex_contacts() {
  std::uint32_t begin = 0;
  for (CandidateVertex& candidate : vertices_) {
    const std::span<const std::uint32_t> faces(faces_.data() + begin, candidate.end_face - begin);
    begin = candidate.end_face;
    if (displacement_ >= candidate.separated_until) find_vertex_contacts(candidate, faces);
    contact_free_displacement_ = std::min(contact_free_displacement_, candidate.separated_until);
  }
  resolve_inverted_contacts();
}

void BlockNarrowPhase::resolve_inverted_contacts() {
  auto& [contacts, all_backwards, near_faces] = scratch();
  double deepest = kUninvertedFraction * size_;
  for (std::size_t i = 0, next = 0; i < contacts.size(); ++i) {
    if (next < all_backwards.size() && all_backwards[next].contact == i) {
      ++next;
    } else {
      deepest = std::max(deepest, kForwardsTimes * contacts[i].overlap);
    }
  }
  for (const InvertedContact& inverted : all_backwards) {
    const ContactPoint forwards = tests_.make_inside_contact(
        inverted.vertex, inverted.centre,
        tests_.nearest_valid_push_point(inverted.vertex, inverted.centre, inverted.nearest,
                                        ground_.local_faces));
    if (forwards.overlap <= deepest) contacts[inverted.contact] = forwards;
  }
  all_backwards.clear();
}

void BlockNarrowPhase::find_vertex_contacts(CandidateVertex& candidate,
                                            std::span<const std::uint32_t> face_indices) {
  auto& [contacts, all_backwards, near_faces] = scratch();
  const Vec3 centre = tests_.in_ground_frame(block_.features.vertices[candidate.vertex]);
  const LocalFaces::Face& sure = ground_.local_faces[face_indices[candidate.near_face]];
  std::span<const LocalFaces::Face> faces(&sure, 1);
  NearestPoint nearest;
  if (displacement_ < candidate.nearest_face_until)
    nearest = project_onto_face(ground_.features, sure.face, centre);
  if (!nearest.within_face) {
    near_faces.clear();
    for (const std::uint32_t face : face_indices) near_faces.push_back(ground_.local_faces[face]);
    faces = near_faces;
    nearest = find_nearest_ground_face(candidate, faces, centre);
  }
  candidate.separated_until = displacement_ + nearest.distance - tests_.reach();
  if (nearest.distance >= tests_.reach()) return;
  if (nearest.distance >= 0.0) {
    tests_.add_outside_contacts(candidate.vertex, centre, faces, contacts);
  } else {
    if (tests_.is_inverted_push(candidate.vertex, centre, nearest)) {
      all_backwards.push_back({contacts.size(), candidate.vertex, centre, nearest});
    }
    contacts.push_back(tests_.make_inside_contact(candidate.vertex, centre, nearest));
  }
}

/// Finds the nearest of all listed faces, and the displacement for which it stays the nearest.
NearestPoint BlockNarrowPhase::find_nearest_ground_face(CandidateVertex& candidate,
                                                        std::span<const LocalFaces::Face> faces,
                                                        const Vec3& centre) {
  const double beyond = kDistinctBlockMargins * margin_;
  const LocalFaces::NearestFace found =
      find_nearest_face(faces, ground_.features, centre, 1e300, beyond, candidate.near_face);
  // Faces that are not listed are at least this far away.
  const double unlisted = tests_.reach() + margin_ + list_valid_until_ - displacement_;
  const double others = std::min(found.second, unlisted);
  candidate.near_face = found.entry;
  candidate.nearest_face_until =
      displacement_ +
      std::min(0.5 * (others - std::abs(found.nearest.distance)), others - tests_.reach());
  return found.nearest;
}

void BlockNarrowPhase::find_side_contacts() {
  for (CandidatePair& pair : pairs_) {
    if (displacement_ < pair.separated_until) {
      contact_free_displacement_ = std::min(contact_free_displacement_, pair.separated_until);
      continue;
    }
    const std::uint32_t of_block = block_.parts.sides[pair.side].feature;
    std::optional<ContactPoint> contact;
    const FeatureSeparation separation =
        tests_.test_pair(pair.kind, of_block, pair.ground_feature, contact);
    pair.separated_until = separated_until(separation, contact.has_value());
    contact_free_displacement_ = std::min(contact_free_displacement_, pair.separated_until);
    if (contact) add_unique_contact(scratch().contacts, *contact);
  }
}

}  // namespace clast::dem_detail
