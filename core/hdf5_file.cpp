#include "core/hdf5_file.hpp"
