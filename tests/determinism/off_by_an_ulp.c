/* A C library for LD_PRELOAD whose elementary functions are off by one ulp at random: no picture
   may depend on how they round. Each asks the real one, and in two of three cases takes the number
   above or below. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <math.h>
#include <stdint.h>
static uint64_t state = 88172645463325252ULL;
static int dice(void) { state ^= state << 13; state ^= state >> 7; state ^= state << 17; return (int)(state % 3) - 1; }
#define OFF(T, name, next, parameters, arguments)                             \
  T name parameters {                                                         \
    T(*real) parameters = (T(*) parameters)dlsym(RTLD_NEXT, #name);           \
    const int step = dice();                                                  \
    return step ? next(real arguments, (T)(step * INFINITY)) : real arguments; \
  }
#define ONE(name)                                       \
  OFF(double, name, nextafter, (double x), (x))         \
  OFF(float, name##f, nextafterf, (float x), (x))       \
  OFF(long double, name##l, nextafterl, (long double x), (x))
#define TWO(name)                                                  \
  OFF(double, name, nextafter, (double x, double y), (x, y))       \
  OFF(float, name##f, nextafterf, (float x, float y), (x, y))      \
  OFF(long double, name##l, nextafterl, (long double x, long double y), (x, y))
ONE(sin) ONE(cos) ONE(tan) ONE(asin) ONE(acos) ONE(atan) ONE(exp) ONE(exp2) ONE(expm1) ONE(log) ONE(log2) ONE(log10) ONE(log1p) ONE(cbrt)
TWO(atan2) TWO(pow) TWO(hypot)
void sincos(double x, double *s, double *c) { *s = sin(x); *c = cos(x); }
void sincosf(float x, float *s, float *c) { *s = sinf(x); *c = cosf(x); }
void sincosl(long double x, long double *s, long double *c) { *s = sinl(x); *c = cosl(x); }
