#pragma once
/// Energy balance of a simulation run.
#include <algorithm>
#include <cmath>

namespace clast {

/// Energies of a simulation run, J: initial, final and dissipated.
struct EnergyBalance {
  double initial = 0.0;     ///< kinetic + potential + elastic at the start
  double final = 0.0;       ///< kinetic + potential + elastic at the end
  double normal = 0.0;      ///< dissipated by the normal law
  double friction = 0.0;    ///< dissipated by sliding and by scar drag
  double rolling = 0.0;     ///< dissipated by rolling resistance
  double reassigned = 0.0;  ///< lost when contacts or their weights change; negative if gained

  double dissipated() const { return normal + friction + rolling + reassigned; }
  /// Adds the dissipated and reassigned energies of another part of the run.
  EnergyBalance& operator+=(const EnergyBalance& part) {
    normal += part.normal;
    friction += part.friction;
    rolling += part.rolling;
    reassigned += part.reassigned;
    return *this;
  }
  /// Sets the final energy and computes the error of the balance.
  /// @param drop  initial total energy minus final potential energy, J
  void close_balance(double final_energy, double drop) {
    final = final_energy;
    const double lost = dissipated();
    error = std::abs(initial - final - lost) /
            std::max({std::abs(lost), 1e-3 * std::abs(drop), 1e-300});
  }

  /// Error of the balance, relative to the dissipated energy, or to 1e-3 of the energy released by
  /// the descent if that is larger.
  double error = 0.0;

  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(initial, final, normal, friction, rolling, reassigned, error);
  }
};

}  // namespace clast
