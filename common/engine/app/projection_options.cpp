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
              "draw the globe with its picture converted to this layout");
  line.choice("--from", from, words, "the layout of the --texture file");
  line.choice("--to", to, or_none,
              "convert the --texture file to this layout and save it, with as many texels on the "
              "sphere unless you give --width or --height");
}

ImageTexture ProjectionOptions::load(const TextureFile& file) const {
  const Image image = file.load();
  if (from == on_globe()) return {image};
  return {convert_projection(image, from, on_globe(), converted_size(image, from, on_globe()))};
}

}  // namespace texmap
