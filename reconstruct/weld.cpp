#include "reconstruct/weld.hpp"
