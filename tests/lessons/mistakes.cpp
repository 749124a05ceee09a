// Lessons with one mistake for each value of MISTAKE: they must not compile, and the message must
// name the mistake.
#include <vector>

#include "engine/app/run_chapter.hpp"
#include "scene/paint.hpp"
#include "scene/stage.hpp"

namespace texmap {

struct Base {
  Stage stage;
  std::vector<Painted<Solid>> objects;
  template <class Real>
  Color<Real> operator()(const Ray<Real>& ray) const {
    return stage.sky(ray);
  }
};

#if MISTAKE == 1
struct Lesson : LessonHooks, Base {
  static constexpr About about{.idea = "a sky"};
  void prepair(Session&) override {}
};
#elif MISTAKE == 2
struct Lesson : LessonHooks, Base {
  static constexpr About about{.idae = "a sky"};
};
#elif MISTAKE == 3
struct Lesson : Base {
  static constexpr About about{.idea = "a sky"};
};
#elif MISTAKE == 4
struct Lesson : LessonHooks, Base {};
#endif

}  // namespace texmap

int main(int argc, char** argv) {
  return texmap::run_chapter<texmap::Lesson>("mistakes", argc, argv);
}
