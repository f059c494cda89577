#pragma once
/// The tables of a study file and the keys of each: what `read_calibration_study` knows, and
/// nothing else.
#include "study/campaign/key_table.hpp"

namespace clast {

/// In the order of docs/formats.md.
const std::vector<KeyTable>& calibration_tables();

}  // namespace clast
