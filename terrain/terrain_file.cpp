#include "terrain/terrain_file.hpp"
