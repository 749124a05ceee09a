#include "figures.hpp"
namespace texmap::test {
void figures_of_14(Figures& /*figures*/) {}
}  // namespace texmap::test
