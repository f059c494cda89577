#pragma once
/// Possible shape classes of blocks with uncertain axes.
#include <string>
#include <vector>

#include "classify/schemes.hpp"

namespace clast {

/// Finds all classes of blocks whose axes L >= I >= S differ from `axes` by at most `axis_error`.
/// They are in the order of `class_names`. On a boundary, the class is that of `shape_class`.
/// @param axis_error  m, positive and finite; axes are not reduced below 1e-6 of their value
/// @throws InputError  if the scheme is unknown
std::vector<std::string> find_possible_classes(const std::string& scheme, const Axes& axes,
                                               double axis_error,
                                               const SchemeOptions& options = {});

/// Finds all classes of axes L >= I >= S that are between `lower` and `upper`.
/// @param lower  positive axes, not larger than `upper`
std::vector<std::string> find_possible_classes(const std::string& scheme, const Axes& lower,
                                               const Axes& upper,
                                               const SchemeOptions& options = {});

}  // namespace clast
