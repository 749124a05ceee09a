// The figures of chapter 00's page: what its program draws.
#include <stdexcept>

#include "engine/picture/load_image.hpp"
#include "figures.hpp"
#include "support/pictures.hpp"
#include "support/running.hpp"

namespace texmap::test {
namespace {

Image drawn_by(const std::string& program) {
  const TemporaryFolder folder;
  const std::string file = folder / "drawn.png";
  const Outcome outcome = run("\"" TEXMAP_BIN_DIR "/" + program + "\" --out \"" + file + "\"");
  if (outcome.status != 0) throw std::runtime_error(program + ": " + outcome.err);
  return load_image(file);
}

std::string color(Rgb8 pixel) {
  return std::to_string(pixel.r) + ", " + std::to_string(pixel.g) + ", " + std::to_string(pixel.b);
}

}  // namespace

void figures_of_00(Figures& figures) {
  const Image image = drawn_by("00_one_file");
  figures.emplace_back("00.middle", color(image.at(400, 300)));
  figures.emplace_back("00.red", color(image.at(250, 330)));
  figures.emplace_back("00.sky", color(image.at(400, 10)));
  const long without = count_different(image, drawn_by("00_without_offset"));
  figures.emplace_back("00.pixels_without_offset", whole(without));
}

}  // namespace texmap::test
