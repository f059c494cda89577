#pragma once
/// Round numbers for steps, cells and scale bars: 1, 2 or 5 times a power of ten.

namespace clast {

/// Rounds up to 1, 2 or 5 times a power of ten; 1 if the value is not positive.
double round_up_to_nice_number(double value);

/// Rounds down to 1, 2 or 5 times a power of ten.
/// @param value  positive
double round_down_to_nice_number(double value);

}  // namespace clast
