// The figures of chapter 06's page.
#include "figures.hpp"

namespace texmap::test {

void figures_of_06(Figures& /*figures*/) {}

}  // namespace texmap::test
