#include "dem/search/contact_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "dem/search/detail/deep_contacts.hpp"
#include "dem/surface/trim.hpp"

namespace clast::dem_detail {
namespace {

/// Margin, as a share of the block's smallest side: lists of what is near look ahead some of them,
/// far enough to be made anew rarely, and near enough to stay short.
constexpr double kGroundMarginShare = 0.05;
/// The ground near a part is gathered for this many margins of movement.
constexpr double kPartMargins = 4.0;
/// The ground near the whole block is gathered for this many margins of movement more.
constexpr double kGroundMargins = 8.0;
/// The ground's mean normal near a part may turn this far from its axis, as a cosine.
constexpr double kSameAxis = 0.97;
/// A part this many margins from the ground is far again.
constexpr double kFarMargins = 2.0;

}  // namespace

ContactSearch::ContactSearch(const IndexedSurface& ground, const BlockSurface& block, double size)
    : ground_(ground),
      surface_(block),
      block_(block.features),
      parts_(block.parts),
      reach_(block.radius + ground.radius),
      size_(size),
      margin_(kGroundMarginShare * size),
      list_holds_(kPartMargins * margin_),
      tests_(ground, block, size),
      part_states_(parts_.parts.size()),
      part_due_(parts_.parts.size(), -1.0) {
  for (const Vec3& vertex : block_.vertices) {
    bounding_radius_ = std::max(bounding_radius_, vertex.norm());
  }
  for (const BlockPart& part : parts_.parts) {
    farthest_ = std::max(farthest_, part.centre.norm() + part.radius);
  }
}

ContactSearch::Scratch& ContactSearch::scratch() {
  thread_local Scratch of_thread;
  return of_thread;
}

std::vector<ContactPoint>& ContactSearch::contacts(const Pose& ground_from_body, double travel) {
  Found& found = scratch().found;
  std::vector<ContactPoint>& contacts = found.contacts;
  const NumberList& visits = scratch().visits;
  move_to(ground_from_body);
  travel_ = travel;
  found.clear();
  list_visits();
  for (const std::uint32_t p : visits) update_vertices(p, {}, found);
  for (const ContactPoint& contact : contacts) deepest_ = std::max(deepest_, contact.overlap);
  if (allowed_.update(deepest_, margin_)) visit_all_sides();
  for (const std::uint32_t p : visits) {
    update_sides(p, {}, found);
    part_due_[p] = next_visit(p);
  }
  add_side_contacts(found);
  remove_resolved(contacts, ground_, surface_, ground_from_body, size_);
  deepest_ = 0.0;
  for (const ContactPoint& contact : contacts) deepest_ = std::max(deepest_, contact.overlap);
  touches_ = !contacts.empty();
  if (touches_) {
    search_at_ = -1.0;
  } else {
    allowed_.reset();
  }
  return contacts;
}

void ContactSearch::move_to(const Pose& ground_from_body) {
  const Mat3 rotation = ground_from_body.rotation.toRotationMatrix();
  const Vec3& position = ground_from_body.translation;
  if (started_) {
    // The turn between the two moves a point by at most 2 sin(angle/2) times its arm, and that
    // factor is the Frobenius norm of the change of the matrix over sqrt(2).
    const double turn = std::sqrt(0.5 * (rotation - tests_.rotation()).squaredNorm());
    turned_ += turn;
    last_move_ = (position - tests_.position()).norm() + turn * farthest_;
    moved_ += last_move_;
  }
  started_ = true;
  tests_.move_to(rotation, position);
}

void ContactSearch::list_visits() {
  const auto parts = static_cast<std::uint32_t>(part_due_.size());
  NumberList &due_parts = scratch().due_parts, &visits = scratch().visits;
  visits.clear(parts);
  due_parts.list(parts,
                 [due = part_due_.data(), now = moved_](std::uint32_t p) { return due[p] <= now; });
  if (due_parts.size() == 0 || sleep_whole()) return;
  for (const std::uint32_t p : due_parts) {
    if (part_states_[p].near) {
      read_way(p);
      renew_ground(p, 0.0);
    } else {
      update_part(p, moved_);
    }
    visits.add_if(part_states_[p].near != nullptr, p);
  }
}

void ContactSearch::visit_all_sides() {
  NumberList& visits = scratch().visits;
  visits.clear(static_cast<std::uint32_t>(part_states_.size()));
  for (std::uint32_t p = 0; p < part_states_.size(); ++p) {
    if (!part_states_[p].near) continue;
    NearPart& part = *part_states_[p].near;
    read_way(p);
    for (GroundFeature& feature : part.features) feature.asleep = {};
    part.pairs.clear();
    part.all_features = {};
    visits.add_if(true, p);
  }
}

bool ContactSearch::sleep_whole() {
  for (const PartState& part : part_states_) {
    if (part.near) return false;
  }
  const double look = bounding_radius_ + reach_ + 8.0 * margin_;
  double above = ground_.height_clearance(tests_.position(), 2.0 * look);
  if (above < look) {
    const std::optional<NearestPoint> nearest = ground_.nearest(tests_.position(), 2.0 * look);
    above = nearest ? nearest->distance : 2.0 * look;
  }
  if (above <= bounding_radius_ + reach_ + margin_) return false;
  for (double& due : part_due_) due = std::max(due, moved_ + above - bounding_radius_ - reach_);
  return true;
}

void ContactSearch::gather_ground(double complete) {
  if (ground_complete_ - (moved_ - ground_gathered_at_) >= complete) return;
  ground_complete_ = complete + kGroundMargins * margin_;
  ground_gathered_at_ = moved_;
  local_.gather(ground_, tests_.position(), bounding_radius_ + ground_complete_);
  for (PartState& part : part_states_) part.near_face = 0;
}

void ContactSearch::update_part(std::uint32_t p, double until) {
  const BlockPart& part = parts_.parts[p];
  PartState& state = part_states_[p];
  const Vec3 centre = placed(part.centre);
  const double touching = part.radius + reach_;
  // Often the last measurement or the plane bounds the gap well enough.
  gather_ground(touching + 2.0 * kPartMargins * margin_);
  const double complete = ground_complete_ - (moved_ - ground_gathered_at_);
  const double enough = std::max(margin_, until - moved_);
  double gap = std::min(local_.plane.clearance(centre) - part.radius, complete) - reach_;
  gap = std::max(
      gap, state.gap - (centre - state.seen).norm() - part.radius * (turned_ - state.seen_turned));
  if (gap <= enough) {
    gap = measured_gap(p);
  }
  if (gap > margin_) {
    part_due_[p] = moved_ + gap;
    return;
  }
  // A part that slept is outside the ground. At the start that is not known, nor how deep it is.
  const bool slept = !(part_due_[p] < 0.0);
  const double deepest = slept ? 0.0 : part.radius - gap - touching;
  state.near = std::make_unique<NearPart>(part);
  for (VertexState& vertex : state.near->vertices) vertex.outside = slept;
  state.near->centre = centre;
  state.near->turned = turned_;
  gather(p, deepest);
}

double ContactSearch::measured_gap(std::uint32_t p) {
  PartState& state = part_states_[p];
  const double touching = parts_.parts[p].radius + reach_;
  const double complete = ground_complete_ - (moved_ - ground_gathered_at_);
  const Vec3 centre = placed(parts_.parts[p].centre);
  double distance = complete;
  if (part_due_[p] < 0.0) {
    // Not measured yet: it may lie deep inside.
    const double far = touching + 8.0 * margin_ + 4.0 * bounding_radius_;
    const std::optional<NearestPoint> nearest = ground_.nearest(centre, far);
    distance = nearest ? nearest->distance : far;
  } else {
    const LocalFaces::Nearest found =
        local_.nearest(ground_.features, centre, complete, 0.0, state.near_face);
    state.near_face = found.entry;
    if (std::abs(found.nearest.distance) < complete) distance = found.nearest.distance;
  }
  state.gap = distance - touching;
  state.seen = centre;
  state.seen_turned = turned_;
  return state.gap;
}

void ContactSearch::read_way(std::uint32_t p) {
  NearPart& part = *part_states_[p].near;
  const Vec3 centre = placed(parts_.parts[p].centre);
  const Vec3 shift = centre - part.centre;
  const double turn = parts_.parts[p].radius * (turned_ - part.turned);
  const double across = part.axis.dot(shift), squared = shift.squaredNorm();
  part.way.across += std::abs(across) + turn;
  part.way.along += std::sqrt(std::max(0.0, squared - across * across)) + turn;
  part.way.whole += std::sqrt(squared) + turn;
  part.centre = centre;
  part.turned = turned_;
}

void ContactSearch::renew_ground(std::uint32_t p, double ahead) {
  if (const NearPart& part = *part_states_[p].near; part.way.whole + ahead < list_end(part)) {
    return;
  }
  const double touching = parts_.parts[p].radius + reach_;
  gather_ground(touching + 2.0 * kPartMargins * margin_);
  const double gap = measured_gap(p);
  if (gap > kFarMargins * margin_) {
    part_states_[p].near.reset();
    part_due_[p] = moved_ + gap;
    return;
  }
  gather(p, deepest_ + last_move_);
}

void ContactSearch::gather(std::uint32_t p, double deepest) {
  const BlockPart& part = parts_.parts[p];
  NearPart& state = *part_states_[p].near;
  const bool is_new = !(state.complete > 0.0);
  state.complete = std::max(reach_, deepest) + 2.0 * kPartMargins * margin_;
  state.gathered_at = state.way.whole;
  gather_ground(state.complete);
  const double reach = part.radius + state.complete;
  state.ground.gather(ground_.features, local_, state.centre, reach);
  if (is_new || state.axis.dot(state.ground.plane.normal) < kSameAxis) turn_axis(p);
  state.tilts.clear();
  for (const LocalFaces::Face& face : state.ground.faces) {
    const double across = std::min(std::abs(face.normal.dot(state.axis)), 1.0);
    const std::array<std::uint32_t, 3>& of_face = ground_.features.faces[face.face].edges;
    const bool at_border = std::any_of(of_face.begin(), of_face.end(), [&](std::uint32_t edge) {
      return ground_.features.edges[edge].kind == EdgeKind::kBorder;
    });
    const double along = std::sqrt(1.0 - across * across);
    state.tilts.push_back({across, along, at_border ? 0.0 : 2.0 / (across + along)});
  }
  for (VertexState& vertex : state.vertices) {
    vertex.near_face = 0;
    vertex.closest_plane = kNoFeature;
  }
  state.pairs.clear();
  state.features.clear();
  state.all_features = state.all_pairs = {};
  const SurfaceFeatures& features = ground_.features;
  const auto list_near = [&](bool is_corner, std::uint32_t number, const Vec3& nearest) {
    if ((state.centre - nearest).squaredNorm() > reach * reach) return;
    state.features.push_back({.is_corner = is_corner, .number = number, .asleep = {}});
  };
  for (const std::uint32_t edge : local_.edges) {
    list_near(false, edge, features.segment(features.edges[edge]).nearest(state.centre));
  }
  for (const std::uint32_t corner : local_.corners) {
    list_near(true, corner, features.vertices[corner]);
  }
  trim(state.tilts, state.features, state.pairs);
}

void ContactSearch::turn_axis(std::uint32_t p) {
  NearPart& part = *part_states_[p].near;
  part.axis = part.ground.plane.normal;
  for (VertexState& vertex : part.vertices) vertex.sure_face = kNoFeature;
  for (Asleep& asleep : part.vertex_asleep) asleep = {};
  part.other_vertices = {};
}

double ContactSearch::next_visit(std::uint32_t p) const {
  const NearPart& part = *part_states_[p].near;
  if (!part.due_vertices.empty()) return moved_;
  double least = list_end(part) - part.way.whole;
  for (const Asleep* asleep : {&part.other_vertices, &part.all_features, &part.all_pairs}) {
    const double left = asleep->left(part.way);
    if (!(left > 0.0)) return moved_;
    // No point of the part moves farther than any of the block, neither across nor along.
    const double used = asleep->per_across + asleep->per_along;
    if (left < least * used) least = left / used;
  }
  return moved_ + least;
}

Asleep ContactSearch::asleep(const NearPart& part, const Vec3& away, double apart,
                             double others) const {
  if (!(apart > 0.0 && others > 0.0)) return {};
  const double across = std::min(std::abs(away.dot(part.axis)), 1.0);
  const double along = std::sqrt(1.0 - across * across);
  const double per = 1.0 / apart, per_other = 1.0 / others;
  Asleep result{std::max(across * per, per_other), std::max(along * per, per_other), 1.0};
  result.until += result.per_across * part.way.across + result.per_along * part.way.along;
  return result;
}

}  // namespace clast::dem_detail
