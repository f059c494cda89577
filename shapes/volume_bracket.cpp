#include "shapes/volume_bracket.hpp"

namespace clast {

VolumeBracket scaled(VolumeBracket bracket, double unit) {
  const double cubed = unit * unit * unit;
  bracket.lower_volume *= cubed;
  bracket.estimated_volume *= cubed;
  if (bracket.upper_volume) *bracket.upper_volume *= cubed;
  if (bracket.sides) {
    bracket.sides->lower *= unit;
    bracket.sides->upper *= unit;
  }
  if (bracket.intervals) {
    bracket.intervals->lower_volume *= cubed;
    bracket.intervals->upper_volume *= cubed;
    bracket.intervals->sides.lower *= unit;
    bracket.intervals->sides.upper *= unit;
  }
  return bracket;
}

}  // namespace clast
