// The exercises of chapter 09, and what strangers write for them.
#include "solutions/09.hpp"

const std::vector<double> texmap::test::answers{188, 1398101};

TEST_CASE("09: strangers' answers get their words") {
  repeated_column("below 0", [](int c, int w) { return c - c / w * w; });
  repeated_column("clamp", [](int c, int w) { return min(max(0, c), w - 1); });
  repeated_column("one width is not enough", [](int c, int w) { return (c + 100 * w) % w; });
  repeated_column("one width is not enough", [](int c, int w) { return (c + w) % w; });

  using Film = std::vector<Color>;
  const auto by_time = [](const char* text, auto other) {  // in frames
    color_at_time(text, [=](const Film& frames, D seconds, D time) {
      const D n = frames.size();
      return solution_2::color_at_time(frames, 1, other(time / seconds * n, n) / n + 7);
    });
  };
  by_time("half a frame is missing", [](D t, D n) { return t + 0.5; });
  by_time("the film begins again", [](D t, D n) { return max(0.5, min(fmod(t, n), n - 0.5)); });
  by_time("nearest frame", [](D t, D n) { return floor(t) + 0.5; });
  color_at_time.right([](const Film& frames, D seconds, D time) {  // by a loop over the film
    const int n = frames.size();
    D x = time / (seconds / n) + n - 0.5;
    while (x >= n) x -= n;
    const int before = x, after = before + 1 < n ? before + 1 : 0;
    return frames[before] + (frames[after] - frames[before]) * (x - before);
  });

  const auto by_ways = [](const char* text, auto level) {  // of the vectors in texels
    level_for(text, [=](Uv here, Uv right, Uv below, int width, int height) {
      const auto way = [=](Uv to) {
        const D u = to.u - here.u;
        return V{(u > 0.5 ? u - 1 : u < -0.5 ? u + 1 : u) * width, (to.v - here.v) * height, 0};
      };
      return level(way(right), way(below));
    });
  };
  by_ways("no level is finer", [](V p, V q) { return log2(max(length(p), length(q))); });
  by_ways("the longer way", [](V p, V) { return log2(max(1.0, length(p))); });
  level_for("across the seam", [](Uv here, Uv right, Uv below, int width, int height) {
    const D p = std::hypot((right.u - here.u) * width, (right.v - here.v) * height);
    const D q = std::hypot((below.u - here.u) * width, (below.v - here.v) * height);
    return max(0.0, log2(max(p, q)));
  });
}
