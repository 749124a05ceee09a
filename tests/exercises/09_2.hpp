// Exercise 09.2: between two frames
//
// A lamp repeats a film without an end. Its `frames` follow each other in this many seconds, all
// equally long; each is one color of light. A frame's color is right in the middle of its time.
// In between mix the two frames next to it in time, as bilinear mixes two texels: the closer one
// counts more. `time` is in seconds since a first frame began, 0 or more; it can be longer than the
// film. Return the color at this time.
#include "exercise.hpp"

Color color_at_time(const std::vector<Color>& frames, double seconds, double time) {
  // solution
  const int count = static_cast<int>(frames.size());
  const double x = time / seconds * count - 0.5;  // middles are now at whole numbers
  const int before = static_cast<int>(std::floor(x));
  const double part = x - before;
  return frames[(before + count) % count] * (1 - part) + frames[(before + 1) % count] * part;
  // start: // Your lines here. frames[0] is the first of frames.size() frames.
  // start: return frames[0];
}
// hint: How long is a frame? Frame k is right at k + 1/2 such times.
// hint: Count the time in frames, less 1/2: now the middles are at whole numbers. std::floor.
// hint: After the last frame comes the first one, and before the first one the last: use %.
