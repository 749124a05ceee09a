// Runs the lesson of the link order.
#include "lesson.hpp"

#include "engine/run/run_chapter.hpp"

int main(int argc, char** argv) {
  return texmap::run_chapter<texmap::chapter_99::Lesson>("99_link_order", argc, argv);
}
