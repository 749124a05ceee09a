// The group of threads: the same picture on one and on several.
#include <memory>
#include <thread>

#include "03_image_texture/lesson.hpp"
#include "08_triangle_uv/lesson.hpp"
#include "11_bump_and_normal_maps/lesson.hpp"
#include "bench.hpp"
#include "pictures.hpp"

namespace texmap::bench {
namespace {

template <class Lesson>
void add_picture(Group& group, const std::string& line) {
  for (const int threads : {1, 2, 4, 8}) {
    Row row{.line = line,
            .column = std::to_string(threads) + (threads == 1 ? " thread" : " threads"),
            .set = line};
    if (threads <= static_cast<int>(std::thread::hardware_concurrency())) {
      row.prepare = [threads]() -> Work {
        const auto lesson = std::make_shared<Lesson>(prepared<Lesson>({}));
        return [=] {
          (void)render<double>(*lesson, view_of(lesson->stage.camera, 400, 300),
                               {.threads = threads});
        };
      };
    }
    group.rows.push_back(row);
  }
}

}  // namespace

Group threads_group() {
  Group group{
      .name = "threads",
      .title = "Threads",
      .text =
          "Drawing alone, in double, at 400 × 300 pixels. A thread takes the next row of the\n"
          "picture as soon as it is done with one. The base is the picture on one thread.",
      .unit = "ms",
      .seconds = 8,
  };
  add_picture<chapter_03::Lesson>(group, "03");
  add_picture<chapter_08::Lesson>(group, "08");
  add_picture<chapter_11::Lesson>(group, "11");
  return group;
}

}  // namespace texmap::bench
