// The figures of chapter 08's page.
#include "figures.hpp"

namespace texmap::test {

void figures_of_08(Figures& /*figures*/) {}

}  // namespace texmap::test
