// The options --projection, --from and --to.
#include "engine/app/projection_options.hpp"

#include <string_view>
#include <utility>
#include <vector>

#include "engine/app/command_line.hpp"
#include "engine/render/convert_projection.hpp"

namespace texmap {

void ProjectionOptions::declare(CommandLine& line) {
  std::vector<std::pair<std::string_view, Projection>> words;
  std::vector<std::pair<std::string_view, std::optional<Projection>>> or_none;  // no default
  for (const ProjectionFacts& facts : projections) {
    words.emplace_back(facts.word, facts.projection);
    or_none.emplace_back(facts.word, facts.projection);
  }
  line.choice("--projection", projection, or_none,
              "draws the globe: its picture is converted to this layout and read from there");
  line.choice("--from", from, words, "the layout of the file of --texture");
  line.choice("--to", to, or_none,
              "converts the file of --texture to this layout and saves it, with as many texels for "
              "the sphere unless --width or --height says otherwise");
}

ImageTexture ProjectionOptions::load(const TextureFile& file) const {
  const Image image = file.load();
  if (from == on_globe()) return {image};
  return {convert_projection(image, from, on_globe(), converted_size(image, from, on_globe()))};
}

}  // namespace texmap
