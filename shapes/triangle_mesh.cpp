#include "shapes/triangle_mesh.hpp"
