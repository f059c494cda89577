#pragma once
/// What files and barriers are called in a sentence.
#include <cstdint>
#include <string>

#include "study/compare/comparison.hpp"

namespace clast::report_detail {

/// "file 2 (soft)".
std::string file_name(const Comparison& comparison, std::uint32_t file);

/// A barrier, and what blocks do there.
struct BarrierText {
  std::string name;  ///< with an article where it is a noun: "the road", "EC22"
  std::string pass;  ///< "pass", "reach"
};
BarrierText barrier_text(const Comparison& comparison, std::size_t line);

}  // namespace clast::report_detail
