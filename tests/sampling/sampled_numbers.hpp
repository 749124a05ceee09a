// The numbers over which the tests of common/sampling run: all of them must give the same.
#pragma once
#include "paired.hpp"

#ifdef TEXMAP_HAVE_PACKS
#define TEXMAP_SAMPLED_NUMBERS                                                                                \
  float, double, long double, texmap::Pack<float>, texmap::Pack<double>, texmap::Paired<texmap::Pack<float>>, \
      texmap::Paired<texmap::Pack<double>>
#else
#define TEXMAP_SAMPLED_NUMBERS float, double, long double
#endif
