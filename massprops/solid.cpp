#include "massprops/solid.hpp"
