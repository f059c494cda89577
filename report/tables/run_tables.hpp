#pragma once
/// The tables with a row for a run or for something that happened in one, as CSV text; columns in
/// docs/formats.md. Rows are in order of file, run and time.
#include <string>

#include "study/compare/comparison.hpp"

namespace clast {

std::string runs_csv(const Comparison& comparison);
std::string crossings_csv(const Comparison& comparison);
std::string impacts_csv(const Comparison& comparison);
std::string stays_csv(const Comparison& comparison);

}  // namespace clast
