#include "shapes/mesh_topology.hpp"
