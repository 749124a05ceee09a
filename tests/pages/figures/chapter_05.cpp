// The figures of chapter 05's page.
#include "figures.hpp"

namespace texmap::test {

void figures_of_05(Figures& /*figures*/) {}

}  // namespace texmap::test
