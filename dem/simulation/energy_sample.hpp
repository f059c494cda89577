#pragma once
/// The energy of many blocks at one instant, and where it has gone until then.
#include <cstddef>

namespace clast {

/// What contacts have dissipated, J.
struct Dissipation {
  double normal = 0.0;    ///< by the normal law
  double friction = 0.0;  ///< by sliding and by scar drag
  double rolling = 0.0;   ///< by rolling resistance

  double sum() const { return normal + friction + rolling; }
  Dissipation& operator-=(const Dissipation& part) {
    normal -= part.normal;
    friction -= part.friction;
    rolling -= part.rolling;
    return *this;
  }
  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(normal, friction, rolling);
  }
};

/// Energies of all bodies that move, J. Their sum, with what was dissipated and reassigned, is what
/// the bodies brought.
struct EnergySample {
  double time = 0.0;           ///< s
  std::size_t moving = 0;      ///< bodies that are neither at rest nor gone
  double translational = 0.0;  ///< kinetic, of the centres of mass; without bodies that are gone
  double rotational = 0.0;     ///< kinetic, likewise
  double potential = 0.0;      ///< m g z of bodies that are there
  double stored = 0.0;         ///< what unloading the contacts would give back
  double departed = 0.0;       ///< kinetic and potential, that bodies had when they left
  Dissipation on_ground;       ///< since the first body came
  Dissipation between_bodies;  ///< likewise
  double reassigned = 0.0;     ///< likewise: lost (or gained, < 0) when contacts change

  /// The same, with time and what was lost counted from an earlier sample on.
  EnergySample since(const EnergySample& begin) const {
    EnergySample sample = *this;
    sample.time -= begin.time;
    sample.on_ground -= begin.on_ground;
    sample.between_bodies -= begin.between_bodies;
    sample.reassigned -= begin.reassigned;
    return sample;
  }
  /// All energy that there is, that went, and that left.
  double sum() const {
    return translational + rotational + potential + stored + departed + on_ground.sum() +
           between_bodies.sum() + reassigned;
  }
  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(time, moving, translational, rotational, potential, stored, departed, on_ground,
          between_bodies, reassigned);
  }
};

}  // namespace clast
