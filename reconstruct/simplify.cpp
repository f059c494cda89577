#include "reconstruct/simplify.hpp"
