#include "study/comparison.hpp"
