// The figures of chapter 04's page.
#include "figures.hpp"

namespace texmap::test {

void figures_of_04(Figures& /*figures*/) {}

}  // namespace texmap::test
