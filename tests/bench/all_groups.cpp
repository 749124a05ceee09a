// The list of everything that is measured.
#include "bench.hpp"

namespace texmap::bench {

std::vector<Group> all_groups() { return {uv_group(), texture_group(), spheres_group(), samplers_group(), colors_group()}; }

}  // namespace texmap::bench
