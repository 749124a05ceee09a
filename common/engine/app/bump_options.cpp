// The options of the chapter with bumps.
#include "engine/app/bump_options.hpp"

#include "engine/app/command_line.hpp"
#include "engine/picture/find_texture.hpp"
#include "engine/picture/load_image.hpp"

namespace texmap {

void BumpOptions::declare(CommandLine& line) {
  line.choice<BumpPicture>("--show", picture,
                           {{"globe", BumpPicture::globe},
                            {"sheet", BumpPicture::sheet},
                            {"poles", BumpPicture::poles},
                            {"daily", BumpPicture::daily}},
                           "the globe; eight ways to read one normal map; heights at a pole; the "
                           "daily exercise's bricks");
  line.choice<BumpForm>(
      "--bump", form,
      {{"exact", BumpForm::exact}, {"blinn", BumpForm::blinn}, {"off", BumpForm::flat}},
      "the raised surface's normal; Blinn's of 1978, without the term h dn; the globe's own");
  line.choice<SlopeFrom>("--slopes", slopes,
                         {{"duals", SlopeFrom::duals},
                          {"forward", SlopeFrom::forward},
                          {"central", SlopeFrom::central}},
                         "from the height's own derivatives, or from differences");
  line.decimal("--step", step, 1e-300, 1, "of differences, in radii of the globe");
  line.decimal("--relief", relief, -10, 10,
               "how high white is, in radii of the globe; below 0 mountains are valleys");
  line.choice<HeightKind>(
      "--relief-from", height,
      {{"image", HeightKind::image}, {"uv", HeightKind::uv}, {"space", HeightKind::space}},
      "what is high: an image, waves in (u, v), waves in space");
  line.text("--relief-image", "FILE", image,
            "the heights, a PNG or JPEG twice as wide as high; red counts");
}

LightImage BumpOptions::load() const {
  return light_of(load_image(find_texture(image)), TexelLight::encoded);
}

}  // namespace texmap
