#include "dem/detail/contact_search.hpp"

#include <algorithm>
#include <cmath>

namespace clast {
namespace {

/// Candidate lists look ahead this share of the block's smallest side: long enough to be rebuilt
/// rarely, short enough to stay short.
constexpr double kMarginShare = 0.05;
/// The ground near a part is gathered for this many margins of movement.
constexpr double kPartMargins = 4.0;
/// Edge and face contacts deeper than this share of the smallest side are not trusted: beyond the
/// middle of the block the opposite side would be nearer.
constexpr double kDepthShare = 0.5;
/// A vertex that may have moved all its distance but really moved less than this share of it needs
/// no new measurement.
constexpr double kLittleMoved = 0.5;
/// Looking for a longer flight starts at the first of these many margins and goes on in strides.
constexpr double kFirstLook = 0.125, kLastLook = 8.0, kStride = 4.0;

}  // namespace

ContactSearch::ContactSearch(const IndexedSurface& ground, const IndexedSurface& block, double size)
    : ground_(ground),
      block_(block.features),
      parts_(block_parts(block.features)),
      reach_(block.radius + ground.radius),
      margin_(kMarginShare * size),
      depth_limit_(kDepthShare * size) {
  for (const Vec3& vertex : block_.vertices) {
    bounding_radius_ = std::max(bounding_radius_, vertex.norm());
  }
  part_states_.resize(parts_.parts.size());
  vertex_states_.resize(parts_.vertices.size());
  side_states_.resize(parts_.sides.size());
  for (std::uint32_t p = 0; p < parts_.parts.size(); ++p) {
    const BlockPart& part = parts_.parts[p];
    for (std::uint32_t v = part.first_vertex; v < part.end_vertex; ++v) vertex_states_[v].part = p;
    for (std::uint32_t s = part.first_side; s < part.end_side; ++s) side_states_[s].part = p;
  }
}

const std::vector<ContactPoint>& ContactSearch::contacts(const Pose& ground_from_body,
                                                         double travel) {
  const Mat3 rotation = ground_from_body.rotation.toRotationMatrix();
  if (started_) moved_ += displacement(rotation, ground_from_body.translation);
  started_ = true;
  rotation_ = rotation;
  position_ = ground_from_body.translation;
  travel_ = travel;
  contacts_.clear();
  if (moved_ >= next_part_ || moved_ > horizon_) wake();
  for (const std::uint32_t v : awake_vertices_) {
    if (vertex_states_[v].due <= moved_) look_at_vertex(v);
  }
  for (const ContactPoint& contact : contacts_) deepest_ = std::max(deepest_, contact.overlap);
  for (const std::uint32_t s : awake_sides_) {
    if (side_states_[s].due <= moved_) {
      look_at_side(s, moved_, std::max(reach_, deepest_) + 2.0 * margin_);
    }
  }
  deepest_ = 0.0;
  for (const ContactPoint& contact : contacts_) deepest_ = std::max(deepest_, contact.overlap);
  if (contacts_.empty() && moved_ >= look_further_at_) look_further();
  return contacts_;
}

double ContactSearch::displacement(const Mat3& rotation, const Vec3& position) const {
  // The turn between the two moves a point by at most 2 sin(angle/2) times its arm, and that factor
  // is the Frobenius norm of the change of the matrix over sqrt(2).
  const double turn = std::sqrt(0.5 * (rotation - rotation_).squaredNorm());
  return (position - position_).norm() + turn * bounding_radius_;
}

void ContactSearch::wake() {
  if (moved_ >= next_part_ && !sleep_whole()) {
    for (std::uint32_t p = 0; p < part_states_.size(); ++p) {
      if (part_states_[p].due <= moved_) look_at_part(p);
    }
  }
  list_awake(moved_ + margin_);
}

bool ContactSearch::sleep_whole() {
  for (const PartState& part : part_states_) {
    if (part.near) return false;
  }
  const double look = bounding_radius_ + reach_ + 8.0 * margin_;
  double above = ground_.height_clearance(position_, 2.0 * look);
  if (above < look) {
    const std::optional<NearestPoint> nearest = ground_.nearest(position_, 2.0 * look);
    above = nearest ? nearest->distance : 2.0 * look;
  }
  if (above <= bounding_radius_ + reach_ + margin_) return false;
  for (PartState& part : part_states_) {
    part.due = std::max(part.due, moved_ + above - bounding_radius_ - reach_);
  }
  return true;
}

void ContactSearch::look_at_part(std::uint32_t p) {
  const BlockPart& part = parts_.parts[p];
  PartState& state = part_states_[p];
  const Vec3 centre = placed(part.centre);
  const double touching = part.radius + reach_;
  const double look = touching + 8.0 * margin_;
  double distance = ground_.height_clearance(centre, look);
  if (distance <= touching + margin_) {
    const double far = look + 4.0 * bounding_radius_;
    const std::optional<NearestPoint> nearest = ground_.nearest(centre, far);
    distance = nearest ? nearest->distance : far;
  }
  if (distance <= touching + margin_) return gather(p, distance);
  state.near = false;
  state.due = moved_ + (distance - touching);
}

void ContactSearch::gather(std::uint32_t p, double distance) {
  const BlockPart& part = parts_.parts[p];
  PartState& state = part_states_[p];
  // How deep a vertex of the part can be inside the ground: unknown at the start, not at all when
  // the part slept, as last seen when it was near.
  double deepest = state.due < 0.0 ? part.radius - distance : 0.0;
  for (std::uint32_t v = part.first_vertex; v < part.end_vertex; ++v) {
    VertexState& vertex = vertex_states_[v];
    if (state.near) {
      deepest = std::max(deepest, moved_ - vertex.seen_at - vertex.distance);
    } else {
      vertex = {.part = p, .due = moved_, .distance = reach_, .seen_at = moved_};
    }
    vertex.near_face = 0;
  }
  if (!state.near) {
    for (std::uint32_t s = part.first_side; s < part.end_side; ++s) {
      SideState& side = side_states_[s];
      side.due = side.clear_until = side.list_until = side.others_clear_until = moved_;
    }
  }
  deepest = std::max(std::min(deepest, part.radius - distance), deepest_);
  const double ahead = kPartMargins * margin_;
  state.complete = std::max(reach_, deepest) + 2.0 * ahead;
  state.gathered_at = moved_;
  state.due = moved_ + ahead;
  state.near = true;
  state.ground.gather(ground_, placed(part.centre), part.radius + state.complete);
}

void ContactSearch::list_awake(double horizon) {
  horizon_ = horizon;
  awake_vertices_.clear();
  awake_sides_.clear();
  next_part_ = sleepers_clear_until_ = 1e300;
  for (std::uint32_t p = 0; p < part_states_.size(); ++p) {
    const PartState& state = part_states_[p];
    next_part_ = std::min(next_part_, state.due);
    if (!state.near) {
      sleepers_clear_until_ = std::min(sleepers_clear_until_, state.due);
      continue;
    }
    const BlockPart& part = parts_.parts[p];
    for (std::uint32_t v = part.first_vertex; v < part.end_vertex; ++v) {
      if (vertex_states_[v].due <= horizon) {
        awake_vertices_.push_back(v);
      } else {
        sleepers_clear_until_ = std::min(sleepers_clear_until_, vertex_states_[v].due);
      }
    }
    for (std::uint32_t s = part.first_side; s < part.end_side; ++s) {
      if (side_states_[s].due <= horizon) {
        awake_sides_.push_back(s);
      } else {
        sleepers_clear_until_ = std::min(sleepers_clear_until_, side_states_[s].clear_until);
      }
    }
  }
}

double ContactSearch::earliest_touch() const {
  double earliest = sleepers_clear_until_;
  for (const std::uint32_t v : awake_vertices_) {
    earliest = std::min(earliest, vertex_states_[v].due);
  }
  for (const std::uint32_t s : awake_sides_) {
    earliest = std::min(earliest, side_states_[s].clear_until);
  }
  return earliest;
}

void ContactSearch::look_further() {
  // What is known decays with every movement. Measuring what could touch first, and only that,
  // shows how far the block can really go; each stride is made only when the one before was clear.
  const double first = kFirstLook * margin_;
  for (double wanted = first; wanted <= kLastLook * margin_; wanted *= kStride) {
    const double until = moved_ + wanted;
    if (earliest_touch() >= until) continue;
    if (until > horizon_) {
      for (std::uint32_t p = 0; p < part_states_.size(); ++p) {
        if (!part_states_[p].near && part_states_[p].due < until) look_at_part(p);
      }
      list_awake(until);
    }
    for (const std::uint32_t v : awake_vertices_) {
      if (vertex_states_[v].due < until) {
        measure_vertex(v, placed(block_.vertices[parts_.vertices[v]]));
      }
    }
    for (const std::uint32_t s : awake_sides_) {
      if (side_states_[s].clear_until < until) look_at_side(s, until, reach_ + wanted);
    }
    if (earliest_touch() < until) break;
  }
  look_further_at_ = moved_ + 0.5 * std::min(first, earliest_touch() - moved_);
}

void ContactSearch::add(const ContactPoint& contact) {
  // A point on the border between two faces of one plane, or at the joint of two collinear edges,
  // is found twice but is one contact.
  for (const ContactPoint& known : contacts_) {
    const bool related =
        known.kind == contact.kind && (known.block_feature == contact.block_feature ||
                                       (known.kind != ContactKind::kVertexGround &&
                                        known.ground_feature == contact.ground_feature));
    if (related && known.normal.dot(contact.normal) > 1.0 - 1e-12 &&
        (known.foot - contact.foot).squaredNorm() < 1e-18) {
      return;
    }
  }
  contacts_.push_back(contact);
}

bool ContactSearch::meets_vertex(std::uint32_t vertex, const Vec3& normal) const {
  return in_cone(block_, vertex, -(rotation_.transpose() * normal));
}

void ContactSearch::look_at_vertex(std::uint32_t v) {
  VertexState& state = vertex_states_[v];
  const Vec3 centre = placed(block_.vertices[parts_.vertices[v]]);
  if (look_at_sure_face(v, centre)) return;
  const double gap = state.distance - reach_;
  const double gap_left = gap - (centre - state.seen).norm();
  if (gap_left > kLittleMoved * gap) {
    state.due = moved_ + gap_left;
    return;
  }
  measure_vertex(v, centre);
}

void ContactSearch::measure_vertex(std::uint32_t v, const Vec3& centre) {
  VertexState& state = vertex_states_[v];
  const PartState& part = part_states_[state.part];
  const double complete = completeness(part);
  // Other faces are measured only as far as it matters that they are farther.
  const double beyond = state.distance < reach_ + margin_ ? kPartMargins * margin_ : 0.0;
  NearestPoint nearest;
  nearest.distance = 1e300;
  double second = complete;  // a lower bound of how far all other faces are
  const auto measure = [&](const LocalGround::Face& face) {
    const double limit = std::min(std::abs(nearest.distance), complete) + beyond;
    if (std::abs(face.normal.dot(centre) - face.offset) > limit) return false;
    const double near = limit + face.radius;
    if ((centre - face.middle).squaredNorm() > near * near) return false;
    const NearestPoint candidate = nearest_on_face(ground_.features, face.face, centre);
    const double distance = std::abs(candidate.distance), best = std::abs(nearest.distance);
    // Ties go to the smaller face number, so that the order of looking does not matter.
    const bool nearer = distance < best || (distance == best && candidate.face < nearest.face);
    second = std::min(second, nearer ? best : distance);
    if (nearer) nearest = candidate;
    return nearer;
  };
  const std::vector<LocalGround::Face>& faces = part.ground.faces;
  const std::uint32_t guess = state.near_face;
  if (guess < faces.size()) measure(faces[guess]);
  for (std::uint32_t i = 0; i < faces.size(); ++i) {
    if (i != guess && measure(faces[i])) state.near_face = i;
  }
  const double depth = std::abs(nearest.distance);
  second = std::min(second, depth + beyond);

  state.seen_at = moved_;
  state.seen = centre;
  state.sure_face = kNoFeature;
  // Beyond what the list holds nothing is known, not even the side.
  state.distance = depth < complete ? nearest.distance : complete;
  state.due = moved_ + (state.distance - reach_);
  if (depth >= complete) return;
  if (nearest.within_face) {
    state.sure_face = nearest.face;
    state.sure_inside_until = moved_ + 0.5 * (second - depth);
    state.sure_outside_until = moved_ + (second - reach_);
  }
  if (nearest.distance >= reach_) return;
  if (nearest.distance >= 0.0) return add_outside_contacts(v, centre);
  add_inside_contact(v, centre, nearest);
}

bool ContactSearch::look_at_sure_face(std::uint32_t v, const Vec3& centre) {
  VertexState& state = vertex_states_[v];
  if (state.sure_face == kNoFeature) return false;
  const SurfaceFace& face = ground_.features.faces[state.sure_face];
  const double height = face.normal.dot(centre - ground_.features.vertices[face.vertices[0]]);
  if (moved_ >= (height < 0.0 ? state.sure_inside_until : state.sure_outside_until)) return false;
  if (!over_face(ground_.features, face, centre)) return false;
  state.distance = height;
  state.seen = centre;
  state.seen_at = moved_;
  if (height >= reach_) {
    state.due = std::min(moved_ + height - reach_, state.sure_outside_until);
    return true;
  }
  state.due = moved_;
  ContactPoint contact;
  contact.block_feature = parts_.vertices[v];
  contact.ground_feature = contact.ground_face = state.sure_face;
  contact.normal = face.normal;
  contact.overlap = reach_ - height;
  contact.foot = centre + (ground_.radius - height) * face.normal;
  contacts_.push_back(contact);
  return true;
}

void ContactSearch::add_inside_contact(std::uint32_t v, const Vec3& centre,
                                       const NearestPoint& nearest) {
  ContactPoint contact;
  contact.block_feature = parts_.vertices[v];
  contact.ground_feature = contact.ground_face = nearest.face;
  const double depth = -nearest.distance;
  // On the surface itself, and above a face, the direction to it is its normal.
  contact.normal =
      nearest.within_face || depth < 1e-9 ? nearest.normal : Vec3((nearest.point - centre) / depth);
  contact.overlap = reach_ + depth;
  contact.foot = nearest.point + ground_.radius * contact.normal;
  contacts_.push_back(contact);
}

void ContactSearch::add_outside_contacts(std::uint32_t v, const Vec3& centre) {
  const SurfaceFeatures& ground = ground_.features;
  const std::uint32_t vertex = parts_.vertices[v];
  ContactPoint contact;
  contact.block_feature = vertex;
  const auto touch = [&](std::uint32_t face, const Vec3& on_ground, const Vec3& normal,
                         double distance) {
    contact.ground_feature = contact.ground_face = face;
    contact.normal = normal;
    contact.overlap = reach_ - distance;
    contact.foot = on_ground + ground_.radius * normal;
    add(contact);
  };
  for (const LocalGround::Face& local : part_states_[vertex_states_[v].part].ground.faces) {
    const double near = reach_ + local.radius;
    if ((centre - local.middle).squaredNorm() > near * near) continue;
    const std::uint32_t f = local.face;
    const SurfaceFace& face = ground.faces[f];
    const double height = face.normal.dot(centre - ground.vertices[face.vertices[0]]);
    if (height < 0.0 || height >= reach_) continue;
    if (over_face(ground, face, centre)) {
      touch(f, centre - height * face.normal, face.normal, height);
      continue;
    }
    for (int k = 0; k < 3; ++k) {
      const SurfaceEdge& edge = ground.edges[face.edges[k]];
      if (edge.faces[0] == f && edge.convex()) {  // each edge once
        const double along = edge.direction.dot(centre - ground.vertices[edge.vertices[0]]);
        if (along >= 0.0 && along <= edge.length) {
          const Vec3 on_edge = ground.vertices[edge.vertices[0]] + along * edge.direction;
          const Vec3 out = centre - on_edge;
          const double distance = out.norm();
          if (distance > 0.0 && distance < reach_) {
            const Vec3 normal = out / distance;
            if (in_arc(edge, normal) && meets_vertex(vertex, normal)) {
              touch(f, on_edge, normal, distance);
            }
          }
        }
      }
      const std::uint32_t corner = face.vertices[k];
      if (!ground.pointed[corner]) continue;
      const Vec3 out = centre - ground.vertices[corner];
      const double distance = out.norm();
      if (!(distance > 0.0 && distance < reach_)) continue;
      const Vec3 normal = out / distance;
      if (in_cone(ground, corner, normal) && meets_vertex(vertex, normal)) {
        touch(f, ground.vertices[corner], normal, distance);
      }
    }
  }
}

}  // namespace clast
