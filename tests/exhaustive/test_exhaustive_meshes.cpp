// Ten million rays at the edges and corners of meshes, in each number: none slips through.
#include <doctest.h>

#include <atomic>

#include "engine/render/threads.hpp"
#include "every_float.hpp"
#include "number/kinds/pack2.hpp"
#include "support/mesh_rays.hpp"

namespace texmap::test {
namespace {

TEST_CASE_TEMPLATE("no crack and no double hit for ten million rays at edges and corners", Real,
                   float, double, long double, Pack2<Pack<float>>, Pack2<Pack<double>>) {
  constexpr long rays = 10'000'000 / one_row_of;
  constexpr int parts = 100;
  std::atomic<long> cracks = 0, doubles = 0, unequal = 0, done = 0;
  for_each_row(parts, 0, {}, [&](int part) {
    const Leaks leaks =
        count_leaks<Real>(rays / parts + 1, 1000 + static_cast<std::uint64_t>(part));
    cracks += leaks.cracks;
    doubles += leaks.doubles;
    unequal += leaks.unequal;
    done += leaks.rays;
  });
  CHECK(done >= rays);
  CHECK(cracks == 0);
  CHECK(doubles == 0);
  CHECK(unequal == 0);
}

}  // namespace
}  // namespace texmap::test
