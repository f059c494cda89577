// Displacements and times of flight without contact, which a block can make in one step.
#include <algorithm>
#include <array>
#include <cmath>

#include "dem/motion/free_flight.hpp"
#include "dem/search/detail/ballistic_sphere.hpp"
#include "dem/search/terrain_narrow_phase.hpp"

namespace clast::dem_detail {
namespace {

/// The flight of the bounding sphere suffices if it is this many times the shortest useful time. A
/// closer search would cost more.
constexpr double kBallSteps = 16.0;
constexpr double kMaxFlight = 60.0;  ///< s
/// First and last displacement of the search, in list margins, and the factor between them.
constexpr double kFirstLook = 0.125, kLastLook = 8.0, kStride = 4.0;
/// Vertices up to this far below a plane count as on it, m.
constexpr double kPlaneRounding = 1e-9;

double distance_in(double time, double speed, double acceleration) {
  return time * (speed + 0.5 * acceleration * time);
}

/// Approach of a flying body to a plane that has the ground on its other side.
struct Approach {
  /// @param away  direction away from the ground, unit
  Approach(const Vec3& away, const FlightBounds& flight)
      : normal(away),
        turn(away.cross(flight.spin)),
        rising(away.dot(flight.velocity)),
        falling(std::max(0.0, away.z() * flight.gravity)) {}
  /// Returns the same approach for arms in the frame of a body with this rotation.
  Approach in_body(const Mat3& rotation) const {
    Approach result = *this;
    result.normal = rotation.transpose() * normal;
    result.turn = rotation.transpose() * turn;
    return result;
  }

  /// True if a point at `distance` from the plane, m, stays clear of it for a time, s. Uses its
  /// present speed and the largest possible acceleration towards the plane.
  /// @param arm      position of the point relative to the centre
  /// @param turning  bound of its acceleration due to rotation, m/s^2
  bool clear(double distance, const Vec3& arm, double turning, double time) const {
    const double speed = rising + turn.dot(arm), acceleration = falling + turning;
    return distance >= 0.0 && distance + time * (speed - 0.5 * time * acceleration) >= 0.0;
  }
  /// Returns the time for which the point stays clear, s. It must be finite.
  double time(double distance, const Vec3& arm, double turning) const {
    const double speed = rising + turn.dot(arm), acceleration = falling + turning;
    const double root = std::sqrt(speed * speed + 2.0 * acceleration * distance);
    return speed >= 0.0 ? (speed + root) / acceleration : 2.0 * distance / (root - speed);
  }

  Vec3 normal;     ///< away from the ground
  Vec3 turn;       ///< its product with an arm is the speed away from the plane by rotation
  double rising;   ///< speed of the centre away from the plane, m/s
  double falling;  ///< acceleration towards the plane, m/s^2
};

}  // namespace

double TerrainNarrowPhase::contact_free_displacement() {
  if (touches_ || accumulated_displacement_ < search_at_) return displacement_;
  // Only parts that could touch within `wanted` are measured. It is increased only while all parts
  // are clear. At a speed of 1, the time is the displacement.
  const FlightBounds creeping{.acceleration = 1e300, .max_point_speed = 1.0};
  const double first = kFirstLook * margin_;
  double wanted = first, clear = 0.0;
  while (true) {
    clear = wanted;
    for (std::uint32_t p = 0; p < part_states_.size(); ++p) {
      clear = std::min(clear, part_contact_free_time(p, creeping, wanted));
    }
    if (clear < wanted || wanted >= kLastLook * margin_) break;
    wanted *= kStride;
  }
  if (clear < first) search_at_ = accumulated_displacement_ + 0.5 * clear;
  return displacement_ + clear;
}

double TerrainNarrowPhase::part_contact_free_time(std::uint32_t p, const FlightBounds& flight,
                                                  double wanted) {
  const BlockPart& of_block = parts_.parts[p];
  const std::unique_ptr<NearPart>& near = part_states_[p].near;
  const Vec3 velocity = flight.velocity + flight.spin.cross(tests_.rotation() * of_block.centre);
  const double turning = flight.spin.norm() * of_block.radius;
  // The smaller of two bounds: from the present speed of the points, and from their top speed.
  const auto displacement_in = [&](double time, double speed) {
    return std::min(distance_in(time, speed + turning, flight.acceleration),
                    distance_in(time, flight.max_point_speed, flight.gravity));
  };
  const auto time_for = [&](double remaining, double axial_coefficient,
                            double transverse_coefficient, double speed) {
    const double per_total = axial_coefficient + transverse_coefficient;
    return std::max(
        min_travel_time(remaining, speed + per_total * turning, per_total * flight.acceleration),
        min_travel_time(remaining, per_total * flight.max_point_speed, per_total * flight.gravity));
  };
  const double speed = velocity.norm(), total = displacement_in(wanted, speed);
  if (near) {
    update_displacement(p);
    refresh_ground_list(p, total);
  } else if (part_expiry_[p] < accumulated_displacement_ + total) {
    update_part(p, accumulated_displacement_ + total);
  }
  if (!near) {
    const double gap = part_expiry_[p] - accumulated_displacement_;
    return gap >= total ? wanted : time_for(gap, 0.0, 1.0, speed);
  }
  const NearPart& part = *near;
  const double axial = std::min(std::abs(velocity.dot(part.axis)), speed);
  const double transverse = std::sqrt(speed * speed - axial * axial);
  const AccumulatedDisplacement ahead{displacement_in(wanted, axial),
                                      displacement_in(wanted, transverse), total};
  FoundContacts& found = scratch().ahead;
  found.clear();
  update_vertices(p, ahead, found);
  update_sides(p, ahead, found);
  part_expiry_[p] = next_update(p);
  if (!part.touching_groups.empty() || part.other_vertices.is_expired(part.displacement))
    return 0.0;
  const AccumulatedDisplacement then = part.displacement + ahead;
  double time = wanted;
  if (list_expiry(part) < then.total) {
    time = time_for(list_expiry(part) - part.displacement.total, 0.0, 1.0, speed);
  }
  time = std::min(time, min_travel_time(part.pairs_contact_free_until - accumulated_displacement_,
                                        flight.max_point_speed, flight.gravity));
  for (const SeparationBound* separation_bound :
       {&part.other_vertices, &part.all_features, &part.all_pairs}) {
    if (!separation_bound->is_expired(then)) continue;
    time = std::min(time, time_for(separation_bound->remaining(part.displacement),
                                   separation_bound->axial_coefficient,
                                   separation_bound->transverse_coefficient,
                                   separation_bound->axial_coefficient * axial +
                                       separation_bound->transverse_coefficient * transverse));
  }
  return time;
}

double TerrainNarrowPhase::find_contact_free_flight_time(const FlightBounds& flight,
                                                         double worthwhile) {
  if (touches_ || accumulated_displacement_ < search_at_) return 0.0;
  const double ball = ballistic_contact_free_time(ground_.grid,
                                                  {.centre = tests_.position(),
                                                   .velocity = flight.velocity,
                                                   .gravity = flight.gravity,
                                                   .radius = bounding_radius_ + reach_},
                                                  kMaxFlight);
  if (ball >= kBallSteps * worthwhile) return ball;
  const double time = std::max(ball, contact_free_time(flight, kMaxFlight));
  if (time < worthwhile)
    search_at_ = accumulated_displacement_ + 0.5 * time * flight.max_point_speed;
  return time;
}

double TerrainNarrowPhase::contact_free_time(const FlightBounds& flight, double horizon) {
  collect_ground(reach_ + kLastLook * margin_);
  const double known =
      ground_complete_ - (accumulated_displacement_ - ground_gathered_at_) - reach_;
  double time = std::min(horizon, min_travel_time(known, flight.max_point_speed, flight.gravity));
  std::vector<std::uint32_t>& unseparated_parts = scratch().unseparated_parts;
  unseparated_parts.clear();
  // The face that limited the last flight is tested first. The time is then short, and most other
  // faces need no close test.
  const auto look_at = [&](std::uint32_t entry) {
    const double over = contact_free_time_over_face(local_.faces[entry], flight, time);
    if (over < time) lowest_face_ = entry;
    time = std::min(time, over);
  };
  const std::uint32_t first = lowest_face_;
  if (first < local_.faces.size()) look_at(first);
  for (std::uint32_t i = 0; i < local_.faces.size(); ++i) {
    if (i != first) look_at(i);
  }
  std::sort(unseparated_parts.begin(), unseparated_parts.end());
  const auto end = std::unique(unseparated_parts.begin(), unseparated_parts.end());
  for (auto p = unseparated_parts.begin(); p != end; ++p) {
    time = std::min(time, part_contact_free_time(*p, flight, time));
  }
  return time;
}

double TerrainNarrowPhase::contact_free_time_over_face(const LocalFaces::Face& face,
                                                       const FlightBounds& flight, double horizon) {
  // First the bounding sphere of the block is tested, then those of its parts, then the vertices of
  // near parts. A block is above a plane if all its vertices are.
  const Vec3& centre = tests_.position();
  const double height = face.normal.dot(centre) - face.offset - reach_;
  const Approach over(face.normal, flight);
  if (over.clear(height - bounding_radius_, Vec3::Zero(), 0.0, horizon)) return horizon;
  const bool at_border = is_at_border(ground_.features, face.face);
  const PartSphere total{centre, bounding_radius_, 0.0};
  if (!at_border && sphere_contact_free_time(face, total, flight, horizon) >= horizon)
    return horizon;
  const Approach above = over.in_body(tests_.rotation());
  std::vector<std::uint32_t>& near_parts = scratch().near_parts;
  near_parts.clear();
  for (std::uint32_t p = 0; p < parts_.parts.size(); ++p) {
    const BlockPart& part = parts_.parts[p];
    const double distance = height + above.normal.dot(part.centre) - part.radius;
    if (!above.clear(distance, part.centre, flight.rotational_acceleration * part.arm, horizon)) {
      near_parts.push_back(p);
    }
  }
  double time = horizon;
  for (const std::uint32_t p : near_parts) {
    const BlockPart& part = parts_.parts[p];
    const double turning = flight.rotational_acceleration * (part.arm + part.radius);
    for (std::uint32_t v = part.first_vertex; v < part.end_vertex; ++v) {
      const Vec3& arm = block_.vertices[parts_.vertices[v]];
      const double distance = height + above.normal.dot(arm);
      if (distance < -kPlaneRounding)
        return parts_contact_free_time(face, at_border, flight, horizon);
      if (!above.clear(std::max(distance, 0.0), arm, turning, time)) {
        time = above.time(std::max(distance, 0.0), arm, turning);
      }
    }
  }
  return time;
}

double TerrainNarrowPhase::parts_contact_free_time(const LocalFaces::Face& face, bool at_border,
                                                   const FlightBounds& flight, double horizon) {
  double time = horizon;
  for (const std::uint32_t p : scratch().near_parts) {
    const BlockPart& part = parts_.parts[p];
    const PartSphere ball{in_ground_frame(part.centre), part.radius,
                          flight.rotational_acceleration * part.arm};
    const double beside = at_border ? 0.0 : sphere_contact_free_time(face, ball, flight, time);
    if (beside > 0.0) {
      time = std::min(time, beside);
    } else {
      scratch().unseparated_parts.push_back(p);
    }
  }
  return time;
}

double TerrainNarrowPhase::sphere_contact_free_time(const LocalFaces::Face& face,
                                                    const PartSphere& part,
                                                    const FlightBounds& flight,
                                                    double horizon) const {
  const Vec3 arm = part.centre - tests_.position();
  const double touching = part.radius + reach_;
  // Tries the bounding sphere of the face, then the plane through its point nearest to the part.
  const Vec3 from_middle = part.centre - face.centre;
  const double far = from_middle.norm();
  if (far > face.radius + touching &&
      Approach(from_middle / far, flight)
          .clear(far - face.radius - touching, arm, part.centre_acceleration, horizon)) {
    return horizon;
  }
  const NearestPoint nearest = project_onto_face(ground_.features, face.face, part.centre);
  const double distance = std::abs(nearest.distance), clearance = distance - touching;
  if (!(clearance > 0.0)) return 0.0;
  const Approach beside((part.centre - nearest.point) / distance, flight);
  return beside.clear(clearance, arm, part.centre_acceleration, horizon)
             ? horizon
             : beside.time(clearance, arm, part.centre_acceleration);
}

}  // namespace clast::dem_detail
