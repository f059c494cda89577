#include "dem/release.hpp"
