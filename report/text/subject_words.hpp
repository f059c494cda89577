#pragma once
/// Names of files and barriers in sentences.
#include <cstdint>
#include <string>

#include "study/compare/comparison.hpp"

namespace clast::report_detail {

/// Returns the label of a results file in sentences, such as "file 2 (soft)".
std::string results_file_label(const Comparison& comparison, std::uint32_t file);

/// Words for a barrier in sentences: its name, and the verb for passing it.
struct BarrierText {
  std::string name;  ///< name, such as "EC22"; nouns have an article, such as "the road"
  std::string pass;  ///< verb, such as "pass" or "reach"
};
BarrierText barrier_text(const Comparison& comparison, std::size_t line);

}  // namespace clast::report_detail
