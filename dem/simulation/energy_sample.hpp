#pragma once
/// Energies of all blocks of a simulation at one time, and the energy dissipated until then.
#include <cstddef>

namespace clast {

/// Energy dissipated by contacts, J.
struct DissipatedEnergy {
  double normal = 0.0;    ///< energy dissipated by the normal law
  double friction = 0.0;  ///< energy dissipated by sliding and by scar drag
  double rolling = 0.0;   ///< energy dissipated by rolling resistance

  double sum() const { return normal + friction + rolling; }
  DissipatedEnergy& operator-=(const DissipatedEnergy& part) {
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

/// Energies of all movable bodies, J. The sum of all energies, including dissipated and reassigned
/// energy, is equal to the initial energy.
struct EnergySample {
  double time = 0.0;           ///< s
  std::size_t moving = 0;      ///< number of bodies that are neither at rest nor removed
  double translational = 0.0;  ///< kinetic energy of the centres of mass, without removed bodies
  double rotational = 0.0;     ///< kinetic energy of rotation, without removed bodies
  double potential = 0.0;      ///< m g z, without removed bodies
  double stored = 0.0;         ///< elastic energy of the contacts
  double departed = 0.0;  ///< kinetic and potential energy of removed bodies when they were removed
  DissipatedEnergy on_ground;  ///< energy dissipated on the ground since the first body was added
  /// Energy dissipated between bodies since the first body was added.
  DissipatedEnergy between_bodies;
  double reassigned = 0.0;  ///< energy lost when contacts changed; negative if gained

  /// Returns a sample whose time, dissipated and reassigned energies are counted from the sample
  /// `begin`.
  EnergySample change_since(const EnergySample& begin) const {
    EnergySample sample = *this;
    sample.time -= begin.time;
    sample.on_ground -= begin.on_ground;
    sample.between_bodies -= begin.between_bodies;
    sample.reassigned -= begin.reassigned;
    return sample;
  }
  /// Returns the sum of present, removed, dissipated and reassigned energy.
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
