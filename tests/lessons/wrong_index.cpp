// A lesson that writes behind the end of its list: a program for learning must say so.
#include "02_checkerboard_uv/lesson.hpp"
#include "engine/run/run_chapter.hpp"

namespace {

struct Lesson : texmap::chapter_02::Lesson {
  void build(texmap::Chosen&) override { objects[objects.size()].shape.radius = 2; }
};

}  // namespace

int main(int argc, char** argv) { return texmap::run_chapter<Lesson>("wrong_index", argc, argv); }
