// The options of a sky that is a picture.
#include "engine/app/sky_options.hpp"

#include <cmath>
#include <string>
#include <utility>

#include "engine/app/command_line.hpp"
#include "engine/app/session.hpp"
#include "engine/app/sky_choice.hpp"
#include "engine/measure/text.hpp"
#include "engine/picture/find_texture.hpp"
#include "engine/picture/load_light.hpp"
#include "engine/system/file_error.hpp"
#include "engine/system/system.hpp"

namespace texmap {

void SkyOptions::declare(CommandLine& line) {
  line.text("--sky", "FILE", name,
            "the picture of the sky, twice as wide as high: Radiance .hdr, PNG or JPEG");
  line.choice<std::optional<SkyLighting>>(
      "--light", chosen,
      {{"auto", std::nullopt},
       {"uniform", SkyLighting::uniform},
       {"cosine", SkyLighting::cosine},
       {"importance", SkyLighting::importance},
       {"mis", SkyLighting::mis},
       {"coefficients", SkyLighting::coefficients}},
      "how matte surfaces sample the sky's light; auto chooses what suits the sky");
  line.flag("--caustics", matte.caustics,
            "also draw the light that mirrors throw on matte surfaces; this is right in the mean, "
            "but leaves very bright dots");
  line.decimal("--exposure", exposure, -30, 30,
               "multiply the sky's light by 2 to this power (stops)");
  line.decimal("--degrees", degrees, -1e300, 1e300,
               "rotates the sky about the vertical axis by this angle");
  line.choice("--filter", filter, "nearest|bilinear",
              "how the sky is read between the centers of its texels");
}

SkyLight SkyOptions::load(const Session& session) {
  LightImage map = load_light(find_texture(name));
  const auto factor = static_cast<float>(std::exp2(exposure));
  for (Color<float>& texel : map.pixels) texel = texel * factor;
  Environment picture(std::move(map), filter, degrees);
  if (picture.map().width % 2 != 0 && !picture.is_constant()) {
    throw FileError("cannot load texture '" + name + "': it is " +
                    std::to_string(picture.map().width) +
                    " pixels wide, and the width of a sky must be even");
  }
  SkyLight sky(std::move(picture));
  if (chosen) {
    matte.way = *chosen;
    return sky;
  }
  const SkyNoise noise = noise_of(sky);
  matte.way = best_lighting(noise);
  if (!session.settings.quiet) {
    print(
        text("one direction's light is off by %s of itself by the cosine, %s by mis: --light %s\n",
             shown(noise.cosine, 3).c_str(), shown(noise.mis, 3).c_str(),
             matte.way == SkyLighting::mis ? "mis" : "cosine"));
  }
  return sky;
}

}  // namespace texmap
