// The exercises of chapter 13. Their pictures are charts: the ways with the one that is taken, and
// what pixels ask of the paint.
#include "exercise.hpp"
#include "exercises.hpp"

namespace texmap::check {
namespace {

using Ways = std::vector<Way>;

/// What a function returns, and how often it asks.
struct Counted {
  static constexpr std::array names = {"the brightness", "how often you ask"};
  double brightness, calls;
};
std::array<double, 2> parts(const Counted& it) { return {it.brightness, it.calls}; }

std::function<int(const Ways&, int, double)> cheapest;
std::function<Counted(const std::vector<Met>&, double)> counted;

/// The way with the smallest key of those that fit; -1 if none does.
int chosen(const Ways& ways, const auto& fits, const auto& key) {
  int best = -1;
  for (int i = 0; i < std::ssize(ways); ++i) {
    const Way& way = ways[std::size_t(i)];
    if (fits(way) && (best < 0 || key(way) < key(ways[std::size_t(best)]))) best = i;
  }
  return best;
}
std::pair<double, double> time_and_error(const Way& way) { return {way.ms, way.at_most}; }
int fastest(const Ways& ways, const auto& fits) { return chosen(ways, fits, time_and_error); }
int fastest(const Ways& ways, double budget) {
  return fastest(ways, [=](const Way& way) { return way.at_most <= budget; });
}
int right_way(const Ways& ways, int width, double budget) {
  return fastest(ways, budget * 2048 / width);
}

Slips<int> wrong_ways(const Ways& ways, int width, double budget) {
  const double most = budget * 2048 / width;  // as it was measured
  const int right = right_way(ways, width, budget), size = int(ways.size());
  const auto fits = [=](const Way& way) { return way.at_most <= most; };
  const auto seen = [=](const Way& way) { return way.seen <= most; };
  const auto in_part = [=](const Way& way) { return way.at_most < most; };
  const auto first_too = [&](const Way& way) { return &way == ways.data() || fits(way); };
  const auto error = [](const Way& way) { return way.at_most; };
  const auto time = [](const Way& way) { return way.ms; };
  const auto time_and_seen = [](const Way& way) { return std::pair(way.ms, way.seen); };
  const int whole = width / 2048;
  return {
      {"what was seen is luck: another picture has other pixels. Take the error at most",
       fastest(ways, seen)},
      {"the ways were measured with 2048 texels: a place is off by another number of yours",
       fastest(ways, budget)},
      {"a wider texture has more texels to be off by: multiply by width / 2048",
       fastest(ways, budget * width / 2048)},
      {"width / 2048 divides whole numbers, and the rest is lost", fastest(ways, budget / whole)},
      {"the budget is not used: this is the fastest of all", fastest(ways, infinity<double>())},
      {"of those that fit the fastest is wanted, and this is the most accurate",
       chosen(ways, fits, error)},
      {"of several that are as fast, take the one that is off by less, at most",
       {chosen(ways, fits, time), chosen(ways, fits, time_and_seen)}},
      {"a way that is off by the whole budget keeps to it, too", fastest(ways, in_part)},
      {"if no way fits, return -1", {max(right, 0), right < 0 ? size : right}},
      {"you begin with way 0, which may not fit: begin with no way, -1", fastest(ways, first_too)},
      {"this is the first way that fits: go on to the end",
       chosen(ways, fits, [](const Way&) { return 0; })},
      {"ways are counted from 0", right + 1},
  };
}

const Ways measured_ways = {{10, 0.00002, 0.0001}, {4, 0.0011, 0.0086}, {2.5, 0.0008, 0.05},
                            {4, 0.0013, 0.004},    {1, 0.18, 0.21},     {7, 0.0011, 0.002}};

/// The ways, time to the right and error upward, with what is taken for a budget that falls.
Image chart() {
  return panels([](int panel, double x, double y) {
    const int taken = cheapest(measured_ways, 512 << panel % 4, 0.25 * pow(0.04, panel / 4));
    for (int i = 0; i < std::ssize(measured_ways); ++i) {
      const auto [ms, seen, most] = measured_ways[std::size_t(i)];
      const double away = std::hypot(x - log2(ms) / 4.5 - 0.13, y - log10(most) / 4.2 - 1.05);
      if (away < (i == taken ? 0.07 : 0.03)) return i == taken ? 1. : 0.5;
    }
    return 0.1;
  });
}

using Seen = std::function<double(const std::vector<Met>&, const PaintOf&, double)>;

double brightness(int object) { return 1 - 0.15 * object; }

/// The student's function with a paint that counts.
std::any with_count(const std::any& yours) {
  const auto* seen = std::any_cast<Seen>(&yours);
  if (seen == nullptr) return yours;
  return std::function([seen = *seen](const std::vector<Met>& met, double sky) {
    double calls = 0;
    const auto paint = [&](int object) { return ++calls, brightness(object); };
    const double color = seen(met, paint, sky);
    return Counted{color, calls};
  });
}

/// Light and texture of the nearest object.
std::pair<double, double> nearest_of(const std::vector<Met>& met) {
  const auto nearest = std::min_element(
      met.begin(), met.end(), [](const Met& a, const Met& b) { return a.distance < b.distance; });
  return {nearest->light, brightness(int(nearest - met.begin()))};
}
Counted right_count(const std::vector<Met>& met, double sky) {
  if (met.empty()) return {sky, 0};
  const auto [light, texture] = nearest_of(met);
  return {light * texture, light > 0 ? 1. : 0.};
}

Slips<Counted> wrong_counts(const std::vector<Met>& met, double sky) {
  const auto [right, once] = right_count(met, sky);
  const auto [light, texture] = met.empty() ? std::pair(sky, sky) : nearest_of(met);
  const double first = met.empty() ? sky : met[0].light * brightness(0);
  const double size = double(met.size()), any = min(size, 1.);
  double nearer = 0, nearer_and_lit = 0, lit = 0, nearest = infinity<double>();
  for (const Met& one : met) {
    if (one.distance < nearest) ++nearer;
    if (one.distance < nearest && one.light > 0) ++nearer_and_lit;
    if (one.light > 0) ++lit;
    nearest = min(nearest, one.distance);
  }
  return {
      {"you ask for the texture of each object: find the nearest one first", {right, size}},
      {"you ask whenever an object is nearer than those before it: ask behind the loop",
       {{right, nearer}, {right, nearer_and_lit}}},
      {"where no light arrives all textures are black: do not ask there", {right, any}},
      {"you ask for the texture of each object in the light: the nearest one alone is seen",
       {right, lit}},
      {"you ask for a texture also where the ray meets nothing", {right, 1}},
      {"the nearest object is seen, and this is the first one", {{first, once}, {first, any}}},
      {"the light is missing: a texture in a shadow is dark", {texture, any}},
      {"the texture is missing: you never ask", {light, 0}},
      {"where the ray meets nothing, the pixel shows the sky", {met.empty() ? 0 : right, once}},
  };
}

/// Five disks, partly in a shadow. Their order differs from panel to panel. A pixel is brighter
/// the more often its ray asks for the paint.
Image asked() {
  return panels([](int panel, double x, double y) {
    std::vector<Met> met;
    for (int disk = 0; disk < 5; ++disk) {
      if (std::hypot(x - 0.36 - 0.07 * disk, y - 0.4 - 0.04 * disk) < 0.3) {
        met.push_back(
            {1. + (disk * (panel % 4 + 1) + panel) % 5, x > 0.8 - 0.04 * panel ? 0. : 1.});
      }
    }
    const auto [color, calls] = counted(met, 0.9);
    return 0.3 * color + 0.14 * calls;
  });
}

/// The law is about what a function returns and how often it asks.
Exercise with_calls(Exercise of) {
  of.values = [values = of.values](const std::any& yours) { return values(with_count(yours)); };
  of.draw = [draw = of.draw](const std::any& yours) { return draw(with_count(yours)); };
  return of;
}

}  // namespace

ExercisesOfChapter all_exercises_of_chapter() {
  static const Place<Ways, int, double> cheapest_places[] = {
      {"the fastest of three that fit, with a texture of 2048 texels",
       {{{9, 0.001, 0.002}, {3, 0.005, 0.009}, {12, 0.003, 0.008}}, 2048, 0.01}},
      {"no pixel was seen that is off by more than 0.01, but one may be: take the slow way",
       {{{9, 0.001, 0.002}, {3, 0.005, 0.09}}, 2048, 0.01}},
      {"on a texture twice as wide 0.009 texels are 0.018",
       {{{3, 0.005, 0.009}, {8, 0.001, 0.004}, {9, 0.001, 0.002}}, 4096, 0.01}},
      {"on a texture half as wide 0.018 texels are 0.009",
       {{{8, 0.001, 0.004}, {3, 0.005, 0.018}, {2, 0.005, 0.03}}, 1024, 0.01}},
      {"on 3000 texels", {{{3, 0.005, 0.009}, {8, 0.001, 0.004}}, 3000, 0.01}},
      {"of two that are as fast, the second is off by less",
       {{{4, 0.001, 0.008}, {4, 0.002, 0.003}, {5, 0.0001, 0.0002}}, 2048, 0.01}},
      {"of two that are as fast, the first is off by less",
       {{{4, 0.002, 0.003}, {4, 0.001, 0.008}, {5, 0.0001, 0.0002}}, 2048, 0.01}},
      {"a way that is off by exactly the budget fits", {{{6, 0, 0}, {5, 0.125, 0.25}}, 4096, 0.5}},
      {"no way is sure to fit", {{{1, 0.0001, 0.5}, {9, 0.001, 0.002}}, 2048, 0.001}},
      {"six ways on a texture 8192 wide", {measured_ways, 8192, 0.02}},
  };
  using Objects = std::vector<Met>;
  static const Place<Objects, double> seen_places[] = {
      {"no object: the sky, and nothing is asked", {Objects{}, 0.9}},
      {"one object in the light: its texture, asked for once", {Objects{{3, 0.5}}, 0.9}},
      {"two objects, the second is nearer: asked once", {Objects{{5, 0.5}, {4, 0.8}}, 0.9}},
      {"one object in a shadow: 0, and nothing is asked", {Objects{{3, 0}}, 0.9}},
      {"the nearest of three is in a shadow: nothing is asked",
       {Objects{{7, 0.4}, {2, 0}, {5, 0.8}}, 0.9}},
      {"five objects, ever nearer: asked once",
       {Objects{{9, 0.3}, {8, 0.9}, {6, 0.5}, {5, 0}, {4, 0.7}}, 0.9}},
      {"five objects, the third is the nearest: asked once",
       {Objects{{9, 0.3}, {6, 0.9}, {2, 0.6}, {5, 0.2}, {4, 0.7}}, 0.9}},
  };
  return {"13",
          {exercise(cheapest, chart, {right_way, wrong_ways, cheapest_places}),
           with_calls(exercise(counted, asked, {right_count, wrong_counts, seen_places}))},
          {}};
}

}  // namespace texmap::check
