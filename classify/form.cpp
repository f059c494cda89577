#include "classify/form.hpp"
