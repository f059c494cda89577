#include "library/block_library.hpp"
