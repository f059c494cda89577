#include "dem/search/block_contacts.hpp"

#include <algorithm>
#include <cmath>

#include "dem/search/detail/deep_contacts.hpp"

namespace clast::dem_detail {

namespace {

/// Margin of the list, as a share of the smallest side: short lists that are made anew rarely.
constexpr double kBlockMarginShare = 0.04;
/// A list for contacts this many times as deep as may come is made anew.
constexpr double kListedTooDeep = 2.0;
/// A way out of the ground that does not lead through the block itself is taken up to this many
/// times as deep as other vertices are ...
constexpr double kForwardsTimes = 2.0;
/// ... or up to this share of the smallest side: beyond lies the far side of the ground.
constexpr double kForwardsShare = 0.25;
/// How much farther than the nearest face others are looked for, in margins: for half that way the
/// nearest is sure to be it.
constexpr double kDistinctBlockMargins = 0.25;

}  // namespace

BlockContacts::BlockContacts(const BlockSurface& ground, const BlockSurface& block, double size)
    : ground_(ground),
      block_(block),
      size_(size),
      margin_(kBlockMarginShare * size),
      turn_(margin_ / block.bounding_radius),
      tests_(ground, block, size) {}

BlockContacts::Scratch& BlockContacts::scratch() {
  thread_local Scratch of_thread;
  return of_thread;
}

std::vector<ContactPoint>& BlockContacts::contacts(const Pose& ground_from_block, double travel) {
  std::vector<ContactPoint>& contacts = scratch().contacts;
  tests_.move_to(ground_from_block.rotation.toRotationMatrix(), ground_from_block.translation);
  contacts.clear();
  scratch().backwards.clear();
  travel_ = travel;
  // Without a past nothing is known of how deep the two may be.
  if (list_until_ < 0.0) allowed_.reset(size_);
  if (travel >= list_until_) make_list();
  safe_until_ = list_until_;
  find_at_vertices();
  for (const ContactPoint& contact : contacts) deepest_ = std::max(deepest_, contact.overlap);
  allowed_.update(deepest_, margin_);
  if (touching_distance() > list_touching_) make_list();
  find_at_sides();
  remove_resolved(contacts, ground_, block_, ground_from_block, size_);
  deepest_ = 0.0;
  Vec3 normal = Vec3::Zero();
  for (const ContactPoint& contact : contacts) {
    deepest_ = std::max(deepest_, contact.overlap);
    normal += contact.overlap * contact.normal;
  }
  if (contacts.empty()) {
    allowed_.reset();
  } else if (!normal.isZero()) {
    direction_ = normal.normalized();
  }
  if (kListedTooDeep * touching_distance() < list_touching_) list_until_ = travel_;
  return contacts;
}

void BlockContacts::find_at_vertices() {
  std::uint32_t begin = 0;
  for (ListedVertex& listed : vertices_) {
    const std::span<const std::uint32_t> faces(faces_.data() + begin, listed.end_face - begin);
    begin = listed.end_face;
    if (travel_ >= listed.clear_until) find_at_vertex(listed, faces);
    safe_until_ = std::min(safe_until_, listed.clear_until);
  }
  turn_forwards();
}

void BlockContacts::turn_forwards() {
  auto& [contacts, all_backwards, near_faces] = scratch();
  double deepest = kForwardsShare * size_;
  for (std::size_t i = 0, next = 0; i < contacts.size(); ++i) {
    if (next < all_backwards.size() && all_backwards[next].contact == i) {
      ++next;
    } else {
      deepest = std::max(deepest, kForwardsTimes * contacts[i].overlap);
    }
  }
  for (const Backwards& backwards : all_backwards) {
    const ContactPoint forwards =
        tests_.inside(backwards.vertex, backwards.centre,
                      tests_.nearest_forwards(backwards.vertex, backwards.centre, backwards.nearest,
                                              ground_.local_faces));
    if (forwards.overlap <= deepest) contacts[backwards.contact] = forwards;
  }
  all_backwards.clear();
}

void BlockContacts::find_at_vertex(ListedVertex& listed, std::span<const std::uint32_t> numbers) {
  auto& [contacts, all_backwards, near_faces] = scratch();
  const Vec3 centre = tests_.placed(block_.features.vertices[listed.vertex]);
  const LocalFaces::Face& sure = ground_.local_faces[numbers[listed.near_face]];
  std::span<const LocalFaces::Face> faces(&sure, 1);
  NearestPoint nearest;
  if (travel_ < listed.sure_until) nearest = foot_on_face(ground_.features, sure.face, centre);
  if (!nearest.within_face) {
    near_faces.clear();
    for (const std::uint32_t face : numbers) near_faces.push_back(ground_.local_faces[face]);
    faces = near_faces;
    nearest = nearest_of_all(listed, faces, centre);
  }
  listed.clear_until = travel_ + nearest.distance - tests_.reach();
  if (nearest.distance >= tests_.reach()) return;
  if (nearest.distance >= 0.0) {
    tests_.add_outside(listed.vertex, centre, faces, contacts);
  } else {
    if (tests_.is_backwards(listed.vertex, centre, nearest)) {
      all_backwards.push_back({contacts.size(), listed.vertex, centre, nearest});
    }
    contacts.push_back(tests_.inside(listed.vertex, centre, nearest));
  }
}

/// Of all its faces; finds out for how long the nearest one is sure to be it.
NearestPoint BlockContacts::nearest_of_all(ListedVertex& listed,
                                           std::span<const LocalFaces::Face> faces,
                                           const Vec3& centre) {
  const double beyond = kDistinctBlockMargins * margin_;
  const LocalFaces::Nearest found =
      nearest_of(faces, ground_.features, centre, 1e300, beyond, listed.near_face);
  // Faces that are not listed are at least this far by now.
  const double unlisted = tests_.reach() + margin_ + list_until_ - travel_;
  const double others = std::min(found.second, unlisted);
  listed.near_face = found.entry;
  listed.sure_until = travel_ + std::min(0.5 * (others - std::abs(found.nearest.distance)),
                                         others - tests_.reach());
  return found.nearest;
}

void BlockContacts::find_at_sides() {
  for (ListedPair& pair : pairs_) {
    if (travel_ < pair.clear_until) {
      safe_until_ = std::min(safe_until_, pair.clear_until);
      continue;
    }
    const std::uint32_t of_block = block_.parts.sides[pair.side].feature;
    std::optional<ContactPoint> contact;
    const FeaturesApart apart = tests_.side(pair.kind, of_block, pair.ground_feature, contact);
    pair.clear_until = clear_until(apart, contact.has_value());
    safe_until_ = std::min(safe_until_, pair.clear_until);
    if (contact) add_once(scratch().contacts, *contact);
  }
}

}  // namespace clast::dem_detail
