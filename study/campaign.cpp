#include "study/campaign.hpp"
