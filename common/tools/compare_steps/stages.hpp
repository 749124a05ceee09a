// The chapters that draw the stage: stages.cmake lists them.
#pragma once
#include <string_view>

#include "comparison.hpp"

namespace texmap::steps {

/// A chapter that draws the stage: its pixels can be compared with those of another.
struct OnStage {
  std::string_view name;
  DrawnStep (*draw)(const std::string& chapter, const Drawing&,
                    const std::vector<std::string>& options);
  ObjectSet changed_objects;
};
template <class Lesson>
constexpr OnStage on_stage(std::string_view name) {
  return {name, draw_step<Lesson>, Lesson::about.changed_objects};
}

[[nodiscard]] const std::vector<OnStage>& stages();

}  // namespace texmap::steps
