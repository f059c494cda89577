#include "classify/dimension_table.hpp"
