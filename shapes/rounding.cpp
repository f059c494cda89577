#include "shapes/rounding.hpp"
