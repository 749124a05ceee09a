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
  for (const ProjectionFacts& facts : projections) words.emplace_back(facts.word, facts.projection);
  line.choice("--projection", projection, words,
              "draws the globe: its picture is converted to this layout and read from there");
  line.choice("--from", from, words, "the layout of the file of --texture");
  line.choice("--to", to, words,
              "converts the file of --texture to this layout and saves it, with as many texels for "
              "the sphere unless --width or --height says otherwise");
}

ImageTexture ProjectionOptions::load(const TextureFile& file) const {
  const Image image = file.load();
  if (from == projection) return {image};
  return {convert_projection(image, from, projection, converted_size(image, from, projection))};
}

}  // namespace texmap
