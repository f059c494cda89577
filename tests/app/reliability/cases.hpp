#pragma once
/// The cases of the reliability trial: kinds of damage, amounts of each, and what is right.
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/random.hpp"
#include "tests/app/reliability/bodies.hpp"
#include "tests/app/reliability/judge.hpp"

namespace clast::reliability {

/// What is given to the program, and which answers are right.
struct DamagedScan {
  TriangleMesh surface;  ///< without triangles: a cloud
  std::vector<Expected> expected;
};

/// One way in which scans are bad. Lengths are shares of L, the longest side.
struct Kind {
  std::string name;
  std::string unit;  ///< of the amounts, as in "20 % of the faces"
  std::vector<double> amounts;
  std::function<DamagedScan(const Body&, double amount, Random&)> make;
  std::size_t every = 1;  ///< made of each so-manieth body
};

const std::vector<Kind>& kinds();

struct Case {
  const Kind* kind = nullptr;
  double amount = 0.0;
  const Body* body = nullptr;

  std::string level() const;  ///< amount and unit
  /// "kind: amount unit: body".
  std::string name() const;
  /// A digest of the name, so that a case is the same whatever other cases there are.
  std::uint64_t seed() const;
  /// Turned at random and damaged.
  DamagedScan scan() const;
};

/// All cases, the bodies of a kind and amount together.
std::vector<Case> make_cases(const std::vector<Body>& bodies);

}  // namespace clast::reliability
