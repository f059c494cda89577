#include "shapes/convex_hull.hpp"
