#pragma once
/// How the bodies of a world move: a step of all of them, from the loads to the next ones.
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/parallel.hpp"
#include "dem/simulation/detail/contact_pairs.hpp"
#include "dem/simulation/detail/sleeping.hpp"
#include "dem/simulation/detail/time_step.hpp"
#include "dem/simulation/world.hpp"
#include "dem/surface/terrain_impl.hpp"

namespace clast::dem_detail {

/// Bodies with their contacts, which refer to members of each other: it stays where it is made.
class WorldMotion {
 public:
  /// @param on  none, or it must outlive the motion
  /// @throws InputError  settings out of range; SimulationError  a shape without mass, or a ground
  ///                     zone without parameters
  WorldMotion(std::vector<RigidBody> of_shapes, const WorldSettings& with, const TerrainSurface* on,
              std::vector<GroundParameters> ground_zones);
  WorldMotion(const WorldMotion&) = delete;
  WorldMotion& operator=(const WorldMotion&) = delete;

  /// @param start  a unit quaternion, and on the terrain
  void add(std::size_t shape, const RigidState& start, bool fixed);
  /// Makes a fixed body, the last that was added, a form.
  void hold(std::size_t form, const HeldBodies& held) { bodies_[form].holds = held; }
  /// Takes a body out of the motion, where it is; wakes what it touched.
  void remove(std::size_t body);
  /// Lets fixed bodies, each named once, move from now on.
  void free(std::span<const std::size_t> bodies);
  /// A step as long as contacts allow, but no longer than `longest`, s.
  void advance(double longest);
  /// Bodies that are not idle, ascending; until the next step.
  std::span<const std::uint32_t> moving() {
    list_moving();
    return moving_;
  }
  /// Lets time pass while no body moves, s.
  void wait(double duration) { time_ += duration; }

  /// All contacts of a body now, as `World::touch`.
  Touch touch(std::size_t body) const;
  /// Balance since the first body came.
  EnergyLedger energy() const;
  EnergySample energy_sample() const;

  /// Nothing in a step, or slow with a contact for as long as rest takes.
  bool resting(const WorldBody& body) const {
    return body.idle() || body.resting >= settings_.rest_duration;
  }
  const WorldSettings& settings() const { return settings_; }
  const TerrainSurface* terrain() const { return terrain_; }
  std::span<const Shape> shapes() const { return shapes_; }
  const std::vector<WorldBody>& bodies() const { return bodies_; }
  const ContactPairs& pairs() const { return pairs_; }
  /// Has the body contacts yet? From the first step after it came.
  bool prepared(std::size_t body) const { return body < prepared_; }
  std::size_t sleeping_count() const { return sleeping_.count(); }
  double time() const { return time_; }  ///< s
  std::uint64_t steps() const { return steps_; }
  void observe(BodyObserver observer) { observer_ = std::move(observer); }

  /// All that the motion to come depends on, between two steps.
  template <class Bytes>
  void serialize(Bytes& bytes) {
    std::vector<std::size_t> shape_of_body;
    for (const WorldBody& body : bodies_) shape_of_body.push_back(body.shape - shapes_.data());
    bytes(shape_of_body);
    if constexpr (Bytes::kReads) {
      bodies_.clear();
      for (const std::size_t shape : shape_of_body) {
        if (shape >= shapes_.size()) throw InputError("the saved state is of another world");
        bodies_.emplace_back(shapes_[shape], RigidState(), false);
      }
      motion_changed();  // the lists of what moves, and places in the broad phase, are made anew
    }
    for (WorldBody& body : bodies_) bytes(body);
    pairs_.serialize(bytes, bodies_);
    bytes(soil_, prepared_, sleeping_, time_, step_length_, initial_, reassigned_, steps_);
  }

 private:
  ContactRules rules(std::span<const GroundParameters> of_zones,
                     std::span<const std::uint16_t> zone_of_face, const SoilMemory* soil) const {
    return {of_zones, zone_of_face, settings_.stiffness, settings_.weights, settings_.law, soil};
  }
  EnergyLedger losses() const {
    EnergyLedger sum = pairs_.losses().sum();
    sum.reassigned += reassigned_;
    return sum;
  }
  Vec3 gravity() const { return {0.0, 0.0, -settings_.gravity}; }

  void prepare();
  /// Lists the bodies and pairs that take part in the motion, if they have changed since the last
  /// list.
  void list_moving();
  /// To be called when the bodies or pairs that take part in the motion change.
  void motion_changed() { listed_ = places_known_ = false; }
  /// Has a pair contacts for the first time, at a start?
  using IsNew = std::function<bool(const ContactPair&)>;
  /// Lists the pairs and begins the contacts of new ones.
  void begin_pairs(const IsNew& is_new);
  void refuse_deep_starts(const IsNew& is_new) const;
  /// Brings the pairs up to date with the places of the bodies.
  void refresh_pairs();
  void wake_touched();
  void let_sleep();
  void apply_loads_anew();
  /// What Verlet steps of this length lose when they begin with the present loads, J.
  double first_kicks(double dt);
  void set_step_length(double dt);
  void begin_moves(const StepChoice& step);
  void end_moves(double dt, bool flight);
  void remove_bodies_off_terrain();
  void take_out(std::size_t body);
  void note_begins();
  void show_moves(double begin);

  WorldSettings settings_;
  const TerrainSurface* terrain_;
  std::vector<GroundParameters> zones_;
  SoilMemory soil_{zones_};
  std::vector<Shape> shapes_;
  ThreadPool team_;

  std::vector<WorldBody> bodies_;
  ContactPairs pairs_{terrain_, rules(std::span(&settings_.between_bodies, 1), {}, nullptr),
                      rules(std::span(&settings_.on_forms, 1), {}, nullptr),
                      rules(zones_,
                            terrain_ ? std::span<const std::uint16_t>(terrain_->impl().zones)
                                     : std::span<const std::uint16_t>(),
                            soil_.any() ? &soil_ : nullptr)};
  std::size_t prepared_ = 0;  ///< bodies that are part of the motion already
  Sleeping sleeping_;
  BodyObserver observer_;
  /// Where a body was when the step began, and whether nothing touched it then.
  struct Begin {
    std::uint32_t body;
    RigidState state;
    bool free = false;
  };
  std::vector<Begin> began_;  ///< of bodies that move in the step, if observed

  // Sleeping bodies should cost next to nothing, so a step works on these lists only.
  bool listed_ = false;                ///< the two lists, and that of the pairs, are up to date
  std::vector<std::uint32_t> moving_;  ///< bodies that are not idle, ascending
  std::vector<std::uint32_t> awake_;   ///< bodies that are not asleep: fixed ones too
  bool places_known_ = false;          ///< the broad phase has those of bodies that don't move

  double time_ = 0.0;
  double step_length_ = settings_.stiffness.time_step;  ///< of the last step, s
  double initial_ = 0.0;                                ///< energy that bodies brought, J
  double reassigned_ = 0.0;                             ///< losses of no pair, J
  std::uint64_t steps_ = 0;
};

/// "body 3", for messages.
std::string name_of_body(std::size_t body);

}  // namespace clast::dem_detail
