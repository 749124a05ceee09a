// The figures of chapter 02's page.
#include "figures.hpp"

namespace texmap::test {

void figures_of_02(Figures& /*figures*/) {}

}  // namespace texmap::test
