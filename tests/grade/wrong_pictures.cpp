// Draws chapter 03 with the mistakes that students make, to test grading: wrong_pictures FOLDER.
#include <cstdio>
#include <exception>
#include <string>

#include "03_image_texture/lesson.hpp"
#include "engine/picture/find_texture.hpp"
#include "engine/picture/load_image.hpp"
#include "engine/picture/save_png.hpp"
#include "support/pictures.hpp"

namespace {

using namespace texmap;
using namespace texmap::test;

Image with_texture(const Image& image) {
  auto lesson = prepared<chapter_03::Lesson>();
  std::get<chapter_03::Textured>(lesson.objects[chapter_03::middle].paint).texture.image = image;
  return picture(lesson);
}

/// The map with each texel drawn as two halves and all of them moved by one half.
Image moved_by_half_a_texel(const Image& map) {
  Image moved(2 * map.width, map.height);
  for (int row = 0; row < moved.height; ++row) {
    for (int column = 0; column < moved.width; ++column) {
      moved.at(column, row) = map.at((column + 1) % moved.width / 2, row);
    }
  }
  return moved;
}

void draw_all(const std::string& folder) {
  const Image earth = load_image(find_texture("earth.png"));
  save_png(with_texture(mirrored(earth)), folder + "/mirrored.png");
  save_png(with_texture(moved_by_half_a_texel(earth)), folder + "/shifted.png");
  Image stray = with_texture(earth);
  stray.at(11, 580) = {255, 0, 255};
  save_png(stray, folder + "/stray.png");
  save_png(picture(prepared<chapter_03::Lesson>(), 400, 300), folder + "/small.png");
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("error: name a folder\nusage: wrong_pictures FOLDER\n", stderr);
    return 2;
  }
  try {
    draw_all(argv[1]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "error: %s\n", error.what());
    return 1;
  }
  return 0;
}
