// Runs the stripes.
#include "stripes_lesson.hpp"

#include "engine/app/run_chapter.hpp"

int main(int argc, char** argv) {
  return texmap::run_chapter<texmap::stripes::Lesson>("stripes", argc, argv);
}
