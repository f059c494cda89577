#include "classify/population.hpp"
