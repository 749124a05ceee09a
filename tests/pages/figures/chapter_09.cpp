// The figures of chapter 09's page.
#include "figures.hpp"

namespace texmap::test {

void figures_of_09(Figures& /*figures*/) {}

}  // namespace texmap::test
