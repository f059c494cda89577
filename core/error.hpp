#pragma once
/// The exception family. A message says what failed, on which item, with the values, and what to
/// do next: "block B017: mesh has 3 open boundaries; repair it first".
#include <stdexcept>
#include <string>

namespace clast {

/// Everything clast throws on purpose.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A file, option or value given by the user can't be used.
class InputError : public Error {
 public:
  using Error::Error;
};

/// A shape does not have the property an operation needs (closed, outward, not flat, ...).
class GeometryError : public Error {
 public:
  using Error::Error;
};

/// A simulation can't be set up or can't go on.
class SimulationError : public Error {
 public:
  using Error::Error;
};

}  // namespace clast
