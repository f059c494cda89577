#include "dem/stiffness.hpp"
