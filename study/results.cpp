#include "study/results.hpp"
