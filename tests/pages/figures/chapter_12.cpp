// The figures of chapter 12's page.
#include "figures.hpp"

namespace texmap::test {

void figures_of_12(Figures& /*figures*/) {}

}  // namespace texmap::test
