#include "classify/box_effect.hpp"

#include <algorithm>

namespace clast {
namespace {

bool same(const Axes& a, const Axes& b) { return a.L == b.L && a.I == b.I && a.S == b.S; }

bool in_use(std::span<const MeasuredBlock> blocks, std::size_t box) {
  return std::all_of(blocks.begin(), blocks.end(), [&](const MeasuredBlock& block) {
    return block.axes_by_box.empty() || same(block.axes_by_box[box], block.axes);
  });
}

}  // namespace

std::vector<BoxConventionEffect> compare_box_conventions(std::span<const MeasuredBlock> blocks,
                                                         std::span<const std::string> schemes,
                                                         const SchemeOptions& limits) {
  std::vector<BoxConventionEffect> effects;
  for (const std::string& scheme : schemes) {
    for (std::size_t box = 0; box < kBoxConventions.size(); ++box) {
      if (in_use(blocks, box)) continue;
      BoxConventionEffect effect{kBoxConventions[box], scheme, 0, 0};
      for (const MeasuredBlock& block : blocks) {
        if (block.axes_by_box.empty()) continue;
        ++effect.blocks;
        effect.reclassified += shape_class(scheme, block.axes_by_box[box], limits) !=
                               shape_class(scheme, block.axes_in_table_unit, limits);
      }
      if (effect.blocks > 0) effects.push_back(effect);
    }
  }
  return effects;
}

std::string describe_box_convention_effect(const BoxConventionEffect& effect) {
  return "By the " + name_of(effect.convention) + " box " +
         (effect.reclassified == 0 ? "none" : std::to_string(effect.reclassified)) + " of " +
         std::to_string(effect.blocks) + (effect.blocks == 1 ? " block" : " blocks") +
         (effect.reclassified == 1 || effect.reclassified == 0 ? " has" : " have") +
         " another class of " + effect.scheme + ".";
}

}  // namespace clast
