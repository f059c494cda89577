#include "shapes/oriented_box.hpp"
