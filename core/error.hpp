#pragma once
/// Exceptions of clast. A message names the item, what failed, the values, and what to do next.
/// Example: "block B017: mesh has 3 open boundaries; repair it first".
#include <stdexcept>
#include <string>

namespace clast {

/// Base class of all exceptions thrown by clast.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Error of a file, option or value given by the user.
class InputError : public Error {
 public:
  using Error::Error;
};

/// Error of a shape that lacks a required property, for example one that is open or flat.
class GeometryError : public Error {
 public:
  using Error::Error;
};

/// Error in the set-up or course of a simulation.
class SimulationError : public Error {
 public:
  using Error::Error;
};

}  // namespace clast
