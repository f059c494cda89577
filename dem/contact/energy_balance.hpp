#pragma once
/// The energy balance of a run.
#include <algorithm>
#include <cmath>

namespace clast {

/// Where energy went, J. Sums over the run.
struct EnergyBalance {
  double initial = 0.0;     ///< kinetic + potential + stored at the start
  double final = 0.0;       ///< the same at the end
  double normal = 0.0;      ///< dissipated by the normal law
  double friction = 0.0;    ///< dissipated by sliding and by scar drag
  double rolling = 0.0;     ///< dissipated by rolling resistance
  double reassigned = 0.0;  ///< lost (or gained, < 0) when contacts or their weights change

  double dissipated() const { return normal + friction + rolling + reassigned; }
  /// Adds what another part of the run dissipated.
  EnergyBalance& operator+=(const EnergyBalance& part) {
    normal += part.normal;
    friction += part.friction;
    rolling += part.rolling;
    reassigned += part.reassigned;
    return *this;
  }
  /// Closes the balance. `drop`: what was there at the start, above the potential at the end, J.
  void close_balance(double final_energy, double drop) {
    final = final_energy;
    const double lost = dissipated();
    error = std::abs(initial - final - lost) /
            std::max({std::abs(lost), 1e-3 * std::abs(drop), 1e-300});
  }

  /// |initial - final - dissipated| / max(dissipated, 1e-3 |kinetic + drop|)
  double error = 0.0;

  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(initial, final, normal, friction, rolling, reassigned, error);
  }
};

}  // namespace clast
