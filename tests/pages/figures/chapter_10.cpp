// The figures of chapter 10's page.
#include "figures.hpp"

namespace texmap::test {

void figures_of_10(Figures& /*figures*/) {}

}  // namespace texmap::test
