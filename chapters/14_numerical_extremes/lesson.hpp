// The lesson of this chapter: what breaks at the limits of a number, and the formulas that hold.
#pragma once
#include <vector>

#include "engine/run/session.hpp"
#include "engine/run/texture_file.hpp"
#include "exhibit.hpp"

namespace texmap::chapter_14 {

struct Lesson : SheetLesson {
  static constexpr About about{
      .idea = "what breaks at the limits of a number, and the formulas that hold",
      .size = {1680, 1900},
      .numbers = Numbers::single,  // the published formulas branch, and packs cannot
  };

  TextureFile texture{"earth.png"};
  TextureFile labels{"uv_map.png"};
  ExhibitOptions exhibit;

  [[nodiscard]] std::vector<Exhibit> exhibits() {
    return all_exhibits(texture.load(), labels.load());
  }

  Groups options() override { return {texture, exhibit}; }
  void build(Chosen& chosen) override { exhibit.apply_to(chosen); }
  void draw_all(Session& session) override { show_exhibits(exhibits(), exhibit, session); }
};

}  // namespace texmap::chapter_14
