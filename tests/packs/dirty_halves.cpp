// Wide code that leaves the upper halves of registers in use: compiled without vzeroupper, for the
// check that must notice it.
#include <immintrin.h>

#include <cmath>
#include <cstdio>

namespace {

__attribute__((noinline)) void sum_of_products(const float* a, const float* b, float* out) {
  _mm256_storeu_ps(out, _mm256_mul_ps(_mm256_loadu_ps(a), _mm256_loadu_ps(b)));
}

__attribute__((noinline)) float mixed(const float* a, float* out) {
  _mm256_storeu_ps(out, _mm256_sqrt_ps(_mm256_loadu_ps(a)));
  return std::fmod(out[0], 3.0F) + out[1];
}

}  // namespace

int main(int argc, char**) {
  float a[8] = {}, out[8] = {};
  for (float& each : a) each = static_cast<float>(argc);
  sum_of_products(a, a, out);
  std::printf("%g\n", static_cast<double>(mixed(out, a)));
}
