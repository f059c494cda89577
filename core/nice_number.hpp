#pragma once
/// Round numbers for steps, cells and scale bars: 1, 2 or 5 times a power of ten.

namespace clast {

/// Rounds up to the next such number; 1 unless value > 0.
double round_up_to_nice(double value);

/// Rounds down to the previous such number.
/// @param value  positive
double round_down_to_nice(double value);

}  // namespace clast
