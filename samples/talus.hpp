#pragma once
/// Synthetic table of block axes measured by tape.
#include <string>

namespace clast {

/// Sixty blocks of a talus as a table with header: name, L, I and S to whole centimetres, and a
/// mass in kg for those that were light enough to be hung on a crane. Sizes are log-normal (median
/// 0.6 m, sigma 0.45); L/I and I/S are 1 plus exponentially distributed parts, with more elongated
/// blocks than the scanned ones are.
std::string make_talus_table();

}  // namespace clast
