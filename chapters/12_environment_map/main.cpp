// Runs this chapter's lesson.
#include "engine/run/run_chapter.hpp"
#include "lesson.hpp"

int main(int argc, char** argv) {
  return texmap::run_chapter<texmap::chapter_12::Lesson>(TEXMAP_CHAPTER, argc, argv);
}
