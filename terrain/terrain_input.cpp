#include "terrain/terrain_input.hpp"
