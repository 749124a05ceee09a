// How far a run is: its parts, counted.
#pragma once
#include "table.hpp"

namespace texmap::chapter_13 {

/// A part of a run that the progress line names.
struct Phase {
  const char* name;
  std::size_t parts;  ///< ticks
};

/// All of a run, in their order.
[[nodiscard]] std::vector<Phase> phases_of(int rounds, Instructions widest);

/// How many rays a whole run follows, without those of the sheet.
[[nodiscard]] double rays_of(const Measurements& all);

/// Counts the parts of a run that are done, for its progress line.
class Ticks {
 public:
  explicit Ticks(std::vector<Phase> stages);
  void operator()(const RenderSettings& settings);
  /// What the line says at its end: the stage of the next part, nothing if all are done.
  [[nodiscard]] std::string remark() const;

 private:
  std::vector<Phase> phases_;
  std::size_t total_ = 0, done_ = 0;
};

}  // namespace texmap::chapter_13
