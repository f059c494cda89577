#include "core/version.hpp"

namespace clast {

const char* version() { return CLAST_VERSION; }

}  // namespace clast
