#include "study/statistics.hpp"
