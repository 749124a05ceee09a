// The ledger: what chapters 01 to 07 would take longer for if they computed what their scenes do
// not require.
#include <map>

#include "ledger.hpp"

namespace texmap::bench {
namespace {

/// How `As` draws what a chapter's lesson has: the lesson itself, or one derived from it.
template <class As, class Lesson = As>
[[nodiscard]] MakeDrawing drawn(const std::vector<std::string>& options = {}) {
  return [=] {
    const auto lesson = prepared<Lesson>(options);
    As other;
    static_cast<Lesson&>(other) = lesson;
    const int height = std::derived_from<Lesson, GathersLight> ? 113 : 150;
    return std::make_shared<LessonWork<As, InDouble>>(std::move(other), 200, height);
  };
}

/// Chapter 01's scene as chapter 06's lesson: its objects without gloss, nothing blended.
[[nodiscard]] std::shared_ptr<Drawing> first_scene_by_the_last() {
  const chapter_01::Lesson first;
  chapter_06::Lesson last;
  last.stage = first.stage;
  last.objects.clear();
  for (const chapter_01::Object& object : first.objects)
    last.objects.push_back({object.shape, object.paint, {.lambertian = first.surface}});
  return std::make_shared<LessonWork<chapter_06::Lesson, InDouble>>(last, 200, 150);
}

}  // namespace

Group ledger_group() {
  Group group = described("ledger");
  group.ratio = Ratio::cost;
  std::map<std::string, MakeDrawing> bases;  // of each set its first line
  const auto add = [&](const std::string& line, const std::string& set, const MakeDrawing& make) {
    const auto [base, is_base] = bases.try_emplace(set, make);
    for (const Variant& variant : double_and_widest_packs()) {
      const auto checked = [=, first = base->second] {
        auto ready = make();
        if (first()->picture(variant) != ready->picture(variant))
          throw std::runtime_error("ledger: another picture: " + line);
        return ready;
      };
      group.rows.push_back(row_of(line, set + " " + variant.name, variant, 1,
                                  is_base ? make : MakeDrawing(checked)));
    }
  };
  add("01: as the chapter draws it", "01", drawn<chapter_01::Lesson>());
  add("01: (u, v) at every hit, used or not", "01", drawn<UvAtEveryHit, chapter_01::Lesson>());
  add("01: hit and (u, v) of every object met, not of the nearest alone", "01",
      drawn<HitOfEveryObject<chapter_01::Lesson>, chapter_01::Lesson>());
  add("01 by the last machinery", "01", first_scene_by_the_last);
  add("03: as the chapter draws it", "03", drawn<chapter_03::Lesson>());
  add("03: hit, (u, v) and texture of every object met, not of the nearest alone", "03",
      drawn<HitOfEveryObject<chapter_03::Lesson>, chapter_03::Lesson>());
  add("06: as the chapter draws it", "06", drawn<chapter_06::Lesson>());
  add("06: a highlight also on objects without gloss", "06",
      drawn<HighlightAnyway, chapter_06::Lesson>());
  const std::vector<std::string> book = {"--scene", "book"};
  add("07: as the chapter draws it", "07", drawn<chapter_07::Lesson>(book));
  add("07: and a new direction under a uniform sky", "07",
      drawn<Beginner<true, false, false>, chapter_07::Lesson>(book));
  add("07: and numbers for a lens and an exposure that are not there", "07",
      drawn<Beginner<true, true, false>, chapter_07::Lesson>(book));
  add("07: and rays where the globe cannot be seen: as a beginner writes it", "07",
      drawn<Beginner<true, true, true>, chapter_07::Lesson>(book));
  return group;
}

}  // namespace texmap::bench
