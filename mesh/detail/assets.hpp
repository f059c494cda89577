#pragma once
/// Files of the folder mesh/assets as strings.
#include <string_view>

namespace clast::mesh_detail::assets {

extern const std::string_view unpack_laz_js;  ///< unpacks a LAZ file with Node and laz-perf

}  // namespace clast::mesh_detail::assets
