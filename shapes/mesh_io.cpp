#include "shapes/mesh_io.hpp"
