#include "samples/talus.hpp"

#include <array>
#include <cmath>
#include <cstdio>

#include "core/random.hpp"

namespace clast {

std::string make_talus_table() {
  constexpr double kDensity = 2650.0;
  constexpr double kOfItsBox = 0.55;        // volume of a block over that of its box
  constexpr double kMaxWeighedMass = 2000;  // kg
  Random random(60);
  const auto excess = [&](double mean) { return -mean * std::log(1.0 - random.uniform()); };
  std::string text = "block,L_cm,I_cm,S_cm,mass_kg\n";
  for (int i = 1; i <= 60; ++i) {
    const double intermediate = 60.0 * std::exp(0.45 * random.normal());  // cm
    const int L = static_cast<int>(std::lround(intermediate * (1.0 + excess(0.35))));
    const int S = static_cast<int>(std::lround(intermediate / (1.0 + excess(0.30))));
    const int I = static_cast<int>(std::lround(intermediate));
    const double mass = kDensity * kOfItsBox * 1e-6 * L * I * S;
    std::array<char, 64> line{};
    if (mass <= kMaxWeighedMass) {
      std::snprintf(line.data(), line.size(), "T%02d,%d,%d,%d,%.0f\n", i, L, I, S, mass);
    } else {
      std::snprintf(line.data(), line.size(), "T%02d,%d,%d,%d,\n", i, L, I, S);
    }
    text += line.data();
  }
  return text;
}

}  // namespace clast
