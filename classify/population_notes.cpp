#include "classify/population_notes.hpp"

#include <algorithm>
#include <map>
#include <string_view>
#include <unordered_map>

#include "core/number_text.hpp"

namespace clast {
namespace {

constexpr std::size_t kMaxNames = 5;  // in a note

/// "A 3 times, B 2 times"; empty when no name stands twice.
std::string repeated_names(std::span<const MeasuredBlock> blocks) {
  std::unordered_map<std::string_view, std::size_t>
      all;  // a million of them in a fifth of a second
  all.reserve(blocks.size());
  for (const MeasuredBlock& block : blocks) ++all[block.name];
  std::map<std::string_view, std::size_t> counts;  // in an order that is the same everywhere
  for (const auto& [name, count] : all) {
    if (count > 1) counts.emplace(name, count);
  }
  std::string text;
  std::size_t named = 0;
  for (const auto& [name, count] : counts) {
    if (named++ == kMaxNames) {
      return text + " and " + std::to_string(counts.size() - kMaxNames) + " more";
    }
    text += (text.empty() ? "" : ", ") + std::string(name) + " " + std::to_string(count) + " times";
  }
  return text;
}

/// "A, B"; empty when every block has a size.
std::string unscaled_names(std::span<const MeasuredBlock> blocks) {
  std::string text;
  std::size_t count = 0;
  for (const MeasuredBlock& block : blocks) {
    if (!block.unscaled || ++count > kMaxNames) continue;
    text += (text.empty() ? "" : ", ") + block.name;
  }
  if (count > kMaxNames) text += " and " + std::to_string(count - kMaxNames) + " more";
  return text;
}

}  // namespace

std::vector<std::string> population_notes(std::span<const MeasuredBlock> blocks) {
  std::vector<std::string> notes;
  const std::string repeated = repeated_names(blocks);
  if (!repeated.empty()) {
    notes.push_back("several blocks have the same name; each of them is counted: " + repeated);
  }
  const std::string unscaled = unscaled_names(blocks);
  if (!unscaled.empty()) {
    notes.push_back(
        "blocks without a known size, which count in the classes but not in sizes and masses: " +
        unscaled + "; their lengths are in units of the model, marked u");
  }
  const auto uncertain =
      std::count_if(blocks.begin(), blocks.end(),
                    [](const MeasuredBlock& block) { return block.axis_error >= block.axes.S; });
  if (uncertain > 0) {
    const auto widest =
        std::max_element(blocks.begin(), blocks.end(),
                         [](const auto& a, const auto& b) { return a.axis_error < b.axis_error; });
    notes.push_back(
        std::to_string(uncertain) + " of " + std::to_string(blocks.size()) +
        " blocks have a shortest axis that is no longer than the error of the axes, "
        "which is up to " +
        format_significant(widest->axis_error, 3) +
        " m: their classes are unreliable; give the error of your measurements as `axis_error`");
  }
  return notes;
}

}  // namespace clast
