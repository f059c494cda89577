#include "classify/schemes.hpp"
