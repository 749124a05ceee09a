// The lesson of this chapter: what breaks at the limits of a number, and the formulas that hold.
#pragma once
#include <vector>

#include "engine/app/lesson.hpp"
#include "engine/app/texture_file.hpp"
#include "exhibit.hpp"

namespace texmap::chapter_14 {

struct Lesson : LessonHooks {
  static constexpr About about{
      .idea = "what breaks at the limits of a number, and the formulas that hold",
      .size = {1680, 1900},
      .numbers = Numbers::single,  // the published formulas branch, and packs cannot
      .without = {"--number", "--samples", "--zoom"},  // the exhibit's options have them
  };

  TextureFile texture{"earth.png"};
  TextureFile labels{"uv_map.png"};
  ExhibitOptions exhibit;

  [[nodiscard]] std::vector<Exhibit> exhibits() const {
    return all_exhibits(texture.load(), labels.load());
  }

  void options(CommandLine& line) override { offer(line, texture, exhibit); }
  void prepare(Session& session) override { exhibit.apply_to(session); }
  void draw_all(Session& session) override { show_exhibits(exhibits(), exhibit, session); }
};

}  // namespace texmap::chapter_14
