#include "dem/detail/contact_search.hpp"

#include <algorithm>
#include <cmath>

#include "dem/detail/deep_contacts.hpp"
#include "dem/detail/flying_ball.hpp"

namespace clast::dem_detail {
namespace {

/// Candidate lists look ahead this share of the block's smallest side: long enough to be rebuilt
/// rarely, short enough to stay short.
constexpr double kMarginShare = 0.05;
/// The ground near a part is gathered for this many margins of movement.
constexpr double kPartMargins = 4.0;
/// Edge and face contacts deeper than this share of the smallest side are not trusted: beyond the
/// middle of the block the opposite side would be nearer.
constexpr double kDepthShare = 0.5;
/// The ground near the whole block is gathered for this many margins of movement more.
constexpr double kGroundMargins = 8.0;
/// Pairs are listed when they are this many margins from touching.
constexpr double kPairMargins = 3.0;
/// What is due is listed for this many calls like the last, but for this share of a margin at
/// least.
constexpr double kListCalls = 16.0, kShortest = 1.0 / 16.0;
/// The flight of the ball around the block is enough when it is this many times what is worthwhile:
/// less than what a closer search costs.
constexpr double kBallSteps = 16.0;
constexpr double kLongestFlight = 60.0;  ///< s
/// The search for a longer flight starts at the first of these numbers of margins and goes on in
/// strides.
constexpr double kFirstLook = 0.125, kLastLook = 8.0, kStride = 4.0;

/// From distance = speed t + acceleration t^2/2, in the form that keeps its digits.
double time_over(double distance, double speed, double acceleration) {
  if (!(distance > 0.0)) return 0.0;
  return 2.0 * distance / (speed + std::sqrt(speed * speed + 2.0 * acceleration * distance));
}

double distance_in(double time, double speed, double acceleration) {
  return time * (speed + 0.5 * acceleration * time);
}

}  // namespace

ContactSearch::ContactSearch(const IndexedSurface& ground, const BlockSurface& block, double size)
    : ground_(ground),
      surface_(block),
      block_(block.features),
      parts_(block.parts),
      reach_(block.radius + ground.radius),
      size_(size),
      margin_(kMarginShare * size),
      depth_limit_(kDepthShare * size),
      awake_vertices_(parts_.vertices.size()),
      awake_sides_(parts_.sides.size()),
      due_sides_(parts_.sides.size()) {
  for (const Vec3& vertex : block_.vertices) {
    bounding_radius_ = std::max(bounding_radius_, vertex.norm());
  }
  part_states_.resize(parts_.parts.size());
  vertex_states_.resize(parts_.vertices.size());
  side_states_.resize(parts_.sides.size());
  side_lists_.resize(parts_.sides.size());
  vertex_due_.assign(parts_.vertices.size(), -1.0);
  side_due_.assign(parts_.sides.size(), -1.0);
  for (std::uint32_t p = 0; p < parts_.parts.size(); ++p) {
    const BlockPart& part = parts_.parts[p];
    for (std::uint32_t v = part.first_vertex; v < part.end_vertex; ++v) vertex_states_[v].part = p;
    for (std::uint32_t s = part.first_side; s < part.end_side; ++s) side_lists_[s].part = p;
  }
}

const std::vector<ContactPoint>& ContactSearch::contacts(const Pose& ground_from_body,
                                                         double travel) {
  move_to(ground_from_body);
  travel_ = travel;
  contacts_.clear();
  if (moved_ >= next_part_ || moved_ > horizon_) wake();
  list_due_sides();
  for (const std::uint32_t v : awake_vertices_) {
    if (vertex_due_[v] <= moved_) update_vertex(v, moved_);
  }
  for (const ContactPoint& contact : contacts_) deepest_ = std::max(deepest_, contact.overlap);
  update_due_sides(std::max(reach_, deepest_pair()) + kPairMargins * margin_);
  remove_resolved(contacts_, ground_, surface_, ground_from_body, size_);
  deepest_ = 0.0;
  for (const ContactPoint& contact : contacts_) deepest_ = std::max(deepest_, contact.overlap);
  if (!contacts_.empty()) {
    search_at_ = -1.0;
    if (listed_for_flight_) horizon_ = -1.0;
  }
  return contacts_;
}

void ContactSearch::move_to(const Pose& ground_from_body) {
  const Mat3 rotation = ground_from_body.rotation.toRotationMatrix();
  const Vec3& position = ground_from_body.translation;
  if (started_) {
    // The turn between the two moves a point by at most 2 sin(angle/2) times its arm, and that
    // factor is the Frobenius norm of the change of the matrix over sqrt(2).
    const double turn = std::sqrt(0.5 * (rotation - rotation_).squaredNorm());
    turned_ += turn;
    last_move_ = (position - position_).norm() + turn * bounding_radius_;
    moved_ += last_move_;
  }
  started_ = true;
  rotation_ = rotation;
  position_ = position;
}

void ContactSearch::wake() {
  bool relist = moved_ > horizon_;
  if (moved_ >= next_part_ && !sleep_whole()) {
    for (std::uint32_t p = 0; p < part_states_.size(); ++p) {
      PartState& part = part_states_[p];
      if (part.due > moved_) continue;
      const bool was_near = part.near;
      update_part(p, moved_);
      relist = relist || part.near != was_near;
    }
  }
  if (relist) return list_awake(moved_ + list_ahead());
  find_next_part();
}

double ContactSearch::list_ahead() const {
  return std::clamp(kListCalls * last_move_, kShortest * margin_, margin_);
}

void ContactSearch::find_next_part() {
  next_part_ = 1e300;
  for (const PartState& part : part_states_) next_part_ = std::min(next_part_, part.due);
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

void ContactSearch::gather_ground(double complete) {
  if (ground_complete_ - (moved_ - ground_gathered_at_) >= complete) return;
  ground_complete_ = complete + kGroundMargins * margin_;
  ground_gathered_at_ = moved_;
  local_.gather(ground_, position_, bounding_radius_ + ground_complete_);
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
  if (!state.near) {
    gap = std::max(gap, state.gap - (centre - state.seen).norm() -
                            part.radius * (turned_ - state.seen_turned));
  }
  if (gap <= enough) {
    double distance = complete;
    if (state.due < 0.0) {
      // Not measured yet: it may lie deep inside.
      const double far = touching + 8.0 * margin_ + 4.0 * bounding_radius_;
      const std::optional<NearestPoint> nearest = ground_.nearest(centre, far);
      distance = nearest ? nearest->distance : far;
    } else {
      const LocalGround::Nearest found =
          local_.nearest(ground_.features, centre, complete, 0.0, state.near_face);
      state.near_face = found.entry;
      if (std::abs(found.nearest.distance) < complete) distance = found.nearest.distance;
    }
    gap = distance - touching;
    state.gap = gap;
    state.seen = centre;
    state.seen_turned = turned_;
  }
  if (gap <= margin_) return gather(p, gap + touching);
  state.near = false;
  state.due = moved_ + gap;
}

void ContactSearch::gather(std::uint32_t p, double distance) {
  const BlockPart& part = parts_.parts[p];
  PartState& state = part_states_[p];
  // How deep a vertex of the part can be inside the ground: unknown at the start, not at all when
  // the part slept, as last measured when it was near.
  double deepest = state.due < 0.0 ? part.radius - distance : 0.0;
  for (std::uint32_t v = part.first_vertex; v < part.end_vertex; ++v) {
    VertexState& vertex = vertex_states_[v];
    if (state.near) {
      deepest = std::max(deepest, moved_ - vertex.seen_at - vertex.distance);
    } else {
      vertex = {.part = p, .distance = reach_, .seen_at = moved_};
      vertex_due_[v] = moved_;
    }
    vertex.near_face = 0;
  }
  if (!state.near) {
    for (std::uint32_t s = part.first_side; s < part.end_side; ++s) {
      SideState& side = side_states_[s];
      side_due_[s] = side.clear_until = side.list_until = side.others_clear_until = moved_;
      side_lists_[s].list_holds = 0.0;
    }
  }
  deepest = std::max(std::min(deepest, part.radius - distance), deepest_);
  const double ahead = kPartMargins * margin_;
  state.complete = std::max(reach_, deepest) + 2.0 * ahead;
  state.gathered_at = moved_;
  state.due = moved_ + ahead;
  state.near = true;
  gather_ground(state.complete);
  state.ground.gather(ground_.features, local_, placed(part.centre), part.radius + state.complete);
}

void ContactSearch::list_awake(double horizon) {
  horizon_ = horizon;
  listed_for_flight_ = false;
  awake_vertices_.clear();
  awake_sides_.clear();
  double sleepers_clear_until = 1e300;
  const auto list = [&](std::uint32_t first, std::uint32_t end, const std::vector<double>& due,
                        NumberList& awake) {
    for (std::uint32_t i = first; i < end; ++i) {
      const bool is_awake = due[i] <= horizon;
      awake.add_if(is_awake, i);
      sleepers_clear_until = std::min(sleepers_clear_until, is_awake ? 1e300 : due[i]);
    }
  };
  for (std::uint32_t p = 0; p < part_states_.size(); ++p) {
    if (!part_states_[p].near) continue;
    const BlockPart& part = parts_.parts[p];
    list(part.first_vertex, part.end_vertex, vertex_due_, awake_vertices_);
    list(part.first_side, part.end_side, side_due_, awake_sides_);
  }
  sleepers_clear_until_ = sleepers_clear_until;
  find_next_part();
}

double ContactSearch::safe_travel() {
  if (!contacts_.empty() || moved_ < search_at_) return travel_;
  // At a speed of 1 the time is the distance.
  const double first = kFirstLook * margin_;
  const double distance = search_time({.acceleration = 1e300, .top_speed = 1.0}, first);
  if (distance < first) search_at_ = moved_ + 0.5 * distance;
  return travel_ + distance;
}

double ContactSearch::safe_time(const FlightBounds& flight, double worthwhile) {
  if (!contacts_.empty() || moved_ < search_at_) return 0.0;
  const double ball = clear_time(ground_.grid,
                                 {.centre = position_,
                                  .velocity = flight.velocity,
                                  .gravity = flight.gravity,
                                  .radius = bounding_radius_ + reach_},
                                 kLongestFlight);
  if (ball >= kBallSteps * worthwhile) return ball;
  const double time = std::max(ball, search_time(flight, worthwhile));
  if (time < worthwhile) search_at_ = moved_ + 0.5 * time * flight.top_speed;
  return time;
}

double ContactSearch::search_time(const FlightBounds& flight, double first) {
  // Bounds shrink with every movement. Measuring what could touch first, and only that, gives how
  // long the block can fly; each stride is made only when the one before was clear.
  const double spin_rate = flight.spin.norm();
  double wanted = first;
  while (true) {
    const double farthest = distance_in(wanted, flight.top_speed, flight.gravity);
    const double until = moved_ + farthest;
    double time = 1e300, others_clear_until = 1e300;
    // The time that a ball around `arm` needs for its distance, looked at again when that is short.
    const auto consider = [&](const double& clear_until, const Vec3& in_body, double radius,
                              const auto& look) {
      if (clear_until >= until) {
        others_clear_until = std::min(others_clear_until, clear_until);
        return;
      }
      const Vec3 arm = rotation_ * in_body;
      const double speed = (flight.velocity + flight.spin.cross(arm)).norm() + radius * spin_rate;
      const double needed = std::min(farthest, distance_in(wanted, speed, flight.acceleration));
      if (clear_until < moved_ + needed) look(moved_ + needed);
      const double distance = clear_until - moved_;
      if (distance_in(time, speed, flight.acceleration) <= distance ||
          distance_in(time, flight.top_speed, flight.gravity) <= distance) {
        return;
      }
      time = std::max(time_over(distance, speed, flight.acceleration),
                      time_over(distance, flight.top_speed, flight.gravity));
    };
    bool relist = until > horizon_;
    for (std::uint32_t p = 0; p < part_states_.size(); ++p) {
      if (part_states_[p].near) continue;
      const double others = time;
      consider(part_states_[p].due, parts_.parts[p].centre, parts_.parts[p].radius,
               [&](double needed) { update_part(p, needed); });
      if (part_states_[p].near) {
        time = others;
        relist = true;
      }
    }
    if (relist) {
      list_awake(std::max(horizon_, until));
      listed_for_flight_ = true;
    }
    others_clear_until = std::min(others_clear_until, sleepers_clear_until_);
    for (const std::uint32_t v : awake_vertices_) {
      consider(vertex_due_[v], block_.vertices[parts_.vertices[v]], 0.0,
               [&](double needed) { update_vertex(v, needed); });
    }
    for (const std::uint32_t s : awake_sides_) {
      const BlockSide& side = parts_.sides[s];
      consider(side_states_[s].clear_until, side.middle, side.radius,
               [&](double needed) { update_side(s, needed, reach_ + (needed - moved_)); });
    }
    time = std::min(time, time_over(others_clear_until - moved_, flight.top_speed, flight.gravity));
    if (time < wanted || farthest >= kLastLook * margin_) return time;
    wanted *= kStride;
  }
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

}  // namespace clast::dem_detail
