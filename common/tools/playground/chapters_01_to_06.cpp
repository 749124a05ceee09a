// The module of chapters 01 to 06: they share most of their code.
#include "01_plain_spheres/lesson.hpp"
#include "02_checkerboard_uv/lesson.hpp"
#include "03_image_texture/lesson.hpp"
#include "04_uv_conventions/lesson.hpp"
#include "05_y_rotation/lesson.hpp"
#include "06_phong_texture_blend/lesson.hpp"
#include "knobs.hpp"

namespace texmap::live {

std::unique_ptr<LiveLesson> make_lesson(int chapter) {
  if (chapter == 1) return std::make_unique<Live<chapter_01::Lesson>>();
  if (chapter == 2) return std::make_unique<Live<chapter_02::Lesson>>();
  if (chapter == 3) return std::make_unique<Live<chapter_03::Lesson>>();
  if (chapter == 4) return std::make_unique<Live<chapter_04::Lesson>>();
  if (chapter == 5) return std::make_unique<Live<chapter_05::Lesson>>();
  return std::make_unique<Live<chapter_06::Lesson>>();
}

}  // namespace texmap::live
