#include "terrain/terrain.hpp"
