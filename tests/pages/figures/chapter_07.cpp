// The figures of chapter 07's page.
#include "figures.hpp"

namespace texmap::test {

void figures_of_07(Figures& /*figures*/) {}

}  // namespace texmap::test
