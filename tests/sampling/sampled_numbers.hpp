// The numbers over which the tests of common/sampling run: all of them must give the same.
#pragma once
#include "number/kinds/pack2.hpp"

#define TEXMAP_SAMPLED_NUMBERS                                           \
  float, double, long double, texmap::Pack<float>, texmap::Pack<double>, \
      texmap::Pack2<texmap::Pack<float>>, texmap::Pack2<texmap::Pack<double>>
