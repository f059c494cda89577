#include "report/text/subject_words.hpp"

namespace clast::report_detail {

std::string file_name(const Comparison& comparison, std::uint32_t file) {
  const std::string stem = comparison.results[file].file.stem().string();
  return "file " + std::to_string(file + 1) + (stem.empty() ? "" : " (" + stem + ")");
}

BarrierWords words_of(const Comparison& comparison, std::size_t line) {
  const BarrierLine& barrier = comparison.lines[line];
  if (!barrier.of_ring()) return {barrier.name, "pass"};
  return {barrier.name.substr(0, barrier.name.rfind(" (")), "reach"};
}

}  // namespace clast::report_detail
