#include "dem/contact_law.hpp"
