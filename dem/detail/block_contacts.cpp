#include "dem/detail/block_contacts.hpp"

#include <algorithm>
#include <array>

#include "dem/detail/deep_contacts.hpp"

namespace clast::dem_detail {

namespace {

/// Margin of the list, as a share of the smallest side: short lists that are made anew rarely.
constexpr double kMarginShare = 0.04;
/// Faces of the ground near a vertex for which no memory is asked of the system.
constexpr std::size_t kFacesAtOnce = 32;

}  // namespace

BlockContacts::BlockContacts(const BlockSurface& ground, const BlockSurface& block, double size)
    : ground_(ground),
      block_(block),
      size_(size),
      margin_(kMarginShare * size),
      turn_(margin_ / block.bounding_radius),
      tests_(ground, block, size) {}

const std::vector<ContactPoint>& BlockContacts::contacts(const Pose& ground_from_block,
                                                         double travel) {
  tests_.move_to(ground_from_block.rotation.toRotationMatrix(), ground_from_block.translation);
  contacts_.clear();
  travel_ = travel;
  // Without a past nothing is known of how deep the two may be.
  if (list_until_ < 0.0) allowed_.reset(size_);
  if (travel >= list_until_) make_list();
  safe_until_ = list_until_;
  find_at_vertices();
  for (const ContactPoint& contact : contacts_) deepest_ = std::max(deepest_, contact.overlap);
  allowed_.update(deepest_, margin_);
  if (touching_distance() > list_touching_) make_list();
  find_at_sides();
  remove_resolved(contacts_, ground_, block_, ground_from_block, size_);
  deepest_ = 0.0;
  Vec3 normal = Vec3::Zero();
  for (const ContactPoint& contact : contacts_) {
    deepest_ = std::max(deepest_, contact.overlap);
    normal += contact.overlap * contact.normal;
  }
  if (contacts_.empty()) {
    allowed_.reset();
  } else if (!normal.isZero()) {
    direction_ = normal.normalized();
  }
  return contacts_;
}

void BlockContacts::find_at_vertices() {
  std::array<LocalGround::Face, kFacesAtOnce> few;
  std::vector<LocalGround::Face> many;
  std::uint32_t begin = 0;
  for (ListedVertex& listed : vertices_) {
    const std::span<const std::uint32_t> numbers(faces_.data() + begin, listed.end_face - begin);
    begin = listed.end_face;
    if (numbers.size() > few.size()) many.resize(numbers.size());
    LocalGround::Face* const copied = numbers.size() > few.size() ? many.data() : few.data();
    for (std::size_t i = 0; i < numbers.size(); ++i) copied[i] = ground_.local_faces[numbers[i]];
    find_at_vertex(listed, {copied, numbers.size()});
  }
}

void BlockContacts::find_at_vertex(ListedVertex& listed, std::span<const LocalGround::Face> faces) {
  const Vec3 centre = tests_.placed(block_.features.vertices[listed.vertex]);
  const LocalGround::Nearest found =
      nearest_of(faces, ground_.features, centre, 1e300, 0.0, listed.near_face);
  const NearestPoint& nearest = found.nearest;
  listed.near_face = found.entry;
  safe_until_ = std::min(safe_until_, travel_ + nearest.distance - tests_.reach());
  if (nearest.distance >= tests_.reach()) return;
  if (nearest.distance >= 0.0) {
    tests_.add_outside(listed.vertex, centre, faces, contacts_);
  } else if (tests_.is_backwards(listed.vertex, centre, nearest)) {
    contacts_.push_back(tests_.inside(
        listed.vertex, centre,
        tests_.nearest_forwards(listed.vertex, centre, nearest, ground_.local_faces)));
  } else {
    contacts_.push_back(tests_.inside(listed.vertex, centre, nearest));
  }
}

void BlockContacts::find_at_sides() {
  for (ListedPair& pair : pairs_) {
    if (travel_ < pair.clear_until) {
      safe_until_ = std::min(safe_until_, pair.clear_until);
      continue;
    }
    const std::uint32_t of_block = block_.parts.sides[pair.side].feature;
    std::optional<ContactPoint> contact;
    const Vec3 between = tests_.side(pair.kind, of_block, pair.ground_feature, contact);
    pair.clear_until = clear_until(between, contact.has_value());
    safe_until_ = std::min(safe_until_, pair.clear_until);
    if (contact) add_once(contacts_, *contact);
  }
}

}  // namespace clast::dem_detail
