#include "dem/rigid_body.hpp"
