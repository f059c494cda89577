#include "massprops/sphero.hpp"
