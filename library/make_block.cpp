#include "library/make_block.hpp"
