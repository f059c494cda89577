#pragma once
/// Cases that are not one whole rock: neighbours, unscanned bases and tunnels, shells, slabs,
/// bridges.
#include <vector>

#include "tests/app/reliability/cases.hpp"

namespace clast::reliability {

std::vector<Kind> odd_kinds();

}  // namespace clast::reliability
