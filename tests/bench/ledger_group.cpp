// The ledger: what chapters 01 to 07 would take longer for if they computed what their scenes do
// not require.
#include <memory>
#include <stdexcept>

#include "ledger.hpp"
#include "make_rows.hpp"

namespace texmap::bench {
namespace {

/// On the stage of chapters 01 to 06.
template <class Lesson>
[[nodiscard]] auto on_stage(Lesson lesson) {
  return std::make_shared<LessonWork<Lesson, InDouble>>(std::move(lesson), 200, 150);
}

/// In the shape of chapter 07.
template <class Lesson>
[[nodiscard]] auto sampled(Lesson lesson) {
  return std::make_shared<LessonWork<Lesson, InDouble>>(std::move(lesson), 200, 113);
}

/// A line of the ledger, and the line that it is compared with.
template <class MakeBase, class MakeOther>
void add_variant(Group& group, const std::string& line, const std::string& set,
                 const MakeBase& base, const MakeOther& other) {
  for (const Variant& variant : {in_double, widest_double_pack()}) {
    const auto checked = [=] {
      const auto ready = other();
      if (base()->picture(variant) != ready->picture(variant))
        throw std::runtime_error("ledger: another picture: " + line);
      return ready;
    };
    group.rows.push_back(row_of(line, set + " " + std::string(variant.name), variant, 1, checked));
  }
}
template <class MakeBase>
void add_base(Group& group, const std::string& line, const std::string& set, const MakeBase& base) {
  for (const Variant& variant : {in_double, widest_double_pack()}) {
    group.rows.push_back(row_of(line, set + " " + std::string(variant.name), variant, 1, base));
  }
}

template <class Lesson>
[[nodiscard]] Lesson prepared() {
  return texmap::prepared<Lesson>();
}

/// A lesson that has what another one has, and draws it in its own way.
template <class Variant, class Lesson>
[[nodiscard]] Variant in_place_of(const Lesson& lesson) {
  Variant variant;
  static_cast<Lesson&>(variant) = lesson;
  return variant;
}

/// Chapter 01's scene as chapter 06's lesson: its objects without gloss, nothing blended.
[[nodiscard]] chapter_06::Lesson first_scene_of_the_last() {
  const chapter_01::Lesson first;
  chapter_06::Lesson last;
  last.stage = first.stage;
  last.objects.clear();
  for (const chapter_01::Object& object : first.objects) {
    last.objects.push_back({object.shape, object.paint, {.lambertian = first.surface}});
  }
  return last;
}

}  // namespace

Group ledger_group() {
  Group group{
      .name = "ledger",
      .title = "What the scenes do not require",
      .text =
          "Chapters as they are (base), and with something computed that their scene does not "
          "require: the same picture to the last byte. `01 by the last machinery` is chapter "
          "01's scene drawn by chapter 06's lesson. 200 × 150 pixels; chapter 07 200 × 113 with "
          "8 samples. What saves less than some hundredths drowns in the noise of the machine.",
      .unit = "ms",
      .ratio = Ratio::cost,
      .seconds = 55,
  };
  const auto stage_chapter = [&group]<class Lesson>(std::type_identity<Lesson>,
                                                    const std::string& number, const auto& make) {
    add_base(group, number + ": as the chapter draws it", number,
             [make] { return on_stage(make()); });
    add_variant(
        group, number + ": (u, v) at every hit, used or not", number,
        [make] { return on_stage(make()); },
        [make] { return on_stage(in_place_of<UvAtEveryHit<Lesson>>(make())); });
  };

  const auto first = prepared<chapter_01::Lesson>;
  stage_chapter(std::type_identity<chapter_01::Lesson>{}, "01", first);
  add_variant(
      group, "01: hit and (u, v) of every object met, not of the nearest alone", "01",
      [=] { return on_stage(first()); },
      [=] { return on_stage(in_place_of<HitOfEveryObject<chapter_01::Lesson>>(first())); });
  add_variant(
      group, "01 by the last machinery", "01", [=] { return on_stage(first()); },
      [] { return on_stage(first_scene_of_the_last()); });

  stage_chapter(std::type_identity<chapter_02::Lesson>{}, "02", prepared<chapter_02::Lesson>);

  stage_chapter(std::type_identity<chapter_03::Lesson>{}, "03", prepared<chapter_03::Lesson>);
  add_variant(
      group, "03: hit, (u, v) and texture of every object met, not of the nearest alone", "03",
      [] { return on_stage(prepared<chapter_03::Lesson>()); },
      [] {
        return on_stage(
            in_place_of<HitOfEveryObject<chapter_03::Lesson>>(prepared<chapter_03::Lesson>()));
      });

  stage_chapter(std::type_identity<chapter_04::Lesson>{}, "04", prepared<chapter_04::Lesson>);

  stage_chapter(std::type_identity<chapter_05::Lesson>{}, "05", prepared<chapter_05::Lesson>);
  add_variant(
      group, "05: sine and cosine at every hit", "05",
      [] { return on_stage(prepared<chapter_05::Lesson>()); },
      [] { return on_stage(SineAtEveryHit(prepared<chapter_05::Lesson>())); });
  const auto unturned = [] { return on_stage(prepared<chapter_04::Lesson>()); };
  add_base(group, "05: not turned, by chapter 04's lesson", "05 not turned", unturned);
  add_variant(group, "05: turned by 0 degrees", "05 not turned", unturned, [] {
    return on_stage(texmap::prepared<chapter_05::Lesson>({"--degrees", "0"}));
  });

  const auto sixth = [] { return on_stage(prepared<chapter_06::Lesson>()); };
  add_base(group, "06: as the chapter draws it", "06", sixth);
  add_variant(group, "06: shadow rays also from surfaces that face away", "06", sixth, [] {
    return on_stage(in_place_of<ShadowRayAnyway>(prepared<chapter_06::Lesson>()));
  });
  add_variant(group, "06: a highlight also on objects without gloss", "06", sixth, [] {
    return on_stage(in_place_of<HighlightAnyway>(prepared<chapter_06::Lesson>()));
  });

  const auto seventh = [] { return prepared<chapter_07::Lesson>(); };
  const auto seventh_work = [=] { return sampled(seventh()); };
  add_base(group, "07: as the chapter draws it", "07", seventh_work);
  add_variant(group, "07: a new direction under a uniform sky", "07", seventh_work,
              [=] { return sampled(in_place_of<ScatterAnyway>(seventh())); });
  add_variant(group, "07: numbers for a lens and an exposure that are not there", "07",
              seventh_work, [=] { return sampled(in_place_of<NumbersAnyway>(seventh())); });
  add_variant(group, "07: rays also where the globe cannot be seen", "07", seventh_work,
              [=] { return sampled(in_place_of<WithoutBounds>(seventh())); });
  return group;
}

}  // namespace texmap::bench
