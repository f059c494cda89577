#include "study/campaign_runner.hpp"
