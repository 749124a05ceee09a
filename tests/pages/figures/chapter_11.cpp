// The figures of chapter 11's page.
#include "figures.hpp"

namespace texmap::test {

void figures_of_11(Figures& /*figures*/) {}

}  // namespace texmap::test
