#pragma once
/// Possible shape classes of blocks with uncertain axes.
#include <string>
#include <vector>

#include "classify/schemes.hpp"

namespace clast {

/// Finds each class of axes L >= I >= S that are all within `axis_error` of `axes`, in the order of
/// `class_names`. On a class boundary the class of `shape_class` counts.
/// @param axis_error  m, positive and finite; axes are at least 1e-6 of themselves
/// @throws InputError  if the scheme is unknown
std::vector<std::string> find_possible_classes(const std::string& scheme, const Axes& axes,
                                               double axis_error,
                                               const SchemeOptions& options = {});

/// Finds each class of axes L >= I >= S between `lower` and `upper`.
/// @param lower  positive, none above `upper`
std::vector<std::string> find_possible_classes(const std::string& scheme, const Axes& lower,
                                               const Axes& upper,
                                               const SchemeOptions& options = {});

}  // namespace clast
