#include "reconstruct/scan.hpp"
