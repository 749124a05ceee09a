// A diagram by its name, and distances in it.
#pragma once
#include <doctest.h>

#include <cmath>
#include <string>

#include "diagrams/diagrams.hpp"

namespace texmap::diagrams {

/// The diagram with this name; the test fails if there is none.
[[nodiscard]] inline Drawing named(const std::string& name) {
  for (const Drawing& drawing : all_diagrams()) {
    if (drawing.name() == name) return drawing;
  }
  FAIL("no diagram has the name " << name);
  return Drawing("", 0, 0, "", "");
}

[[nodiscard]] inline double distance(Spot a, Spot b) { return std::hypot(a.x - b.x, a.y - b.y); }

}  // namespace texmap::diagrams
