// The options --filter, --scene, --wrap, --taps, --floor and --plot.
#include "engine/app/filter_options.hpp"

#include "engine/app/command_line.hpp"

namespace texmap {
namespace {

FilteredTexture texture_of(const Image& image, const FilterOptions& options, Wrap wrap) {
  return {.pyramid = pyramid_of(light_of(image, TexelLight::linear)),
          .filter = options.filter,
          .wrap = wrap,
          .taps = options.taps,
          .border = {0.05, 0.05, 0.05}};
}

}  // namespace

void FilterOptions::declare(CommandLine& line) {
  line.choice<Filter>("--filter", filter,
                      {{"nearest", Filter::nearest},
                       {"bilinear", Filter::bilinear},
                       {"trilinear", Filter::trilinear},
                       {"anisotropic", Filter::anisotropic},
                       {"ewa", Filter::ewa},
                       {"stochastic", Filter::stochastic}},
                      "how textures are filtered");
  line.choice<FilterScene>(
      "--scene", scene,
      {{"both", FilterScene::both}, {"plane", FilterScene::plane}, {"globe", FilterScene::globe}},
      "what to draw: a plane up to the horizon, a globe far away, or both");
  line.choice<Wrap>("--wrap", wrap,
                    {{"repeat", Wrap::repeat},
                     {"mirror", Wrap::mirror},
                     {"clamp", Wrap::clamp},
                     {"border", Wrap::border}},
                    "what the floor shows outside the first copy of its picture");
  line.whole("--taps", taps, 1, 64,
             "how many times at most a filter reads along a pixel's footprint");
  line.text("--floor", "FILE", floor_file,
            "the picture on the floor: a PNG or JPEG file, or the word checkers");
  line.text("--plot", "FILE.svg", plot,
            "also plot the filters' errors against the number of texels they read");
  line.wishes.budget =
      "the allowed error of textured pixels: exact or levels=4; prints which filter it chooses";
  line.wishes.no_intervals =
      "where rounding leaves open which level a filter reads, the bound would be too wide to be "
      "of use";
}

Image checkers_image(int size, int squares) {
  Image image(size, size);
  for (int row = 0; row < size; ++row) {
    for (int column = 0; column < size; ++column) {
      const bool light = (row * squares / size + column * squares / size) % 2 == 0;
      image.at(column, row) = light ? Rgb8{255, 255, 255} : Rgb8{0, 0, 0};
    }
  }
  return image;
}

FilteredTexture FilterOptions::load_floor() const {
  const bool made = floor_file == "checkers";
  return texture_of(made ? checkers_image(1024, 32) : TextureFile{floor_file}.load(), *this, wrap);
}

FilteredTexture FilterOptions::load_globe(const TextureFile& file) const {
  return texture_of(file.load(), *this, Wrap::spherical);
}

}  // namespace texmap
