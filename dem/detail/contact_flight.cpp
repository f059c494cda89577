// How far or how long no contact can come: what lets a block fly on at once.
#include <algorithm>
#include <array>
#include <cmath>

#include "dem/detail/contact_search.hpp"
#include "dem/detail/flying_ball.hpp"
#include "dem/detail/free_flight.hpp"

namespace clast::dem_detail {
namespace {

/// The flight of the ball around the block is enough when it is this many times what is worthwhile:
/// less than what a closer search costs.
constexpr double kBallSteps = 16.0;
constexpr double kLongestFlight = 60.0;  ///< s
/// The search for a longer way starts at the first of these numbers of margins and goes on in
/// strides.
constexpr double kFirstLook = 0.125, kLastLook = 8.0, kStride = 4.0;
/// Vertices this far below a plane, m, are on it.
constexpr double kRounding = 1e-9;

double distance_in(double time, double speed, double acceleration) {
  return time * (speed + 0.5 * acceleration * time);
}

/// How what flies comes to a plane that has the ground on its other side.
struct Approach {
  /// @param rotation  of the body
  Approach(const Vec3& away, const FlightBounds& flight, const Mat3& rotation)
      : normal(rotation.transpose() * away),
        turn(rotation.transpose() * away.cross(flight.spin)),
        rising(away.dot(flight.velocity)),
        falling(std::max(0.0, away.z() * flight.gravity)) {}

  /// Whether what is `apart` from the plane, m, stays clear of it for a time, s. From its distance
  /// now, its speed and the largest acceleration there is towards the plane.
  /// @param arm      of the point in the body frame
  /// @param turning  bound of what turning changes its velocity by, m/s^2
  bool clear(double apart, const Vec3& arm, double turning, double time) const {
    const double speed = rising + turn.dot(arm), acceleration = falling + turning;
    return apart >= 0.0 && apart + time * (speed - 0.5 * time * acceleration) >= 0.0;
  }
  /// The time for which it does, where that is not for ever.
  double time(double apart, const Vec3& arm, double turning) const {
    const double speed = rising + turn.dot(arm), acceleration = falling + turning;
    const double root = std::sqrt(speed * speed + 2.0 * acceleration * apart);
    return speed >= 0.0 ? (speed + root) / acceleration : 2.0 * apart / (root - speed);
  }

  Vec3 normal;     ///< away from the ground, in the body frame
  Vec3 turn;       ///< likewise: times an arm, the speed away from the plane by the spin
  double rising;   ///< of the centre, m/s
  double falling;  ///< m/s^2
};

/// Beyond a border the ground goes on as a plane.
bool is_at_border(const SurfaceFeatures& surface, std::uint32_t face) {
  const std::array<std::uint32_t, 3>& edges = surface.faces[face].edges;
  return std::any_of(edges.begin(), edges.end(), [&](std::uint32_t edge) {
    return surface.edges[edge].kind == EdgeKind::kBorder;
  });
}

}  // namespace

double ContactSearch::safe_travel() {
  if (!contacts_.empty() || moved_ < search_at_) return travel_;
  // Measuring what could touch first, and only that, gives how far the block can move; each stride
  // is made only when the one before was clear.
  const double first = kFirstLook * margin_;
  double wanted = first, clear = 0.0;
  while (true) {
    clear = wanted;
    for (std::uint32_t p = 0; p < part_states_.size(); ++p) {
      clear = std::min(clear, part_clearance(p, wanted));
    }
    if (clear < wanted || wanted >= kLastLook * margin_) break;
    wanted *= kStride;
  }
  if (clear < first) search_at_ = moved_ + 0.5 * clear;
  return travel_ + clear;
}

double ContactSearch::part_clearance(std::uint32_t p, double wanted) {
  PartState& part = part_states_[p];
  if (part.near) {
    read_way(p);
    renew_ground(p, wanted);
  } else if (part_due_[p] < moved_ + wanted) {
    update_part(p, moved_ + wanted);
  }
  if (!part.near) return std::min(wanted, part_due_[p] - moved_);
  const Way ahead{wanted, wanted, wanted};
  update_vertices(p, ahead);
  update_sides(p, ahead);
  part_due_[p] = next_visit(p);
  if (!part.due_vertices.empty()) return 0.0;
  double clear = std::min(wanted, list_end(part) - part.way.whole);
  for (const Asleep& asleep : {part.other_vertices, part.all_features, part.all_pairs}) {
    if (!asleep.due(part.way + ahead)) continue;
    clear = std::min(clear, asleep.left(part.way) / (asleep.per_across + asleep.per_along));
  }
  return std::max(clear, 0.0);
}

double ContactSearch::safe_time(const FlightBounds& flight, double worthwhile) {
  if (!contacts_.empty() || moved_ < search_at_) return 0.0;
  const double ball = clear_time(ground_.grid,
                                 {.centre = tests_.position(),
                                  .velocity = flight.velocity,
                                  .gravity = flight.gravity,
                                  .radius = bounding_radius_ + reach_},
                                 kLongestFlight);
  if (ball >= kBallSteps * worthwhile) return ball;
  const double time = std::max(ball, flight_time(flight, kLongestFlight));
  if (time < worthwhile) search_at_ = moved_ + 0.5 * time * flight.top_speed;
  return time;
}

double ContactSearch::flight_time(const FlightBounds& flight, double horizon) {
  gather_ground(reach_ + kLastLook * margin_);
  const double known = ground_complete_ - (moved_ - ground_gathered_at_) - reach_;
  double time = std::min(horizon, time_over(known, flight.top_speed, flight.gravity));
  // First the face that ended the last flight: with little time left most others need no close
  // look.
  const auto look_at = [&](std::uint32_t entry) {
    const double over = flight_time_over(local_.faces[entry], flight, time);
    if (over < time) lowest_face_ = entry;
    time = std::min(time, over);
  };
  const std::uint32_t first = lowest_face_;
  if (first < local_.faces.size()) look_at(first);
  for (std::uint32_t i = 0; i < local_.faces.size(); ++i) {
    if (i != first) look_at(i);
  }
  return time;
}

double ContactSearch::flight_time_over(const LocalGround::Face& face, const FlightBounds& flight,
                                       double horizon) {
  // The ball around the block, then those around its parts, and where they are too near the
  // vertices. A block whose vertices are all above a plane is above it.
  const double height = face.normal.dot(tests_.position()) - face.offset - reach_;
  const Approach above(face.normal, flight, tests_.rotation());
  if (above.clear(height - bounding_radius_, Vec3::Zero(), 0.0, horizon)) return horizon;
  const bool at_border = is_at_border(ground_.features, face.face);
  if (!at_border &&
      time_beside(face, Vec3::Zero(), bounding_radius_, 0.0, flight, horizon) >= horizon)
    return horizon;
  near_parts_.clear();
  for (std::uint32_t p = 0; p < parts_.parts.size(); ++p) {
    const BlockPart& part = parts_.parts[p];
    const double apart = height + above.normal.dot(part.centre) - part.radius;
    if (!above.clear(apart, part.centre, flight.turning * part.arm, horizon)) {
      near_parts_.push_back(p);
    }
  }
  double time = horizon;
  for (const std::uint32_t p : near_parts_) {
    const BlockPart& part = parts_.parts[p];
    const double turning = flight.turning * (part.arm + part.radius);
    for (std::uint32_t v = part.first_vertex; v < part.end_vertex; ++v) {
      const Vec3& arm = block_.vertices[parts_.vertices[v]];
      const double apart = height + above.normal.dot(arm);
      if (apart < -kRounding) return flight_time_beside(face, flight, horizon);
      if (!above.clear(std::max(apart, 0.0), arm, turning, time)) {
        time = above.time(std::max(apart, 0.0), arm, turning);
      }
    }
  }
  return time;
}

double ContactSearch::flight_time_beside(const LocalGround::Face& face, const FlightBounds& flight,
                                         double horizon) {
  const bool at_border = is_at_border(ground_.features, face.face);
  double time = horizon;
  for (const std::uint32_t p : near_parts_) {
    const BlockPart& part = parts_.parts[p];
    const double beside = at_border ? 0.0
                                    : time_beside(face, part.centre, part.radius,
                                                  flight.turning * part.arm, flight, time);
    if (beside > 0.0) {
      time = std::min(time, beside);
    } else {
      const double way = std::min(distance_in(time, flight.top_speed, flight.gravity), margin_);
      time = std::min(time, time_over(part_clearance(p, way), flight.top_speed, flight.gravity));
    }
  }
  return time;
}

double ContactSearch::time_beside(const LocalGround::Face& face, const Vec3& arm, double radius,
                                  double turning, const FlightBounds& flight,
                                  double horizon) const {
  const Vec3 centre = placed(arm);
  const NearestPoint nearest = foot_on_face(ground_.features, face.face, centre);
  const double distance = std::abs(nearest.distance), apart = distance - radius - reach_;
  if (!(apart > 0.0)) return 0.0;
  const Approach beside((centre - nearest.point) / distance, flight, tests_.rotation());
  return beside.clear(apart, arm, turning, horizon) ? horizon : beside.time(apart, arm, turning);
}

}  // namespace clast::dem_detail
