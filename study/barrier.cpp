#include "study/barrier.hpp"
