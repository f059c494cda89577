#include "shapes/sphero_polyhedron.hpp"
