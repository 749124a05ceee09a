// The list of everything that is measured.
#include "bench.hpp"

namespace texmap::bench {

std::vector<Group> all_groups() {
  return {chapters_group(), budgets_group(),  ledger_group(), uv_group(),      texture_group(),
          spheres_group(),  samplers_group(), colors_group(), encoding_group()};
}

}  // namespace texmap::bench
