// The exercises of chapter 13, and what strangers write for them.
#include "solutions/13.hpp"

const std::vector<double> texmap::test::answers{};

TEST_CASE("13: strangers' answers get their words") {
  using Ways = const std::vector<Way>&;
  const auto first_by = [](const char* text, auto fits, auto key) {
    cheapest(text, [=](Ways ways, int width, D budget) {
      int best = -1;
      for (int i = 0; i < std::ssize(ways); ++i)
        if (fits(ways[i], width / 2048., budget) && (best < 0 || key(ways[i]) < key(ways[best])))
          best = i;
      return best;
    });
  };
  const auto ms = [](const Way& way) { return way.ms; };
  const auto both = [](const Way& way) { return std::pair(way.ms, way.at_most); };
  first_by(
      "luck", [](const Way& w, D k, D most) { return w.seen * k <= most; }, both);
  first_by(
      "another number of yours", [](const Way& w, D, D most) { return w.at_most <= most; }, both);
  first_by(
      "as fast", [](const Way& w, D k, D most) { return w.at_most * k <= most; }, ms);

  using Objects = const std::vector<Met>&;
  seen("each object", [](Objects met, const PaintOf& paint, D sky) {
    std::vector<D> colors;
    for (int i = 0; i < std::ssize(met); ++i) colors.push_back(paint(i) * met[i].light);
    int nearest = 0;
    for (int i = 0; i < std::ssize(met); ++i)
      if (met[i].distance < met[nearest].distance) nearest = i;
    return met.empty() ? sky : colors[nearest];
  });
  seen("do not ask there", [](Objects met, const PaintOf& paint, D sky) {
    D nearest = infinity;
    int which = -1;
    for (int i = 0; i < std::ssize(met); ++i)
      if (met[i].distance < nearest) nearest = met[which = i].distance;
    return which < 0 ? sky : met[which].light * paint(which);
  });
}
