#include "study/report/html_report.hpp"
