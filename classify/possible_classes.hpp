#pragma once
/// Which shape classes a block can have whose axes are known to within an error or a range.
#include <string>
#include <vector>

#include "classify/schemes.hpp"

namespace clast {

/// Every class that some axes L >= I >= S have which are each within `axis_error` of `axes`, in the
/// order of `class_names`. On a limit a class is possible where `shape_class` gives it.
/// @param axis_error  m, positive and finite; an axis is never assumed thinner than 1e-6 of itself
/// @throws InputError  unknown scheme
std::vector<std::string> find_possible_classes(const std::string& scheme, const Axes& axes,
                                          double axis_error, const SchemeOptions& options = {});

/// The same of axes L >= I >= S each of which lies between those of `lower` and `upper`.
/// @param lower  positive, none above that of `upper`
std::vector<std::string> find_possible_classes(const std::string& scheme, const Axes& lower,
                                          const Axes& upper, const SchemeOptions& options = {});

}  // namespace clast
