#pragma once
/// Round numbers for steps, cells and scale bars: 1, 2 or 5 times a power of ten.

namespace clast {

/// The smallest of them that is not below `value`; 1 unless value > 0.
double round_up_to_nice(double value);

/// The largest of them up to `value`.
/// @param value  positive
double round_down_to_nice(double value);

}  // namespace clast
