#define TM_PAIR_SINGLE
#include "single_rates.h"

SINGLE_RATES(single_rates_default)
