// Tests of tests/support/dice.hpp: equal seeds give equal draws, and a number has all digits of its
// type.
#include <doctest.h>

#include "support/dice.hpp"

namespace texmap::test {
namespace {

TEST_CASE("the draws are those of splitmix64") {
  Dice dice(1234567);  // the published values for this seed
  for (const std::uint64_t value :
       {6457827717110365317U, 3203168211198807973U, 9817491932198370423U, 4593380528125082431U}) {
    CHECK(dice.bits() == value);
  }
}

/// The first number of a tape, which must take so many draws. Its exponent is the last of them.
template <class T>
T number_of(Dice::Tape tape, int low, int high) {
  Dice dice(tape, 1);
  const T number = dice.number<T>(low, high);
  CHECK(dice.taken() == tape.size());
  return number;
}

TEST_CASE("a number's digits after the first are the leading bits of one draw") {
  const std::uint64_t bits = 0xfedcba9876543211U;
  CHECK(number_of<float>({bits, 0}, 0, 1) == 0x1.fedcbap0F);
  CHECK(number_of<double>({bits, 0}, 0, 1) == 0x1.fedcba9876543p0);
  CHECK(number_of<double>({bits, 13}, -8, 9) == 0x1.fedcba9876543p5);
  if constexpr (std::numeric_limits<long double>::digits == 64)
    CHECK(number_of<long double>({bits, 0}, 0, 1) == 0x1.fedcba9876543210p0L);
}

}  // namespace
}  // namespace texmap::test
