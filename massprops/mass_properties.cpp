#include "massprops/mass_properties.hpp"
