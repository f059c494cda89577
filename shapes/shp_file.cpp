#include "shapes/shp_file.hpp"
