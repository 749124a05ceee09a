// Runs this chapter's lesson; all chapters' main programs are alike.
#include "lesson.hpp"
#include "run_chapter.hpp"

int main(int argc, char** argv) { return texmap::run_chapter<texmap::chapter_13::Lesson>(TEXMAP_CHAPTER, argc, argv); }
