#include "dem/terrain_surface.hpp"
