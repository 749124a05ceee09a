// The figures of chapter 13's page.
#include "figures.hpp"

namespace texmap::test {

void figures_of_13(Figures& /*figures*/) {}

}  // namespace texmap::test
