#include "dem/detail/contact_forces.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace clast {
namespace {

/// A contact that vanishes and one that appears are the same contact, carried over to another
/// feature, when they are closer than this share of the block's smallest side ...
constexpr double kHandOverShare = 0.03;
/// ... and their normals are within 45 degrees.
constexpr double kHandOverCosine = 0.7071067811865476;
Vec3 turned_into_plane(const Vec3& vector, const Vec3& normal) {
  const double length = vector.norm();
  const Vec3 flat = vector - vector.dot(normal) * normal;
  const double flat_length = flat.norm();
  return flat_length > 1e-300 ? Vec3(flat * (length / flat_length)) : Vec3(Vec3::Zero());
}

void limit(Vec3& vector, double largest) {
  const double length = vector.norm();
  if (length > largest) vector *= largest / length;
}

}  // namespace

ContactForces::ContactForces(std::span<const GroundParameters> zones,
                             std::span<const std::uint16_t> zone_of_face,
                             const SurfaceFeatures& block, double size,
                             const ContactStiffness& stiffness, ContactWeights weights)
    : zones_(zones),
      zone_of_face_(zone_of_face),
      patches_(block, weights),
      stiffness_(stiffness),
      near_(kHandOverShare * size) {}

ContactLoad ContactForces::update(const std::vector<ContactPoint>& points, const BodyMotion& block,
                                  const BodyMotion& other, double duration, EnergyLedger& ledger) {
  ContactLoad load;
  if (points.empty() && contacts_.empty()) return load;
  const double k_n = stiffness_.normal, k_t = stiffness_.tangential, k_r = stiffness_.rolling;
  const Vec3 spin = block.angular_velocity - other.angular_velocity;

  match(points);
  const std::span<const double> weights = patches_.share(points, block.world_from_body.rotation);
  std::vector<Contact>& now = now_;
  now.assign(points.size(), {});
  for (std::size_t i = 0; i < points.size(); ++i) {
    now[i].point = points[i];
    now[i].weight = weights[i];
    now[i].ground = &zones_[zone_of_face_.empty() ? 0 : zone_of_face_[points[i].ground_face]];
  }

  for (std::size_t i = 0; i < now.size(); ++i) {
    Contact& contact = now[i];
    const Vec3& n = contact.point.normal;
    const double overlap = contact.point.overlap;
    const double restitution = contact.ground->energy_restitution;
    const double w = contact.weight;
    const Vec3 place = contact.point.point();
    contact.arm = place - block.world_from_body.translation;
    contact.other_arm = place - other.world_from_body.translation;
    const Vec3& arm = contact.arm;
    const Vec3 moving = block.velocity_at(place) - other.velocity_at(place);
    const double closing = -moving.dot(n);
    const Vec3 sliding = moving + closing * n;

    // Where it was a step ago. A contact without a past has come from as far as its speed allows;
    // an overlap that this does not explain carries the least that the law allows.
    double before = std::max(0.0, overlap - std::max(0.0, closing) * duration);
    double normal_before = k_n * restitution * before;
    double weight_before = w;
    double restitution_before = restitution;
    Vec3 tangential_before = Vec3::Zero(), rolling_before = Vec3::Zero();
    // Power of the loads of the step before along the motion of this one, by normal and friction:
    // they act where the contact was then.
    double power_normal = -normal_before * closing, power_sliding = 0.0;
    if (previous_of_[i] >= 0) {
      const Contact& previous = contacts_[previous_of_[i]];
      before = previous.point.overlap;
      normal_before = previous.normal;
      weight_before = previous.weight;
      restitution_before = previous.ground->energy_restitution;
      tangential_before = turned_into_plane(previous.tangential, n);
      rolling_before = previous.rolling;
      const Vec3 moving_there = relative_velocity(block, other, previous);
      power_normal = previous.normal * previous.point.normal.dot(moving_there);
      power_sliding = previous.tangential.dot(moving_there);
    } else {
      ledger.reassigned -= 0.5 * w * k_n * restitution * before * before;
    }

    const double deeper = overlap - before;
    contact.normal = deeper > 0.0 ? normal_before + k_n * deeper : k_n * restitution * overlap;
    contact.tangential = tangential_before - k_t * duration * sliding;
    limit(contact.tangential, contact.ground->friction * contact.normal);
    if (contact.ground->rolling_friction > 0.0) {
      contact.rolling = rolling_before - k_r * duration * spin;
      const double length = contact.rolling.norm();
      // The arm of Eq. 5 is perpendicular to the axis about which the block rolls.
      const double lever = length > 0.0 ? arm.cross(contact.rolling).norm() / length : 0.0;
      limit(contact.rolling, contact.ground->rolling_friction * lever * contact.normal);
    }

    const Vec3 force = w * (contact.normal * n + contact.tangential);
    load.force += force;
    load.torque += arm.cross(force) + w * contact.rolling;
    load.torque_on_other -= contact.other_arm.cross(force) + w * contact.rolling;

    // Work taken from the block by the mean of the forces at both ends of the step, less what is
    // stored, is dissipated; a change of weight or zone changes what is stored and is booked apart.
    const double taken_normal =
        -0.5 * duration * (weight_before * power_normal - w * contact.normal * closing);
    ledger.normal +=
        taken_normal - 0.5 * w * k_n * restitution * (overlap * overlap - before * before);
    ledger.reassigned -=
        0.5 * k_n * before * before * (w * restitution - weight_before * restitution_before);
    const double taken_sliding =
        -0.5 * duration * (weight_before * power_sliding + w * contact.tangential.dot(sliding));
    const double tangential_squared = tangential_before.squaredNorm();
    ledger.friction +=
        taken_sliding - 0.5 * w / k_t * (contact.tangential.squaredNorm() - tangential_squared);
    const double taken_rolling =
        -0.5 * duration * (weight_before * rolling_before + w * contact.rolling).dot(spin);
    const double rolling_squared = rolling_before.squaredNorm();
    ledger.rolling +=
        taken_rolling - 0.5 * w / k_r * (contact.rolling.squaredNorm() - rolling_squared);
    ledger.reassigned -=
        0.5 * (w - weight_before) * (tangential_squared / k_t + rolling_squared / k_r);
  }

  for (std::size_t j = 0; j < contacts_.size(); ++j) {
    if (carried_on_[j]) continue;
    const Contact& gone = contacts_[j];
    const Vec3 moving = relative_velocity(block, other, gone);
    const double given_back =
        0.5 * duration * gone.weight *
        ((gone.normal * gone.point.normal + gone.tangential).dot(moving) + gone.rolling.dot(spin));
    const bool parted = moving.dot(gone.point.normal) > 0.0;
    (parted ? ledger.normal : ledger.reassigned) += stored(gone) - given_back;
  }
  std::swap(contacts_, now_);
  return load;
}

Vec3 ContactForces::relative_velocity(const BodyMotion& block, const BodyMotion& other,
                                      const Contact& contact) {
  return block.velocity + block.angular_velocity.cross(contact.arm) - other.velocity -
         other.angular_velocity.cross(contact.other_arm);
}

void ContactForces::match(const std::vector<ContactPoint>& points) {
  previous_of_.assign(points.size(), -1);
  carried_on_.assign(contacts_.size(), 0);
  const auto carry_on = [&](std::size_t i, std::size_t j) {
    previous_of_[i] = static_cast<int>(j);
    carried_on_[j] = 1;
  };
  // The same pair of features. Both lists are in the same order, so the search goes on where the
  // last one ended.
  std::size_t next = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t tried = 0; tried < contacts_.size(); ++tried) {
      const std::size_t j = (next + tried) % contacts_.size();
      const ContactPoint& a = points[i];
      const ContactPoint& b = contacts_[j].point;
      if (carried_on_[j] || a.kind != b.kind || a.block_feature != b.block_feature ||
          a.ground_feature != b.ground_feature || a.normal.dot(b.normal) < kHandOverCosine) {
        continue;
      }
      carry_on(i, j);
      next = j + 1;
      break;
    }
  }
  const auto hand_over = [&](const auto& related) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (previous_of_[i] >= 0) continue;
      std::optional<std::size_t> best;
      double best_cosine = kHandOverCosine;
      for (std::size_t j = 0; j < contacts_.size(); ++j) {
        if (carried_on_[j] || !related(points[i], contacts_[j].point)) continue;
        const double cosine = points[i].normal.dot(contacts_[j].point.normal);
        if (cosine > best_cosine) {
          best_cosine = cosine;
          best = j;
        }
      }
      if (best) carry_on(i, *best);
    }
  };
  // The same block feature on the next ground feature, or the same ground feature under the next
  // block feature; then whatever took over at the same place.
  hand_over([](const ContactPoint& a, const ContactPoint& b) {
    return a.kind == b.kind &&
           (a.block_feature == b.block_feature ||
            (a.kind != ContactKind::kVertexGround && a.ground_feature == b.ground_feature));
  });
  hand_over([&](const ContactPoint& a, const ContactPoint& b) {
    return (a.foot - b.foot).squaredNorm() < near_ * near_;
  });
}

double ContactForces::stored(const Contact& contact) const {
  const double overlap = contact.point.overlap;
  return 0.5 * contact.weight *
         (stiffness_.normal * contact.ground->energy_restitution * overlap * overlap +
          contact.tangential.squaredNorm() / stiffness_.tangential +
          contact.rolling.squaredNorm() / stiffness_.rolling);
}

double ContactForces::stored_energy() const {
  double sum = 0.0;
  for (const Contact& contact : contacts_) sum += stored(contact);
  return sum;
}

double ContactForces::max_overlap() const {
  double largest = 0.0;
  for (const Contact& contact : contacts_) largest = std::max(largest, contact.point.overlap);
  return largest;
}

double ContactForces::settled_depth() {
  // One law carries with its weighted mean overlap: that is the depth that Eq. 2 speaks of.
  std::vector<double> depth(contacts_.size(), 0.0);
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    const ContactPoint& point = contacts_[i].point;
    depth[patches_.law_of(i)] +=
        contacts_[i].weight * point.overlap * std::max(0.0, point.normal.z());
  }
  return depth.empty() ? 0.0 : *std::max_element(depth.begin(), depth.end());
}

double ContactForces::smallest_restitution() const {
  double smallest = 1.0;
  for (const Contact& contact : contacts_) {
    smallest = std::min(smallest, contact.ground->energy_restitution);
  }
  return smallest;
}

}  // namespace clast
