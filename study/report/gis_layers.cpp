#include "study/report/gis_layers.hpp"
