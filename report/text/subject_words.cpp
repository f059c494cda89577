#include "report/text/subject_words.hpp"

#include <algorithm>
#include <cctype>

namespace clast::report_detail {

std::string results_file_label(const Comparison& comparison, std::uint32_t file) {
  const std::string stem = comparison.results[file].file.stem().string();
  return "file " + std::to_string(file + 1) + (stem.empty() ? "" : " (" + stem + ")");
}

namespace {

/// "the road", but "EC22" and "Fence 2".
std::string with_article(const std::string& name) {
  const bool noun = std::all_of(name.begin(), name.end(), [](unsigned char c) {
    return std::islower(c) || c == ' ' || c == '-' || c >= 0x80;
  });
  return noun && !name.starts_with("the ") ? "the " + name : name;
}

}  // namespace

BarrierText barrier_text(const Comparison& comparison, std::size_t line) {
  const BarrierLine& barrier = comparison.lines[line];
  if (!barrier.belongs_to_ring()) return {with_article(barrier.name), "pass"};
  return {with_article(barrier.name.substr(0, barrier.name.rfind(" ("))), "reach"};
}

}  // namespace clast::report_detail
