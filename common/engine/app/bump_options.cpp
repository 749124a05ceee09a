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
                           "globe: the globe. sheet: eight ways to read one normal map. poles: "
                           "heights at a pole. daily: the daily exercise's bricks");
  line.choice<BumpForm>(
      "--bump", form,
      {{"exact", BumpForm::exact}, {"blinn", BumpForm::blinn}, {"off", BumpForm::flat}},
      "exact: the normal of the raised surface. blinn: Blinn's of 1978, which leaves out the term "
      "h dn. off: the globe's own normal");
  line.choice<SlopeFrom>(
      "--slopes", slopes,
      {{"duals", SlopeFrom::duals},
       {"forward", SlopeFrom::forward},
       {"central", SlopeFrom::central}},
      "slopes of the height: duals are exact derivatives, forward and central are differences");
  line.decimal("--step", step, 1e-300, 1, "the step of the differences, in radii of the globe");
  line.decimal("--relief", relief, -10, 10,
               "the height of white, in radii of the globe; below 0 mountains become valleys");
  line.choice<HeightKind>(
      "--relief-from", height,
      {{"image", HeightKind::image}, {"uv", HeightKind::uv}, {"space", HeightKind::space}},
      "where the heights come from: an image, waves in (u, v), or waves in space");
  line.text(
      "--relief-image", "FILE", image,
      "the image of the heights, a PNG or JPEG twice as wide as high; its red channel is used");
}

LightImage BumpOptions::load() const {
  return light_of(load_image(find_texture(image)), TexelLight::encoded);
}

}  // namespace texmap
