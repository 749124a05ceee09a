#include <iterator>
#include <utility>

#include "diagrams.hpp"

namespace texmap::diagrams {

std::vector<Drawing> all_diagrams() {
  std::vector<Drawing> all;
  for (auto* chapter :
       {&diagrams_of_02, &diagrams_of_04, &diagrams_of_06, &diagrams_of_07, &diagrams_of_10,
        &diagrams_of_11, &diagrams_of_12, &diagrams_of_13, &diagrams_of_14}) {
    std::vector<Drawing> drawn = chapter();
    all.insert(all.end(), std::make_move_iterator(drawn.begin()),
               std::make_move_iterator(drawn.end()));
  }
  return all;
}

}  // namespace texmap::diagrams
