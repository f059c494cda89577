#pragma once
/// Published shape classes.
#include <string>
#include <vector>

#include "classify/form.hpp"

namespace clast {

/// The ten classes of Sneed & Folk: C, CP, CB, CE, P, B, E, VP, VB, VE. @cite sneed1958
std::string sneed_folk_class(const Axes& axes);
/// "disc", "spheroid", "blade" or "rod", with limits of 2/3. @cite zingg1935
std::string zingg_class(const Axes& axes);
/// "elongated" for s_c > 0.3, else "compact". @cite garcia2022
std::string garcia_class(const Axes& axes);

/// Every scheme, in the order they are listed: "sneed-folk", "zingg", "garcia".
const std::vector<std::string>& scheme_names();
/// Class names of a scheme in the order they are listed in tables.
/// @param scheme  "sneed-folk", "zingg" or "garcia"
/// @throws InputError  unknown scheme; the message lists the known ones
const std::vector<std::string>& class_names(const std::string& scheme);
std::string shape_class(const std::string& scheme, const Axes& axes);

}  // namespace clast
